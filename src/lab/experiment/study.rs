//! A study: the same experiment at several sizes, many times, each run with random numbers of its own.
//!
//! The points of one run that goes on and on are correlated, and an interval through them is too narrow. So
//! no two runs of a study share a random number, neither within a size nor from one size to the next.
//! Intervals come from leaving out one replicate after the other (see [`jackknife`](crate::stats::jackknife)).

use crate::stats::Estimate;
use crate::stats::price::Paid;
use crate::stats::slope::{self, Fit, Insufficient};

/// Runs at several sizes.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub struct Study<R> {
    /// Samples of a run at each size, the smallest first.
    pub sizes: Vec<u32>,
    /// `runs[r][k]`: replicate `r` at size `k`.
    pub runs: Vec<Vec<R>>,
}

impl<R> Study<R> {
    /// The mean over replicates of a value at one size, such as the squared error.
    pub fn at(&self, size: usize, value: impl Fn(&R) -> f64) -> Estimate {
        self.runs.iter().map(|row| value(&row[size])).collect()
    }

    /// The line of error against cost on logarithmic axes, from the squared error of each run and from its
    /// cost, which may depend on the samples of its size.
    pub fn fit(
        &self,
        cost: impl Fn(u32, &R) -> f64,
        square: impl Fn(&R) -> f64,
    ) -> Result<Fit, Insufficient> {
        let row = |row: &Vec<R>| {
            self.sizes
                .iter()
                .zip(row)
                .map(|(n, run)| cost(*n, run))
                .collect()
        };
        let costs: Vec<Vec<f64>> = self.runs.iter().map(row).collect();
        let squares: Vec<Vec<f64>> = self
            .runs
            .iter()
            .map(|row| row.iter().map(&square).collect())
            .collect();
        slope::fit(&costs, &squares)
    }

    /// Squared error and cost of the largest run of each replicate: what
    /// [`price::ratio`](crate::stats::price::ratio) compares two methods by.
    pub fn largest(&self, square: impl Fn(&R) -> f64, cost: impl Fn(&R) -> f64) -> Vec<Paid> {
        let last = self.runs.iter().filter_map(|row| row.last());
        last.map(|run| [square(run), cost(run)]).collect()
    }
}

/// The seed of one run, different for each replicate and place in a study. A place tells the size, and what
/// else runs differ in; it has at most 32 bits.
pub fn seed_of(seed: u64, replicate: u32, place: u64) -> u64 {
    // An odd factor is a bijection; neighbouring seeds of a study stay far apart.
    seed.wrapping_mul(0x9e37_79b9_7f4a_7c15)
        .wrapping_add(place << 32 | u64::from(replicate))
}

/// The replicates of all shares in their own order, where each share has every n-th one.
pub fn in_order<R>(shares: Vec<Vec<R>>) -> Vec<R> {
    let mut all: Vec<_> = shares.into_iter().map(Vec::into_iter).collect();
    let mut rows = Vec::new();
    loop {
        let round: Vec<R> = all.iter_mut().map_while(Iterator::next).collect();
        if round.is_empty() {
            return rows;
        }
        rows.extend(round);
    }
}

/// The order in which `count` things run in a round: forwards, then backwards, and one place further on every
/// second round, so that whatever else slows the machine slows all of them alike.
pub fn order(round: u32, count: usize) -> Vec<usize> {
    let shift = round as usize / 2;
    let mut order: Vec<usize> = (0..count).map(|i| (i + shift) % count).collect();
    if round % 2 == 1 {
        order.reverse();
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn everyone_is_first_as_often_as_last() {
        assert_eq!(
            [0, 1, 2, 3].map(|r| order(r, 3)),
            [[0, 1, 2], [2, 1, 0], [1, 2, 0], [0, 2, 1]]
        );
        assert_eq!(
            [0, 1, 2, 3].map(|r| order(r, 2)),
            [[0, 1], [1, 0], [1, 0], [0, 1]]
        );
    }

    #[test]
    fn replicates_are_shared_out_and_come_back_in_order() {
        for (replicates, n) in [(10, 1), (10, 3), (9, 3), (2, 5), (256, 7)] {
            let shares = (0..n).map(|first| {
                let numbers = (first..replicates).step_by(n as usize);
                numbers.collect::<Vec<u32>>()
            });
            let all = in_order(shares.collect());
            assert!(all.into_iter().eq(0..replicates), "{replicates} by {n}");
        }
    }

    #[test]
    fn no_two_runs_share_a_seed() {
        let mut seen = BTreeSet::new();
        for replicate in (0..20).chain([u32::MAX]) {
            for place in 0..1000 {
                for seed in 1..4 {
                    assert!(seen.insert(seed_of(seed, replicate, place)));
                }
            }
        }
    }

    #[test]
    fn a_study_reads_its_runs_by_size() {
        // Errors of 1 / n, twice as large in the second replicate.
        let sizes = vec![10, 100];
        let runs = vec![vec![0.1, 0.01], vec![0.2, 0.02]];
        let study = Study { sizes, runs };
        assert_eq!(study.at(1, |e| *e).mean(), 0.015);
        assert_eq!(
            study.largest(|e| e * e, |_| 7.0),
            [[0.01 * 0.01, 7.0], [0.02 * 0.02, 7.0]]
        );
        let fit = study
            .fit(|n, _| f64::from(n), |e| e * e)
            .expect("an exact slope");
        assert!((fit.line.slope + 1.0).abs() < 1e-12, "{fit:?}");
    }
}
