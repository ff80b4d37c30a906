//! Walking in a scene.

use super::{Aimed, Step, Walkable};
use crate::color::Rgb;
use crate::geometry;
use crate::lights::Incident;
use crate::sampling::frame::Frame;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{Hit, Tracer};
use crate::space::{Ray, Solid};
use glam::Vec3;

/// A point of a scene, as a ray saw it.
#[derive(Clone, Copy, Debug)]
pub struct SolidPoint<'a> {
    /// The point and its object.
    pub hit: Hit<'a>,
    /// Local axes around its normal.
    pub frame: Frame,
    /// Where the ray came from, in local coordinates.
    pub wo: Vec3,
    /// The same in world coordinates.
    pub back: Vec3,
}

impl<'a> SolidPoint<'a> {
    /// The point `hit` seen along a ray with unit `direction`.
    pub fn new(hit: Hit<'a>, direction: Vec3) -> Self {
        let frame = Frame::new(hit.surface.n);
        SolidPoint {
            hit,
            frame,
            wo: frame.to_local(-direction),
            back: -direction,
        }
    }
}

impl<'a> Walkable<Solid> for Tracer<'a> {
    type Point = SolidPoint<'a>;

    fn follow(&mut self, ray: &Ray<Solid>, segment: u32) -> Option<SolidPoint<'a>> {
        let ray = geometry::Ray::new(ray.origin, ray.direction);
        let hit = if segment == 1 {
            self.camera_ray(&ray)?
        } else {
            self.secondary_ray(&ray)?
        };
        self.note_lamp(&hit, -ray.direction);
        Some(SolidPoint::new(hit, ray.direction))
    }

    fn arriving(&self, ray: &Ray<Solid>, met: Option<&SolidPoint<'a>>) -> Rgb {
        match met {
            Some(at) => at.hit.emitted(at.back),
            None => self.scene().background(ray.direction),
        }
    }

    fn scatter(&self, at: &SolidPoint<'a>, place: u64, stream: &Stream) -> Option<Step<Solid>> {
        let choice = stream.at(place, Purpose::Branch).one();
        let u = stream.at(place, Purpose::Direction).two();
        let scattered = at.hit.object.material?.scatter(at.wo, choice, u)?;
        let direction = at.frame.to_world(scattered.wi).normalize();
        let ray = at.hit.surface.spawn(direction);
        Some(Step {
            ray: Ray {
                origin: ray.origin,
                direction,
            },
            weight: scattered.weight,
            pdf: scattered.pdf,
        })
    }

    fn lamps(&self) -> usize {
        self.scene().lamps()
    }

    fn aim(
        &mut self,
        at: &SolidPoint<'a>,
        lamp: usize,
        place: u64,
        stream: &Stream,
    ) -> Option<Aimed> {
        let material = at.hit.object.material?;
        let mut numbers = stream.at_item(place, Purpose::LightPoint, lamp as u32);
        let (u, pick) = (numbers.two(), numbers.fine());
        let sample = self.sample_light(lamp, &at.hit.surface, pick, u)?;
        let wi = at.frame.to_local(sample.wi);
        let f = material.f(at.wo, wi);
        let cos = wi.z.abs();
        // A shadow ray costs as much as any other: it is not sent where nothing could come of it.
        if f.is_black() || cos == 0.0 || !self.visible(lamp, &sample) {
            return None;
        }
        Some(Aimed {
            light: f * sample.incident.facing_irradiance() * cos,
            pdf: match sample.incident {
                Incident::Radiance { pdf, .. } => Some(pdf),
                Incident::Irradiance(_) => None,
            },
            pdf_scatter: material.pdf(at.wo, wi),
        })
    }

    fn pdf_aim(
        &self,
        from: &SolidPoint<'a>,
        ray: &Ray<Solid>,
        met: Option<&SolidPoint<'a>>,
    ) -> f32 {
        let scene = self.scene();
        let lamp = match met {
            Some(at) => at.hit.object.light.map(|light| light as usize),
            None => scene.environment_light,
        };
        let at = met.map(|at| &at.hit.surface);
        lamp.map_or(0.0, |lamp| {
            self.pdf_light(lamp, &from.hit.surface, ray.direction, at)
        })
    }
}
