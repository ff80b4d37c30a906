//! How noise falls with samples: the same estimate many times, in blocks of a thousand samples.
//!
//! What a thousand samples more are worth after twenty thousand is a difference of two nearly equal
//! numbers. Two runs apart would hide it in their own noise. So the longer run contains the shorter
//! one, and any block may be the one that is left out: both noises come from the same blocks.

use halfdisk::stats::{Measurement, jackknife};
use rayon::prelude::*;

/// Blocks of each run: twenty, and one more.
pub const BLOCKS: usize = 21;

/// Groups of runs, left out one after the other for the errors.
const GROUPS: usize = 40;

/// By how much noise falls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Falls {
    /// From one block to two, as a share of the noise of one.
    pub one_to_two: Measurement,
    /// From twenty to twenty-one, as a share of the noise of twenty.
    pub twenty_to_more: Measurement,
    /// The first fall over the second, both as they are.
    pub ratio: Measurement,
}

/// Sums of squared distances from the truth, of means of 1, 2, 20 and 21 blocks.
type Squares = [f64; 4];

/// Runs the estimator in `40 · runs_each` runs of [`BLOCKS`] blocks: `block(i)` is the mean of block
/// `i`, independent of all others, and its expectation `truth`.
pub fn falls(runs_each: u32, truth: f64, block: impl Fn(u32) -> f64 + Sync) -> Falls {
    let groups: Vec<Squares> = (0..GROUPS as u32)
        .into_par_iter()
        .map(|group| {
            let mut sums = Squares::default();
            for run in group * runs_each..(group + 1) * runs_each {
                let off: Vec<f64> = (0..BLOCKS as u32)
                    .map(|b| block(run * BLOCKS as u32 + b) - truth)
                    .collect();
                let squares = squares(&off);
                (0..4).for_each(|k| sums[k] += squares[k]);
            }
            sums
        })
        .collect();
    let all = |k: usize| groups.iter().map(|g| g[k]).sum::<f64>();
    let all: Squares = [0, 1, 2, 3].map(all);
    let found = |of: fn(&Squares) -> f64| {
        let without = |own: &Squares| of(&[0, 1, 2, 3].map(|k| all[k] - own[k]));
        let others: Vec<f64> = groups.iter().map(without).collect();
        Measurement::from((of(&all), jackknife(&others)))
    };
    Falls {
        one_to_two: found(|s| 1.0 - (s[1] / s[0]).sqrt()),
        twenty_to_more: found(|s| 1.0 - (s[3] / s[2]).sqrt()),
        ratio: found(|s| (s[0].sqrt() - s[1].sqrt()) / (s[2].sqrt() - s[3].sqrt())),
    }
}

// ANCHOR: squares
/// Mean squares of the distances: of one block, of two, of all but one, of all.
fn squares(off: &[f64]) -> Squares {
    let n = off.len() as f64;
    let sum: f64 = off.iter().sum();
    let mean = |squares: &dyn Fn(usize) -> f64| (0..off.len()).map(squares).sum::<f64>() / n;
    [
        mean(&|i| off[i].powi(2)),
        mean(&|i| (0.5 * (off[i] + off[(i + 1) % off.len()])).powi(2)),
        mean(&|i| ((sum - off[i]) / (n - 1.0)).powi(2)),
        (sum / n).powi(2),
    ]
}
// ANCHOR_END: squares

#[cfg(test)]
mod tests {
    use super::*;
    use halfdisk::sampling::stream::{Purpose, Stream};

    #[test]
    fn the_falls_are_those_of_the_root_and_a_mean_that_drifts_is_noticed() {
        let block = |i| f64::from(Stream::new(3, i, 0).at(0, Purpose::Pixel).one());
        let found = falls(200, 0.5, block);
        let near = |f: Measurement, exact: f64| (f.value - exact).abs() < 4.0 * f.error;
        assert!(near(found.one_to_two, 1.0 - 0.5_f64.sqrt()), "{found:?}");
        assert!(
            near(found.twenty_to_more, 1.0 - (20.0 / 21.0_f64).sqrt()),
            "{found:?}"
        );
        assert!(found.twenty_to_more.error < 0.001, "{found:?}");
        // Blocks that share a part fall more slowly.
        let shared = |i: u32| block(i) + 0.1 * block(1_000_000 + i / BLOCKS as u32) - 0.05;
        assert!(!near(
            falls(200, 0.5, shared).twenty_to_more,
            1.0 - (20.0 / 21.0_f64).sqrt()
        ));
    }
}
