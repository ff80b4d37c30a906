//! All that a render knows of its samples, so that it can go on later, elsewhere, as if it had never stopped.

use super::watch::Watch;
use super::{BadSample, Faults, Film, Rendered, Shard};
use crate::sampling::stream::Sampler;
use crate::scene::RayCounts;
use crate::stats::Estimate;

/// A render between two samples, from what it leaves ([`Rendered`]): [`Session::resume`](super::Session::resume) goes on
/// from it.
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
    /// The mean of the picture by each pass alone; in no file, since a part of the picture does not know it.
    #[serde(skip)]
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
    /// The samples that every pixel has taken, of a shard those of its own; more than there can be where it has no
    /// pixel, for a small picture may have fewer tiles than shards.
    pub fn spp(&self, shard: Option<Shard>) -> u32 {
        let film = &self.film;
        let shard = shard.unwrap_or(Shard { index: 1, count: 1 });
        let places = shard.places(self.size());
        let taken = places.map(|[[x, y], _]| film.pixel(x, y).taken);
        taken.min().unwrap_or(u32::MAX)
    }

    /// The same of a shard with its film [packed](Film::packed) from a picture of this size.
    pub(crate) fn packed_spp(&self, shard: Shard, size: [u32; 2]) -> u32 {
        let places = shard.places(size);
        let taken = places.map(|[_, [x, y]]| self.film.pixel(x, y).taken);
        taken.min().unwrap_or(u32::MAX)
    }

    /// Width and height of its picture.
    pub fn size(&self) -> [u32; 2] {
        [self.film.width(), self.film.height()]
    }

    // ANCHOR: add_shard
    /// Adds a shard of the same picture: what its render knows, with its film [packed](Film::packed).
    ///
    /// # Panics
    ///
    /// Where that was packed from a picture of another size.
    pub fn add_shard(&mut self, part: &State, shard: Shard) {
        self.film.unpack(&part.film, shard);
        self.tally.join(&part.tally);
        // What passes prepare is for all pixels, so each shard has it.
        self.tally.rays += part.tally.rays - part.tally.pass_rays;
    }
    // ANCHOR_END: add_shard

    /// Adds a picture of the same scene by another seed, of as many samples: the mean of all samples of both.
    ///
    /// Samples that lie evenly tell their error by runs of one length, and those of two seeds are independent, so each
    /// pixel has the runs of both. A picture too short for a run is one itself.
    ///
    /// # Panics
    ///
    /// Where their pictures differ in size.
    pub fn add_seed(&mut self, other: &State, sampler: Sampler) {
        assert_eq!(self.size(), other.size());
        let pixels = self.film.pixels_mut().iter_mut();
        for (pixel, its) in pixels.zip(other.film.pixels()) {
            let mut its = *its;
            if sampler == Sampler::Sobol {
                for pixel in [&mut *pixel, &mut its] {
                    if pixel.in_runs == 0 {
                        pixel.end_run(false);
                    }
                }
            }
            pixel.merge(&its);
        }
        self.tally.join(&other.tally);
        self.tally.rays += other.tally.rays;
        self.tally.pass_rays += other.tally.pass_rays;
    }
}

impl Tally {
    /// What samples of both were, but for their rays.
    fn join(&mut self, other: &Tally) {
        let mut one = Watch::from(*self);
        one.join(Watch::from(*other));
        self.faults = one.faults;
        self.first_bad = one.first;
        self.largest = one.largest;
        self.lights_met |= other.lights_met;
    }
}

impl From<Tally> for Watch {
    fn from(tally: Tally) -> Self {
        Watch {
            faults: tally.faults,
            first: tally.first_bad,
            largest: tally.largest,
        }
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
