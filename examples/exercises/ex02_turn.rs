//! Exercise 2: the matrix of step 2.
//!
//! A sampler knows the surface's own axes only: `x` along the surface, `y` along its normal. The ray needs the axes of
//! the world. Write the function that turns a direction from the first to the second, given the surface's unit normal.
//!
//! The tangent is the normal turned to the right by 90 degrees, so an upright normal (0, 1) has the tangent (1, 0).
//!
//! A matrix that is transposed reads the same while the surface is level. So the grader tilts it.

use halfdisk::glam::Vec2;
use halfdisk::lab::exercises::{self, turn};
use std::process::ExitCode;

/// Turns the local direction `w` into world coordinates.
pub fn to_world(normal: Vec2, w: Vec2) -> Vec2 {
    // BEGIN SOLUTION
    let tangent = Vec2::new(normal.y, -normal.x);
    tangent * w.x + normal * w.y
    // END SOLUTION
}

/// What is graded.
pub const ANSWER: turn::ToWorld = to_world;

fn main() -> ExitCode {
    exercises::main(&turn::exam(), &ANSWER)
}
