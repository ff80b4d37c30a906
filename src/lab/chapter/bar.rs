//! A progress bar with the time left, on stderr; silent where that is no terminal.

use super::tell;
use crate::radiosity::Watch;
use crate::render::Progress;
use crate::render::stopping::{Pilot, Prediction, Reached};
use indicatif::{ProgressBar, ProgressStyle};
use std::sync::atomic::{AtomicBool, Ordering};

/// Shows how far a render is, and passes on a wish to stop.
#[derive(Debug)]
pub struct Bar {
    bar: ProgressBar,
    stop: &'static AtomicBool,
    speaks: bool,
}

impl Bar {
    /// A bar labelled `what` that stops its render once `stop` is true.
    pub fn new(what: &str, stop: &'static AtomicBool) -> Self {
        let bar = ProgressBar::new(0).with_message(what.to_owned());
        let template = "{msg}  [{bar:32}] {percent:>3} %  {elapsed} gone, {eta} left{prefix}";
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style.progress_chars("=> "));
        }
        Bar {
            bar,
            stop,
            speaks: true,
        }
    }

    /// A bar that shows nothing.
    pub fn hidden(stop: &'static AtomicBool) -> Self {
        Bar {
            bar: ProgressBar::hidden(),
            stop,
            speaks: false,
        }
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

impl Watch for Bar {
    fn tell(&self, done: u64, total: u64) {
        Progress::tell(self, done, total);
    }

    fn stop(&self) -> bool {
        Progress::stop(self)
    }
}

impl Progress for Bar {
    fn tell(&self, done: u64, total: u64) {
        self.bar.set_length(total);
        self.bar.set_position(done);
    }

    fn stop(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// Said at once, whether or not there is a terminal: a long wait may follow.
    fn predicted(&self, said: &Prediction) {
        if self.speaks {
            self.bar.suspend(|| tell(said));
        }
    }

    fn piloted(&self, pilot: &Pilot) {
        self.bar.set_prefix(format!("; pilot: {pilot}"));
    }

    fn reached(&self, reached: &Reached) {
        self.bar.set_prefix(format!("; {reached}"));
    }
}
