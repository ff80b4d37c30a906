//! When `halfdisk render` ends: after so many samples, at an error, or when time is up.

use super::left_out::LeftOut;
use crate::lab::chapter::whole;
use crate::render::accuracy::{Accuracy, Measure};
use crate::render::rounding;
use crate::render::stopping::{
    Goal, MOST_SAMPLES, Outcome, Prediction, Reached, StoppedBy, TOLERANCE, fewest, percent,
    seconds,
};
use crate::sampling::stream::Sampler;
use clap::Args;
use serde::Serialize;
use std::fmt::{self, Display, Formatter};
use std::time::Duration;

/// When a render ends.
#[derive(Debug, Args)]
pub(super) struct Ending {
    /// Samples per pixel [default: the scene's suggestion]
    #[arg(long, allow_negative_numbers = true, value_parser = whole(1_u32..=MOST_SAMPLES),
        conflicts_with_all = ["target_error", "time"])]
    spp: Option<u32>,
    /// End at this relative error, such as 2% or 0.02, or up to a twentieth of it above: the root mean square over the pixels of each one's
    /// standard error over the brightness around it, the mean of 9 x 9 pixels, or of the picture where
    /// that is brighter. A pilot with other random numbers predicts samples and seconds first
    #[arg(long, value_name = "PERCENT", value_parser = share)]
    target_error: Option<f64>,
    /// Let this share of the pixels, such as 95%, have the target error or less, in place of the root
    /// mean square
    #[arg(long, value_name = "PERCENT", value_parser = share, requires = "target_error")]
    target_quantile: Option<f64>,
    /// End after this time, such as 500ms, 30s, 5m or 1h30m, but not before each pixel has a sample; with
    /// --target-error, whichever is first
    #[arg(long, value_name = "TIME", value_parser = time)]
    time: Option<Duration>,
}

/// A share in (0, 1]: `2%` or `0.02`.
fn share(text: &str) -> Result<f64, String> {
    let (number, scale) = match text.strip_suffix('%') {
        Some(number) => (number.trim_end(), 100.0),
        None => (text, 1.0),
    };
    match number.parse::<f64>().map(|x| x / scale) {
        Ok(share) if share > 0.0 && share <= 1.0 => Ok(share),
        Ok(share) if scale == 1.0 && share > 1.0 && share <= 100.0 => Err(format!(
            "without a % that is {}; {number} per cent is written as {number}% or {}",
            percent(share),
            share / 100.0
        )),
        _ => Err("a share above 0 and up to 100 % is written as 2% or 0.02".to_owned()),
    }
}

/// A time: `500ms`, `30s`, `5m`, `1h30m`, or seconds.
pub(super) fn time(text: &str) -> Result<Duration, String> {
    let allowed = units(text).filter(|&s| s > 0.0 && s < 1e9);
    let time = allowed.and_then(|s| Duration::try_from_secs_f64(s).ok());
    time.ok_or_else(|| "a time above 0 is written as 500ms, 30s, 5m or 1h30m".to_owned())
}

/// Numbers with units, added up in seconds; one that stands alone needs no unit.
fn units(text: &str) -> Option<f64> {
    let mut seconds = 0.0;
    let mut rest = text.trim();
    while !rest.is_empty() {
        let end = rest.find(|c: char| !c.is_ascii_digit() && c != '.');
        let (number, after) = rest.split_at(end.unwrap_or(rest.len()));
        let after = after.trim_start();
        let end = after.find(|c: char| !c.is_alphabetic());
        let (unit, after) = after.split_at(end.unwrap_or(after.len()));
        let scale = match unit {
            "" if number == text.trim() => 1.0,
            "ms" => 1e-3,
            "s" => 1.0,
            "m" | "min" => 60.0,
            "h" => 3600.0,
            _ => return None,
        };
        seconds += number.parse::<f64>().ok()? * scale;
        rest = after.trim_start();
    }
    Some(seconds)
}

impl Ending {
    /// This end, or else another.
    pub(super) fn or(self, other: Ending) -> Ending {
        match (self.spp, self.target_error, self.time) {
            (None, None, None) => other,
            _ => self,
        }
    }

    /// Samples per pixel where nothing else ends the render.
    pub(super) fn spp(&self, suggested: u32) -> u32 {
        self.spp.unwrap_or(suggested)
    }

    pub(super) fn goal(&self) -> Goal {
        Goal {
            error: self.target_error,
            measure: self
                .target_quantile
                .map_or(Measure::default(), Measure::Quantile),
            time: self.time,
        }
    }
}

/// How accurate a picture is, and why its render ended.
#[derive(Serialize)]
pub(super) struct Ended<'a> {
    target: Option<f64>,
    tolerance: Option<f64>,
    quantile: Option<f64>,
    time: Option<f64>,
    #[serde(flatten, with = "Told")]
    pub outcome: &'a Outcome,
    error_is_a_bound: bool,
    top_share: Option<f64>,
    /// What the picture lacks.
    #[serde(skip)]
    left_out: Option<&'a LeftOut>,
}

/// What programs are told of how a render ended.
#[derive(Serialize)]
#[serde(remote = "Outcome")]
struct Told {
    prediction: Option<Prediction>,
    reached: Reached,
    stopped_by: StoppedBy,
    extensions: u32,
}

impl<'a> Ended<'a> {
    pub fn new(
        outcome: &'a Outcome,
        goal: &Goal,
        sampler: Sampler,
        left_out: Option<&'a LeftOut>,
    ) -> Self {
        let accuracy = Accuracy::of(&outcome.rendered.film);
        let noise = accuracy.error(Measure::RootMeanSquare);
        let has_noise = noise.is_finite() && noise > rounding(&outcome.rendered.rays);
        let has_pilot = outcome.prediction.is_some_and(|said| said.separate);
        Ended {
            target: goal.error,
            tolerance: goal.error.map(|_| TOLERANCE),
            quantile: match goal.measure {
                Measure::RootMeanSquare => None,
                Measure::Quantile(share) => Some(share),
            },
            time: goal.time.map(|t| t.as_secs_f64()),
            outcome,
            error_is_a_bound: !has_pilot && outcome.reached.spp < fewest(sampler),
            top_share: has_noise.then(|| accuracy.top_share()),
            left_out,
        }
    }

    /// Why it ended, where something but its samples should end it.
    fn end(&self) -> String {
        let why = match self.outcome.stopped_by {
            StoppedBy::Error => {
                let unknown = self.left_out.and_then(LeftOut::unknown);
                let but = unknown.map(|unknown| format!(", but {unknown}"));
                let (tolerance, but) = (percent(TOLERANCE), but.unwrap_or_default());
                return format!("\nended at its target (to within {tolerance} of it){but}");
            }
            StoppedBy::Time => "ended with its time",
            StoppedBy::Samples => "ended above its target, with the most samples it may take",
            StoppedBy::NoNoise if self.outcome.reached.error.is_finite() => {
                "ended above its target: what is left of the error is rounding"
            }
            StoppedBy::NoNoise => "ended without an error to compare with its target",
            StoppedBy::Interrupt if self.outcome.is_pilot => {
                "the picture is the pilot's, which has a seed of its own"
            }
            StoppedBy::Interrupt => return String::new(),
        };
        format!("\n{why}")
    }

    /// The error of the picture.
    fn error(&self) -> String {
        let Reached { error, .. } = self.outcome.reached;
        if error.is_infinite() {
            let film = &self.outcome.rendered.film;
            let why = match film.pixels().iter().map(|p| p.count()).min().unwrap_or(0) {
                0 => "some pixels have no sample",
                1 => "one sample has no spread",
                _ if film.max() == 0.0 => "no sample found light",
                _ => {
                    "all samples of each pixel are alike: they are exact, or what differs is too rare \
                     to have been met"
                }
            };
            return format!("error: not known ({why})");
        }
        let bound = if self.error_is_a_bound {
            "at most "
        } else {
            ""
        };
        let of = self.quantile.map_or_else(String::new, |share| {
            format!(" or less in {} of the pixels", percent(share))
        });
        format!("error: {bound}{}{of}", percent(error))
    }

    /// Samples and seconds beside those that were predicted.
    fn samples(&self) -> String {
        let Reached {
            spp, seconds: gone, ..
        } = self.outcome.reached;
        let mut samples = format!("samples per pixel: {spp}");
        let mut time = format!("time: {}", seconds(gone));
        if let Some(said) = &self.outcome.prediction {
            samples += &format!(", predicted {}", said.spp);
            time += &format!(", predicted {}", seconds(said.seconds));
        }
        let light_paths = self.outcome.prediction.and_then(|said| said.light_paths);
        let light_paths = light_paths.map_or_else(String::new, |n| format!(" --light-paths {n}"));
        let again = match self.outcome.stopped_by {
            StoppedBy::Interrupt => String::new(),
            _ => format!("; the same picture comes by --spp {spp}{light_paths}"),
        };
        format!("\n{samples}; {time}{again}")
    }
}

impl Display for Ended<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let has_goal = self.target.is_some() || self.time.is_some();
        f.write_str(&self.error())?;
        let finder = self.left_out.and_then(LeftOut::finder);
        if let Some(name) = finder.filter(|_| self.outcome.reached.error.is_finite()) {
            write!(f, " of the light that {name} finds")?;
        }
        if let Some(target) = self.target {
            write!(f, ", target {}", percent(target))?;
        }
        if let Some(said) = self
            .outcome
            .prediction
            .filter(|said| said.error.is_finite())
        {
            write!(f, "; predicted {}", percent(said.error))?;
        }
        if has_goal {
            f.write_str(&self.samples())?;
        }
        if let Some(top) = self.top_share {
            let worst = match self.outcome.rendered.film.pixels().len() {
                0..=1000 => "worst pixel has",
                _ => "worst 0.1 % of the pixels have",
            };
            let top = percent(top);
            write!(f, "\nfireflies: the {worst} {top} of the squared error")?;
        }
        if has_goal {
            f.write_str(&self.end())?;
        }
        let times = match self.outcome.extensions {
            0 => return writeln!(f),
            1 => "once".to_owned(),
            2 => "twice".to_owned(),
            n => format!("{n} times"),
        };
        writeln!(
            f,
            "\nrendered more samples {times}: the error was still above the target"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_numbers_with_units() {
        let ms = |text: &str| time(text).map(|t| t.as_millis()).ok();
        for (text, expected) in [
            ("30", 30_000),
            ("0.5s", 500),
            ("500ms", 500),
            ("5m", 300_000),
            ("2 min", 120_000),
            ("1h30m", 5_400_000),
            ("1h 30m 5s", 5_405_000),
            ("1.5h", 5_400_000),
            ("1m30.5s", 90_500),
        ] {
            assert_eq!(ms(text), Some(expected), "{text}");
        }
        for wrong in [
            "", "s", "0", "0ms", "-1s", "1h30", "30 30", "1e3s", "3d", "inf", "1.2.3s", "1h-5m",
        ] {
            assert_eq!(ms(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn shares_are_percentages_or_fractions() {
        for (text, expected) in [
            ("2%", 0.02),
            ("2 %", 0.02),
            ("0.02", 0.02),
            ("1", 1.0),
            ("100%", 1.0),
        ] {
            assert_eq!(share(text), Ok(expected));
        }
        let said = share("2").unwrap_err();
        assert_eq!(
            said,
            "without a % that is 200 %; 2 per cent is written as 2% or 0.02"
        );
        for wrong in [
            "", "%", "0", "0%", "-2%", "101%", "nan", "inf", "two", "2%%",
        ] {
            assert!(share(wrong).is_err(), "{wrong}");
        }
    }
}
