//! Lights, as a scene is put together: those without a surface, shapes that shine, what is beyond.

use super::description as said;
use super::field::{Checked, Problem, Within, check};
use super::image_file;
use super::motion::PlacedInstance;
use super::parts::{Parts, alone};
use super::value::{Finite, Positive, Radiance};
use super::{Mapping, Object};
use crate::color::Rgb;
use crate::geometry::{Instance, Primitive, Shape, SharedMesh};
use crate::lights::{
    DirectionalLight, EnvironmentLight, Light, MeshLight, PlacedLight, PointLight, QuadLight,
    SphereLight, TriangleLight,
};
use crate::materials::{Color, Material};
use glam::Vec3;
use std::path::Path;
use std::sync::Arc;

impl Parts<'_> {
    pub(super) fn light(&self, said: &said::Light) -> Checked<Light> {
        Ok(match *said {
            said::Light::Custom(ref light) => {
                let what = "must give some light: its fluence is a positive, finite number";
                check(light.fluence() > 0.0 && light.fluence().is_finite(), what)?;
                Light::Custom(PlacedLight::new(Arc::clone(light), self.origin))
            }
            said::Light::Point {
                position,
                intensity,
            } => {
                let position = position.get().and_then(|p| self.relative(p));
                Light::Point(PointLight {
                    position: position.within("position").within("point")?,
                    intensity: intensity.get()?,
                })
            }
            said::Light::Directional {
                direction,
                irradiance,
            } => Light::Directional(DirectionalLight {
                from: -direction.get()?.as_vec3(),
                irradiance: irradiance.get()?,
            }),
        })
    }

    /// Adds shapes as one object. Of those that shine, all triangles of a mesh are one light, and all
    /// others are lights and objects of their own.
    ///
    /// A lamp in the very place of an earlier one is left out and counted: no ray ever meets it.
    pub(super) fn push(
        &mut self,
        mut shapes: Vec<Shape>,
        material: Option<Material>,
        emission: Option<Emission>,
        span: Vec3,
        mapping: &Mapping,
    ) {
        let mut which: Vec<usize> = (0..shapes.len()).collect();
        let mut together = shapes.len();
        if let Some(Emission { two_sided, .. }) = emission {
            which.retain(|&i| {
                self.light_places
                    .insert(place_of(&shapes[i], span, two_sided))
            });
            shapes = which.iter().map(|&i| shapes[i]).collect();
            self.hidden_lights += together - shapes.len();
            if !matches!(shapes.first(), Some(Shape::Triangle(_))) {
                together = 1;
            }
        }
        let together = together.max(1);
        for (shapes, which) in shapes.chunks(together).zip(which.chunks(together)) {
            let object = self.objects.len() as u32;
            let light = emission
                .as_ref()
                .and_then(|emission| emission.light(shapes));
            let emission = emission.as_ref().filter(|_| light.is_some());
            self.objects.push(Object {
                material: material.clone(),
                emission: emission.map_or(Color::Constant(Rgb::BLACK), |e| e.radiance.clone()),
                mapping: mapping.some(which),
                two_sided: emission.is_some_and(|e| e.two_sided),
                light: light.as_ref().map(|_| self.lights.len() as u32),
            });
            self.lights.extend(light);
            self.all.extend(shapes.iter().map(|&shape| (shape, object)));
        }
    }
}

impl Parts<'_> {
    /// Adds an object that is an instance of a shape; of a mesh, if that is given.
    pub(super) fn push_instance(
        &mut self,
        (instance, mesh): (Instance, Option<Arc<SharedMesh>>),
        material: Option<Material>,
        mapping: Mapping,
    ) {
        self.instances.push(PlacedInstance {
            instance,
            mesh,
            object: self.objects.len() as u32,
        });
        self.objects.push(Object {
            material,
            mapping,
            ..Object::default()
        });
    }
}

/// What a surface sends out.
pub(super) struct Emission {
    pub(super) radiance: Color,
    pub(super) two_sided: bool,
}

impl Emission {
    /// The light of one shape, or of some triangles; `None` where these have no area.
    fn light(&self, shapes: &[Shape]) -> Option<Light> {
        let (radiance, two_sided) = (self.radiance.brightest(), self.two_sided);
        let mesh = |triangles| {
            let light = MeshLight::new(triangles, radiance)?;
            Some(Light::Mesh(if two_sided {
                light.two_sided()
            } else {
                light
            }))
        };
        let &[shape] = shapes else {
            return mesh(shapes.iter().filter_map(Shape::still_triangle).collect());
        };
        Some(match shape {
            Shape::Sphere(sphere) => Light::Sphere(SphereLight { sphere, radiance }),
            Shape::Triangle(triangle) => Light::Triangle(TriangleLight {
                triangle,
                radiance,
                two_sided,
            }),
            Shape::Quad(quad) => {
                let light = QuadLight::new(quad, radiance);
                Light::Quad(if two_sided { light.two_sided() } else { light })
            }
        })
    }
}

/// What tells a lamp from all others: where its shape is and moves to, and whether both sides shine.
fn place_of(shape: &Shape, span: Vec3, two_sided: bool) -> Vec<u32> {
    let mut key = shape.key();
    key.extend(span.to_array().map(|x| (x + 0.0).to_bits()));
    key.push(u32::from(two_sided));
    key
}

/// Pixels an environment may have: each takes 20 bytes.
const MAX_PIXELS: usize = 1 << 26;

/// What is seen beyond the scene: a constant radiance, or a light one can aim at.
pub(super) fn environment(
    said: &said::Description,
    folder: Option<&Path>,
) -> Checked<(Rgb, Option<Light>)> {
    let Some(environment) = &said.environment else {
        let constant = said.background.map_or(Ok(Rgb::BLACK), Radiance::get);
        return Ok((constant.within("background")?, None));
    };
    let what = "cannot stand beside `background`, which says the same";
    let alone = check(said.background.is_none(), what);
    alone
        .and_then(|()| beyond(environment, folder))
        .within("environment")
}

fn beyond(said: &said::Environment, folder: Option<&Path>) -> Checked<(Rgb, Option<Light>)> {
    match &said.light {
        said::Sky::Radiance(color) => {
            let what = "is only possible with an `image`";
            check(said.scale.is_none(), what).within("scale")?;
            check(said.rotate.is_none(), what).within("rotate")?;
            Ok((color.get()?, None))
        }
        said::Sky::Image(file) => {
            let scale = said.scale.map_or(Ok(1.0), Positive::get)?;
            let angle = said.rotate.map_or(Ok(0.0), Finite::get)?.to_radians();
            let light = image_light(file, alone(folder).within("image")?, scale, angle);
            Ok((Rgb::BLACK, light.within("image")?.map(Light::Environment)))
        }
    }
}

/// The light of an image; `None` where all of it is black.
fn image_light(
    file: &Path,
    folder: &Path,
    scale: f64,
    angle: f64,
) -> Checked<Option<EnvironmentLight>> {
    let path = folder.join(file);
    let complain = |what: String| Problem::new(format!("names {}, which {what}", path.display()));
    let (width, mut pixels) = image_file::read(&path, MAX_PIXELS).map_err(complain)?;
    for (at, pixel) in pixels.iter_mut().enumerate() {
        let scaled = pixel.channels().map(|x| (f64::from(x) * scale) as f32);
        if !scaled.iter().all(|x| x.is_finite() && *x >= 0.0) {
            let [r, g, b] = pixel.channels();
            return Err(complain(format!(
                "must hold finite numbers of 0 or more, but has [{r}, {g}, {b}] in column {} of row {}",
                at % width,
                at / width
            )));
        }
        *pixel = Rgb::from(scaled);
    }
    Ok(EnvironmentLight::new(width, pixels, angle))
}
