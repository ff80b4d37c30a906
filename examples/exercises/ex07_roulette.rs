//! Exercise 7: Russian roulette.
//!
//! A closed room without geometry: whatever a path meets emits 1 and reflects the share `rho`. Follow a path that goes
//! on at each wall with the probability `q` and ends otherwise. Its mean must be 1 / (1 − ρ), with no longest path.
//!
//! `random.fine()` gives the next uniform in [0, 1). Take one of them for each decision.
//!
//! The grader compares means and variances with their closed forms at several ρ and q.

use halfdisk::lab::exercises::{self, roulette};
use halfdisk::sampling::stream::Numbers;
use std::process::ExitCode;

/// The light that one path brings.
pub fn path(rho: f64, q: f64, random: &mut Numbers) -> f64 {
    // BEGIN SOLUTION
    let (mut li, mut beta) = (0.0, 1.0);
    loop {
        li += beta;
        if random.fine() >= q {
            return li;
        }
        // The reflected light, and 1/q for those that ended.
        beta *= rho / q;
    }
    // END SOLUTION
}

/// What is graded.
pub const ANSWER: roulette::Path = path;

fn main() -> ExitCode {
    exercises::main(&roulette::exam(), &ANSWER)
}
