//! Lights, as a scene is put together: those without a surface, shapes that shine, what is beyond.

use super::Object;
use super::description as said;
use super::field::{self, Checked, Field, exactly_one};
use super::image_file;
use super::parts::Parts;
use crate::color::Rgb;
use crate::geometry::Shape;
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
    /// A lamp in the very place of an earlier one is left out and counted: no ray ever meets it, and
    /// aimed at it would shine all the same.
    pub(super) fn push_lamp(
        &mut self,
        mut shapes: Vec<Shape>,
        material: Option<Material>,
        radiance: Rgb,
        span: Vec3,
    ) {
        let before = shapes.len();
        shapes.retain(|shape| self.lamp_places.insert(place_of(shape, span)));
        self.hidden_lamps += before - shapes.len();
        if shapes.is_empty() {
            return;
        }
        let triangles = shapes.iter().map(|shape| match shape {
            Shape::Triangle(triangle) => Some(*triangle),
            Shape::Quad(_) | Shape::Sphere(_) => None,
        });
        if let Some(triangles) = triangles.collect::<Option<Vec<_>>>() {
            let light = match triangles.as_slice() {
                [triangle] => Some(Light::Triangle(TriangleLight {
                    triangle: *triangle,
                    radiance,
                })),
                _ => MeshLight::new(triangles, radiance).map(Light::Mesh),
            };
            let light = light.map(|light| (light, radiance));
            self.push(shapes, material, light);
            return;
        }
        for shape in shapes {
            let light = match shape {
                Shape::Quad(quad) => Light::Quad(QuadLight::new(quad, radiance)),
                Shape::Sphere(sphere) => Light::Sphere(SphereLight { sphere, radiance }),
                Shape::Triangle(triangle) => Light::Triangle(TriangleLight { triangle, radiance }),
            };
            self.push(vec![shape], material, Some((light, radiance)));
        }
    }

    /// Adds shapes as one object, which may be a light.
    pub(super) fn push(
        &mut self,
        shapes: Vec<Shape>,
        material: Option<Material>,
        light: Option<(Light, Rgb)>,
    ) {
        let object = self.objects.len() as u32;
        let index = light.as_ref().map(|_| self.lights.len() as u32);
        let (light, emission) = light.unzip();
        self.lights.extend(light);
        self.objects.push(Object {
            material,
            emission: emission.unwrap_or_default(),
            light: index,
        });
        self.all.extend(shapes.into_iter().map(|s| (s, object)));
    }
}

/// The bits of where a shape is and moves to.
fn place_of(shape: &Shape, span: Vec3) -> Vec<u32> {
    let points = match shape {
        Shape::Sphere(s) => vec![s.center, Vec3::splat(s.radius)],
        Shape::Quad(q) => q.corners().to_vec(),
        Shape::Triangle(t) => vec![t.a, t.b, t.c],
    };
    let all = points.iter().chain([&span]);
    // Zeros of both signs are one place.
    all.flat_map(|p| p.to_array().map(|x| (x + 0.0).to_bits()))
        .collect()
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
