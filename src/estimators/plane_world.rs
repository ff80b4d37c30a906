//! A flat world of segments, circles and lamps, as a world to gather in.

use super::directions::Recipe;
use super::gather::{Gather, step1_direction, step2_turn, step4_cosine};
use super::world::{Hit, World};
use crate::color::Rgb;
use crate::flatland::{FlatHit, FlatSurface, FlatWorld};
use crate::sampling::stream::{Purpose, Stream};
use crate::space::{Flat, Ray, Space};
use crate::stats::Estimate;
use glam::Vec2;
use rayon::prelude::*;

/// A flat world whose point lamps are aimed at; its glowing surfaces are found by chance.
#[derive(Clone, Copy, Debug)]
pub struct PlaneWorld<'a>(pub &'a FlatWorld);

/// The point of a flat world that is asked, seen from the side of `towards`.
pub fn point(hit: &FlatHit, towards: Vec2) -> Hit<Flat, Rgb> {
    Hit {
        p: hit.surface.p,
        error: hit.surface.error,
        n: hit.surface.normal_towards(towards),
        albedo: hit.albedo,
        emission: hit.emitted(towards),
        aimed: false,
    }
}

impl World<Flat> for PlaneWorld<'_> {
    type Light = Rgb;

    fn first_hit(&mut self, ray: &Ray<Flat>) -> Option<Hit<Flat, Rgb>> {
        let hit = self.0.first_hit(ray.origin, ray.direction)?;
        Some(point(&hit, -ray.direction))
    }

    fn environment(&self, _: Vec2) -> Rgb {
        self.0.background
    }

    fn direct(&mut self, at: &Hit<Flat, Rgb>, _: &Stream, _: u64) -> Rgb {
        let from = FlatSurface {
            p: at.p,
            error: at.error,
            n: at.n,
        };
        let mut irradiance = Rgb::BLACK;
        for lamp in &self.0.lamps {
            let Some(light) = lamp.light_at(at.p) else {
                continue;
            };
            let cos = at.n.dot(light.wi);
            if cos > 0.0 && self.0.sees_point(&from, lamp.position) {
                irradiance += light.irradiance * cos;
            }
        }
        irradiance
    }
}

/// The red light that a point of a flat world reflects, over `count` gathers.
pub fn reflected(
    world: &FlatWorld,
    at: &FlatHit,
    gather: &Gather,
    count: u32,
    seed: u64,
) -> Estimate {
    let at = point(at, at.surface.n);
    let sample = |i| {
        let li = gather.reflected(&mut PlaneWorld(world), &at, &Stream::new(seed, i, 0));
        f64::from(li.r)
    };
    let samples: Vec<f64> = (0..count).into_par_iter().map(sample).collect();
    samples.into_iter().collect()
}

// ANCHOR: as_printed
/// The same by the essay's formula as printed: the mean of colour times cosine, times the albedo.
/// It forgets the density and the Lambert constant, and reads `2/π` of the truth.
pub fn reflected_as_printed(world: &FlatWorld, at: &FlatHit, count: u32, seed: u64) -> Estimate {
    let at = point(at, at.surface.n);
    let mut world = PlaneWorld(world);
    let sample = |i| {
        let mut numbers = Stream::new(seed, i, 0).at(0, Purpose::Direction);
        let drawn = step1_direction::<Flat>(Recipe::Uniform, 0, 1, &mut numbers);
        let wi = step2_turn::<Flat>(&Flat::frame(at.n), drawn.w);
        let color = match world.first_hit(&at.spawn(wi)) {
            Some(hit) => hit.emission,
            None => world.environment(wi),
        };
        f64::from((at.albedo * step4_cosine::<Flat, _>(color, drawn.w)).r)
    };
    (0..count).map(sample).collect()
}
// ANCHOR_END: as_printed
