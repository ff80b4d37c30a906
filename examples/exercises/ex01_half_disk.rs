//! Exercise 1: a direction of the half disk.
//!
//! A point on a surface of the flat world sees a half disk of directions. Draw one of them, uniformly in angle, and
//! state its density. Write both functions:
//!
//! * `sample` turns a uniform `u` in [0, 1) into a unit vector. `x` goes along the surface, `y` along its normal, so
//!   `y` is never below 0.
//! * `pdf` gives the density of a unit vector, per radian. It is 0 below the surface.
//!
//! The grader reads means over your directions, integrates your density, and compares the two with a chi-square test.

use halfdisk::glam::Vec2;
use halfdisk::lab::exercises::{self, half_disk, samplers::FlatSampler};
use std::f32::consts::{FRAC_1_PI, PI};
use std::process::ExitCode;

/// Draws a direction of the half disk, uniformly in angle.
pub fn sample(u: f32) -> Vec2 {
    // BEGIN SOLUTION
    let theta = PI * u;
    Vec2::new(theta.cos(), theta.sin())
    // END SOLUTION
}

/// The density of a direction, per radian.
pub fn pdf(w: Vec2) -> f32 {
    // BEGIN SOLUTION
    if w.y >= 0.0 { FRAC_1_PI } else { 0.0 }
    // END SOLUTION
}

/// What is graded.
pub const ANSWER: FlatSampler = FlatSampler { sample, pdf };

fn main() -> ExitCode {
    exercises::main(&half_disk::exam(), &ANSWER)
}
