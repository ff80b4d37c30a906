//! Mistakes one can only make in space.

use super::variants::{SKY, mean, uniform_term};
use super::{Exam, Variant};
use crate::sampling::hemisphere;
use crate::sampling::stream::Numbers;
use crate::space::Solid;
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, TAU};

/// All of them.
pub(super) fn list() -> Vec<Variant> {
    vec![
        Variant {
            name: "no 1/pi, and twice",
            forgot: "the BRDF's 1/π, and that the factor 2 is in the density already: a published \
                     program divides by the density and multiplies by 2",
            reading: |exam| f64::from(exam.albedo) * TAU,
            gather: twice_without_pi,
        },
        Variant {
            name: "polar angle uniform",
            forgot: "that equal steps of the angle from the normal are not equal solid angles",
            reading: |exam| f64::from(exam.albedo) * 4.0 * FRAC_1_PI,
            gather: polar_angle_uniform,
        },
    ]
}

/// Density right, then times 2 in place of `1 / π`.
pub fn twice_without_pi(exam: &Exam, numbers: &mut Numbers) -> f64 {
    2.0 * f64::from(exam.albedo) * mean(exam, || uniform_term::<Solid>(numbers))
}

/// θ uniform in `[0, π/2)`, with the density of directions uniform in solid angle.
pub fn polar_angle_uniform(exam: &Exam, numbers: &mut Numbers) -> f64 {
    let term = || {
        let [u, _] = numbers.two();
        let cos = libm::cos(FRAC_PI_2 * f64::from(u));
        SKY * cos / f64::from(hemisphere::pdf_uniform(glam::Vec3::Z))
    };
    FRAC_1_PI * f64::from(exam.albedo) * mean(exam, term)
}
