//! Exercise 6: which ray?
//!
//! A surface scatters the share k[0] of the light, mirrors k[1] and lets through k[2]; what is left is absorbed. One
//! ray shall follow one of the three. Write the function that chooses, with probabilities proportional to the shares,
//! and gives the number of the part (0, 1 or 2) and the weight of what its ray brings.
//!
//! The uniform `u` lies in [0, 1), both 0 and the number just below 1 included. A part without a share is never chosen.
//! At least one share is above 0.

use halfdisk::lab::exercises::{self, choose};
use std::process::ExitCode;

/// Chooses a part: its number, and its weight.
pub fn choose_part(k: [f64; 3], u: f64) -> (usize, f64) {
    // BEGIN SOLUTION
    let total: f64 = k.iter().sum();
    let r = u * total;
    // k/p is the same for all parts: the sum of the shares.
    let part = match r {
        r if r < k[0] => 0,
        r if r < k[0] + k[1] => 1,
        _ => 2,
    };
    (part, total)
    // END SOLUTION
}

/// What is graded.
pub const ANSWER: choose::Choose = choose_part;

fn main() -> ExitCode {
    exercises::main(&choose::exam(), &ANSWER)
}
