//! How a picture's samples are taken.

use super::Shard;
use crate::sampling::stream::{Purpose, Sampler};

/// How to render.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Samples per pixel.
    pub spp: u32,
    /// The picture's seed.
    pub seed: u64,
    /// How the samples of a pixel lie to each other.
    pub sampler: Sampler,
    /// Integrals that are left out: their purposes' numbers are all 1/2 (see
    /// [`Stream::fixing`](crate::sampling::stream::Stream::fixing)).
    pub fixed: &'static [Purpose],
    /// Side of the square tiles that threads take in turn, in pixels; changes no bit.
    pub tile: u32,
    /// Only a share of the picture's tiles; `None` for all.
    pub shard: Option<Shard>,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            spp: 16,
            seed: 0,
            sampler: Sampler::Independent,
            fixed: &[],
            tile: 16,
            shard: None,
        }
    }
}
