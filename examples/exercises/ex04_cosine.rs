//! Exercise 4: the cosine by inversion.
//!
//! Light from above counts more than light from the side, by the cosine with the normal. So draw more directions where
//! the cosine is large. Let θ be the angle from the tangent, between 0 and π; the cosine with the normal is sin θ = `y`.
//!
//! * Find the density: proportional to sin θ, with the integral 1.
//! * Integrate it from 0 to θ. Set the result equal to `u`, and solve for cos θ, which is `x`.
//!
//! Write `sample`, which turns a uniform `u` in [0, 1) into a unit vector, and `pdf`, its density per radian.

use halfdisk::glam::Vec2;
use halfdisk::lab::exercises::{self, cosine, samplers::FlatSampler};
use std::process::ExitCode;

/// Draws a direction of the half disk, proportionally to the cosine with the normal.
pub fn sample(u: f32) -> Vec2 {
    // BEGIN SOLUTION
    // The density sin θ / 2 has the integral (1 - cos θ) / 2.
    let x = 1.0 - 2.0 * u;
    Vec2::new(x, 2.0 * (u * (1.0 - u)).sqrt())
    // END SOLUTION
}

/// The density of a direction, per radian; 0 below the surface.
pub fn pdf(w: Vec2) -> f32 {
    // BEGIN SOLUTION
    0.5 * w.y.max(0.0)
    // END SOLUTION
}

/// What is graded.
pub const ANSWER: FlatSampler = FlatSampler { sample, pdf };

fn main() -> ExitCode {
    exercises::main(&cosine::exam(), &ANSWER)
}
