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
    /// The time it may take, pilot included.
    pub time: Option<Duration>,
}

/// What a pilot saw.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Pilot {
    /// Its samples for each pixel.
    pub spp: u32,
    /// Its seconds in the pixel loop.
    pub seconds: f64,
    /// The relative error of its picture.
    pub error: f64,
    /// The relative standard error of that, as far as the scatter of pixels tells.
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
    /// The relative error then.
    pub error: f64,
    /// What sets the number of samples: the error, the time, or the most samples there may be.
    pub limited_by: StoppedBy,
}

/// How far a render got.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Reached {
    /// Samples of each pixel.
    pub spp: u32,
    /// Seconds since its first sample, without the pilot's.
    pub seconds: f64,
    /// Its relative error: by its own account, or, of less than two runs of even samples, by the
    /// pilot's.
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
    /// Somebody stopped it.
    Interrupt,
}
