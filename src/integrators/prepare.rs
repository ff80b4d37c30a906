//! What integrators are made with, and what those do that look at the scene beforehand.

use crate::radiosity::{PatchSize, RadiosityError, Watch};

/// What an integrator is made with.
#[derive(Clone, Copy)]
pub struct Settings<'a> {
    /// The longest path in segments.
    pub max_depth: u32,
    /// How small patches are, for integrators that have any.
    pub patches: PatchSize,
    /// Paths from the lights in each sample of all pixels, for integrators that trace some: see
    /// [`Path::light_paths`](super::Path::light_paths).
    pub light_paths: Option<u32>,
    /// Walks from the lights in each pass, for integrators with photons; `None` for the usual number.
    pub walks: Option<u32>,
    /// The radius of their first discs in scene units, positive; `None` for the usual one.
    pub radius: Option<f32>,
    /// Who watches, where making it takes a while.
    pub watch: &'a dyn Watch,
}

impl Settings<'_> {
    /// Paths of at most `max_depth` segments, all else as usual, and nobody watches.
    pub fn new(max_depth: u32) -> Self {
        Settings {
            max_depth,
            patches: PatchSize::default(),
            light_paths: None,
            walks: None,
            radius: None,
            watch: &(),
        }
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
