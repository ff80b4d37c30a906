//! Chapter 03: π by any number of darts, with its error bar.

use crate::within;
use halfdisk::lab::estimators::hit_or_miss;

/// How many darts are thrown.
pub const DARTS: [f64; 2] = [32.0, 131_072.0];
/// Darts that are drawn at most.
pub const SHOWN: u32 = 400;

fn count(darts: f64) -> u32 {
    within(darts, DARTS).round() as u32
}

/// The estimate of π, and its standard error.
pub fn run(darts: f64, seed: u32) -> Vec<f64> {
    let pi = hit_or_miss::darts(count(darts), seed.into());
    vec![pi.mean(), pi.std_error()]
}

/// The first darts of [`run`], at most [`SHOWN`]: `x`, `y`, and the score, 4 or 0.
pub fn board(darts: f64, seed: u32) -> Vec<f64> {
    let thrown = hit_or_miss::thrown(count(darts).min(SHOWN), seed.into());
    thrown.flat_map(|([x, y], score)| [x, y, score]).collect()
}
