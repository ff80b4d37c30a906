//! Exercise 8: a spherical lamp by solid angle.
//!
//! A ball of radius `r` shines at the distance `d` from here, to its centre. From outside it is seen in a cone of
//! directions around the z axis. Draw one of them, uniformly in solid angle.
//!
//! Write `sample`, which turns two uniforms in [0, 1) into a unit vector that meets the ball, and `pdf`, the density of
//! all these directions, per steradian.
//!
//! The grader also asks about a tiny lamp: d = 1000 and r = 0.1. Mind what is left of 1 − cos in single precision.

use halfdisk::glam::Vec3;
use halfdisk::lab::exercises::{self, sphere_lamp};
use std::f32::consts::TAU;
use std::process::ExitCode;

/// Draws a direction to the ball, uniformly in solid angle.
pub fn sample(d: f32, r: f32, u: [f32; 2]) -> Vec3 {
    // BEGIN SOLUTION
    let one_minus_cos = u[0] * cap(d, r);
    let sin = (one_minus_cos * (2.0 - one_minus_cos)).sqrt();
    let (sin_phi, cos_phi) = (TAU * u[1]).sin_cos();
    Vec3::new(sin * cos_phi, sin * sin_phi, 1.0 - one_minus_cos)
    // END SOLUTION
}

/// The density of these directions, per steradian.
pub fn pdf(d: f32, r: f32) -> f32 {
    // BEGIN SOLUTION
    1.0 / (TAU * cap(d, r))
    // END SOLUTION
}

/// A function for both of them: 1 − cos θ_max.
pub fn cap(d: f32, r: f32) -> f32 {
    // BEGIN SOLUTION
    let sin2 = (r / d) * (r / d);
    // 1 - cos = sin² / (1 + cos), in which nothing cancels.
    sin2 / (1.0 + (1.0 - sin2).sqrt())
    // END SOLUTION
}

/// What is graded.
pub const ANSWER: sphere_lamp::Cone = sphere_lamp::Cone { sample, pdf };

fn main() -> ExitCode {
    exercises::main(&sphere_lamp::exam(), &ANSWER)
}
