//! Mistakes one can only make in the flat world.

use super::variants::{SKY, mean, uniform_term};
use super::{Exam, Variant};
use crate::sampling::half_disk;
use crate::sampling::stream::Numbers;
use crate::space::Flat;
use std::f64::consts::FRAC_1_PI;

/// All of them.
pub(super) fn list() -> Vec<Variant> {
    vec![
        Variant {
            name: "1/pi of space",
            forgot: "that a white diffuse surface of the flat world has BRDF 1/2, not 1/π",
            reading: |exam| f64::from(exam.albedo) * 2.0 * FRAC_1_PI,
            gather: one_over_pi,
        },
        Variant {
            name: "cosine of the sampled angle",
            forgot: "that the sampled angle counts from the tangent: its sine is the cosine with \
                     the normal",
            reading: |_| 0.0,
            gather: angle_from_tangent,
        },
    ]
}

/// Density right, BRDF `albedo / π`.
pub fn one_over_pi(exam: &Exam, numbers: &mut Numbers) -> f64 {
    f64::from(exam.albedo) * FRAC_1_PI * mean(exam, || uniform_term::<Flat>(numbers))
}

/// The tangent's coordinate in place of the normal's: light from the right minus light from the
/// left.
pub fn angle_from_tangent(exam: &Exam, numbers: &mut Numbers) -> f64 {
    let term = || {
        let w = half_disk::sample_uniform(numbers.one());
        SKY * f64::from(w.x) / f64::from(half_disk::pdf_uniform(w))
    };
    0.5 * f64::from(exam.albedo) * mean(exam, term)
}
