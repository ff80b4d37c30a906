//! Points and directions of simple shapes from uniforms.

use crate::numeric::{self, gamma};
use glam::{Vec2, Vec3};
use std::f32::consts::{FRAC_1_PI, PI, TAU};

/// Draws a point of the unit disc, uniformly.
///
/// * Domain: `u` in `[0, 1)²` → `|p| < 1`, up to rounding.
/// * Density: `1 / π`, per unit area ([`pdf_disk`]).
/// * Method: the distribution function of the radius is `r²`.
pub fn sample_disk(u: [f32; 2]) -> Vec2 {
    let (sin, cos) = numeric::sin_cos(TAU * u[1]);
    u[0].sqrt() * Vec2::new(cos, sin)
}

/// Draws a point of the unit disc, uniformly, so that neighbours in the square stay neighbours and
/// the middle of the square is the middle of the disc.
///
/// * Domain: `u` in `[0, 1)²` → `|p| <= 1`, up to rounding.
/// * Density: `1 / π`, per unit area ([`pdf_disk`]).
/// * Method: squares around the middle become circles around it.
/// * Source: Shirley, Chiu, A Low Distortion Map Between Disk and Square (JGT 2(3), 1997).
pub fn sample_disk_concentric(u: [f32; 2]) -> Vec2 {
    let [x, y] = u.map(|u| 2.0 * u - 1.0);
    // Radius and angle within the wedge around an axis, of 45 degrees to either side.
    let wedge = |radius: f32, across: f32| {
        let along = if radius == 0.0 { 0.0 } else { across / radius };
        let (sin, cos) = numeric::sin_cos(0.25 * PI * along);
        (radius * cos, radius * sin)
    };
    if x.abs() > y.abs() {
        let (along, across) = wedge(x, y);
        Vec2::new(along, across)
    } else {
        let (along, across) = wedge(y, x);
        Vec2::new(across, along)
    }
}

/// Density of [`sample_disk`] and [`sample_disk_concentric`] at `p`, per unit area.
pub fn pdf_disk(p: Vec2) -> f32 {
    // A sample on the rim may come out a few roundings beyond it.
    if p.length_squared() <= 1.0 + gamma(8) {
        FRAC_1_PI
    } else {
        0.0
    }
}

/// Draws a direction of the whole sphere, uniformly.
///
/// * Domain: `u` in `[0, 1)²` → unit `ω`.
/// * Density: `1 / 4π`, per steradian ([`pdf_sphere`]).
/// * Method: `z` is uniform in `(-1, 1]`, as Archimedes found.
pub fn sample_sphere(u: [f32; 2]) -> Vec3 {
    let z = 1.0 - 2.0 * u[0];
    // 2 √(u (1 - u)), not √(1 - z²): the second loses its digits at the poles.
    let r = 2.0 * (u[0] * (1.0 - u[0])).sqrt();
    let (sin, cos) = numeric::sin_cos(TAU * u[1]);
    Vec3::new(r * cos, r * sin, z)
}

/// Density of [`sample_sphere`], per steradian, in every direction.
pub fn pdf_sphere() -> f32 {
    0.25 * FRAC_1_PI
}

/// Draws a direction within the angle `θ_max` of `z`, uniformly in solid angle.
///
/// * Domain: `u` in `[0, 1)²` and `one_minus_cos_max = 1 - cos θ_max` in `(0, 1]` → unit `ω`.
/// * Density: `1 / (2π (1 - cos θ_max))`, per steradian ([`pdf_cone`]).
/// * Method: `1 - cos θ` is uniform in `[0, 1 - cos θ_max)`; working with the difference keeps
///   full precision for lights of any smallness (see [`numeric::one_minus_cos`]).
/// * Source: Shirley, Wang, Zimmerman, Monte Carlo Techniques for Direct Lighting Calculations
///   (ACM TOG 15(1), 1996), "Spherical luminaires".
pub fn sample_cone(u: [f32; 2], one_minus_cos_max: f32) -> Vec3 {
    let one_minus_cos = u[0] * one_minus_cos_max;
    let sin = (one_minus_cos * (2.0 - one_minus_cos)).sqrt();
    let (sin_phi, cos_phi) = numeric::sin_cos(TAU * u[1]);
    Vec3::new(sin * cos_phi, sin * sin_phi, 1.0 - one_minus_cos)
}

/// Density of [`sample_cone`] inside its cone, per steradian.
pub fn pdf_cone(one_minus_cos_max: f32) -> f32 {
    1.0 / (2.0 * PI * one_minus_cos_max)
}

/// Draws a point of a triangle, uniformly: the weights of its second and third corner.
///
/// * Domain: `u` in `[0, 1)²` → `b`, `c` of at least 0 whose sum is at most 1, up to rounding.
/// * Density: `1 / area`, per unit area of the triangle ([`pdf_triangle`]).
/// * Method: the share of the triangle beyond a line parallel to a side is a square.
/// * Source: Turk, Generating Random Points in Triangles (Graphics Gems, 1990).
pub fn sample_triangle(u: [f32; 2]) -> [f32; 2] {
    let root = u[0].sqrt();
    [root * (1.0 - u[1]), root * u[1]]
}

/// Density of [`sample_triangle`] on a triangle of this area, per unit area.
pub fn pdf_triangle(area: f64) -> f64 {
    1.0 / area
}
