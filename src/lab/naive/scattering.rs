//! Surfaces.

use glam::Vec3;
use std::f32::consts::PI;

/// The share of light that a smooth interface reflects, in `f32` and without a word of total
/// reflection: NaN beyond the critical angle, and 0 / 0 where the two media are one and the same.
pub fn fresnel(cos_i: f32, eta: f32) -> f32 {
    let cos_t = (1.0 - (1.0 - cos_i * cos_i) / (eta * eta)).sqrt();
    let parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    let perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    0.5 * (parallel * parallel + perpendicular * perpendicular)
}

/// Schlick's approximation with the cosine on the near side: from inside glass it is off by 0.96 at
/// the critical angle.
///
/// Source: Schlick, An Inexpensive BRDF Model for Physically-based Rendering (Computer Graphics Forum
/// 13(3), 1994).
pub fn schlick(cos_i: f32, eta: f32) -> f32 {
    let f0 = ((1.0 - eta) / (1.0 + eta)).powi(2);
    f0 + (1.0 - f0) * (1.0 - cos_i).powi(5)
}

/// The refracted direction, unasked whether there is one: under total reflection it is NaN.
///
/// * `wo` leaves the surface on the side of `n`; `eta` is the index behind over the one before.
pub fn refract(wo: Vec3, n: Vec3, eta: f32) -> Vec3 {
    let cos_i = wo.dot(n);
    let cos_t = (1.0 - (1.0 - cos_i * cos_i) / (eta * eta)).sqrt();
    (n * cos_i - wo) / eta - n * cos_t
}

/// The distribution of facets from the cosine with the normal, in `f32`: `(α² - 1) cos² + 1` cancels
/// at the peak of a nearly smooth surface.
pub fn ggx(alpha: f32, cos: f32) -> f32 {
    let a2 = alpha * alpha;
    let spread = (a2 - 1.0) * cos * cos + 1.0;
    a2 / (PI * spread * spread)
}

/// The probability to be scattered diffusely by shares unchecked: 0 / 0 for a black surface, and what
/// is left for absorption may be below zero.
pub fn absorption(kd: f32, ks: f32) -> [f32; 2] {
    [kd / (kd + ks), 1.0 - (kd + ks)]
}
