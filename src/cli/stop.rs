//! When `halfdisk render` ends: after so many samples, at an error, or when time is up.

use crate::desk::whole;
use crate::render::accuracy::{Accuracy, Measure};
use crate::render::target::{Goal, MOST_SAMPLES, Outcome, StoppedBy, fewest, percent, seconds};
use crate::sampling::stream::Sampler;
use clap::Args;
use serde_json::{Value, json};
use std::time::Duration;

/// When a render ends.
#[derive(Debug, Args)]
pub(super) struct Ending {
    /// Samples per pixel [default: the scene's suggestion]
    #[arg(long, allow_negative_numbers = true, value_parser = whole(1_u32..=MOST_SAMPLES),
        conflicts_with_all = ["target_error", "time"])]
    spp: Option<u32>,
    /// End at this relative error, such as 2%: the root mean square over the pixels of each one's
    /// standard error over the brightness around it, the mean of 9 x 9 pixels, or of the picture where
    /// that is brighter. A pilot with other random numbers predicts samples and seconds first
    #[arg(long, value_name = "PERCENT", value_parser = share)]
    target_error: Option<f64>,
    /// Let this share of the pixels, such as 95%, have the target error or less, in place of the root
    /// mean square
    #[arg(long, value_name = "PERCENT", value_parser = share, requires = "target_error")]
    target_quantile: Option<f64>,
    /// End after this time, such as 30s, 5m or 1h, pilot included; with --target-error, whichever is
    /// first
    #[arg(long, value_name = "TIME", value_parser = time)]
    time: Option<Duration>,
}

/// A share in (0, 1]: `2%` or `0.02`.
fn share(text: &str) -> Result<f64, String> {
    let (number, scale) = match text.strip_suffix('%') {
        Some(number) => (number.trim_end(), 100.0),
        None => (text, 1.0),
    };
    let share = number.parse::<f64>().map(|x| x / scale);
    let allowed = share.ok().filter(|&x| x > 0.0 && x <= 1.0);
    allowed.ok_or_else(|| "a share above 0 and up to 1 is written as 2% or 0.02".to_owned())
}

/// A time: `30s`, `5m`, `1h`, or seconds.
fn time(text: &str) -> Result<Duration, String> {
    let units = [("s", 1.0), ("m", 60.0), ("h", 3600.0)];
    let named = units
        .iter()
        .find_map(|(unit, s)| Some((text.strip_suffix(unit)?, *s)));
    let (number, unit) = named.unwrap_or((text, 1.0));
    let seconds = number.trim_end().parse::<f64>().map(|x| x * unit);
    let allowed = seconds.ok().filter(|&s| s > 0.0 && s < 1e9);
    let time = allowed.and_then(|s| Duration::try_from_secs_f64(s).ok());
    time.ok_or_else(|| "a time is written as 30s, 5m or 1h".to_owned())
}

impl Ending {
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

/// How accurate the picture is and why it ended, for people.
pub(super) fn report(outcome: &Outcome, goal: &Goal, sampler: Sampler) -> String {
    let reached = &outcome.reached;
    let known =
        outcome.prediction.is_some() || u64::from(reached.spp) >= u64::from(fewest(sampler));
    let bound = if known { "" } else { " or less" };
    let of = match goal.measure {
        Measure::RootMeanSquare => String::new(),
        Measure::Quantile(share) => format!(" or less in {} of the pixels", percent(share)),
    };
    let mut text = format!("error reached: {}{bound}{of}", percent(reached.error));
    if let Some(target) = goal.error {
        text += &format!(", target {}", percent(target));
    }
    if let Some(said) = &outcome.prediction {
        text += &format!(
            "; predicted {}\nsamples per pixel: {}, predicted {}; time: {}, predicted {}",
            percent(said.error),
            reached.spp,
            said.spp,
            seconds(reached.seconds),
            seconds(said.seconds)
        );
    }
    let top = Accuracy::of(&outcome.rendered.film).top_share();
    if top.is_finite() {
        let top = percent(top);
        text +=
            &format!("\nfireflies: the worst 0.1 % of the pixels have {top} of the squared error");
    }
    if goal.error.is_some() || goal.time.is_some() {
        text += match outcome.stopped_by {
            StoppedBy::Error => "\nended at its target",
            StoppedBy::Time => "\nended with its time",
            StoppedBy::Samples => "\nended above its target, with the most samples it may take",
            StoppedBy::Interrupt if outcome.prediction.is_none() => {
                "\nthe picture is the pilot's, which has a seed of its own"
            }
            StoppedBy::Interrupt => "",
        };
    }
    if outcome.extensions > 0 {
        let times = outcome.extensions;
        text += &format!("; it went on {times} times because the error was above the target");
    }
    text + "\n"
}

/// The same for machines.
pub(super) fn as_json(outcome: &Outcome, goal: &Goal) -> Value {
    let accuracy = Accuracy::of(&outcome.rendered.film);
    let quantile = match goal.measure {
        Measure::RootMeanSquare => None,
        Measure::Quantile(share) => Some(share),
    };
    json!({
        "target": goal.error,
        "quantile": quantile,
        "time": goal.time.map(|t| t.as_secs_f64()),
        "prediction": outcome.prediction,
        "reached": outcome.reached,
        "stopped_by": outcome.stopped_by,
        "extensions": outcome.extensions,
        "top_share": accuracy.top_share(),
    })
}
