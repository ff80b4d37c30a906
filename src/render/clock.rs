//! The time that a render may take.

use super::Progress;
use crate::time::Moment;
use std::time::Duration;

/// Says when time is up, by the clock of who watches.
pub(super) struct Clock<'a> {
    start: Moment,
    time: Duration,
    progress: &'a dyn Progress,
    /// True where the first pass over the picture is finished though time is up.
    pub waits: bool,
}

impl<'a> Clock<'a> {
    /// Starts now; time is up after `time`, but not before each pixel has a sample.
    pub fn new(time: Duration, progress: &'a dyn Progress) -> Self {
        Clock {
            start: Moment::now(),
            time,
            progress,
            waits: true,
        }
    }

    /// A clock that started with this one, stops after a share of its time, and waits for nothing.
    pub fn share(&self, share: f64) -> Clock<'a> {
        Clock {
            time: self.time.mul_f64(share),
            waits: false,
            ..*self
        }
    }

    /// True once time is up.
    pub fn late(&self) -> bool {
        self.elapsed() >= self.time
    }

    /// What is gone of the time.
    pub fn elapsed(&self) -> Duration {
        self.progress.elapsed(self.start)
    }

    /// What is left of the time.
    pub fn left(&self) -> Duration {
        self.time.saturating_sub(self.elapsed())
    }

    /// Tells how much of the time is gone.
    pub fn tell(&self) {
        let [gone, all] = [self.elapsed().min(self.time), self.time];
        self.progress
            .tell(gone.as_millis() as u64, all.as_millis() as u64);
    }
}
