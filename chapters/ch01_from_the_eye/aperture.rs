//! How many of a lamp's rays enter an eye?
//!
//! A point lamp sends rays everywhere; the eye is a slit (in the flat world) or a round hole (in
//! space) that faces it. Most rays miss, and a pinhole is missed by all of them.

use halfdisk::sampling::stream::{Numbers, Purpose, Stream};
use halfdisk::sampling::warps;
use halfdisk::{numeric, stats::Estimate};
use std::f64::consts::PI;

/// The chance that a ray of the flat world enters a slit of `width` at `distance`:
/// the angle of the slit, `2 atan(w / 2d)`, out of `2π`.
pub fn slit_chance(width: f64, distance: f64) -> f64 {
    libm::atan(width / (2.0 * distance)) / PI
}

/// The chance that a ray in space enters a disc of `radius` at `distance`:
/// the solid angle of the disc, `2π (1 - cos θ)` with `cos θ = d / √(d² + r²)`, out of `4π`.
pub fn disc_chance(radius: f64, distance: f64) -> f64 {
    let slant = (distance * distance + radius * radius).sqrt();
    // 1 - d / s = (s² - d²) / (s (s + d)), in which nothing cancels for small discs.
    0.5 * radius * radius / (slant * (slant + distance))
}

// ANCHOR: count
/// Sends `rays` rays from a lamp of the flat world and counts those that enter the slit.
pub fn count_through_slit(width: f32, distance: f32, rays: u32, seed: u64) -> Estimate {
    count(rays, seed, |numbers| {
        let (sin, cos) = numeric::sin_cos(std::f32::consts::TAU * numbers.one());
        cos > 0.0 && sin.abs() * distance < 0.5 * width * cos
    })
}

/// Sends `rays` rays from a lamp in space and counts those that enter the disc.
pub fn count_through_disc(radius: f32, distance: f32, rays: u32, seed: u64) -> Estimate {
    count(rays, seed, |numbers| {
        let w = warps::sample_sphere(numbers.two());
        w.z > 0.0 && w.truncate().length() * distance < radius * w.z
    })
}
// ANCHOR_END: count

fn count(rays: u32, seed: u64, enters: impl Fn(&mut Numbers) -> bool) -> Estimate {
    let hits = (0..rays)
        .filter(|&ray| enters(&mut Stream::new(seed, ray, 0).at(0, Purpose::Emission)))
        .count();
    Estimate::from_hits(hits as u64, u64::from(rays))
}
