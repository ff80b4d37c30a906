//! Exercise 14: a sum that remembers.
//!
//! Add up a million tenths in single precision, and the mean is off in the third digit: each addition rounds to the
//! spacing of the sum. Write the mean of samples with sums in `f32` only, right to six digits.
//!
//! What an addition has lost can be found: after `next = sum + x`, the number `(next - sum) - x` says exactly how much
//! too much was added. Give it back with the next term.
//!
//! Source: Kahan, Further Remarks on Reducing Truncation Errors (Communications of the ACM 8(1), 1965).

use halfdisk::lab::exercises::{self, compensated};
use std::process::ExitCode;

/// The mean of at least one sample.
pub fn mean(samples: &[f32]) -> f32 {
    // BEGIN SOLUTION
    let (mut sum, mut lost) = (0.0_f32, 0.0_f32);
    for x in samples {
        let x = x - lost;
        let next = sum + x;
        lost = (next - sum) - x;
        sum = next;
    }
    sum / samples.len() as f32
    // END SOLUTION
}

/// What is graded.
pub const ANSWER: compensated::Mean = mean;

fn main() -> ExitCode {
    exercises::main(&compensated::exam(), &ANSWER)
}
