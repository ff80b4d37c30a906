//! Exercise 13: density estimation, also where the line ends.
//!
//! Photons have landed on a line from 0 to 1. Each carries the same flux. Estimate the irradiance at a place `at`: the
//! flux of the photons at most `radius` away, over the length on which they could fall.
//!
//! Near an end of the line a part of that window lies beyond it, where no photon can fall. Divide by the part that lies
//! on the line. (To mirror the photons at the end is another cure; the page says where it is wrong.)

use halfdisk::lab::exercises::{self, edge};
use std::process::ExitCode;

/// The irradiance at `at`, from the places of the photons and the flux of each.
pub fn irradiance(photons: &[f64], flux: f64, at: f64, radius: f64) -> f64 {
    // BEGIN SOLUTION
    let found = photons.iter().filter(|x| (*x - at).abs() <= radius).count();
    let length = (at + radius).min(1.0) - (at - radius).max(0.0);
    flux * found as f64 / length
    // END SOLUTION
}

/// What is graded.
pub const ANSWER: edge::Irradiance = irradiance;

fn main() -> ExitCode {
    exercises::main(&edge::exam(), &ANSWER)
}
