//! What a point of a flat world reflects: point lamps are sampled, glowing surfaces are found by chance.

use halfdisk::flatland::{FlatHit, FlatWorld};
use halfdisk::integrators::world::{FlatTracer, Lights, World};
use halfdisk::lab::estimators::directions::Recipe;
use halfdisk::lab::estimators::gather::{Gather, step1_direction, step2_turn, step4_cosine};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::space::{Flat, Space};
use halfdisk::stats::Estimate;
use rayon::prelude::*;

/// The red light that a point of a flat world reflects, over `count` gathers.
pub fn reflected(
    world: &FlatWorld,
    at: &FlatHit,
    gather: &Gather,
    count: u32,
    seed: u64,
) -> Estimate {
    let at = at.seen_from(at.surface.n);
    let sample = |i| {
        let mut world = FlatTracer::sampling(world, Lights::Points);
        let li = gather.reflected(&mut world, &at, &Stream::new(seed, i, 0));
        f64::from(li.r)
    };
    let samples: Vec<f64> = (0..count).into_par_iter().map(sample).collect();
    samples.into_iter().collect()
}

// ANCHOR: as_printed
/// The same by the essay's formula as printed: the mean of colour times cosine, times the albedo.
/// It forgets the density and the Lambert constant, and reads `2/π` of the truth.
pub fn reflected_as_printed(world: &FlatWorld, at: &FlatHit, count: u32, seed: u64) -> Estimate {
    let mut world = FlatTracer::sampling(world, Lights::Points);
    let at = world.diffuse(&at.seen_from(at.surface.n));
    let sample = |i| {
        let mut numbers = Stream::new(seed, i, 0).at(0, Purpose::Direction);
        let drawn = step1_direction::<Flat>(Recipe::Uniform, 0, 1, &mut numbers);
        let wi = step2_turn::<Flat>(&Flat::frame(at.n), drawn.w);
        let ray = at.spawn(wi);
        let hit = world.intersect(&ray, 2);
        let color = world.emitted(&ray, hit.as_ref());
        f64::from((at.albedo * step4_cosine::<Flat>(color, drawn.w)).r)
    };
    (0..count).map(sample).collect()
}
// ANCHOR_END: as_printed
