//! Directions of the hemisphere over a surface, in local coordinates (`z` is the normal).

use crate::numeric;
use glam::Vec3;
use std::f32::consts::{FRAC_1_PI, TAU};

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
