//! Directions of the half disk over a surface of the flat world, in local coordinates (`y` is the
//! normal, `x` the tangent).
//!
//! The twin of [`hemisphere`](super::hemisphere). Angles θ count from the tangent, from 0 to π, so
//! the cosine with the normal is `sin θ = ω.y`.

use super::as_uniform;
use crate::numeric;
use glam::Vec2;
use std::f32::consts::{FRAC_1_PI, PI};

/// Draws a direction of the half disk, uniformly in angle.
///
/// * Domain: `u` in `[0, 1)` → unit `ω = (cos θ, sin θ)`, θ in `[0, π)`, `ω.y >= 0`.
/// * Density: `p(ω) = 1 / π`, per radian ([`pdf_uniform`]).
/// * Method: `θ = π u`. The angle is taken from the nearer end, `π (1 - u)` in the second half:
///   `π u` rounds, and near π its rounding is as large as its sine.
/// * Source: the essay's first step. A uniform point of the half disk has the same law of angles.
pub fn sample_uniform(u: f32) -> Vec2 {
    let from_nearer_end = u.min(1.0 - u);
    let (sin, cos) = numeric::sin_cos(PI * from_nearer_end);
    Vec2::new(if u < 0.5 { cos } else { -cos }, sin)
}

/// Density of [`sample_uniform`] at the unit direction `w`, per radian.
pub fn pdf_uniform(w: Vec2) -> f32 {
    if w.y >= 0.0 { FRAC_1_PI } else { 0.0 }
}

/// The uniform from which [`sample_uniform`] makes `w`: `θ / π`.
pub fn invert_uniform(w: Vec2) -> f32 {
    as_uniform(numeric::atan2(w.y.max(0.0), w.x) * FRAC_1_PI)
}

/// Draws a direction of the half disk, proportionally to the cosine with the normal.
///
/// * Domain: `u` in `[0, 1)` → unit `ω` with `ω.y > 0`.
/// * Density: `p(ω) = ω.y / 2`, per radian ([`pdf_cosine`]).
/// * Method: inverse of the distribution function `P(θ) = (1 - cos θ) / 2`, as
///   `cos θ = 1 - 2u` and `sin θ = 2 √(u (1 - u))`; `√(1 - cos² θ)` is 0.7 % off at `u = 1e-6`.
///   For `u = 0`, where the density is zero, the middle of its cell of 2⁻²⁴ stands.
/// * Source: Malley's method, one dimension down; Pharr, Jakob, Humphreys, Physically Based
///   Rendering (4th ed. 2023), "Cosine-Weighted Hemisphere Sampling".
pub fn sample_cosine(u: f32) -> Vec2 {
    let u = u.max(f32::EPSILON / 4.0);
    Vec2::new(1.0 - 2.0 * u, 2.0 * (u * (1.0 - u)).sqrt())
}

/// Density of [`sample_cosine`] at the unit direction `w`, per radian.
pub fn pdf_cosine(w: Vec2) -> f32 {
    w.y.max(0.0) * 0.5
}

/// The uniform from which [`sample_cosine`] makes `w`: `(1 - cos θ) / 2`.
pub fn invert_cosine(w: Vec2) -> f32 {
    // Near the tangent 1 - x has lost its digits, and y² / (1 + x) has not.
    let one_minus_x = if w.x > 0.0 {
        w.y * w.y / (1.0 + w.x)
    } else {
        1.0 - w.x
    };
    as_uniform(0.5 * one_minus_x)
}

/// Draws a direction of the half disk, proportionally to a power of the cosine with the normal.
///
/// * Domain: `u` in `[0, 1)²` and `exponent >= 1/2` or `exponent = 0` → unit `ω` with
///   `ω.y > 0`; for exponent 0 `ω.y >= 0`.
/// * Density: `p(ω) = ω.yⁿ Γ(n/2 + 1) / (√π Γ((n + 1)/2))`, per radian ([`pdf_cos_n`]).
/// * Method: the distribution function has no elementary inverse, but a projection has the right
///   law: `ω.x = √(1 - s) cos φ` with `s = (1 - u₀)^(2/n)` and `φ = 2π u₁`. For `n = 1` that is
///   Archimedes' hat-box, for `n = 2` the projection of the disc.
/// * Source: Ulrich, Computer Generation of Distributions on the m-Sphere (Applied Statistics
///   33(2), 1984), for the symmetric beta law that `ω.x` follows.
pub fn sample_cos_n(u: [f32; 2], exponent: f32) -> Vec2 {
    debug_assert!(exponent == 0.0 || exponent >= 0.5, "exponent {exponent}");
    // ln s; for exponent 0 the power is 0, but at u = 0, where 0/0 would be.
    let log_s = if exponent > 0.0 {
        2.0 / exponent * libm::log1pf(-u[0])
    } else {
        f32::NEG_INFINITY
    };
    let (s, one_minus_s) = (libm::expf(log_s), -libm::expm1f(log_s));
    let (sin, cos) = numeric::sin_cos(2.0 * PI * u[1]);
    // 1 - x² as a sum of squares, in which nothing cancels.
    Vec2::new(one_minus_s.sqrt() * cos, (sin * sin + s * cos * cos).sqrt())
}

/// Density of [`sample_cos_n`] at the unit direction `w`, per radian.
pub fn pdf_cos_n(w: Vec2, exponent: f32) -> f32 {
    if w.y < 0.0 {
        return 0.0;
    }
    let n = f64::from(exponent);
    let log_ratio = libm::lgamma(0.5 * n + 1.0) - libm::lgamma(0.5 * (n + 1.0));
    let constant = libm::exp(log_ratio) / std::f64::consts::PI.sqrt();
    (constant * libm::pow(f64::from(w.y), n)) as f32
}

/// The `index`-th of `count` stratified uniforms: a uniform of the `index`-th of `count` equal
/// parts of `[0, 1)`.
///
/// Each part gets one sample, so a smooth integrand's error falls as `count^(-3/2)`.
///
/// * Domain: `index < count`, `u` in `[0, 1)`.
/// * Source: Cochran, Sampling Techniques (1953), chapter 5.
pub fn stratified(index: u32, count: u32, u: f32) -> f32 {
    as_uniform(((f64::from(index) + f64::from(u)) / f64::from(count)) as f32)
}
