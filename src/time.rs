//! The time, where there is a clock.

use std::time::{Duration, Instant};

/// A moment from which time is measured.
///
/// On the web Rust has no clock, and to ask for one would panic: there the time gone is not known.
#[derive(Clone, Copy, Debug)]
pub struct Moment(Option<Instant>);

impl Moment {
    /// This moment.
    pub fn now() -> Self {
        let clock = !cfg!(all(target_family = "wasm", target_os = "unknown"));
        Moment(clock.then(Instant::now))
    }

    /// The time gone since; `None` where there is no clock.
    pub fn elapsed(self) -> Option<Duration> {
        self.0.map(|start| start.elapsed())
    }
}
