//! Lights, as a scene is put together: those without a surface, shapes that shine, what is beyond.

use super::Object;
use super::description as said;
use super::field::{self, Checked, Field, exactly_one};
use super::image_file;
use super::parts::Parts;
use crate::color::Rgb;
use crate::geometry::{Shape, Triangle};
use crate::lights::{
    DirectionalLight, EnvironmentLight, Light, MeshLight, PointLight, QuadLight, SphereLight,
    TriangleLight,
};
use crate::materials::Material;
use glam::Vec3;
use std::path::Path;

impl Parts<'_> {
    pub(super) fn add_light(&mut self, field: &Field, said: &said::Light) -> Checked<()> {
        let point = said.point.as_ref().map(|l| {
            let field = field.key("point");
            let at = field.key("position");
            Ok(Light::Point(PointLight {
                position: self.within_reach(&at, field::vector(&at, l.position)?)?,
                intensity: field::light(&field.key("intensity"), l.intensity)?,
            }))
        });
        let directional = said.directional.as_ref().map(|l| {
            let field = field.key("directional");
            let direction = field::direction(&field.key("direction"), l.direction)?;
            Ok(Light::Directional(DirectionalLight {
                from: -direction.as_vec3(),
                irradiance: field::light(&field.key("irradiance"), l.irradiance)?,
            }))
        });
        let kinds = vec![("point", point), ("directional", directional)];
        self.lights
            .push(exactly_one(field, "kind of light", kinds)??);
        Ok(())
    }

    /// Adds shapes that shine: all triangles as one light, all others one by one.
    ///
    /// A lamp in the very place of an earlier one is left out and counted: no ray ever meets it.
    pub(super) fn push_lamp(
        &mut self,
        mut shapes: Vec<Shape>,
        material: Option<Material>,
        emission: Emission,
        span: Vec3,
    ) {
        let before = shapes.len();
        shapes.retain(|shape| {
            let place = place_of(shape, span, emission.two_sided);
            self.lamp_places.insert(place)
        });
        self.hidden_lamps += before - shapes.len();
        if shapes.is_empty() {
            return;
        }
        let triangles = shapes.iter().map(|shape| match shape {
            Shape::Triangle(triangle) => Some(*triangle),
            Shape::Quad(_) | Shape::Sphere(_) => None,
        });
        if let Some(triangles) = triangles.collect::<Option<Vec<_>>>() {
            let light = emission.of_triangles(triangles);
            self.push(shapes, material, light.map(|light| (light, emission)));
            return;
        }
        for shape in shapes {
            let light = emission.of_shape(shape);
            self.push(vec![shape], material, Some((light, emission)));
        }
    }

    /// Adds shapes as one object, which may be a light.
    pub(super) fn push(
        &mut self,
        shapes: Vec<Shape>,
        material: Option<Material>,
        light: Option<(Light, Emission)>,
    ) {
        let object = self.objects.len() as u32;
        let index = light.as_ref().map(|_| self.lights.len() as u32);
        let (light, emission) = light.unzip();
        self.lights.extend(light);
        self.objects.push(Object {
            material,
            emission: emission.map_or(Rgb::BLACK, |e| e.radiance),
            two_sided: emission.is_some_and(|e| e.two_sided),
            light: index,
        });
        self.all.extend(shapes.into_iter().map(|s| (s, object)));
    }
}

/// What a surface sends out.
#[derive(Clone, Copy)]
pub(super) struct Emission {
    pub(super) radiance: Rgb,
    pub(super) two_sided: bool,
}

impl Emission {
    /// The light of all these triangles; `None` where they have no area.
    fn of_triangles(self, triangles: Vec<Triangle>) -> Option<Light> {
        if let [triangle] = *triangles {
            return Some(self.of_shape(Shape::Triangle(triangle)));
        }
        let light = MeshLight::new(triangles, self.radiance)?;
        Some(Light::Mesh(match self.two_sided {
            true => light.two_sided(),
            false => light,
        }))
    }

    fn of_shape(self, shape: Shape) -> Light {
        let Emission {
            radiance,
            two_sided,
        } = self;
        match shape {
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
        }
    }
}

/// The bits of where a shape is and moves to, and whether both sides shine; from whichever corner it
/// was told.
fn place_of(shape: &Shape, span: Vec3, two_sided: bool) -> Vec<u32> {
    let mut points = match shape {
        Shape::Sphere(s) => vec![
            s.center,
            Vec3::new(s.radius, f32::from(u8::from(s.inward)), 0.0),
        ],
        Shape::Quad(q) => q.corners().to_vec(),
        Shape::Triangle(t) => vec![t.a, t.b, t.c],
    };
    if !matches!(shape, Shape::Sphere(_)) {
        let first = (0..points.len()).min_by(|&i, &j| {
            let [p, q] = [i, j].map(|at| points[at].to_array().map(|x| x + 0.0));
            p.partial_cmp(&q).unwrap_or(std::cmp::Ordering::Equal)
        });
        points.rotate_left(first.unwrap_or(0));
    }
    points.extend([span, Vec3::X * f32::from(u8::from(two_sided))]);
    // Zeros of both signs are one place.
    let bits = |p: &Vec3| p.to_array().map(|x| (x + 0.0).to_bits());
    points.iter().flat_map(bits).collect()
}

/// Pixels an environment may have: each takes 20 bytes.
const MAX_PIXELS: usize = 1 << 26;

/// What is seen beyond the scene: a constant radiance, or a light one can aim at.
pub(super) fn environment(
    top: &Field,
    said: &said::Description,
    folder: Option<&Path>,
) -> Checked<(Rgb, Option<Light>)> {
    let Some(environment) = &said.environment else {
        let constant = match said.background {
            Some(color) => field::light_or_none(&top.key("background"), color)?,
            None => Rgb::BLACK,
        };
        return Ok((constant, None));
    };
    let field = top.key("environment");
    if said.background.is_some() {
        return Err(field.problem("cannot stand beside `background`, which says the same"));
    }
    let radiance = environment.radiance.map(|color| {
        for (name, given) in [
            ("scale", environment.scale.is_some()),
            ("rotate", environment.rotate.is_some()),
        ] {
            if given {
                return Err(field.key(name).problem("is only possible with an `image`"));
            }
        }
        Ok((field::light_or_none(&field.key("radiance"), color)?, None))
    });
    let image = environment.image.as_ref().map(|file| {
        let light = image_light(&field, environment, file, folder)?;
        Ok((Rgb::BLACK, light.map(Light::Environment)))
    });
    let kinds = vec![("radiance", radiance), ("image", image)];
    exactly_one(&field, "kind of environment", kinds)?
}

/// The light of an image; `None` where all of it is black.
fn image_light(
    field: &Field,
    said: &said::Environment,
    file: &Path,
    folder: Option<&Path>,
) -> Checked<Option<EnvironmentLight>> {
    let scale = field::positive(&field.key("scale"), said.scale.unwrap_or(1.0))?;
    let degrees = field::finite(&field.key("rotate"), said.rotate.unwrap_or(0.0))?;
    let field = field.key("image");
    let Some(folder) = folder else {
        return Err(field.problem("is only possible in a scene file of its own"));
    };
    let path = folder.join(file);
    let complain = |what: String| field.problem(format!("names {}, which {what}", path.display()));
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
    Ok(EnvironmentLight::new(width, pixels, degrees.to_radians()))
}
