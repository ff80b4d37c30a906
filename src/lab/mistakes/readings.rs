//! What each variant reads in the mean under a white sky, after one bounce.

use super::Exam;
use super::variants::EXCESS;
use crate::space::{Dimension, Space};
use std::f64::consts::{FRAC_1_PI, FRAC_PI_4};

/// The constant that [`Space::LAMBERT`] rounds to `f32`.
pub(super) fn lambert(dimension: Dimension) -> f64 {
    match dimension {
        Dimension::Flat => 0.5,
        Dimension::Solid => FRAC_1_PI,
    }
}

/// Mean cosine of uniform directions: `∫ cos θ dω` over the measure of all directions, 2/π in the
/// flat world and 1/2 in space.
pub(super) fn mean_cosine<S: Space>() -> f64 {
    match S::DIMENSION {
        Dimension::Flat => 2.0 * FRAC_1_PI,
        Dimension::Solid => 0.5,
    }
}

fn albedo(exam: &Exam) -> f64 {
    f64::from(exam.albedo)
}

pub(super) fn right(exam: &Exam) -> f64 {
    albedo(exam)
}

pub(super) fn as_printed<S: Space>(exam: &Exam) -> f64 {
    albedo(exam) * mean_cosine::<S>()
}

pub(super) fn as_printed_over_pi<S: Space>(exam: &Exam) -> f64 {
    as_printed::<S>(exam) * FRAC_1_PI
}

pub(super) fn density_forgotten<S: Space>(exam: &Exam) -> f64 {
    as_printed::<S>(exam) * lambert(S::DIMENSION)
}

pub(super) fn constant_forgotten<S: Space>(exam: &Exam) -> f64 {
    albedo(exam) / lambert(S::DIMENSION)
}

/// The mean cosine of directions that are proportional to the cosine.
pub(super) fn cosine_twice<S: Space>(exam: &Exam) -> f64 {
    albedo(exam)
        * match S::DIMENSION {
            Dimension::Flat => FRAC_PI_4,
            Dimension::Solid => 2.0 / 3.0,
        }
}

pub(super) fn one_too_many(exam: &Exam) -> f64 {
    albedo(exam) * (1.0 + 1.0 / f64::from(exam.samples))
}

/// The transposed matrix turns the wrong way: its directions lie around an axis twice the tilt
/// away from the normal.
pub(super) fn transposed(exam: &Exam) -> f64 {
    albedo(exam) * libm::cos(2.0 * f64::from(exam.tilt))
}

pub(super) fn transposed_clamped(exam: &Exam) -> f64 {
    let cos = libm::cos(f64::from(exam.tilt));
    albedo(exam) * cos * cos
}

pub(super) fn counted_twice(exam: &Exam) -> f64 {
    (1.0 + f64::from(u8::from(exam.aimed))) * albedo(exam)
}

pub(super) fn weight_forgotten(_: &Exam) -> f64 {
    1.0
}

pub(super) fn coefficients_above_one(exam: &Exam) -> f64 {
    EXCESS * albedo(exam)
}
