//! A scene, as a world to gather in.
//!
//! Diffuse surfaces only: mirrors and glass have no place in the seven steps, and count as black.

use super::world::{Hit, World};
use crate::color::Rgb;
use crate::geometry::{self, Surface};
use crate::lights::LightSample;
use crate::materials::Material;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::Tracer;
use crate::space::{Ray, Solid};
use glam::Vec3;

/// A scene whose lamps are aimed at: direct light by shadow rays, one to each lamp.
#[derive(Debug)]
pub struct SceneWorld<'t, 's> {
    tracer: &'t mut Tracer<'s>,
}

impl<'t, 's> SceneWorld<'t, 's> {
    /// The world of the tracer's scene; the tracer counts its rays.
    pub fn new(tracer: &'t mut Tracer<'s>) -> Self {
        SceneWorld { tracer }
    }
}

impl World<Solid> for SceneWorld<'_, '_> {
    type Light = Rgb;

    fn first_hit(&mut self, ray: &Ray<Solid>) -> Option<Hit<Solid, Rgb>> {
        let ray = geometry::Ray::new(ray.origin, ray.direction);
        let hit = self.tracer.secondary_ray(&ray)?;
        let Surface { p, error, n } = hit.surface;
        let albedo = match hit.object.material {
            Some(Material::Lambert(lambert)) => lambert.albedo,
            _ => Rgb::BLACK,
        };
        Some(Hit {
            p,
            error,
            n: if n.dot(ray.direction) < 0.0 { n } else { -n },
            albedo,
            emission: hit.emitted(-ray.direction),
            // Every object that emits is one of the scene's lights.
            aimed: true,
        })
    }

    fn environment(&self, _: Vec3) -> Rgb {
        self.tracer.scene().background
    }

    fn direct(&mut self, at: &Hit<Solid, Rgb>, stream: &Stream, node: u64) -> Rgb {
        let from = Surface {
            p: at.p,
            error: at.error,
            n: at.n,
        };
        let mut irradiance = Rgb::BLACK;
        for (i, light) in self.tracer.scene().lights.iter().enumerate() {
            let u = stream.at_item(node, Purpose::LightPoint, i as u32).two();
            let Some(sample) = light.sample(&from, u) else {
                continue;
            };
            let LightSample { wi, incident, .. } = sample;
            let cos = at.n.dot(wi);
            if cos > 0.0 && !at.albedo.is_black() && self.tracer.is_free(&sample.shadow_ray) {
                irradiance += incident.facing_irradiance() * cos;
            }
        }
        irradiance
    }
}
