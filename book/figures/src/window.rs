//! Chapter 16: photons in a window below a lamp, whose bias grows with its radius and whose variance falls.

use crate::of_chapters::window::{LAMP, first_photons, window};
use crate::within;
use halfdisk::flatland::{FlatWorld, gallery};
use halfdisk::glam::Vec2;
use halfdisk::photons::{Kernel, PhotonMap};
use halfdisk::scene::read::Source;
use halfdisk::stats::Estimate;
use std::f64::consts::PI;

/// The radius of the window, in metres.
pub const RADIUS: [f64; 2] = [1.0 / 64.0, 1.0];
/// Walks of each run, and independent runs.
pub const WALKS: u32 = 2000;
const RUNS: u32 = 8;
/// Photons that are drawn.
pub const SHOWN: u32 = 200;

/// Mean and variance of what the window reads; the truth is 1.
pub fn law(radius: f64) -> Vec<f64> {
    let (mean, variance) = window(within(radius, RADIUS), WALKS);
    vec![mean, variance]
}

/// What the first run reads and its standard error; mean and standard error of the squared distance of all runs
/// from the truth; then where on the floor the first walks of the first run left their photons.
pub fn run(radius: f64, seed: u32) -> Vec<f64> {
    let lamp = gallery::from_text(Source {
        file: "lamp.toml",
        text: LAMP,
    });
    // The text is a part of this program, so it can be read.
    lamp.map_or_else(|_| Vec::new(), |lamp| below(&lamp, radius, seed))
}

fn below(lamp: &FlatWorld, radius: f64, seed: u32) -> Vec<f64> {
    let radius = within(radius, RADIUS);
    let mut reads = Vec::new();
    let mut landed = Vec::new();
    for run in 0..RUNS {
        let photons = first_photons(lamp, WALKS, seed.into(), run);
        if run == 0 {
            landed = photons.iter().map(|photon| f64::from(photon.p.x)).collect();
        }
        let disc = radius as f32;
        let map = PhotonMap::new(photons, WALKS, disc, Kernel::Constant);
        let read = map.estimate(Vec2::ZERO, Vec2::Y, disc, |photon| photon.power);
        reads.push(f64::from(read.g));
    }
    let squares: Estimate = reads.iter().map(|read| (read - 1.0).powi(2)).collect();
    let mut numbers = vec![reads[0], error(&landed, radius)];
    numbers.extend([squares.mean(), squares.std_error()]);
    numbers.extend(landed.into_iter().take(SHOWN as usize));
    numbers
}

/// The standard error of a reading, from the share of the walks that landed in the window; unknown where none did.
fn error(landed: &[f64], radius: f64) -> f64 {
    let inside = landed.iter().filter(|x| x.abs() < radius).count();
    if inside == 0 {
        return f64::INFINITY;
    }
    // All photons have the same power. A window that they all fell into would read 2 π over its width.
    Estimate::from_hits(inside as u64, WALKS.into()).std_error() * PI / radius
}
