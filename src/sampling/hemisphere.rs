//! Directions of the hemisphere over a surface, in local coordinates (`z` is the normal).
//!
//! The twin of [`half_disk`](super::half_disk). Angles θ count from the normal, φ around it.

use super::as_uniform;
use crate::numeric;
use glam::Vec3;
use std::f32::consts::{FRAC_1_PI, TAU};

/// Draws a direction of the hemisphere, uniformly in solid angle.
///
/// * Domain: `u` in `[0, 1)²` → unit `ω` with `ω.z > 0`.
/// * Density: `p(ω) = 1 / 2π`, per steradian ([`pdf_uniform`]).
/// * Method: `cos θ = 1 - u` is uniform, as Archimedes found; `sin θ = √(u (2 - u))`.
/// * Source: Shirley, Discrepancy as a Quality Measure for Sample Distributions (Eurographics
///   1991), "Non-uniform sampling".
pub fn sample_uniform(u: [f32; 2]) -> Vec3 {
    let sin = (u[0] * (2.0 - u[0])).sqrt();
    let (sin_phi, cos_phi) = numeric::sin_cos(TAU * u[1]);
    Vec3::new(sin * cos_phi, sin * sin_phi, 1.0 - u[0])
}

/// Density of [`sample_uniform`] at the unit direction `w`, per steradian.
pub fn pdf_uniform(w: Vec3) -> f32 {
    if w.z >= 0.0 { 0.5 * FRAC_1_PI } else { 0.0 }
}

/// The uniforms from which [`sample_uniform`] makes `w`: `1 - cos θ` and `φ / 2π`.
pub fn invert_uniform(w: Vec3) -> [f32; 2] {
    // Near the pole 1 - z has lost its digits, and sin² / (1 + z) has not.
    let one_minus_cos = (w.x * w.x + w.y * w.y) / (1.0 + w.z.max(0.0));
    [as_uniform(one_minus_cos), turn(w)]
}

// ANCHOR: cosine
/// Draws a direction of the upper hemisphere, proportionally to the cosine with the normal.
///
/// * Domain: `u` in `[0, 1)²` → unit `ω` with `ω.z > 0`.
/// * Density: `p(ω) = cos θ / π`, per steradian ([`pdf_cosine`]).
/// * Method: inverse of the distribution function `P(θ) = sin² θ`, as `cos θ = √(1 - u)`, so that
///   no arc cosine is taken and `cos θ` is never zero: `u < 1`.
/// * Source: Shirley, Discrepancy as a Quality Measure for Sample Distributions (Eurographics
///   1991), "Non-uniform sampling"; the slides write it `cos⁻¹ √ξ`.
pub fn sample_cosine(u: [f32; 2]) -> Vec3 {
    let sin = u[0].sqrt();
    let (sin_phi, cos_phi) = numeric::sin_cos(TAU * u[1]);
    Vec3::new(sin * cos_phi, sin * sin_phi, (1.0 - u[0]).sqrt())
}

/// Density of [`sample_cosine`] at the unit direction `w`, per steradian.
pub fn pdf_cosine(w: Vec3) -> f32 {
    w.z.max(0.0) * FRAC_1_PI
}
// ANCHOR_END: cosine

/// The uniforms from which [`sample_cosine`] makes `w`: `sin² θ` and `φ / 2π`.
pub fn invert_cosine(w: Vec3) -> [f32; 2] {
    [as_uniform(w.x * w.x + w.y * w.y), turn(w)]
}

/// Draws a direction of the hemisphere, proportionally to a power of the cosine with the normal.
///
/// * Domain: `u` in `[0, 1)²` and `exponent >= 0` → unit `ω` with `ω.z > 0`.
/// * Density: `p(ω) = (n + 1) cosⁿ θ / 2π`, per steradian ([`pdf_cos_n`]).
/// * Method: inverse of the distribution function `P(θ) = 1 - cosⁿ⁺¹ θ`, as
///   `cos θ = (1 - u)^(1/(n + 1))`; `sin² θ = 1 - cos² θ` without cancelling, by `expm1`.
/// * Source: Lafortune, Willems, Using the Modified Phong Reflectance Model for Physically Based
///   Rendering (Report CW 197, KU Leuven 1994), section 5.
pub fn sample_cos_n(u: [f32; 2], exponent: f32) -> Vec3 {
    debug_assert!(exponent >= 0.0, "exponent {exponent}");
    let log_cos = libm::log1pf(-u[0]) / (exponent + 1.0);
    let sin = (-libm::expm1f(2.0 * log_cos)).sqrt();
    let (sin_phi, cos_phi) = numeric::sin_cos(TAU * u[1]);
    Vec3::new(sin * cos_phi, sin * sin_phi, libm::expf(log_cos))
}

/// Density of [`sample_cos_n`] at the unit direction `w`, per steradian.
pub fn pdf_cos_n(w: Vec3, exponent: f32) -> f32 {
    if w.z < 0.0 {
        return 0.0;
    }
    (exponent + 1.0) * libm::powf(w.z, exponent) * 0.5 * FRAC_1_PI
}

/// The `index`-th of `count` stratified uniforms: a uniform of the `index`-th cell of a grid of
/// `⌊√count⌋²` equal cells; where `count` is no square, the samples left over fall anywhere, which
/// leaves the mean right.
///
/// Each cell gets one sample, so a smooth integrand's error falls as `count^-1`, and one with an
/// edge as `count^(-3/4)`.
///
/// * Domain: `index < count`, `u` in `[0, 1)²`.
/// * Source: Cook, Stochastic Sampling in Computer Graphics (ACM TOG 5(1), 1986), "Jittering a
///   Regular Grid"; Mitchell, Consequences of Stratified Sampling in Graphics (SIGGRAPH 1996).
pub fn stratified(index: u32, count: u32, u: [f32; 2]) -> [f32; 2] {
    let side = count.isqrt();
    if index >= side * side {
        return u;
    }
    let cell = [index / side, index % side];
    [0, 1].map(|k| as_uniform(((f64::from(cell[k]) + f64::from(u[k])) / f64::from(side)) as f32))
}

/// The azimuth of `w` as a share of a full turn.
fn turn(w: Vec3) -> f32 {
    let turn = numeric::atan2(w.y, w.x) / TAU;
    as_uniform(if turn < 0.0 { turn + 1.0 } else { turn })
}
