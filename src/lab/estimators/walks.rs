//! Many walks along one ray: their mean, their variance, and what they cost.

use crate::color::Rgb;
use crate::flatland::FlatWorld;
use crate::geometry::Ray;
use crate::integrators::Integrator;
use crate::integrators::world::FlatTracer;
use crate::sampling::stream::Stream;
use crate::scene::{Scene, Tracer};
use crate::stats::Estimate;
use rayon::prelude::*;

/// What many walks gave.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Walks {
    /// Radiance of the red channel; each walk is a sample.
    pub estimate: Estimate,
    /// Squared distance of each sample from the truth: its mean is the variance of one walk.
    pub squares: Estimate,
    /// Rays of all walks, those to lamps included.
    pub rays: u64,
}

/// Walks that one thread takes at a time.
const BATCH: u32 = 1 << 14;

impl Walks {
    /// Rays of one walk, on average.
    pub fn rays_each(&self) -> f64 {
        self.rays as f64 / self.estimate.count().max(1) as f64
    }

    /// Variance of one walk over the square of the truth, and its standard error.
    pub fn relative_variance(&self, truth: f64) -> (f64, f64) {
        let square = truth * truth;
        (
            self.squares.mean() / square,
            self.squares.std_error() / square,
        )
    }
}

/// `count` walks on all threads, whose number changes no bit. A walk returns what it found and the
/// rays it took; `truth` is what they should find on average.
pub fn many(
    truth: f64,
    count: u32,
    seed: u64,
    walk: impl Fn(&Stream) -> (Rgb, u64) + Sync,
) -> Walks {
    let batch = |number: u32| {
        let start = number * BATCH;
        let mut walks = Walks::default();
        for i in start..count.min(start.saturating_add(BATCH)) {
            let (li, rays) = walk(&Stream::new(seed, i, 0));
            let found = f64::from(li.r);
            walks.estimate.add(found);
            walks.squares.add((found - truth) * (found - truth));
            walks.rays += rays;
        }
        walks
    };
    let batches: Vec<Walks> = (0..count.div_ceil(BATCH))
        .into_par_iter()
        .map(batch)
        .collect();
    batches.iter().fold(Walks::default(), |sum, b| Walks {
        estimate: sum.estimate.merge(&b.estimate),
        squares: sum.squares.merge(&b.squares),
        rays: sum.rays + b.rays,
    })
}

/// `count` walks in a flat world.
pub fn flat(
    world: &FlatWorld,
    truth: f64,
    count: u32,
    seed: u64,
    walk: impl Fn(&mut FlatTracer, &Stream) -> Rgb + Sync,
) -> Walks {
    many(truth, count, seed, |stream| {
        let mut world = FlatTracer::new(world);
        let li = walk(&mut world, stream);
        (li, world.rays)
    })
}

/// `count` samples of the radiance along one ray of a scene.
pub fn solid(
    scene: &Scene,
    ray: &Ray,
    integrator: &impl Integrator,
    truth: f64,
    count: u32,
    seed: u64,
) -> Walks {
    many(truth, count, seed, |stream| {
        let mut tracer = Tracer::new(scene);
        let li = integrator.li(&mut tracer, ray, stream);
        (li, tracer.counts().total())
    })
}
