//! Samples of which more is kept than their radiance.

use super::{Film, Rendered};
use crate::color::Rgb;
use crate::geometry::Ray;
use crate::integrators::{Integrator, Passes, PathInLanes, Splat};
use crate::sampling::stream::Stream;
use crate::scene::{Scene, Tracer};

/// Takes the samples of a picture, and records their parts in further pictures or notes.
///
/// Every [`Integrator`] is one that records nothing else.
pub trait Recorder: Sync {
    /// What is noted of the samples of a tile.
    type Notes: Clone + Default + Send + Sync;

    /// How many further pictures there are.
    fn pictures(&self) -> usize {
        0
    }

    /// What is prepared for each sample of all pixels at once: its light is in the picture, too.
    fn passes(&self, _scene: &Scene) -> Option<&dyn Passes> {
        None
    }

    /// The same samples, many at a time, where nothing but their radiance is kept; `None` where each is taken by
    /// itself.
    fn in_lanes<'s>(&self, _scene: &'s Scene) -> Option<PathInLanes<'s>> {
        None
    }

    /// Records the light of such a pass that arrives in the pixel of a sample, in W/(m² sr), after
    /// [`Recorder::record`]; `splats` are its parts, where [`Prepared::splats`](crate::integrators::Prepared) has
    /// them.
    fn arrive(
        &self,
        _light: Rgb,
        _splats: impl Iterator<Item = Splat>,
        _parts: &mut [Rgb],
        _notes: &mut Self::Notes,
    ) {
    }

    /// One sample of the radiance that arrives along `ray`, in W/(m² sr). Its parts in the further pictures
    /// go to `parts`.
    fn record(
        &self,
        tracer: &mut Tracer,
        ray: &Ray,
        stream: &Stream,
        parts: &mut [Rgb],
        notes: &mut Self::Notes,
    ) -> Rgb;
}

impl<I: Integrator + ?Sized> Recorder for I {
    type Notes = ();

    fn passes(&self, scene: &Scene) -> Option<&dyn Passes> {
        Integrator::passes(self, scene)
    }

    fn in_lanes<'s>(&self, scene: &'s Scene) -> Option<PathInLanes<'s>> {
        Integrator::in_lanes(self, scene)
    }

    fn record(
        &self,
        tracer: &mut Tracer,
        ray: &Ray,
        stream: &Stream,
        _: &mut [Rgb],
        _: &mut (),
    ) -> Rgb {
        self.li(tracer, ray, stream)
    }
}

/// A render, and what was recorded of its samples.
#[derive(Clone, Debug)]
pub struct Recorded<Notes> {
    /// The picture.
    pub rendered: Rendered,
    /// The further pictures.
    pub pictures: Vec<Film>,
    /// The notes of each tile, in a fixed order.
    pub notes: Vec<Notes>,
}
