//! What is predicted and reached, in words.

use crate::numeric::{count, three_digits};
use crate::render::goal::{Pilot, Prediction, Reached, StoppedBy};
use std::fmt::{Display, Formatter, Result};

impl Display for Pilot {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let (spp, time) = (
            count(self.spp as usize, "sample", "samples"),
            seconds(self.seconds),
        );
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
            count(self.spp as usize, "sample", "samples"),
            seconds(self.seconds),
            error(self.error),
        )?;
        if let Some(paths) = self.light_paths {
            let paths = count(paths as usize, "path", "paths");
            write!(f, ", {paths} from the lights in each")?;
        }
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
        p => format!("{} %", three_digits(p)),
    }
}

/// A duration as people say it, rounded.
pub fn seconds(seconds: f64) -> String {
    match seconds {
        s if !s.is_finite() => "unknown time".to_owned(),
        s if s < 99.95 => format!("{} s", three_digits(s)),
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
            (5999.4, "99 min 59 s"),
            (5999.6, "1.7 h"),
            (6000.0, "1.7 h"),
            (7380.0, "2.0 h"),
            (f64::NAN, "unknown time"),
            (f64::INFINITY, "unknown time"),
        ] {
            assert_eq!(seconds(s), said, "{s}");
        }
        for i in 0..59_900 {
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
    #[test]
    fn small_shares_keep_two_digits_and_none_is_printed_as_nothing() {
        let shown = [0.0, 1e-9, 4e-6, 1e-5, 0.00094, 0.02, 0.09999].map(percent);
        let expected = [
            "0.00 %",
            "1.0e-7 %",
            "0.00040 %",
            "0.0010 %",
            "0.094 %",
            "2.00 %",
            "10.0 %",
        ];
        assert_eq!(shown, expected);
    }
}
