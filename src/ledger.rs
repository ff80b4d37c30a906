//! What a chapter cost and what it gained: one line of the book's ledger.

use serde::{Deserialize, Serialize};
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
    /// Distance of that estimate from the truth in standard errors, where the truth is known.
    pub bias_in_errors: Option<f64>,
    /// `1 / (variance · rays per sample)`: how much certainty a ray buys.
    pub efficiency: Option<f64>,
    /// What was paid and what was gained, in a sentence.
    pub gain: String,
}

impl Ledger {
    /// An empty line with its sentence; seconds are filled in when the chapter ends.
    pub fn of(gain: &str) -> Self {
        Ledger {
            rays: 0,
            seconds: 0.0,
            variance: None,
            bias_in_errors: None,
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
        if let Some(z) = self.bias_in_errors {
            write!(f, ", bias {z:+.2} standard errors")?;
        }
        if let Some(e) = self.efficiency {
            write!(f, ", efficiency {e:.3e} per ray")?;
        }
        Ok(())
    }
}
