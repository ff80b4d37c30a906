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

/// A share as a percentage, rounded to three digits; `unknown` where it is not finite.
pub fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    match percent {
        p if !p.is_finite() => "unknown".to_owned(),
        // What rounds to 10.00 or 100.0 has a digit less behind the point.
        p if p < 9.995 => format!("{p:.2} %"),
        p if p < 99.95 => format!("{p:.1} %"),
        p => format!("{p:.0} %"),
    }
}

/// A duration as people say it, rounded.
pub fn seconds(seconds: f64) -> String {
    match seconds {
        s if !s.is_finite() => "unknown time".to_owned(),
        s if s < 9.995 => format!("{s:.2} s"),
        s if s < 99.95 => format!("{s:.1} s"),
        s if s < 6000.0 => {
            let whole = s.round();
            format!("{:.0} min {:02.0} s", (whole / 60.0).floor(), whole % 60.0)
        }
        s => format!("{:.1} h", s / 3600.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The numbers in a text, in their order.
    fn numbers(text: &str) -> Vec<f64> {
        let parts = text.split(' ').filter_map(|part| part.parse().ok());
        parts.collect()
    }

    #[test]
    fn durations_are_rounded_and_no_minute_has_sixty_seconds() {
        for (s, said) in [
            (0.0, "0.00 s"),
            (9.994, "9.99 s"),
            (9.996, "10.0 s"),
            (99.94, "99.9 s"),
            (99.96, "1 min 40 s"),
            (119.4, "1 min 59 s"),
            (119.6, "2 min 00 s"),
            (179.999, "3 min 00 s"),
            (5999.6, "100 min 00 s"),
            (6000.0, "1.7 h"),
            (7380.0, "2.0 h"),
            (f64::NAN, "unknown time"),
            (f64::INFINITY, "unknown time"),
        ] {
            assert_eq!(seconds(s), said, "{s}");
        }
        for i in 0..60_000 {
            let s = 0.1 * f64::from(i) + 0.033;
            let said = seconds(s);
            let (read, step) = match numbers(&said)[..] {
                [minutes, rest] => {
                    assert!(rest < 60.0, "{said}");
                    (60.0 * minutes + rest, 1.0)
                }
                [s] if said.ends_with(" s") => (s, if s < 9.995 { 0.01 } else { 0.1 }),
                _ => panic!("{said}"),
            };
            assert!((read - s).abs() <= 0.5001 * step, "{s}: {said}");
        }
    }

    #[test]
    fn percentages_are_rounded_to_three_digits() {
        for (share, said) in [
            (0.0, "0.00 %"),
            (0.012_349, "1.23 %"),
            (0.012_351, "1.24 %"),
            (0.099_94, "9.99 %"),
            (0.099_96, "10.0 %"),
            (0.123_46, "12.3 %"),
            (0.123_54, "12.4 %"),
            (0.999_4, "99.9 %"),
            (0.999_6, "100 %"),
            (1.004_9, "100 %"),
            (1.005_1, "101 %"),
            (f64::INFINITY, "unknown"),
            (f64::NAN, "unknown"),
        ] {
            assert_eq!(percent(share), said, "{share}");
        }
        for i in 0..20_000 {
            let p = 0.01 * f64::from(i) + 0.003;
            let said = percent(0.01 * p);
            let read = numbers(&said)[0];
            let step = match p {
                p if p < 9.995 => 0.01,
                p if p < 99.95 => 0.1,
                _ => 1.0,
            };
            assert!((read - p).abs() <= 0.5001 * step, "{p}: {said}");
        }
    }
}
