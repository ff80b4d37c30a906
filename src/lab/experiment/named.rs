//! The estimators one can ask for by name.

use super::convergence::{Estimator, Sizes};
use crate::lab::estimators::directions::Recipe;
use crate::lab::estimators::gather::Gather;
use crate::lab::estimators::{hit_or_miss, many_dimensions, worlds};
use crate::lab::mistakes::{Exam, variants};
use crate::sampling::stream::{Numbers, Purpose, Stream};
use crate::space::{Flat, Solid, Space};
use std::f64::consts::PI;

/// Estimators: name, what it does, truth, sizes, and the estimate.
macro_rules! estimators {
    ($($name:expr, $about:expr, $truth:expr, $sizes:ident, $run:expr;)*) => {
        vec![$(Estimator::<fn(u32, u64) -> f64> {
            name: $name,
            about: $about,
            truth: $truth,
            rays_per_sample: 1,
            sizes: Sizes::$sizes,
            run: $run,
        }),*]
    };
}

/// Products of sines over unit cubes.
macro_rules! products {
    ($($d:literal)*) => {
        estimators![$(
            concat!("product-", $d),
            concat!("a product of ", $d, " sines over the unit cube, by chance"),
            1.0, Doublings, |n, seed| many_dimensions::monte_carlo($d, n, seed).mean();
        )*]
    };
}

/// The estimator of this name.
pub fn find(name: &str) -> Option<Estimator> {
    all().into_iter().find(|estimator| estimator.name == name)
}

/// All of them, in the order in which they are listed.
pub fn all() -> Vec<Estimator> {
    let strip = 0.5 * (libm::sin(f64::from(1.0_f32)) - libm::sin(f64::from(0.2_f32)));
    let mut all = estimators! {
        "darts", "pi by darts at the quarter disc",
            PI, Doublings, |n, seed| hit_or_miss::darts(n, seed).mean();
        "sample-mean", "pi as the mean height of the quarter disc",
            PI, Doublings, |n, seed| hit_or_miss::sample_mean(n, seed).mean();
        "jittered-darts", "pi by one dart in each cell of a grid",
            PI, Squares, hit_or_miss::jittered_darts;
        "midpoints", "pi by heights at the middles of equal steps",
            PI, Doublings, |n, _| hit_or_miss::midpoints(n);
        "step", "the integral of a function with a jump",
            hit_or_miss::STEP, Doublings, |n, seed| hit_or_miss::step(n, seed).mean();

        "half-disk-lamp", "flat world: a strip of light, uniform directions",
            strip, Doublings, |n, seed| lamp::<Flat>(Recipe::Uniform, n, seed);
        "half-disk-lamp-cosine", "flat world: a strip of light, cosine directions",
            strip, Doublings, |n, seed| lamp::<Flat>(Recipe::Cosine, n, seed);
        "hemisphere-lamp", "space: a strip of light, uniform directions",
            strip, Doublings, |n, seed| lamp::<Solid>(Recipe::Uniform, n, seed);
        "hemisphere-lamp-cosine", "space: a strip of light, cosine directions",
            strip, Doublings, |n, seed| lamp::<Solid>(Recipe::Cosine, n, seed);
        "hemisphere-lamp-stratified",
            "space: a strip of light, one uniform direction in each cell of a grid",
            strip, Squares, |n, seed| lamp::<Solid>(Recipe::Stratified, n, seed);

        "half-disk", "flat world: a white sky, uniform directions",
            1.0, Doublings, |n, seed| furnace::<Flat>(Recipe::Uniform, n, seed);
        "half-disk-stratified", "flat world: a white sky, one uniform direction in each part",
            1.0, Doublings, |n, seed| furnace::<Flat>(Recipe::Stratified, n, seed);
        "half-disk-literal", "flat world: the essay's formula as printed",
            1.0, Doublings, |n, seed| variant(variants::as_printed::<Flat>, n, seed);
        "hemisphere", "space: a white sky, uniform directions",
            1.0, Doublings, |n, seed| furnace::<Solid>(Recipe::Uniform, n, seed);
        "hemisphere-stratified", "space: a white sky, one uniform direction in each cell of a grid",
            1.0, Squares, |n, seed| furnace::<Solid>(Recipe::Stratified, n, seed);
        "hemisphere-literal", "space: the essay's formula as printed",
            1.0, Doublings, |n, seed| variant(variants::as_printed::<Solid>, n, seed);
    };
    all.extend(products![1 2 3 4 5 6 7 8]);
    all
}

/// One gather of `n` directions under a strip of light, from 0.2 to 1 radian off the normal.
fn lamp<S: Space>(recipe: Recipe, n: u32, seed: u64) -> f64 {
    let gather = Gather {
        samples: n,
        depth: 1,
        recipe,
    };
    let (floor, stream) = (worlds::floor::<S>(1.0), Stream::new(seed, 0, 0));
    f64::from(
        gather
            .reflected(&mut worlds::strip::<S>(0.2, 1.0), &floor, &stream)
            .r,
    )
}

/// One gather of `n` directions under a white sky.
fn furnace<S: Space>(recipe: Recipe, n: u32, seed: u64) -> f64 {
    let gather = Gather {
        samples: n,
        depth: 1,
        recipe,
    };
    let (floor, stream) = (worlds::floor::<S>(1.0), Stream::new(seed, 0, 0));
    f64::from(
        gather
            .reflected(&mut worlds::white::<S>(), &floor, &stream)
            .r,
    )
}

/// One gather of `n` directions by a variant of the list of mistakes.
fn variant(gather: fn(&Exam, &mut Numbers) -> f64, n: u32, seed: u64) -> f64 {
    let exam = Exam {
        samples: n,
        ..Exam::default()
    };
    gather(
        &exam,
        &mut Stream::new(seed, 0, 0).at(0, Purpose::Direction),
    )
}
