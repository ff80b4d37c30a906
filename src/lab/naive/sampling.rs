//! Uniforms, directions, weights.

use glam::{Vec2, Vec3};
use std::f32::consts::PI;

/// A uniform from a word of 32 bits: 1 for the 128 largest of them.
pub fn uniform(word: u32) -> f32 {
    word as f32 * 2.0_f32.powi(-32)
}

/// The radical inverse in `f32`, digit by digit: reaches 1 at `b^k - 1`, and repeats itself in large
/// bases.
pub fn radical_inverse(base: u32, mut index: u32) -> f32 {
    let (mut value, mut place) = (0.0, 1.0 / base as f32);
    while index > 0 {
        value += (index % base) as f32 * place;
        index /= base;
        place /= base as f32;
    }
    value
}

/// A direction of the half disk, uniform in angle, counted from the normal: its cosine is below zero
/// at `u = 0`.
pub fn uniform_flat(u: f32) -> Vec2 {
    let (sin, cos) = libm::sincosf(PI * (u - 0.5));
    Vec2::new(sin, cos)
}

/// A direction of the half disk, proportional to the cosine, by way of its angle.
pub fn cosine_flat(u: f32) -> Vec2 {
    let (sin, cos) = libm::sincosf(libm::asinf(2.0 * u - 1.0));
    Vec2::new(sin, cos)
}

/// A direction of the hemisphere above a point of the unit disk: lifted to the sphere. At the rim `z`
/// is 0, and `f cos / pdf` is 0 / 0.
pub fn lifted(p: Vec2) -> Vec3 {
    p.extend((1.0 - p.length_squared()).max(0.0).sqrt())
}

/// `1 - cos θ` from `sin² θ`: 7 % off at `sin = 1e-3`, and 0 below `1.7e-4`.
pub fn one_minus_cos(sin2: f32) -> f32 {
    1.0 - (1.0 - sin2).sqrt()
}

/// Two tangents of a unit normal.
///
/// Fails near `n = -z`, where `1 + n.z` has no digits left.
/// Source: Frisvad, Building an Orthonormal Basis from a 3D Unit Vector Without Normalization (JGT
/// 16(3), 2012).
pub fn basis(n: Vec3) -> [Vec3; 2] {
    if n.z < -0.999_999_9 {
        return [Vec3::NEG_Y, Vec3::NEG_X];
    }
    let a = 1.0 / (1.0 + n.z);
    let b = -n.x * n.y * a;
    [
        Vec3::new(1.0 - n.x * n.x * a, b, -n.x),
        Vec3::new(b, 1.0 - n.y * n.y * a, -n.y),
    ]
}

/// The power heuristic as it is printed: NaN for densities above 2e19, or both below 3e-23.
pub fn power_weight(own: f32, other: f32) -> f32 {
    own * own / (own * own + other * other)
}

/// Sums of weights in `f32`, up to each: weights that vanish beside the sum are never chosen.
pub fn cumulative(weights: impl IntoIterator<Item = f32>) -> Vec<f32> {
    let add = |sum: &mut f32, weight| {
        *sum += weight;
        Some(*sum)
    };
    weights.into_iter().scan(0.0, add).collect()
}

/// The probability to survive, the throughput itself: above 1 it is none, and dividing by it loses
/// light.
pub fn survival(throughput: f32) -> f32 {
    throughput
}
