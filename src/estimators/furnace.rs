//! The furnace: where everything glows alike, every right estimator reads the same.
//!
//! A furnace has no shapes to look at, so a wrong constant has nowhere to hide. Open: a surface
//! under a white sky reflects its albedo. Closed: in a room of glowing walls bounce `k` adds
//! `albedo^k`.

use super::directions::Recipe;
use super::gather::Gather;
use super::worlds::{self, Furnace};
use crate::sampling::stream::Stream;
use crate::space::{Ray, Space};
use crate::stats::Estimate;
use glam::Vec2;

/// What a surface of `albedo` reflects under a white sky, by `gathers` gathers of `samples`
/// directions each. The truth is the albedo.
///
/// One direction of a uniform gather has a standard deviation of `√(π²/8 - 1) = 0.4834` times the
/// albedo in the flat world and `1/√3` in space; a cosine gather has none.
pub fn open<S: Space>(
    recipe: Recipe,
    albedo: f32,
    samples: u32,
    gathers: u32,
    seed: u64,
) -> Estimate {
    let gather = Gather {
        samples,
        depth: 1,
        recipe,
    };
    let floor = worlds::floor::<S>(albedo);
    (0..gathers)
        .map(|i| {
            let stream = Stream::new(seed, i, 0);
            f64::from(gather.reflected(&mut worlds::white::<S>(), &floor, &stream))
        })
        .collect()
}

/// Radiance of a closed furnace with at most `depth` bounces, by `walks` random walks: a gather
/// with one direction at each surface. The truth is [`Furnace::radiance`].
pub fn closed<S: Space>(
    recipe: Recipe,
    albedo: f32,
    depth: u32,
    walks: u32,
    seed: u64,
) -> Estimate {
    let walk = Gather {
        samples: 1,
        depth,
        recipe,
    };
    let eye = Ray::<S> {
        origin: S::from_plane(Vec2::ZERO),
        direction: S::from_plane(Vec2::Y),
    };
    (0..walks)
        .map(|i| {
            let stream = Stream::new(seed, i, 0);
            f64::from(walk.li(&mut Furnace { albedo }, &eye, &stream))
        })
        .collect()
}
