//! What a chapter cost and what it gained: one line of the book's ledger.

use crate::stats::z_test::Largest;
use serde::{Deserialize, Deserializer, Serialize};
use std::fmt;

/// A chapter's line in the ledger.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ledger {
    /// Rays traced by the whole chapter.
    pub rays: u64,
    /// Wall-clock seconds of the whole chapter; the one number that differs from run to run.
    pub seconds: f64,
    /// Variance of one sample of the chapter's main estimate, where it has one.
    pub variance: Option<f64>,
    /// How far the chapter's results are from known truths, where there are any.
    pub compared: Option<Compared>,
    /// `1 / (variance · rays per sample)`: how much certainty a ray buys.
    pub efficiency: Option<f64>,
    /// What was paid and what was gained, in a sentence.
    pub gain: String,
}

/// The largest of several distances from known truths, and what to make of it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Compared {
    /// The largest |z|: the distance in standard errors, on whichever side. Endless where an estimate
    /// without an error is not the truth.
    #[serde(deserialize_with = "endless_if_null")]
    pub largest_z: f64,
    /// Of so many comparisons.
    pub comparisons: u32,
    /// What the largest |z| of so many exceeds by chance once in a thousand runs.
    pub surprising: f64,
}

/// JSON has no word for a number without end: it is written as null.
fn endless_if_null<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    Ok(Option::deserialize(from)?.unwrap_or(f64::INFINITY))
}

impl From<Largest> for Compared {
    fn from(largest: Largest) -> Self {
        Compared {
            largest_z: largest.z,
            comparisons: largest.of,
            // More digits would be those of the machine's logarithm.
            surprising: (100.0 * largest.surprising()).round() / 100.0,
        }
    }
}

impl fmt::Display for Compared {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Compared {
            largest_z,
            comparisons,
            surprising,
        } = self;
        let s = if *comparisons == 1 { "" } else { "s" };
        write!(
            f,
            "largest |z| {largest_z:.2} of {comparisons} comparison{s} with known truths; \
             {surprising:.1} would be surprising"
        )
    }
}

impl Ledger {
    /// An empty line with its sentence; seconds are filled in when the chapter ends.
    pub fn of(gain: &str) -> Self {
        Ledger {
            rays: 0,
            seconds: 0.0,
            variance: None,
            compared: None,
            efficiency: None,
            gain: gain.to_owned(),
        }
    }
}

impl fmt::Display for Ledger {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} rays, {:.2} s", self.rays, self.seconds)?;
        if let Some(v) = self.variance {
            write!(f, ", variance {v:.3e}")?;
        }
        if let Some(compared) = &self.compared {
            write!(f, ", {compared}")?;
        }
        if let Some(e) = self.efficiency {
            write!(f, ", efficiency {e:.3e} per ray")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_says_of_how_many_comparisons_the_largest_is_and_gives_it_no_sign() {
        let mut largest = Largest::default();
        [0.4, -2.796, 1.1].into_iter().for_each(|z| largest.add(z));
        largest = largest.with(Largest { z: 1.0, of: 21 });
        let ledger = Ledger {
            rays: 7,
            compared: Some(largest.into()),
            ..Ledger::of("")
        };
        assert_eq!(
            ledger.to_string(),
            "7 rays, 0.00 s, largest |z| 2.80 of 24 comparisons with known truths; 4.1 would be \
             surprising"
        );
    }

    #[test]
    fn an_endless_distance_survives_its_file() {
        let mut largest = Largest::default();
        largest.add(f64::NAN);
        let ledger = Ledger {
            compared: Some(largest.into()),
            ..Ledger::of("")
        };
        let text = serde_json::to_string(&ledger).unwrap();
        let back: Ledger = serde_json::from_str(&text).unwrap();
        assert_eq!(back, ledger, "{text}");
        assert!(
            back.to_string().contains("|z| inf of 1 comparison "),
            "{back}"
        );
    }
}
