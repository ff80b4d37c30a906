//! What integrators are made with, and what those do that look at the scene beforehand.

use crate::radiosity::{PatchSize, RadiosityError};

/// What an integrator is made with.
#[derive(Clone, Copy)]
pub struct Settings<'a> {
    /// The longest path in segments.
    pub max_depth: u32,
    /// How small patches are, for integrators that have any.
    pub patches: PatchSize,
    /// Who watches, where making it takes a while.
    pub watch: &'a dyn Watch,
}

impl Settings<'_> {
    /// Paths of at most `max_depth` segments, all else as usual, and nobody watches.
    pub fn new(max_depth: u32) -> Self {
        Settings {
            max_depth,
            patches: PatchSize::default(),
            watch: &(),
        }
    }
}

/// Who watches while an integrator is made.
pub trait Watch: Sync {
    /// `done` of `total` parts of the work are finished.
    fn tell(&self, done: u64, total: u64);
    /// True to give up soon.
    fn stop(&self) -> bool;
}

/// Nobody watches and nobody stops.
impl Watch for () {
    fn tell(&self, _: u64, _: u64) {}
    fn stop(&self) -> bool {
        false
    }
}

/// Why there is no such integrator for a scene, as one sentence for people.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Refused {
    /// Its light cannot be put onto patches.
    #[error(transparent)]
    Radiosity(#[from] RadiosityError),
}

impl Refused {
    /// True where whoever watches asked for it.
    pub fn is_stop(&self) -> bool {
        matches!(self, Refused::Radiosity(RadiosityError::Stopped))
    }
}
