//! Exercise 11: light paths as expressions.
//!
//! A light path is a word: `L` for the light, then `D` for each diffuse and `S` for each specular surface, then `E` for
//! the eye. An expression stands for many words: `S*` is any number of mirrors, `S+` at least one, `D?` at most one
//! diffuse surface, `(D|S)` either of the two.
//!
//! Write two expressions:
//!
//! * what Whitted's ray tracing finds: it follows mirrors and glass from the eye, and asks the lights at the first
//!   diffuse surface;
//! * caustics that are seen in mirrors or glass: light that comes by mirrors or glass to a diffuse surface, and from
//!   there by mirrors or glass to the eye.
//!
//! The grader compares all words with at most six surfaces.

use halfdisk::lab::exercises::{self, paths};
use std::process::ExitCode;

/// What Whitted's ray tracing finds.
pub fn whitted() -> &'static str {
    // BEGIN SOLUTION
    "LD?S*E"
    // END SOLUTION
}

/// Caustics that are seen in mirrors or glass.
pub fn mirrored_caustic() -> &'static str {
    // BEGIN SOLUTION
    "LS+DS+E"
    // END SOLUTION
}

/// What is graded.
pub const ANSWER: paths::Paths = paths::Paths {
    whitted,
    mirrored_caustic,
};

fn main() -> ExitCode {
    exercises::main(&paths::exam(), &ANSWER)
}
