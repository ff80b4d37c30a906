//! Who watches the samples of a render, and what is found there.

use super::{BadSample, Film};
use crate::color::Rgb;
use std::ops::AddAssign;

/// Samples that no light can have brought, by what was wrong with them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Faults {
    /// A channel that is no number: 0 / 0, ∞ - ∞, a root of something negative.
    pub nan: u64,
    /// A channel without bound, and none that is no number: a density of 0, an overflow.
    pub infinite: u64,
    /// A finite sample with a channel below zero: weights that take light away.
    pub negative: u64,
}

impl Faults {
    /// Samples that are in no mean.
    pub fn non_finite(&self) -> u64 {
        self.nan + self.infinite
    }
}

impl AddAssign for Faults {
    fn add_assign(&mut self, other: Faults) {
        self.nan += other.nan;
        self.infinite += other.infinite;
        self.negative += other.negative;
    }
}

/// Looks at every sample before it goes into its mean.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Watch {
    pub faults: Faults,
    /// The first fault in row order.
    pub first: Option<BadSample>,
    /// The largest channel of any sample without fault.
    pub largest: f32,
}

impl Watch {
    /// True where a sample may go into a mean: it is finite. One below zero may, too, for without it
    /// the mean of the others would be wrong; it is counted all the same.
    #[inline]
    pub fn admits(&mut self, li: Rgb, at: BadSample) -> bool {
        let largest = li.max_channel();
        let [r, g, b] = li.channels();
        if r >= 0.0 && g >= 0.0 && b >= 0.0 && largest < f32::INFINITY {
            self.largest = self.largest.max(largest);
            return true;
        }
        self.note(li, at)
    }

    #[cold]
    fn note(&mut self, li: Rgb, at: BadSample) -> bool {
        let finite = li.is_finite();
        if finite {
            self.faults.negative += 1;
        } else if li.channels().into_iter().any(f32::is_nan) {
            self.faults.nan += 1;
        } else {
            self.faults.infinite += 1;
        }
        self.earlier(at);
        finite
    }

    fn earlier(&mut self, at: BadSample) {
        let key = |b: BadSample| (b.y, b.x, b.sample);
        if self.first.is_none_or(|first| key(at) < key(first)) {
            self.first = Some(at);
        }
    }

    /// What both have seen.
    pub fn join(&mut self, other: Watch) {
        self.faults += other.faults;
        self.largest = self.largest.max(other.largest);
        if let Some(at) = other.first {
            self.earlier(at);
        }
    }
}

/// How many pixels are brighter than `bound` by more than six of their standard errors: where no
/// more light can arrive (see [`Scene::brightest`](crate::scene::Scene::brightest)), these have made
/// some. Pixels of fewer than 16 samples do not know their error, and are not asked.
pub fn too_bright(film: &Film, bound: f64) -> usize {
    let over = |pixel: &&super::Pixel| {
        pixel.count() >= 16
            && pixel.channels.iter().any(|channel| {
                // Sums in `f32` along a path round, too.
                channel.mean() - 6.0 * channel.std_error() > bound * (1.0 + 1e-5)
            })
    };
    film.pixels().iter().filter(over).count()
}
