//! From a reading to the mistake that makes it.
//!
//! Under a white sky a surface reflects its albedo; each mistake on the list reads something else,
//! exactly known. [`diagnose`] compares readings with the list; [`examine`] takes them from an
//! estimator.

mod examine;

pub use examine::{Patient, examine};

use super::mistakes::{self, Exam, Variant};
use crate::space::Dimension;
use crate::stats::z_test::FOUR;
use serde::Serialize;
use std::fmt::Write as _;

/// Readings are not told apart below this share of one: sums in `f32` round.
const RESOLUTION: f64 = 1e-5;

/// A number an estimator gave, with its standard error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Reading {
    /// The number.
    pub value: f64,
    /// Its standard error; 0 where it has none.
    pub error: f64,
    /// What was asked.
    pub exam: Exam,
}

/// How well a variant explains the readings.
#[derive(Clone, Copy, Debug)]
pub struct Finding {
    /// The variant, which may be the right one.
    pub variant: Variant,
    /// Distance from its readings in standard errors: the largest of all.
    pub z: f64,
}

/// What the readings say, the likeliest first.
#[derive(Clone, Debug)]
pub struct Diagnosis {
    /// The world of the estimator.
    pub dimension: Dimension,
    /// The readings.
    pub readings: Vec<Reading>,
    /// Every variant, the closest to the readings first.
    pub findings: Vec<Finding>,
}

/// Compares readings with what the right estimator and each mistake would read.
///
/// ```
/// use halfdisk::lab::{doctor::{Reading, diagnose}, mistakes::Exam};
/// use halfdisk::space::Dimension;
///
/// let reading = Reading { value: 0.786, error: 0.002, exam: Exam::default() };
/// let diagnosis = diagnose(Dimension::Flat, &[reading]);
/// assert_eq!(diagnosis.matches()[0].variant.name, "cosine twice");
/// println!("{}", diagnosis.explain());
/// ```
pub fn diagnose(dimension: Dimension, readings: &[Reading]) -> Diagnosis {
    let mut variants = vec![mistakes::right(dimension)];
    variants.extend(mistakes::all(dimension));
    let mut findings: Vec<Finding> = variants
        .into_iter()
        .map(|variant| Finding {
            variant,
            z: distance(&variant, readings),
        })
        .collect();
    // Stable: the right estimator stands before mistakes that these readings cannot reveal.
    findings.sort_by(|a, b| a.z.total_cmp(&b.z));
    Diagnosis {
        dimension,
        readings: readings.to_vec(),
        findings,
    }
}

fn distance(variant: &Variant, readings: &[Reading]) -> f64 {
    let z = |r: &Reading| {
        let exact = variant.reading(&r.exam);
        // A mean of what is never below zero is not below zero, however uncertain it is.
        if r.value < -RESOLUTION && exact > RESOLUTION {
            return f64::INFINITY;
        }
        let off = (r.value - exact).abs();
        let error = r.error.max(RESOLUTION * r.value.abs().max(1.0));
        // A reading that is no number is far from everything.
        if off.is_finite() {
            off / error
        } else {
            f64::INFINITY
        }
    };
    readings.iter().map(z).fold(0.0, f64::max)
}

impl Diagnosis {
    /// The variants within four standard errors of all readings, the closest first.
    pub fn matches(&self) -> &[Finding] {
        let close = self.findings.partition_point(|finding| finding.z <= FOUR);
        &self.findings[..close]
    }

    /// True where the right estimator is among the matches.
    pub fn healthy(&self) -> bool {
        self.matches().iter().any(|f| f.variant.name == "right")
    }

    /// How many fit, where it is more than a few.
    fn headline(&self) -> String {
        let fit = self.matches().len();
        if fit < 4 {
            return String::new();
        }
        let (how_many, what) = match self.healthy() {
            true => (
                fit - 1,
                "The right estimator reads this, and so do {} mistakes",
            ),
            false => (fit, "{} mistakes read this"),
        };
        format!(
            "{}, as far as these digits tell: measure with more of them. The closest comes first; z is its \
             distance in standard errors, at most 4.\n",
            what.replace("{}", &how_many.to_string())
        )
    }

    /// What the readings say, in sentences, and how to tell matches apart.
    pub fn explain(&self) -> String {
        let mut text = String::new();
        let below = |r: &&Reading| r.value + r.error < 0.0;
        if let Some(reading) = self.readings.iter().find(below) {
            let _ = writeln!(
                text,
                "A white sky reads 0 or more, and {} is below: look for a wrong sign first.",
                reading.value
            );
        }
        let Some((first, others)) = self.matches().split_first() else {
            text += &match self.findings.first() {
                Some(Finding { variant, z }) if z.is_finite() => format!(
                    "No mistake on the list reads this; the nearest is {z:.1} standard errors \
                     away: {}.\n",
                    variant.name
                ),
                _ => "No mistake on the list reads this.\n".to_owned(),
            };
            return text;
        };
        text += &self.headline();
        let Finding { variant, z } = first;
        let _ = writeln!(
            text,
            "{} (z {z:.2}). Forgotten: {}.",
            variant.name, variant.forgot
        );
        for other in others {
            let name = other.variant.name;
            let _ = writeln!(
                text,
                "or: {name} (z {:.2}). Forgotten: {}. {}",
                other.z,
                other.variant.forgot,
                tell_apart(variant, &other.variant)
            );
        }
        text
    }
}

/// Questions of which every mistake on the list answers at least one wrongly.
pub fn questions() -> [Exam; 6] {
    let usual = Exam::default();
    let tilt = std::f32::consts::FRAC_PI_6;
    [
        usual,
        Exam {
            albedo: 0.5,
            ..usual
        },
        Exam { tilt, ..usual },
        Exam {
            samples: 4,
            ..usual
        },
        Exam {
            bounces: 2,
            ..usual
        },
        Exam {
            aimed: false,
            ..usual
        },
    ]
}

/// The question on which two variants read differently, if there is one.
pub fn question(a: &Variant, b: &Variant) -> Option<Exam> {
    questions()
        .into_iter()
        .find(|exam| (a.reading(exam) - b.reading(exam)).abs() > 0.05)
}

fn tell_apart(a: &Variant, b: &Variant) -> String {
    match question(a, b) {
        Some(exam) => format!(
            "To tell: with albedo {}, {} samples, a tilt of {:.0} degrees, {} bounce{} and {} \
             shadow rays the first reads {:.4} and this one {:.4}.",
            exam.albedo,
            exam.samples,
            exam.tilt.to_degrees(),
            exam.bounces,
            if exam.bounces == 1 { "" } else { "s" },
            if exam.aimed { "seeing" } else { "blind" },
            a.reading(&exam),
            b.reading(&exam)
        ),
        None => {
            "No reading tells them apart: they are the same numbers in another order.".to_owned()
        }
    }
}
