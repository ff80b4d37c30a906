//! All that a render knows of its samples, so that it can go on later, elsewhere, as if it had never stopped.

use super::{BadSample, Faults, Film, Rendered};
use crate::scene::RayCounts;
use crate::stats::Estimate;

/// A render between two samples: see [`Rendered::state`] and [`Session::resume`](super::Session::resume).
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// The picture, with how many samples each pixel has taken.
    pub film: Film,
    /// What is known of all pixels together.
    pub tally: Tally,
}

/// What is known of the samples of all pixels together: the fields of [`Rendered`] of these names.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Tally {
    /// Rays traced.
    pub rays: RayCounts,
    /// Those of them that passes prepared.
    pub pass_rays: RayCounts,
    /// The mean of the picture by each pass alone.
    pub passes: Estimate,
    /// Samples that no light can have brought.
    pub faults: Faults,
    /// The first of them in row order.
    pub first_bad: Option<BadSample>,
    /// The largest channel of a sample without fault.
    pub largest: f32,
    /// The lamps that walks have met.
    pub lights_met: u64,
}

impl State {
    /// The samples that every pixel has taken.
    pub fn spp(&self) -> u32 {
        let taken = self.film.pixels().iter().map(|pixel| pixel.taken);
        taken.min().unwrap_or(0)
    }
}

impl From<&Rendered> for Tally {
    fn from(rendered: &Rendered) -> Self {
        Tally {
            rays: rendered.rays,
            pass_rays: rendered.pass_rays,
            passes: rendered.passes,
            faults: rendered.faults,
            first_bad: rendered.first_bad,
            largest: rendered.largest,
            lights_met: rendered.lights_met,
        }
    }
}

impl From<&Rendered> for State {
    fn from(rendered: &Rendered) -> Self {
        State {
            film: rendered.film.clone(),
            tally: rendered.into(),
        }
    }
}
