//! What is predicted and reached, in words.

use crate::render::goal::{Prediction, Reached, StoppedBy};
use std::fmt::{Display, Formatter, Result};

impl Display for Prediction {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let pilot = &self.pilot;
        write!(
            f,
            "pilot: {} samples per pixel in {} have an error of {}; predicted: {} samples, {}, error {}",
            pilot.spp,
            seconds(pilot.seconds),
            percent(pilot.error),
            self.spp,
            seconds(self.seconds),
            percent(self.error),
        )?;
        match self.limited_by {
            StoppedBy::Time => write!(f, ", for that is the time there is"),
            StoppedBy::Samples => write!(f, ", the most samples there may be"),
            StoppedBy::Error | StoppedBy::Interrupt => Ok(()),
        }
    }
}

impl Display for Reached {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let error = percent(self.error);
        write!(
            f,
            "{} spp in {}: error {error}",
            self.spp,
            seconds(self.seconds)
        )?;
        if let Some(left) = self.seconds_to_target {
            write!(f, ", target in {}", seconds(left))?;
        }
        write!(f, ", half of it in {}", seconds(self.seconds_to_half))
    }
}

/// A share as a percentage of three digits; `unknown` where it is not finite.
pub fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    match percent {
        p if !p.is_finite() => "unknown".to_owned(),
        p if p < 10.0 => format!("{p:.2} %"),
        p if p < 100.0 => format!("{p:.1} %"),
        p => format!("{p:.0} %"),
    }
}

/// A duration as people say it.
pub fn seconds(seconds: f64) -> String {
    match seconds {
        s if !s.is_finite() => "unknown time".to_owned(),
        s if s < 10.0 => format!("{s:.2} s"),
        s if s < 100.0 => format!("{s:.1} s"),
        s if s < 6000.0 => format!(
            "{:.0} min {:02.0} s",
            (s / 60.0).floor(),
            (s % 60.0).floor()
        ),
        s => format!("{:.1} h", s / 3600.0),
    }
}
