//! Sixteen numbers side by side, one for each path.
//!
//! Each operation rounds as its plain twin does, so what is computed in lanes is what the plain code computes,
//! bit for bit, whatever vectors the processor has. So nothing is fused, no reciprocal is approximate, and where
//! a NaN or a tie decides, a comparison and a choice stand in place of a minimum.
//!
//! All of it is inlined into one function for each set of instructions. Closures are not, and lose the
//! instructions: there are none in this code.

mod functions;
mod transpose;
mod vector;
mod wide;

pub use functions::{offset_origin, scale_and_direction, sin_cos};
pub use transpose::{transpose, transpose_wide};
pub use vector::{Row3, Vector};
pub use wide::{WideVector, Wides, Words64};

use fearless_simd::prelude::*;
use fearless_simd::{Level, f32x16, mask32x16, u32x16};

/// Paths side by side.
pub const LANES: usize = 16;
/// The bits of all lanes.
pub const ALL_LANES: u32 = 0xffff;

/// One `f32` for each lane.
pub type Floats<S> = f32x16<S>;
/// One `u32` for each lane.
pub type Words<S> = u32x16<S>;
/// Some of the lanes.
pub type Mask<S> = mask32x16<S>;

/// One `f32` for each lane, in memory.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
pub struct Row(pub [f32; LANES]);

/// One `u32` for each lane, in memory.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
pub struct WordRow(pub [u32; LANES]);

impl Row {
    /// The numbers as a vector.
    #[inline(always)]
    pub fn get<S: Simd>(&self, s: S) -> Floats<S> {
        Floats::from_slice(s, &self.0)
    }

    /// Stores a vector.
    #[inline(always)]
    pub fn set<S: Simd>(&mut self, x: Floats<S>) {
        x.store_slice(&mut self.0);
    }

    /// Stores a vector in some of the lanes.
    #[inline(always)]
    pub fn set_where<S: Simd>(&mut self, s: S, mask: Mask<S>, x: Floats<S>) {
        self.set(mask.select(x, self.get(s)));
    }
}

impl WordRow {
    /// The numbers as a vector.
    #[inline(always)]
    pub fn get<S: Simd>(&self, s: S) -> Words<S> {
        Words::from_slice(s, &self.0)
    }

    /// Stores a vector.
    #[inline(always)]
    pub fn set<S: Simd>(&mut self, x: Words<S>) {
        x.store_slice(&mut self.0);
    }

    /// Stores a vector in some of the lanes.
    #[inline(always)]
    pub fn set_where<S: Simd>(&mut self, s: S, mask: Mask<S>, x: Words<S>) {
        self.set(mask.select(x, self.get(s)));
    }
}

impl<S: Simd> From<Floats<S>> for Row {
    #[inline(always)]
    fn from(x: Floats<S>) -> Row {
        let mut row = Row::default();
        row.set(x);
        row
    }
}

impl<S: Simd> From<Words<S>> for WordRow {
    #[inline(always)]
    fn from(x: Words<S>) -> WordRow {
        let mut row = WordRow::default();
        row.set(x);
        row
    }
}

/// The same number in every lane.
#[inline(always)]
pub fn floats<S: Simd>(s: S, x: f32) -> Floats<S> {
    Floats::splat(s, x)
}

/// The same number in every lane.
#[inline(always)]
pub fn words<S: Simd>(s: S, x: u32) -> Words<S> {
    Words::splat(s, x)
}

/// The lanes whose bits are set.
#[inline(always)]
pub fn mask<S: Simd>(s: S, bits: u32) -> Mask<S> {
    Mask::from_bitmask(s, u64::from(bits))
}

/// A bit for each lane of a mask.
#[inline(always)]
pub fn bits<S: Simd>(mask: Mask<S>) -> u32 {
    mask.to_bitmask() as u32
}

/// The lanes whose bits are set, one by one.
#[derive(Clone, Copy, Debug)]
pub struct Each(pub u32);

impl Iterator for Each {
    type Item = usize;

    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        if self.0 == 0 {
            return None;
        }
        let lane = self.0.trailing_zeros() as usize % LANES;
        self.0 &= self.0 - 1;
        Some(lane)
    }
}

/// The sets of instructions that this processor has and code in lanes can run by, the widest first.
pub fn levels() -> Vec<Level> {
    let best = Level::new();
    #[cfg(target_arch = "x86_64")]
    let all = [
        matches!(best, Level::Avx512(_)).then_some(best),
        best.as_avx2().map(Level::Avx2),
        best.as_sse4_2().map(Level::Sse4_2),
        best.as_sse2().map(Level::Sse2),
    ];
    #[cfg(not(target_arch = "x86_64"))]
    let all = [Some(best)];
    all.into_iter().flatten().collect()
}

/// What a set of instructions is called.
pub fn level_name(level: Level) -> &'static str {
    match level {
        #[cfg(target_arch = "x86_64")]
        Level::Avx512(_) => "AVX-512",
        #[cfg(target_arch = "x86_64")]
        Level::Avx2(_) => "AVX2",
        #[cfg(target_arch = "x86_64")]
        Level::Sse4_2(_) => "SSE4.2",
        #[cfg(target_arch = "x86_64")]
        Level::Sse2(_) => "SSE2",
        #[cfg(target_arch = "aarch64")]
        Level::Neon(_) => "Neon",
        _ => "others",
    }
}
