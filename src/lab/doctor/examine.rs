//! Taking readings from somebody's own estimator.

use super::{Diagnosis, Reading, diagnose, questions};
use crate::lab::mistakes::{Exam, Variant};
use crate::sampling::stream::{Numbers, Purpose, Stream};
use crate::space::Space;
use crate::stats::Estimate;

/// What an estimator is given: a surface, a sky to cast rays into, and random numbers.
#[derive(Debug)]
pub struct Patient<S: Space> {
    /// The surface's unit normal.
    pub normal: S::Vector,
    /// The share of light it reflects.
    pub albedo: f32,
    /// How many directions to gather from.
    pub samples: u32,
    exam: Exam,
    numbers: Numbers,
}

impl<S: Space> Patient<S> {
    /// The surface of an exam, which is seen once, with these random numbers.
    pub fn new(exam: &Exam, numbers: Numbers) -> Self {
        Patient {
            normal: S::tilted(exam.tilt),
            albedo: exam.albedo,
            samples: exam.samples,
            exam: Exam {
                bounces: 1,
                ..*exam
            },
            numbers,
        }
    }

    /// What a known estimator, right or wrong, reads in its place.
    pub fn ask(&mut self, variant: &Variant) -> f32 {
        variant.gather(&self.exam, &mut self.numbers) as f32
    }

    /// Random numbers in `[0, 1)`: one of them in the flat world, two in space.
    pub fn random(&mut self) -> S::Uniforms {
        S::uniforms(&mut self.numbers)
    }

    /// Radiance that arrives from a unit direction in world coordinates: the sky is white all over.
    pub fn cast_ray(&self, _wi: S::Vector) -> f32 {
        1.0
    }

    /// What shadow rays find: `∫ L cos θ dω` over the sky where one can aim at it, 0 elsewhere.
    pub fn shadow_rays(&self) -> f32 {
        if self.exam.aimed {
            1.0 / S::LAMBERT
        } else {
            0.0
        }
    }
}

/// Examines an estimator of the radiance that a surface reflects.
///
/// It is asked at two albedos, sample counts and tilts, and with shadow rays that find nothing, so
/// that a mistake which hides from one question shows in another.
///
/// ```
/// use halfdisk::lab::doctor::{Patient, examine};
/// use halfdisk::{sampling::{flat_frame::FlatFrame, half_disk}, space::Flat};
///
/// let diagnosis = examine(|p: &mut Patient<Flat>| {
///     let mut sum = 0.0;
///     for _ in 0..p.samples {
///         let w = half_disk::sample_uniform(p.random());
///         let wi = FlatFrame::new(p.normal).to_world(w);
///         sum += p.cast_ray(wi) * w.y;
///     }
///     p.albedo * sum / p.samples as f32
/// });
/// assert_eq!(diagnosis.matches()[0].variant.name, "formula as printed");
/// ```
pub fn examine<S: Space>(mut estimator: impl FnMut(&mut Patient<S>) -> f32) -> Diagnosis {
    // A patient reflects once.
    let asked = questions().into_iter().filter(|exam| exam.bounces == 1);
    let read = |exam: Exam| {
        let estimate: Estimate = (0..GATHERS)
            .map(|i| {
                let numbers = Stream::new(SEED, i, 0).at(0, Purpose::Direction);
                f64::from(estimator(&mut Patient::new(&exam, numbers)))
            })
            .collect();
        Reading {
            value: estimate.mean(),
            error: estimate.std_error(),
            exam,
        }
    };
    let readings: Vec<Reading> = asked.map(read).collect();
    diagnose(S::DIMENSION, &readings)
}

/// Gathers for each reading: with 16 directions, an error of 0.1 %.
const GATHERS: u32 = 20_000;
/// The same numbers for every patient: a diagnosis can be repeated.
const SEED: u64 = 1;
