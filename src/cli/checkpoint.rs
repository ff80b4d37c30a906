//! Pictures on the way: what a render has is written now and then.

use crate::lab::chapter::{Bar, tell};
use crate::output::{self, Display, Provenance};
use crate::render::stopping::{Pilot, Prediction, Reached};
use crate::render::{Progress, Rendered, Tally};
use std::path::Path;
use std::sync::OnceLock;
use std::time::Duration;

/// Whoever watches a render, and writes what there is.
pub(super) struct Keeper<'a> {
    pub bar: Bar,
    /// How often.
    pub every: Option<Duration>,
    pub path: &'a Path,
    /// What makes the picture with so many samples, and paths from the lights where a pilot chose their number.
    pub facts: &'a (dyn Fn(u32, Option<u32>) -> Provenance + Sync),
    /// What the pilot chose.
    pub light_paths: OnceLock<u32>,
}

impl Progress for Keeper<'_> {
    fn tell(&self, done: u64, total: u64) {
        self.bar.tell(done, total);
    }

    fn stop(&self) -> bool {
        self.bar.stop()
    }

    fn piloted(&self, pilot: &Pilot) {
        self.bar.piloted(pilot);
    }

    fn predicted(&self, said: &Prediction) {
        if let Some(light_paths) = said.light_paths {
            self.light_paths.get_or_init(|| light_paths);
        }
        self.bar.predicted(said);
    }

    fn reached(&self, reached: &Reached) {
        self.bar.reached(reached);
    }

    fn keeps_every(&self) -> Option<Duration> {
        self.every
    }

    /// A picture on the way that cannot be written ends nothing: the next one may be.
    fn keep(&self, rendered: &Rendered, spp: u32) {
        let facts = Provenance {
            tally: Some(Tally::from(rendered)),
            ..(self.facts)(spp, self.light_paths.get().copied())
        };
        if let Err(what) = output::write(self.path, &rendered.film, Display::Radiance, &facts) {
            tell(format_args!("note: --checkpoint: {what}"));
        }
    }
}
