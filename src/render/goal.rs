//! What a render should reach, what it is predicted to take, and how far it got.

use super::accuracy::Measure;
use serde::Serialize;
use std::time::Duration;

/// What is asked of a render.
#[derive(Clone, Copy, Debug, Default)]
pub struct Goal {
    /// The relative error it should reach (see [`accuracy`](super::accuracy)).
    pub error: Option<f64>,
    /// How the errors of all pixels become one number.
    pub measure: Measure,
    /// The time it may take, pilot included. Each pixel gets one sample, however long that takes.
    pub time: Option<Duration>,
}

/// What a pilot saw.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Pilot {
    /// Its samples for each pixel.
    pub spp: u32,
    /// Its seconds in the pixel loop.
    pub seconds: f64,
    /// The relative error of its picture; infinite where it is not known.
    pub error: f64,
    /// The relative standard error of that, as far as the scatter of pixels tells; infinite where it is
    /// not known.
    pub uncertainty: f64,
}

/// What a render will take.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Prediction {
    /// What it was predicted from.
    pub pilot: Pilot,
    /// Samples for each pixel.
    pub spp: u32,
    /// Seconds in the pixel loop, without the pilot's.
    pub seconds: f64,
    /// The relative error then; infinite where it is not known.
    pub error: f64,
    /// What sets the number of samples: the error, the time, the most samples there may be, or that the
    /// pilot saw no noise.
    pub limited_by: StoppedBy,
    /// True where the pilot has random numbers of its own; false where it is the beginning of the picture
    /// itself, and its word changes nothing.
    pub separate: bool,
    /// Paths from the lights in each sample of all pixels, where other than the usual number promise the same
    /// error for fewer rays.
    #[serde(skip)]
    pub light_paths: Option<u32>,
}

/// How far a render got.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Reached {
    /// Samples of each pixel.
    pub spp: u32,
    /// Seconds since its first sample, without the pilot's.
    pub seconds: f64,
    /// Its relative error: by its own account, or, of less than two runs of even samples, by the
    /// pilot's. Infinite where it is not known: where pixels have one sample, or all samples of each
    /// pixel are alike.
    pub error: f64,
    /// Seconds it still needs to the target, where there is one.
    pub seconds_to_target: Option<f64>,
    /// Seconds it would still need to half its error.
    pub seconds_to_half: f64,
}

/// Why a render ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum StoppedBy {
    /// The error is at its target.
    Error,
    /// Time is up, by prediction or by the clock.
    Time,
    /// It has the samples that were asked for, or the most it may take.
    Samples,
    /// All samples of each pixel are alike, so that no error can be told: they are exact, or what
    /// differs is too rare to have been met.
    NoNoise,
    /// Somebody stopped it.
    Interrupt,
}
