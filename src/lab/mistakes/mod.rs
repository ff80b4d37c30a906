//! The classic mistakes, kept: each a complete estimator with one thing wrong.
//!
//! Nearly all of them estimate what a white sky makes a surface reflect, where the right answer is the
//! albedo. What they read instead is known exactly, so a reading names its mistake (see
//! [`doctor`](super::doctor)); and the checks that accept the right estimator must reject each of
//! these. Those of [`misled`] are walks that combine two techniques with wrong weights; [`Clamped`] cuts
//! off what is bright.

mod clamped;
pub mod count_twice;
pub mod flat_only;
pub mod misled;
mod readings;
pub mod solid_only;
pub mod variants;

pub use clamped::Clamped;

use crate::sampling::stream::{Numbers, Purpose, Stream};
use crate::space::{Dimension, Flat, Solid, Space};
use crate::stats::Estimate;
use serde::{Serialize, Serializer};

/// The surface that is asked, and how.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Exam {
    /// The share of light the surface reflects, in `[0, 1]`.
    pub albedo: f32,
    /// Directions of each gather.
    pub samples: u32,
    /// Angle between the surface's normal and the axis that needs no turning, in radians, in
    /// `[0, π/2]`.
    #[serde(rename = "tilt_degrees", serialize_with = "degrees")]
    pub tilt: f32,
    /// How often the light is reflected before it is read: the reading's power.
    pub bounces: u32,
    /// True where shadow rays find the sky. Otherwise only rays that meet it by chance do.
    #[serde(rename = "shadow_rays", serialize_with = "shadow_rays")]
    pub aimed: bool,
}

fn degrees<S: Serializer>(radians: &f32, serializer: S) -> Result<S::Ok, S::Error> {
    radians.to_degrees().serialize(serializer)
}

fn shadow_rays<S: Serializer>(aimed: &bool, serializer: S) -> Result<S::Ok, S::Error> {
    let word = if *aimed { "seeing" } else { "blind" };
    word.serialize(serializer)
}

impl Default for Exam {
    /// A white, upright surface, 16 directions, one bounce, a sky one can aim at.
    fn default() -> Self {
        Exam {
            albedo: 1.0,
            samples: 16,
            tilt: 0.0,
            bounces: 1,
            aimed: true,
        }
    }
}

/// An estimator of reflected light, right or wrong.
#[derive(Clone, Copy, Debug)]
pub struct Variant {
    /// Its name.
    pub name: &'static str,
    /// What was forgotten or mixed up, in a sentence.
    pub forgot: &'static str,
    /// Exact reading of one bounce.
    reading: fn(&Exam) -> f64,
    /// One gather of one bounce.
    gather: fn(&Exam, &mut Numbers) -> f64,
}

impl Variant {
    /// What it reads in the mean, exactly, up to the rounding of `f32`.
    pub fn reading(&self, exam: &Exam) -> f64 {
        let one = (self.reading)(exam);
        (0..exam.bounces).fold(1.0, |product, _| product * one)
    }

    /// One gather: a factor for each bounce, all of them independent.
    pub fn gather(&self, exam: &Exam, numbers: &mut Numbers) -> f64 {
        (0..exam.bounces).fold(1.0, |product, _| product * (self.gather)(exam, numbers))
    }

    /// What it reads in `gathers` gathers.
    pub fn measure(&self, exam: &Exam, gathers: u32, seed: u64) -> Estimate {
        (0..gathers)
            .map(|i| {
                let mut numbers = Stream::new(seed, i, 0).at(0, Purpose::Direction);
                self.gather(exam, &mut numbers)
            })
            .collect()
    }
}

/// The right estimator.
pub fn right(dimension: Dimension) -> Variant {
    match dimension {
        Dimension::Flat => right_in::<Flat>(),
        Dimension::Solid => right_in::<Solid>(),
    }
}

/// The mistakes one can make in this dimension.
pub fn all(dimension: Dimension) -> Vec<Variant> {
    match dimension {
        Dimension::Flat => [shared::<Flat>(), flat_only::list()].concat(),
        Dimension::Solid => [shared::<Solid>(), solid_only::list()].concat(),
    }
}

fn right_in<S: Space>() -> Variant {
    Variant {
        name: "right",
        forgot: "nothing: albedo · LAMBERT · (1/N) Σ L cos θ / pdf",
        reading: readings::right,
        gather: variants::right::<S>,
    }
}

fn shared<S: Space>() -> Vec<Variant> {
    vec![
        Variant {
            name: "formula as printed",
            forgot: "both the density and the Lambert constant: albedo · (1/N) Σ L cos θ",
            reading: readings::as_printed::<S>,
            gather: variants::as_printed::<S>,
        },
        Variant {
            name: "printed formula over pi",
            forgot: "the density: steps 4 to 7 as they stand, and then 1/π",
            reading: readings::as_printed_over_pi::<S>,
            gather: variants::as_printed_over_pi::<S>,
        },
        Variant {
            name: "density forgotten",
            forgot: "the division by the density of the direction",
            reading: readings::density_forgotten::<S>,
            gather: variants::density_forgotten::<S>,
        },
        Variant {
            name: "Lambert constant forgotten",
            forgot: "the BRDF's constant: 1/2 in the flat world, 1/π in space",
            reading: readings::constant_forgotten::<S>,
            gather: variants::constant_forgotten::<S>,
        },
        Variant {
            name: "cosine twice",
            forgot: "that directions proportional to the cosine have the cosine in them already",
            reading: readings::cosine_twice::<S>,
            gather: variants::cosine_twice::<S>,
        },
        Variant {
            name: "one term too many",
            forgot: "that a sum from 0 to N has N + 1 terms",
            reading: readings::one_too_many,
            gather: variants::one_too_many::<S>,
        },
        Variant {
            name: "matrix transposed, cosine clamped",
            forgot: "that tangent and normal are the columns of the matrix, not its rows; \
                     directions below the surface count as zero",
            reading: readings::transposed_clamped,
            gather: variants::transposed_clamped::<S>,
        },
        Variant {
            name: "matrix transposed",
            forgot: "that tangent and normal are the columns of the matrix, not its rows",
            reading: readings::transposed,
            gather: variants::transposed::<S>,
        },
        Variant {
            name: "light counted twice",
            forgot: "that a lamp found by a shadow ray must not count when a ray hits it",
            reading: readings::counted_twice,
            gather: variants::counted_twice::<S>,
        },
        Variant {
            name: "selection weight forgotten",
            forgot: "that what a chosen lobe brings is multiplied by kd + ks + kt; without it \
                     every surface reflects everything",
            reading: readings::weight_forgotten,
            gather: variants::weight_forgotten::<S>,
        },
        Variant {
            name: "coefficients above one",
            forgot: "that kd + ks + kt may not exceed the albedo: here it is 1.2 of it, and each \
                     bounce makes more light",
            reading: readings::coefficients_above_one,
            gather: variants::coefficients_above_one::<S>,
        },
    ]
}
