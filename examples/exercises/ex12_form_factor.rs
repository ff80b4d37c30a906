//! Exercise 12: a form factor by crossed strings.
//!
//! Which share of the light that leaves one wall of the flat world arrives at another? Hottel's rule says: stretch four
//! strings between their ends. Two of them cross. The form factor is the length of the crossed strings, less that of
//! the others, over twice the length of the wall that the light leaves.
//!
//! Each wall is given by its two ends. Its front is on the left of the way from the first to the second, and the walls
//! face each other: go around a room counterclockwise, and you meet the ends in this order.

use halfdisk::glam::DVec2;
use halfdisk::lab::exercises::{self, form_factor};
use std::process::ExitCode;

/// The form factor from wall `a` to wall `b`, which nothing hides.
pub fn from_to(a: [DVec2; 2], b: [DVec2; 2]) -> f64 {
    // BEGIN SOLUTION
    let crossed = a[0].distance(b[0]) + a[1].distance(b[1]);
    let others = a[0].distance(b[1]) + a[1].distance(b[0]);
    (crossed - others) / (2.0 * a[0].distance(a[1]))
    // END SOLUTION
}

/// What is graded.
pub const ANSWER: form_factor::FormFactor = from_to;

fn main() -> ExitCode {
    exercises::main(&form_factor::exam(), &ANSWER)
}
