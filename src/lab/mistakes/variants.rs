//! The right estimator and the mistakes that both dimensions know, one function each: a gather of
//! one bounce under a white sky.

use super::Exam;
use crate::sampling::stream::Numbers;
use crate::space::Space;
use std::f64::consts::FRAC_1_PI;

/// Radiance of the sky.
pub(super) const SKY: f64 = 1.0;

/// How far the coefficients of [`coefficients_above_one`] exceed the albedo.
pub const EXCESS: f64 = 1.2;

/// The mean of `samples` values.
pub(super) fn mean(exam: &Exam, mut value: impl FnMut() -> f64) -> f64 {
    (0..exam.samples).map(|_| value()).sum::<f64>() / f64::from(exam.samples)
}

/// A uniform direction's cosine with the normal.
pub(super) fn uniform_cosine<S: Space>(numbers: &mut Numbers) -> f64 {
    f64::from(S::cos(S::sample_uniform(S::uniforms(numbers))))
}

/// `L cos θ / pdf` of a uniform direction.
pub(super) fn uniform_term<S: Space>(numbers: &mut Numbers) -> f64 {
    let w = S::sample_uniform(S::uniforms(numbers));
    SKY * f64::from(S::cos(w)) / f64::from(S::pdf_uniform(w))
}

/// The BRDF of a diffuse surface.
fn brdf<S: Space>(exam: &Exam) -> f64 {
    f64::from(exam.albedo) * f64::from(S::LAMBERT)
}

/// Nothing is wrong here.
pub fn right<S: Space>(exam: &Exam, numbers: &mut Numbers) -> f64 {
    brdf::<S>(exam) * mean(exam, || uniform_term::<S>(numbers))
}

/// No density, no BRDF constant: the essay's formula with the cosine of its fourth step.
pub fn as_printed<S: Space>(exam: &Exam, numbers: &mut Numbers) -> f64 {
    f64::from(exam.albedo) * mean(exam, || SKY * uniform_cosine::<S>(numbers))
}

/// The same with the 1/π that belongs to space.
pub fn as_printed_over_pi<S: Space>(exam: &Exam, numbers: &mut Numbers) -> f64 {
    as_printed::<S>(exam, numbers) * FRAC_1_PI
}

/// The BRDF is right, the density is missing.
pub fn density_forgotten<S: Space>(exam: &Exam, numbers: &mut Numbers) -> f64 {
    brdf::<S>(exam) * mean(exam, || SKY * uniform_cosine::<S>(numbers))
}

/// The density is right, the BRDF's constant is missing.
pub fn constant_forgotten<S: Space>(exam: &Exam, numbers: &mut Numbers) -> f64 {
    f64::from(exam.albedo) * mean(exam, || uniform_term::<S>(numbers))
}

/// Directions proportional to the cosine, whose terms are `L` alone, times the cosine.
pub fn cosine_twice<S: Space>(exam: &Exam, numbers: &mut Numbers) -> f64 {
    let term = || {
        let w = S::sample_cosine(S::uniforms(numbers));
        SKY * f64::from(S::cos(w))
    };
    f64::from(exam.albedo) * mean(exam, term)
}

/// The sum runs from 0 to N.
pub fn one_too_many<S: Space>(exam: &Exam, numbers: &mut Numbers) -> f64 {
    let sum: f64 = (0..=exam.samples).map(|_| uniform_term::<S>(numbers)).sum();
    brdf::<S>(exam) * sum / f64::from(exam.samples)
}

/// Turns a local direction with the transposed matrix: tangent and normal as rows. For a basis
/// that is the way from the world to local coordinates.
pub fn turn_transposed<S: Space>(frame: &S::Frame, w: S::Vector) -> S::Vector {
    S::to_local(frame, w)
}

/// Directions turned the wrong way, some of which point below the surface and take light away.
pub fn transposed<S: Space>(exam: &Exam, numbers: &mut Numbers) -> f64 {
    with_transposed_matrix::<S>(exam, numbers, |cos| cos)
}

/// The same with a cosine that is never negative.
pub fn transposed_clamped<S: Space>(exam: &Exam, numbers: &mut Numbers) -> f64 {
    with_transposed_matrix::<S>(exam, numbers, |cos| cos.max(0.0))
}

fn with_transposed_matrix<S: Space>(
    exam: &Exam,
    numbers: &mut Numbers,
    clamp: impl Fn(f64) -> f64,
) -> f64 {
    let n = S::tilted(exam.tilt);
    let frame = S::frame(n);
    let term = || {
        let w = S::sample_uniform(S::uniforms(numbers));
        let wi = turn_transposed::<S>(&frame, w);
        SKY * clamp(f64::from(S::dot(n, wi))) / f64::from(S::pdf_uniform(w))
    };
    brdf::<S>(exam) * mean(exam, term)
}

/// The sky is a lamp one can aim at. Here shadow rays find it, and the gather's rays find it
/// again.
pub fn counted_twice<S: Space>(exam: &Exam, numbers: &mut Numbers) -> f64 {
    let direct = mean(exam, || {
        let w = S::sample_cosine(S::uniforms(numbers));
        let visible = f64::from(u8::from(exam.aimed));
        visible * SKY * f64::from(S::cos(w)) / f64::from(S::pdf_cosine(w))
    });
    let indirect = mean(exam, || uniform_term::<S>(numbers));
    brdf::<S>(exam) * (direct + indirect)
}

/// One of three lobes is chosen in proportion to its coefficient, and what it brings is not
/// multiplied by their sum. Each lobe alone sees the white sky as 1.
pub fn weight_forgotten<S: Space>(exam: &Exam, numbers: &mut Numbers) -> f64 {
    mean(exam, || lobe::<S>(f64::from(exam.albedo), numbers))
}

/// The weight is there, but the coefficients sum to more than the surface can reflect.
pub fn coefficients_above_one<S: Space>(exam: &Exam, numbers: &mut Numbers) -> f64 {
    let k_tot = EXCESS * f64::from(exam.albedo);
    k_tot * mean(exam, || lobe::<S>(k_tot, numbers))
}

/// What the chosen lobe brings, before its coefficient: half the choices scatter, the others
/// reflect or transmit.
fn lobe<S: Space>(k_tot: f64, numbers: &mut Numbers) -> f64 {
    let r = k_tot * f64::from(numbers.one());
    let u = S::uniforms(numbers);
    if r < 0.5 * k_tot {
        let w = S::sample_cosine(u);
        SKY * f64::from(S::LAMBERT) * f64::from(S::cos(w)) / f64::from(S::pdf_cosine(w))
    } else {
        SKY
    }
}
