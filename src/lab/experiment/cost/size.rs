//! What pictures of one size give, and what can be said of several.

use serde::Serialize;

/// What pictures of one size give.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Size {
    /// Samples per pixel.
    pub spp: u32,
    /// Mean rays of a picture.
    pub rays: f64,
    /// Median seconds of a picture.
    pub seconds: f64,
    /// Mean seconds, through which the line goes.
    pub mean_seconds: f64,
    /// Between the quartiles of the seconds.
    pub spread: f64,
    /// Root mean squared relative error, without bias; 0 where its square came out below zero.
    pub error: f64,
    /// Standard error of that.
    pub error_error: f64,
    /// The share of the squared error in the worst thousandth of the pixels.
    pub top_share: f64,
}

/// What can be said about how the error of a method falls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Like one over the root of its rays: the interval of the slope is narrow and holds -1/2.
    Sufficient,
    /// Even points: faster than one over the root.
    Faster,
    /// It levels out: its expectation is not the truth.
    Biased,
    /// No statement.
    Insufficient,
}
