//! Who watches a render.

use super::Rendered;
use super::goal::{Pilot, Prediction, Reached};
use crate::time::Moment;
use std::time::Duration;

/// What is told while a render runs, and how it is stopped.
pub trait Progress: Sync {
    /// `done` of `total` samples of all pixels are finished.
    fn tell(&self, done: u64, total: u64);
    /// True to stop soon and keep what is there.
    fn stop(&self) -> bool;
    /// The time gone since `start`. Who watches may have a clock of their own, which never goes back. On
    /// the web they must: without a clock, any time is up at once.
    fn elapsed(&self, start: Moment) -> Duration {
        start.elapsed().unwrap_or(Duration::MAX)
    }
    /// A pilot got so far.
    fn piloted(&self, _: &Pilot) {}
    /// A pilot says what a render to a goal will take.
    fn predicted(&self, _: &Prediction) {}
    /// A render to a goal got so far.
    fn reached(&self, _: &Reached) {}
    /// How much time may pass between two calls of [`Progress::keep`]; `None` where nobody keeps anything.
    fn keeps_every(&self) -> Option<Duration> {
        None
    }
    /// A render got so far, on its way to `spp` samples per pixel.
    fn keep(&self, _: &Rendered, _spp: u32) {}
}

/// Nobody watches and nobody stops.
impl Progress for () {
    fn tell(&self, _: u64, _: u64) {}
    fn stop(&self) -> bool {
        false
    }
}
