//! Care for floating point: the functions whose last bits decide whether a picture is right.
//!
//! Transport runs in `f32`. This floor holds what keeps it honest there: a quadratic that does
//! not cancel, bounds on rounding errors, ray origins that have left their surface, and one
//! deterministic source ([`libm`]) for sine, cosine and their kin. The platform's own versions
//! differ in the last bit between machines; a picture here is the same bytes everywhere, so the
//! lint in `clippy.toml` refuses them outside this floor.

pub mod lanes;
mod quadratic;
mod rounding;

pub use quadratic::{Roots, quadratic};
pub use rounding::{UNIT_ROUNDOFF, gamma, offset_origin, scale_and_direction};

/// Sine of an angle in radians.
pub fn sin(x: f32) -> f32 {
    libm::sinf(x)
}

/// Cosine of an angle in radians.
pub fn cos(x: f32) -> f32 {
    libm::cosf(x)
}

/// Sine and cosine of an angle in radians.
pub fn sin_cos(x: f32) -> (f32, f32) {
    libm::sincosf(x)
}

/// The angle in `[0, π]` of a cosine.
pub fn acos(x: f32) -> f32 {
    libm::acosf(x)
}

/// The angle of the point `(x, y)` from the x axis, in `[-π, π]`.
pub fn atan2(y: f32, x: f32) -> f32 {
    libm::atan2f(y, x)
}

// ANCHOR: one_minus_cos
/// `1 - cos θ` from `sin² θ`, for θ in `[0, π/2]`.
///
/// The plain form `1 - sqrt(1 - sin²)` cancels: it is 7 % off at `sin = 1e-3` and exactly zero
/// below `1.7e-4`. Multiplying by `(1 + cos) / (1 + cos)` leaves nothing to cancel.
pub fn one_minus_cos(sin2: f32) -> f32 {
    sin2 / (1.0 + (1.0 - sin2).max(0.0).sqrt())
}
// ANCHOR_END: one_minus_cos

/// A number with so many decimals, and no minus before zeros.
pub fn fixed(x: f64, decimals: usize) -> String {
    let text = format!("{x:.decimals$}");
    match text.strip_prefix('-') {
        Some(zeros) if zeros.chars().all(|c| matches!(c, '0' | '.')) => zeros.to_owned(),
        _ => text,
    }
}

/// Three digits, and no more than two after the point: `0.12`, `1.23`, `12.3`, `123`.
pub fn three_digits(x: f64) -> String {
    let decimals = match x {
        x if x < 9.995 => 2,
        x if x < 99.95 => 1,
        _ => 0,
    };
    format!("{x:.decimals$}")
}

/// A number of things: `1 sample`, `2 samples`.
pub fn count(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::naive;

    #[test]
    fn one_minus_cos_keeps_its_digits_where_the_plain_form_loses_all() {
        let mut worst_ours = 0.0_f64;
        let mut plain_failures = 0;
        for k in 1..=38 {
            let sin = libm::pow(10.0, -f64::from(k) / 2.0);
            let sin2 = (sin * sin) as f32;
            let truth = f64::from(sin2) / (1.0 + (1.0 - f64::from(sin2)).sqrt());
            let relative = |x: f32| ((f64::from(x) - truth) / truth).abs();
            worst_ours = worst_ours.max(relative(one_minus_cos(sin2)));
            plain_failures += usize::from(relative(naive::one_minus_cos(sin2)) > 0.01);
        }
        assert!(worst_ours < 1.3e-7, "worst relative error {worst_ours:e}");
        assert!(
            plain_failures > 20,
            "the plain form should fail: {plain_failures}"
        );
    }
}
