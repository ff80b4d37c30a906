//! All that a render knows of its samples, so that it can go on later, elsewhere, as if it had never stopped.

use super::watch::Watch;
use super::{BadSample, Faults, Film, Rendered, Shard};
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
        let least = |[x, y]: [Range<u32>; 2]| {
            let pixels = y.flat_map(|y| x.clone().map(move |x| film.pixel(x, y).taken));
            pixels.min()
        };
        let shard = shard.unwrap_or(Shard { index: 1, count: 1 });
        let tiles = shard.tiles([film.width(), film.height()]);
        tiles.filter_map(least).min().unwrap_or(u32::MAX)
    }

    /// The state of a picture from those of its shards, in the order of their numbers.
    ///
    /// # Panics
    ///
    /// Where there are none, or their pictures differ in size.
    #[must_use]
    pub fn of_shards(parts: &[State]) -> State {
        let size = [parts[0].film.width(), parts[0].film.height()];
        let mut pixels = parts[0].film.pixels().to_vec();
        let mut tally = parts[0].tally;
        for (part, index) in parts.iter().zip(1..).skip(1) {
            assert_eq!([part.film.width(), part.film.height()], size);
            let count = parts.len() as u32;
            for [x, y] in (Shard { index, count }).tiles(size) {
                for (x, y) in y.flat_map(|y| x.clone().map(move |x| (x, y))) {
                    pixels[(y * size[0] + x) as usize] = *part.film.pixel(x, y);
                }
            }
            tally.join(&part.tally);
        }
        let film = Film::new(size[0], pixels);
        State { film, tally }
    }
}

impl Tally {
    /// What both know of their shards of a picture. What passes prepare is for all pixels, so each of them has it.
    fn join(&mut self, other: &Tally) {
        let (mut one, mut all) = (Watch::from(*self), self.rays);
        one.join(Watch::from(*other));
        all += other.rays - other.pass_rays;
        *self = Tally {
            rays: all,
            pass_rays: self.pass_rays,
            passes: self.passes,
            faults: one.faults,
            first_bad: one.first,
            largest: one.largest,
            lights_met: self.lights_met | other.lights_met,
        };
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
