//! All that a render knows of its samples, so that it can go on later, elsewhere, as if it had never stopped.

use super::watch::Watch;
use super::{BadSample, Faults, Film, Rendered, Shard};
use crate::sampling::stream::Sampler;
use crate::scene::RayCounts;
use crate::stats::Estimate;
use std::ops::Range;

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
        let pixels = shard.tiles(self.size()).flat_map(places);
        let taken = pixels.map(|[x, y]| film.pixel(x, y).taken);
        taken.min().unwrap_or(u32::MAX)
    }

    /// Width and height of its picture.
    pub fn size(&self) -> [u32; 2] {
        [self.film.width(), self.film.height()]
    }

    /// Adds a shard of the same picture, whose pixels it does not have yet.
    ///
    /// # Panics
    ///
    /// Where their pictures differ in size.
    pub fn add_shard(&mut self, part: &State, shard: Shard) {
        assert_eq!(self.size(), part.size());
        let pixels = shard.tiles(self.size()).flat_map(places);
        for [x, y] in pixels {
            *self.film.pixel_mut(x, y) = *part.film.pixel(x, y);
        }
        self.tally.join(&part.tally);
        // What passes prepare is for all pixels, so each shard has it.
        self.tally.rays += part.tally.rays - part.tally.pass_rays;
    }

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
        for [x, y] in places([0..self.film.width(), 0..self.film.height()]) {
            let (pixel, mut its) = (self.film.pixel_mut(x, y), *other.film.pixel(x, y));
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

/// The pixels of a rectangle, row by row.
fn places([x, y]: [Range<u32>; 2]) -> impl Iterator<Item = [u32; 2]> {
    y.flat_map(move |y| x.clone().map(move |x| [x, y]))
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
