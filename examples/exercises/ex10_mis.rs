//! Exercise 10: multiple importance sampling.
//!
//! A lamp hangs over a white floor of the flat world. Two techniques find it: chance, whose directions follow the
//! cosine, and aiming, whose directions all meet the lamp. Draw one direction by each, and combine both into one
//! estimate of the light that the floor reflects.
//!
//! * `lamp.sample_chance(u)` and `lamp.sample_aim(u)` draw an angle from a uniform.
//! * `lamp.pdf(theta)` gives the densities of an angle by both techniques: `[chance, aiming]`.
//! * `lamp.integrand(theta)` is the light from there that the floor reflects; 0 beside the lamp.
//!
//! The mean must be right for every lamp. The variance must be as small as that of the balance or the power heuristic,
//! for a small lamp and for a large one.

use halfdisk::lab::estimators::overhead::Overhead;
use halfdisk::lab::exercises::{self, mis};
use std::process::ExitCode;

/// One estimate from two uniforms: the first for chance, the second for aiming.
pub fn estimate(lamp: &Overhead, u: [f64; 2]) -> f64 {
    // BEGIN SOLUTION
    let met = lamp.sample_chance(u[0]);
    let [own, other] = lamp.pdf(met);
    // w f / p with w = p / (p + q): the density cancels.
    let by_chance = lamp.integrand(met) / (own + other);

    let aimed = lamp.sample_aim(u[1]);
    let [other, own] = lamp.pdf(aimed);
    let by_aiming = lamp.integrand(aimed) / (own + other);
    by_chance + by_aiming
    // END SOLUTION
}

/// What is graded.
pub const ANSWER: mis::Both = estimate;

fn main() -> ExitCode {
    exercises::main(&mis::exam(), &ANSWER)
}
