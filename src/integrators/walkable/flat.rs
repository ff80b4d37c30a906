//! Walking in a flat world.

use super::{Aimed, Step, Walkable};
use crate::color::Rgb;
use crate::flatland::{FlatHit, FlatSurface, FlatWorld};
use crate::sampling::half_disk;
use crate::sampling::stream::{Purpose, Stream};
use crate::space::{Flat, Ray, Space};
use glam::Vec2;

/// A flat world to walk in, and the rays that were followed there.
#[derive(Clone, Copy, Debug)]
pub struct FlatWalk<'a> {
    /// The world.
    pub world: &'a FlatWorld,
    /// Rays so far, shadow rays included.
    pub rays: u64,
}

impl<'a> FlatWalk<'a> {
    /// The world, with no ray followed.
    pub fn new(world: &'a FlatWorld) -> Self {
        FlatWalk { world, rays: 0 }
    }
}

/// A point of a flat world, with the normal on the side it was seen from.
#[derive(Clone, Copy, Debug)]
pub struct FlatPoint {
    /// What the ray met.
    pub hit: FlatHit,
}

/// Where a shadow ray ends.
enum Target {
    Point(Vec2),
    Surface(FlatSurface),
}

impl Walkable<Flat> for FlatWalk<'_> {
    type Point = FlatPoint;

    fn follow(&mut self, ray: &Ray<Flat>, _: u32) -> Option<FlatPoint> {
        self.rays += 1;
        let hit = self.world.first_hit(ray.origin, ray.direction)?;
        Some(FlatPoint {
            hit: hit.seen_from(-ray.direction),
        })
    }

    fn arriving(&self, _: &Ray<Flat>, met: Option<&FlatPoint>) -> Rgb {
        met.map_or(self.world.background, |at| at.hit.emission)
    }

    fn scatter(&self, at: &FlatPoint, place: u64, stream: &Stream) -> Option<Step<Flat>> {
        if at.hit.albedo.is_black() {
            return None;
        }
        let surface = &at.hit.surface;
        let local = half_disk::sample_cosine(stream.at(place, Purpose::Direction).one());
        let direction = Flat::to_world(&Flat::frame(surface.n), local);
        Some(Step {
            ray: Ray {
                origin: surface.leave(direction),
                direction,
            },
            weight: at.hit.albedo,
            pdf: Some(half_disk::pdf_cosine(local)),
        })
    }

    fn lamps(&self) -> usize {
        self.world.lamps.len() + self.world.glowing().len()
    }

    fn aim(&mut self, at: &FlatPoint, lamp: usize, place: u64, stream: &Stream) -> Option<Aimed> {
        let surface = &at.hit.surface;
        let points = &self.world.lamps;
        let (wi, irradiance, pdf, target) = if let Some(point) = points.get(lamp) {
            let light = point.light_at(surface.p)?;
            (
                light.wi,
                light.irradiance,
                None,
                Target::Point(point.position),
            )
        } else {
            let u = stream
                .at_item(place, Purpose::LightPoint, lamp as u32)
                .one();
            let glowing = &self.world.glowing()[lamp - points.len()];
            let drawn = glowing.sample(surface.p, u)?;
            let irradiance = glowing.radiance / drawn.pdf;
            (
                drawn.wi,
                irradiance,
                Some(drawn.pdf),
                Target::Surface(drawn.surface),
            )
        };
        let cos = surface.n.dot(wi);
        if cos <= 0.0 || at.hit.albedo.is_black() {
            return None;
        }
        self.rays += 1;
        let free = match target {
            Target::Point(p) => self.world.sees_point(surface, p),
            Target::Surface(there) => self.world.sees(surface, &there),
        };
        free.then(|| Aimed {
            light: at.hit.albedo * Flat::LAMBERT * irradiance * cos,
            pdf,
            pdf_scatter: half_disk::pdf_cosine(Vec2::new(0.0, cos)),
        })
    }

    fn pdf_aim(&self, from: &FlatPoint, _: &Ray<Flat>, met: Option<&FlatPoint>) -> f32 {
        let Some(met) = met else {
            return 0.0;
        };
        let same = self.world.glowing().iter().find(|g| g.part == met.hit.part);
        same.map_or(0.0, |glowing| glowing.pdf(from.hit.surface.p))
    }
}
