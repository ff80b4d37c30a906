//! Bounds on rounding errors, and ray origins that respect them.

use glam::Vec3;

/// The unit round-off of `f32`: the largest relative error of one correctly rounded operation.
pub const UNIT_ROUNDOFF: f32 = f32::EPSILON * 0.5;

// ANCHOR: gamma
/// Bound on the relative error after `n` rounded operations, `n u / (1 - n u)`.
///
/// Source: Higham, Accuracy and Stability of Numerical Algorithms (2nd ed. 2002), lemma 3.1.
pub const fn gamma(n: u32) -> f32 {
    let nu = n as f32 * UNIT_ROUNDOFF;
    nu / (1.0 - nu)
}
// ANCHOR_END: gamma

/// A vector as a power of two and a direction of which the largest component is at least 1 and
/// less than 2; of denormal vectors it is less.
///
/// No bit is lost. The length itself would need squares, which overflow above 1e19 and lose their
/// digits below 1e-19.
pub fn scale_and_direction(v: Vec3) -> (f32, Vec3) {
    let power = f32::from_bits(v.abs().max_element().to_bits() & 0x7f80_0000);
    let scale = if power > 0.0 { power } else { 1.0 };
    (scale, v * (1.0 / scale))
}

// ANCHOR: offset
/// Moves a hit point off its surface, to the side that `direction` leaves on.
///
/// * `p` is the computed point; the true one lies within `error` of it, coordinate by coordinate.
/// * `n` is the geometric unit normal; its sign does not matter.
/// * Result: the nearest representable point that is certainly on the side of `direction`.
///
/// The distance moved is `|n| · error`, so it scales with the scene: no constant here is a length.
/// Source: Pharr, Jakob, Humphreys, Physically Based Rendering (4th ed. 2023), "Robust Spawned
/// Ray Origins".
pub fn offset_origin(p: Vec3, error: Vec3, n: Vec3, direction: Vec3) -> Vec3 {
    let distance = n.abs().dot(error);
    let side = if direction.dot(n) < 0.0 { -1.0 } else { 1.0 };
    let offset = n * (side * distance);
    // The sum below rounds too: step on to the next number away from the surface. Numbers of one
    // sign are ordered as their bits are, so that is one more or one less; zero has no sign, and
    // the smallest number beside it serves. All of it is computed, for nobody can predict signs.
    let away = |p: f32, offset: f32| {
        let moved = p + offset;
        let up = (offset > 0.0) == (moved > 0.0);
        let bits = moved.to_bits();
        let stepped = bits.wrapping_add(2 * u32::from(up)).wrapping_sub(1);
        let from_zero = f32::from_bits(1).copysign(offset).to_bits();
        let left = if moved == 0.0 { from_zero } else { stepped };
        f32::from_bits(if offset == 0.0 { bits } else { left })
    };
    Vec3::new(
        away(p.x, offset.x),
        away(p.y, offset.y),
        away(p.z, offset.z),
    )
}
// ANCHOR_END: offset

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gamma_bounds_a_long_product() {
        let mut product = 1.0_f32;
        for _ in 0..1000 {
            product *= 1.0 + UNIT_ROUNDOFF * 1.5;
        }
        let exact = libm::pow(1.0 + f64::from(UNIT_ROUNDOFF) * 1.5, 1000.0);
        // Each factor is itself rounded: two roundings per step.
        assert!((f64::from(product) - exact).abs() / exact <= f64::from(gamma(2000)));
        assert!(gamma(7) > 7.0 * UNIT_ROUNDOFF);
    }

    #[test]
    fn the_origin_leaves_on_the_side_of_the_direction() {
        let p = Vec3::new(1000.0, -2000.0, 3000.0);
        let error = p.abs() * gamma(7);
        let n = Vec3::new(1.0, 2.0, -2.0) / 3.0;
        for side in [1.0, -1.0] {
            let moved = offset_origin(p, error, n, n * side);
            let distance = (moved - p).as_dvec3().dot(n.as_dvec3()) * f64::from(side);
            assert!(distance >= f64::from(n.abs().dot(error)), "{distance}");
        }
    }

    #[test]
    fn vectors_of_any_length_have_a_direction() {
        let v = Vec3::new(3.0, -4.0, 12.0);
        for k in [-129, -120, -70, -1, 0, 1, 70, 120, 124] {
            let power = libm::exp2(f64::from(k)) as f32;
            let (scale, direction) = scale_and_direction(v * power);
            assert_eq!((scale, direction), (8.0 * power, v / 8.0), "2^{k}");
        }
        assert_eq!((v * 1e20).normalize(), Vec3::ZERO, "the plain form");
        assert_eq!(scale_and_direction(Vec3::ZERO), (1.0, Vec3::ZERO));
    }

    #[test]
    fn moving_by_nothing_stays_in_place() {
        let p = Vec3::new(1.0, 2.0, 3.0);
        assert_eq!(offset_origin(p, Vec3::ZERO, Vec3::Z, Vec3::Z), p);
    }
}
