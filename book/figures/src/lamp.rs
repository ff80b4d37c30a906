//! Chapter 11: a lamp of any size over a floor, found by chance, by aiming, and by both.

use crate::within;
use halfdisk::lab::estimators::overhead::{Overhead, Technique};
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::stats::Estimate;

/// Half of the angle at which the lamp is seen, in radians.
pub const HALF_ANGLE: [f64; 2] = [0.01, 1.5];
/// The ways to find it, in the order of all lists.
pub const WAYS: [Technique; 4] = [
    Technique::Chance,
    Technique::Aiming,
    Technique::Both(Heuristic::Balance),
    Technique::Both(Heuristic::Power),
];
/// Samples of each way behind its mean.
const SAMPLES: u32 = 400;
/// Directions of each technique that are drawn.
pub const RAYS: u32 = 24;

/// The radiance of the floor, and the variance of one sample by each of [`WAYS`]; then the bound for the third of them, and
/// what somebody would reach who knows the better of the first two.
pub fn law(half_angle: f64) -> Vec<f64> {
    let lamp = Overhead::new(within(half_angle, HALF_ANGLE));
    let variances = WAYS.map(|way| lamp.variance(way));
    [
        &[lamp.mean()],
        &variances[..],
        &[lamp.bound(), lamp.oracle()],
    ]
    .concat()
}

/// For each of [`WAYS`] mean and standard error of the floor's radiance, and the variance of one sample; then [`RAYS`] angles of directions by chance,
/// and as many of directions to the lamp, in radians from the normal.
pub fn run(half_angle: f64, seed: u32) -> Vec<f64> {
    let lamp = Overhead::new(within(half_angle, HALF_ANGLE));
    let pair = |i| {
        let mut numbers = Stream::new(seed.into(), i, 0).at(0, Purpose::Integrand);
        numbers.two().map(f64::from)
    };
    let mut numbers = Vec::new();
    for way in WAYS {
        let read: Estimate = (0..SAMPLES).map(|i| lamp.estimate(way, pair(i))).collect();
        numbers.extend([read.mean(), read.std_error(), read.variance()]);
    }
    numbers.extend((0..RAYS).map(|i| lamp.sample_chance(pair(i)[0])));
    numbers.extend((0..RAYS).map(|i| lamp.sample_aim(pair(i)[1])));
    numbers
}
