//! The furnace: where everything glows alike, every right estimator reads the same.
//!
//! A furnace has no shapes to look at, so a wrong constant has nowhere to hide. Open: a surface
//! under a white sky reflects its albedo. Closed: in a room of glowing walls bounce `k` adds
//! `albedo^k`.

use super::directions::Recipe;
use super::gather::Gather;
use super::worlds::{self, Furnace, Lit};
use crate::integrators::world::World;
use crate::sampling::stream::Stream;
use crate::space::Space;
use crate::stats::Estimate;

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
            f64::from(
                gather
                    .reflected(&mut worlds::white::<S>(), &floor, &stream)
                    .r,
            )
        })
        .collect()
}

/// What bounce `bounce` adds in a closed furnace, by `walks` random walks. The truth is
/// `albedo^bounce`.
pub fn bounce<S: Space>(
    recipe: Recipe,
    albedo: f32,
    bounce: u32,
    walks: u32,
    seed: u64,
) -> Estimate {
    // The same walk with and without its last step: the difference is the step's light alone.
    let walk = |depth, i| radiance::<S>(recipe, albedo, depth, &Stream::new(seed, i, 0));
    (0..walks)
        .map(|i| match bounce {
            0 => walk(0, i),
            k => walk(k, i) - walk(k - 1, i),
        })
        .collect()
}

/// Irradiance `∫ L cos θ dω` of a floor under a sky, by `samples` uniform directions.
pub fn irradiance<S: Space, W: World<S, Point = Lit<S>>>(
    mut sky: W,
    samples: u32,
    seed: u64,
) -> Estimate {
    let gather = Gather {
        samples: 1,
        depth: 1,
        recipe: Recipe::Uniform,
    };
    // A white floor reflects LAMBERT of it.
    let floor = worlds::floor::<S>(1.0);
    (0..samples)
        .map(|i| {
            let reflected = gather.reflected(&mut sky, &floor, &Stream::new(seed, i, 0));
            f64::from(reflected.r) / f64::from(S::LAMBERT)
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
    (0..walks)
        .map(|i| radiance::<S>(recipe, albedo, depth, &Stream::new(seed, i, 0)))
        .collect()
}

/// One random walk of a closed furnace.
fn radiance<S: Space>(recipe: Recipe, albedo: f32, depth: u32, stream: &Stream) -> f64 {
    let walk = Gather {
        samples: 1,
        depth,
        recipe,
    };
    let li = walk.li(&mut Furnace { albedo }, &Furnace::eye::<S>(), stream);
    f64::from(li.r)
}
