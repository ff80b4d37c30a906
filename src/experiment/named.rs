//! The estimators one can ask for by name.

use super::convergence::{Estimator, Sizes};
use crate::estimators::directions::Recipe;
use crate::estimators::gather::Gather;
use crate::estimators::mistakes::{Exam, variants};
use crate::estimators::{hit_or_miss, many_dimensions, worlds};
use crate::sampling::stream::{Numbers, Purpose, Stream};
use crate::space::{Flat, Solid, Space};
use std::f64::consts::PI;

/// All of them, in the order in which they are listed.
pub fn all() -> Vec<Estimator> {
    [integrals(), lamps(), furnaces(), dimensions()]
        .into_iter()
        .flatten()
        .collect()
}

/// The estimator of this name.
pub fn find(name: &str) -> Option<Estimator> {
    all().into_iter().find(|estimator| estimator.name == name)
}

fn estimator(
    name: &'static str,
    about: &'static str,
    truth: f64,
    run: fn(u32, u64) -> f64,
) -> Estimator {
    Estimator {
        name,
        about,
        truth,
        rays_per_sample: 1,
        sizes: Sizes::Doublings,
        run,
    }
}

/// The same for an estimator that needs a square number of samples.
fn on_squares(estimator: Estimator) -> Estimator {
    Estimator {
        sizes: Sizes::Squares,
        ..estimator
    }
}

fn integrals() -> Vec<Estimator> {
    vec![
        estimator("darts", "pi by darts at the quarter disc", PI, |n, seed| {
            hit_or_miss::darts(n, seed).mean()
        }),
        estimator(
            "sample-mean",
            "pi as the mean height of the quarter disc",
            PI,
            |n, seed| hit_or_miss::sample_mean(n, seed).mean(),
        ),
        on_squares(estimator(
            "jittered-darts",
            "pi by one dart in each cell of a grid",
            PI,
            hit_or_miss::jittered_darts,
        )),
        estimator(
            "midpoints",
            "pi by heights at the middles of equal steps",
            PI,
            |n, _| hit_or_miss::midpoints(n),
        ),
        estimator(
            "step",
            "the integral of a function with a jump",
            hit_or_miss::STEP,
            |n, seed| hit_or_miss::step(n, seed).mean(),
        ),
    ]
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

fn lamps() -> Vec<Estimator> {
    let truth = 0.5 * (libm::sin(f64::from(1.0_f32)) - libm::sin(f64::from(0.2_f32)));
    vec![
        estimator(
            "half-disk-lamp",
            "flat world: a strip of light, uniform directions",
            truth,
            |n, seed| lamp::<Flat>(Recipe::Uniform, n, seed),
        ),
        estimator(
            "half-disk-lamp-cosine",
            "flat world: a strip of light, cosine directions",
            truth,
            |n, seed| lamp::<Flat>(Recipe::Cosine, n, seed),
        ),
        estimator(
            "hemisphere-lamp",
            "space: a strip of light, uniform directions",
            truth,
            |n, seed| lamp::<Solid>(Recipe::Uniform, n, seed),
        ),
        estimator(
            "hemisphere-lamp-cosine",
            "space: a strip of light, cosine directions",
            truth,
            |n, seed| lamp::<Solid>(Recipe::Cosine, n, seed),
        ),
        on_squares(estimator(
            "hemisphere-lamp-stratified",
            "space: a strip of light, one uniform direction in each cell of a grid",
            truth,
            |n, seed| lamp::<Solid>(Recipe::Stratified, n, seed),
        )),
    ]
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

fn furnaces() -> Vec<Estimator> {
    vec![
        estimator(
            "half-disk",
            "flat world: a white sky, uniform directions",
            1.0,
            |n, seed| furnace::<Flat>(Recipe::Uniform, n, seed),
        ),
        estimator(
            "half-disk-stratified",
            "flat world: a white sky, one uniform direction in each part",
            1.0,
            |n, seed| furnace::<Flat>(Recipe::Stratified, n, seed),
        ),
        estimator(
            "half-disk-literal",
            "flat world: the essay's formula as printed",
            1.0,
            |n, seed| variant(variants::as_printed::<Flat>, n, seed),
        ),
        estimator(
            "hemisphere",
            "space: a white sky, uniform directions",
            1.0,
            |n, seed| furnace::<Solid>(Recipe::Uniform, n, seed),
        ),
        on_squares(estimator(
            "hemisphere-stratified",
            "space: a white sky, one uniform direction in each cell of a grid",
            1.0,
            |n, seed| furnace::<Solid>(Recipe::Stratified, n, seed),
        )),
        estimator(
            "hemisphere-literal",
            "space: the essay's formula as printed",
            1.0,
            |n, seed| variant(variants::as_printed::<Solid>, n, seed),
        ),
    ]
}

fn dimensions() -> Vec<Estimator> {
    macro_rules! product {
        ($($d:literal)*) => {
            vec![$(estimator(
                concat!("product-", $d),
                concat!("a product of ", $d, " sines over the unit cube, by chance"),
                1.0,
                |n, seed| many_dimensions::monte_carlo($d, n, seed).mean(),
            )),*]
        };
    }
    product![1 2 3 4 5 6 7 8]
}
