//! One pass of samples over the tiles of a picture.

use super::Options;
use super::recorder::Recorder;
use super::tile::Tile;
use crate::integrators::{Pass, PathInLanes, Prepared};
use crate::sampling::stream::Sampler;
use crate::scene::{RayCounts, Scene};
use crate::stats::Estimate;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

/// What is known of passes for which something was prepared.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct OfPasses {
    /// The rays that this took.
    pub(super) rays: RayCounts,
    /// The mean of the picture by each alone.
    pub(super) means: Estimate,
}

/// What all samples of a picture have in common.
pub(super) struct Shots<'a, R: Recorder + ?Sized> {
    pub(super) scene: &'a Scene,
    pub(super) recorder: &'a R,
    pub(super) options: &'a Options,
    pub(super) stop: &'a (dyn Fn() -> bool + Sync),
    /// The same samples many at a time, where the recorder can.
    pub(super) lanes: Option<&'a PathInLanes<'a>>,
    /// Hears of samples that were taken, and of how many.
    pub(super) tell: &'a (dyn Fn(u64) + Sync),
}

impl<R: Recorder + ?Sized> Shots<'_, R> {
    /// Takes the samples of a pass over the picture; false where it was stopped before the last.
    pub(super) fn take(
        &self,
        pass: Range<u32>,
        tiles: &mut [Tile<R::Notes>],
        of_passes: &mut OfPasses,
    ) -> bool {
        let Some(passes) = self.recorder.passes(self.scene) else {
            return self.of_tiles(pass, &Prepared::default(), tiles);
        };
        // What is prepared for a sample is for all pixels at once, so all tiles take it together.
        pass.into_iter().all(|sample| {
            let prepared = passes.prepare(&Pass {
                scene: self.scene,
                sample,
                seed: self.options.seed,
                sampler: self.options.sampler,
                fixed: self.options.fixed,
                stop: self.stop,
            });
            prepared.is_some_and(|prepared| {
                of_passes.rays += prepared.rays;
                let whole = self.of_tiles(sample..sample + 1, &prepared, tiles);
                if whole && self.options.sampler == Sampler::Independent {
                    let pixels: usize = tiles.iter().map(|tile| tile.pixels.len()).sum();
                    let sum: f64 = tiles.iter().map(|tile| tile.sum).sum();
                    of_passes.means.add(sum / pixels as f64);
                }
                whole
            })
        })
    }

    fn of_tiles(
        &self,
        pass: Range<u32>,
        prepared: &Prepared,
        tiles: &mut [Tile<R::Notes>],
    ) -> bool {
        let whole = AtomicBool::new(true);
        let stop = || !whole.load(Ordering::Relaxed) || (self.stop)();
        tiles.par_iter_mut().for_each(|tile| {
            let samples = tile.pixels.len() as u64 * u64::from(pass.end - pass.start);
            if tile.sample(self, pass.clone(), prepared, &stop) {
                (self.tell)(samples);
            } else {
                whole.store(false, Ordering::Relaxed);
            }
        });
        whole.into_inner()
    }
}
