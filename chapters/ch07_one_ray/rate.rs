//! The variance of many paths, in the flat room whose answer is known.

use crate::SEGMENTS;
use glam::Vec2;
use halfdisk::flatland::{self, exact};
use halfdisk::integrators::Kajiya;
use halfdisk::integrators::world::FlatTracer;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::experiment::convergence::{Design, Estimator, Sizes, converge};
use halfdisk::lab::figures::variance_chart;
use halfdisk::sampling::stream::Stream;
use halfdisk::space::{Flat, Ray};

/// The variance of the mean of `N` paths, whose single one has this variance.
pub fn chart(desk: &mut Desk, of_one: f64) -> Result<(), DeskError> {
    let design = Design {
        replicates: desk.choose(128, 64),
        doublings: desk.choose(10, 6),
        first: 1,
        seed: desk.options.seed,
    };
    let room = flatland::load("room")?;
    let eye = Ray::<Flat>::new(Vec2::splat(0.5), Vec2::NEG_Y);
    let kajiya = Kajiya {
        max_depth: SEGMENTS,
    };
    let estimator = Estimator {
        name: "paths in the flat room",
        about: "",
        truth: exact::ROOM_FLOOR,
        rays_per_sample: SEGMENTS,
        sizes: Sizes::Doublings,
        run: |n: u32, seed: u64| {
            let mut world = FlatTracer::new(&room);
            let mut path = |i| f64::from(kajiya.walk(&mut world, &eye, &Stream::new(seed, i, 0)).r);
            (0..n).map(&mut path).sum::<f64>() / f64::from(n)
        },
    };
    let run = converge(&estimator, &design);
    let chart = variance_chart("Paths in the flat room", &[(run, Some(of_one))]);
    let caption = "The mean of N paths follows σ²/N, with the variance σ² that many single paths of the \
                   room showed. Nothing in the law knows how long the paths are.";
    desk.figure("rate.svg", caption, chart.to_svg()?)
}
