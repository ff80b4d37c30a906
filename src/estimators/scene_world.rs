//! A scene, as a world to gather in.
//!
//! Diffuse surfaces only: mirrors and glass have no place in the seven steps, and count as black.

use super::gather::Gather;
use super::world::{Hit, World};
use crate::color::Rgb;
use crate::geometry::{self, Surface};
use crate::integrators::Integrator;
use crate::lights::LightSample;
use crate::materials::Material;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{self, Tracer};
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

/// The point of a scene that a ray along `direction` meets.
fn point(hit: &scene::Hit, direction: Vec3) -> Hit<Solid, Rgb> {
    let Surface { p, error, n } = hit.surface;
    let albedo = match hit.object.material {
        Some(Material::Lambert(lambert)) => lambert.albedo,
        _ => Rgb::BLACK,
    };
    Hit {
        p,
        error,
        n: if n.dot(direction) < 0.0 { n } else { -n },
        albedo,
        emission: hit.emitted(-direction),
        // Every object that emits is one of the scene's lights.
        aimed: true,
    }
}

/// Gathering makes pictures, too: of diffuse scenes, cut off at a depth.
impl Integrator for Gather {
    fn li(&self, tracer: &mut Tracer, ray: &geometry::Ray, stream: &Stream) -> Rgb {
        let Some(hit) = tracer.camera_ray(ray) else {
            return tracer.scene().background(ray.direction);
        };
        let at = point(&hit, ray.direction);
        at.emission + self.reflected(&mut SceneWorld::new(tracer), &at, stream)
    }
}

impl World<Solid> for SceneWorld<'_, '_> {
    type Light = Rgb;

    fn first_hit(&mut self, ray: &Ray<Solid>) -> Option<Hit<Solid, Rgb>> {
        let ray = geometry::Ray::new(ray.origin, ray.direction);
        let hit = self.tracer.secondary_ray(&ray)?;
        Some(point(&hit, ray.direction))
    }

    fn environment(&self, direction: Vec3) -> Rgb {
        let scene = self.tracer.scene();
        // An image around the scene is one of the lights, and aimed at.
        match scene.environment_light {
            Some(_) => Rgb::BLACK,
            None => scene.background(direction),
        }
    }

    fn direct(&mut self, at: &Hit<Solid, Rgb>, stream: &Stream, node: u64) -> Rgb {
        let from = Surface {
            p: at.p,
            error: at.error,
            n: at.n,
        };
        let mut irradiance = Rgb::BLACK;
        for i in 0..self.tracer.scene().lamps() {
            let mut numbers = stream.at_item(node, Purpose::LightPoint, i as u32);
            let (u, pick) = (numbers.two(), numbers.fine());
            let Some(sample) = self.tracer.sample_light(i, &from, pick, u) else {
                continue;
            };
            let LightSample { wi, incident, .. } = sample;
            let cos = at.n.dot(wi);
            if cos > 0.0 && !at.albedo.is_black() && self.tracer.visible(i, &sample) {
                irradiance += incident.facing_irradiance() * cos;
            }
        }
        irradiance
    }
}
