//! What is predicted and reached, in words.

use crate::render::goal::{Pilot, Prediction, Reached, StoppedBy};
use std::fmt::{Display, Formatter, Result};

impl Display for Pilot {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let (spp, time) = (count(self.spp.into(), "sample"), seconds(self.seconds));
        write!(f, "{spp} per pixel in {time}, error {}", error(self.error))
    }
}

impl Display for Prediction {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(
            f,
            "{}: {}; predicted: {}, {}, error {}",
            if self.separate { "pilot" } else { "so far" },
            self.pilot,
            count(self.spp.into(), "sample"),
            seconds(self.seconds),
            error(self.error),
        )?;
        match self.limited_by {
            StoppedBy::Time => write!(f, "; the time there is allows no more"),
            StoppedBy::Samples => write!(f, "; a pixel may have no more"),
            StoppedBy::NoNoise => write!(f, "; the pilot saw no noise"),
            StoppedBy::Error | StoppedBy::Interrupt => Ok(()),
        }
    }
}

impl Display for Reached {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let (time, error) = (seconds(self.seconds), error(self.error));
        write!(f, "{} spp in {time}: error {error}", self.spp)?;
        if let Some(left) = self.seconds_to_target.filter(|left| left.is_finite()) {
            write!(f, ", target in {}", seconds(left))?;
        }
        write!(f, ", half of it in {}", seconds(self.seconds_to_half))
    }
}

/// `1 sample`, `2 samples`.
pub fn count(n: u64, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

/// An error as a percentage, or that it is not known.
fn error(share: f64) -> String {
    if share.is_finite() {
        percent(share)
    } else {
        "not known".to_owned()
    }
}

/// A share as a percentage of three digits, of two where it is less than a tenth of one; `unknown` where
/// it is not finite.
pub fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    match percent {
        p if !p.is_finite() => "unknown".to_owned(),
        p if p < 1e-4 && p > 0.0 => format!("{p:.1e} %"),
        p if p < 0.1 && p > 0.0 => {
            let digits = 1 - libm::floor(libm::log10(p)) as i32;
            format!("{p:.*} %", digits.unsigned_abs() as usize)
        }
        p if p < 9.995 => format!("{p:.2} %"),
        p if p < 99.95 => format!("{p:.1} %"),
        p => format!("{p:.0} %"),
    }
}

/// A duration as people say it.
pub fn seconds(seconds: f64) -> String {
    match seconds {
        s if !s.is_finite() => "unknown time".to_owned(),
        s if s < 9.995 => format!("{s:.2} s"),
        s if s < 99.95 => format!("{s:.1} s"),
        s if s < 5999.5 => {
            let whole = s.round() as u64;
            format!("{} min {:02} s", whole / 60, whole % 60)
        }
        s => format!("{:.1} h", s / 3600.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_shares_keep_two_digits_and_none_is_printed_as_nothing() {
        let shown = [0.0, 1e-9, 4e-6, 1e-5, 0.00094, 0.02, 0.09999, 0.5, 0.99999].map(percent);
        let expected = [
            "0.00 %",
            "1.0e-7 %",
            "0.00040 %",
            "0.0010 %",
            "0.094 %",
            "2.00 %",
            "10.0 %",
            "50.0 %",
            "100 %",
        ];
        assert_eq!(shown, expected);
    }

    #[test]
    fn no_minute_has_sixty_seconds() {
        let shown = [9.996, 99.96, 119.7, 3599.9, 5999.9].map(seconds);
        assert_eq!(
            shown,
            ["10.0 s", "1 min 40 s", "2 min 00 s", "60 min 00 s", "1.7 h"]
        );
    }
}
