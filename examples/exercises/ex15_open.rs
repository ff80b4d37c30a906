//! Exercise 15, an open one: beat a price.
//!
//! A sky of the flat world gets brighter to one side, and a lamp stands in it. You know where the lamp is: from the
//! angle `sky.lamp[0]` to `sky.lamp[1]`, counted from the tangent (1, 0), in radians. How bright lamp and sky are you
//! can only look up: `sky.look(w)` is the radiance in a direction.
//!
//! Estimate the irradiance, the integral of radiance times cosine over the half disk. Look as often as you like, in any
//! directions that you like. The mean must be right. The price of an answer is its variance times its number of looks,
//! and yours must be at most a twentieth of that of one uniform direction, under this sky and under another one.
//!
//! How low can you get? The right answer is told its price.

use halfdisk::glam::Vec2;
use halfdisk::lab::exercises::{self, open};
use halfdisk::sampling::stream::Numbers;
use open::Sky;
use std::process::ExitCode;

/// One estimate of the irradiance.
pub fn irradiance(sky: &mut Sky, random: &mut Numbers) -> f64 {
    // BEGIN SOLUTION
    // Two integrals: the lamp's angles, and all others. The cosine with the normal is sin θ, so 1 − cos θ is uniform
    // where directions follow it.
    let [from, to] = sky.lamp;
    let mut sum = 0.0;
    for [from, to] in [[0.0, from], [from, to], [to, std::f32::consts::PI]] {
        let (first, last) = (from.cos(), to.cos());
        let cos = first + (last - first) * random.one();
        let w = Vec2::new(cos, (1.0 - cos * cos).max(0.0).sqrt());
        // Radiance times cosine over its density: the integral of the cosine.
        sum += sky.look(w) * f64::from(first - last);
    }
    sum
    // END SOLUTION
}

/// What is graded.
pub const ANSWER: open::Irradiance = irradiance;

fn main() -> ExitCode {
    exercises::main(&open::exam(), &ANSWER)
}
