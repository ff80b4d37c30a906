//! Exercise 5: Malley's method.
//!
//! In space the same density, proportional to the cosine, comes by a shortcut: draw a point of the unit disk, uniformly
//! in area, and lift it to the hemisphere above. Here `z` is the normal.
//!
//! Write `sample`, which turns two uniforms in [0, 1) into a unit vector with `z` not below 0, and `pdf`, its density
//! per steradian; it is 0 below the surface.

use halfdisk::glam::Vec3;
use halfdisk::lab::exercises::{self, malley, samplers::SolidSampler};
use std::f32::consts::{FRAC_1_PI, TAU};
use std::process::ExitCode;

/// Draws a direction of the hemisphere, proportionally to the cosine with the normal.
pub fn sample(u: [f32; 2]) -> Vec3 {
    // BEGIN SOLUTION
    let r = u[0].sqrt();
    let (sin, cos) = (TAU * u[1]).sin_cos();
    Vec3::new(r * cos, r * sin, (1.0 - u[0]).sqrt())
    // END SOLUTION
}

/// The density of a direction, per steradian.
pub fn pdf(w: Vec3) -> f32 {
    // BEGIN SOLUTION
    w.z.max(0.0) * FRAC_1_PI
    // END SOLUTION
}

/// What is graded.
pub const ANSWER: SolidSampler = SolidSampler { sample, pdf };

fn main() -> ExitCode {
    exercises::main(&malley::exam(), &ANSWER)
}
