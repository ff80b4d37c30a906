//! A mean with its error, gathered one sample at a time.

use serde::{Deserialize, Serialize};

/// The running mean and variance of a sequence of numbers.
///
/// Sums are `f64` and follow Welford's recurrence, so a constant sequence has variance exactly
/// zero and no difference of large numbers is taken: in `f32`, `E[x²] - E[x]²` reports a variance
/// of -25 018 for a million numbers of mean 1000 and variance 1.
///
/// Sources: Welford, Note on a Method for Calculating Corrected Sums of Squares and Products
/// (Technometrics 4(3), 1962); Chan, Golub, LeVeque, Algorithms for Computing the Sample Variance
/// (The American Statistician 37(3), 1983), "Pairwise algorithm", for [`Estimate::merge`].
///
/// ```
/// use halfdisk::stats::Estimate;
///
/// let dice: Estimate = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0].into_iter().collect();
/// assert_eq!(dice.mean(), 3.5);
/// assert_eq!(dice.variance(), 3.5);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    count: u64,
    mean: f64,
    /// Sum of squared distances from the mean.
    m2: f64,
}

/// A number and its standard error.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Measurement {
    /// The number.
    pub value: f64,
    /// Its standard error; infinite where it is not known.
    pub error: f64,
}

impl From<(f64, f64)> for Measurement {
    fn from((value, error): (f64, f64)) -> Self {
        Measurement { value, error }
    }
}

impl Measurement {
    /// The same in other units, or relative to something known.
    #[must_use]
    pub fn map(self, scale: impl Fn(f64) -> f64) -> Measurement {
        (scale(self.value), scale(self.error)).into()
    }

    /// The same in hundredths.
    #[must_use]
    pub fn percent(self) -> Measurement {
        self.map(|x| 100.0 * x)
    }
}

/// A closed interval of real numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Its lower end.
    pub low: f64,
    /// Its upper end.
    pub high: f64,
}

impl Interval {
    /// True where `x` lies within, ends included.
    pub fn contains(&self, x: f64) -> bool {
        self.low <= x && x <= self.high
    }
}

impl Estimate {
    /// An estimate from no samples: mean 0, error unknown.
    pub fn new() -> Self {
        Self::default()
    }

    /// The estimate after `count` yes-or-no samples of which `hits` were yes (counted as 1).
    pub fn from_hits(hits: u64, count: u64) -> Self {
        assert!(hits <= count, "{hits} hits out of {count}");
        let p = if count == 0 {
            0.0
        } else {
            hits as f64 / count as f64
        };
        Estimate {
            count,
            mean: p,
            m2: count as f64 * p * (1.0 - p),
        }
    }

    /// The estimate after `count` samples with this sum and sum of squares. For samples that are
    /// mostly zero; elsewhere the difference it takes would cancel.
    pub fn from_sums(count: u64, sum: f64, squares: f64) -> Self {
        let mean = if count == 0 { 0.0 } else { sum / count as f64 };
        Estimate {
            count,
            mean,
            m2: (squares - sum * mean).max(0.0),
        }
    }

    /// Adds one sample.
    pub fn add(&mut self, x: f64) {
        self.count += 1;
        let delta = x - self.mean;
        self.mean += delta / self.count as f64;
        self.m2 += delta * (x - self.mean);
    }

    // ANCHOR: merge
    /// The estimate of both sets of samples together.
    #[must_use]
    pub fn merge(&self, other: &Estimate) -> Estimate {
        if self.count == 0 {
            return *other;
        }
        if other.count == 0 {
            return *self;
        }
        let count = self.count + other.count;
        let share = other.count as f64 / count as f64;
        let delta = other.mean - self.mean;
        Estimate {
            count,
            mean: self.mean + delta * share,
            m2: self.m2 + other.m2 + delta * delta * self.count as f64 * share,
        }
    }
    // ANCHOR_END: merge

    /// How many samples, their mean, and the sum of their squared distances from it: all that
    /// [`Estimate::from_parts`] needs for the same estimate.
    pub fn parts(&self) -> (u64, f64, f64) {
        (self.count, self.mean, self.m2)
    }

    /// The estimate of so many samples with this mean and this sum of squared distances from it.
    pub fn from_parts(count: u64, mean: f64, m2: f64) -> Self {
        Estimate { count, mean, m2 }
    }

    /// How many samples were added.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// The mean; 0 where there are no samples.
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// The variance of one sample (unbiased); 0 below two samples.
    pub fn variance(&self) -> f64 {
        if self.count < 2 {
            0.0
        } else {
            self.m2 / (self.count - 1) as f64
        }
    }

    /// The standard error of the mean; infinite below two samples, where it is unknown.
    pub fn std_error(&self) -> f64 {
        if self.count < 2 {
            f64::INFINITY
        } else {
            (self.variance() / self.count as f64).sqrt()
        }
    }

    /// The mean and its standard error.
    pub fn measurement(&self) -> Measurement {
        (self.mean(), self.std_error()).into()
    }

    /// The root of the mean of squared errors, and its own standard error to first order: `d√m = dm / 2√m`.
    /// A mean below zero, which unbiased estimates of a square may have, counts as none.
    pub fn root(&self) -> Measurement {
        let value = if self.mean < 0.0 {
            0.0
        } else {
            self.mean.sqrt()
        };
        let error = match value {
            0.0 if self.count > 1 => 0.0,
            _ => self.std_error() / (2.0 * value),
        };
        Measurement { value, error }
    }

    /// The mean plus and minus `z` standard errors.
    pub fn interval(&self, z: f64) -> Interval {
        let half = z * self.std_error();
        Interval {
            low: self.mean - half,
            high: self.mean + half,
        }
    }

    /// How many standard errors the mean lies above `truth`; 0 where it is exactly the truth.
    pub fn z(&self, truth: f64) -> f64 {
        let difference = self.mean - truth;
        if difference == 0.0 {
            0.0
        } else {
            difference / self.std_error()
        }
    }
}

impl FromIterator<f64> for Estimate {
    fn from_iter<I: IntoIterator<Item = f64>>(samples: I) -> Self {
        let mut estimate = Estimate::new();
        samples.into_iter().for_each(|x| estimate.add(x));
        estimate
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_constant_has_no_variance_at_all() {
        let e: Estimate = std::iter::repeat_n(0.1, 100_000).collect();
        assert_eq!(e.variance(), 0.0);
        assert_eq!(e.z(0.1), 0.0);
    }

    #[test]
    fn a_large_mean_does_not_hide_a_small_variance() {
        // ±1 around 10 000: variance exactly n / (n - 1).
        let e: Estimate = (0..1_000_000)
            .map(|i| 1e4 + f64::from(i % 2) * 2.0 - 1.0)
            .collect();
        assert!((e.variance() - 1.0).abs() < 1e-4, "{}", e.variance());
    }

    #[test]
    fn ten_million_tenths_average_to_a_tenth() {
        let e: Estimate = std::iter::repeat_n(f64::from(0.1_f32), 10_000_000).collect();
        assert!((e.mean() - 0.1).abs() < 1e-6);
    }

    #[test]
    fn merging_equals_adding_in_turn() {
        let xs: Vec<f64> = (0..1000).map(|i| f64::from(i * i % 97)).collect();
        let whole: Estimate = xs.iter().copied().collect();
        for cut in [0, 1, 500, 999, 1000] {
            let a: Estimate = xs[..cut].iter().copied().collect();
            let b: Estimate = xs[cut..].iter().copied().collect();
            let m = a.merge(&b);
            assert_eq!(m.count(), whole.count());
            assert!((m.mean() - whole.mean()).abs() < 1e-12);
            assert!((m.variance() - whole.variance()).abs() < 1e-9);
        }
    }

    #[test]
    fn hits_are_zeros_and_ones() {
        let e = Estimate::from_hits(30, 100);
        let same: Estimate = (0..100).map(|i| f64::from(u8::from(i < 30))).collect();
        assert!((e.mean() - same.mean()).abs() < 1e-15);
        assert!((e.variance() - same.variance()).abs() < 1e-12);
        let sums = Estimate::from_sums(100, 30.0, 30.0);
        assert!((sums.variance() - same.variance()).abs() < 1e-12);
    }

    #[test]
    fn the_interval_holds_the_truth_as_often_as_it_says_and_not_more() {
        use crate::sampling::stream::{Purpose, Stream};
        let mut covered = 0;
        for run in 0..2000 {
            let mut u = Stream::new(5, run, 0).at(0, Purpose::Pixel);
            let e: Estimate = (0..200).map(|_| f64::from(u.one())).collect();
            // The uniforms are the lower ends of 2^24 cells: their mean is half a cell below 1/2.
            covered += i32::from(e.interval(2.0).contains(0.5));
        }
        let share = f64::from(covered) / 2000.0;
        assert!((share - 0.9545).abs() < 0.015, "{share}");
    }

    #[test]
    fn one_sample_knows_no_error() {
        let mut e = Estimate::new();
        e.add(3.0);
        assert_eq!(e.std_error(), f64::INFINITY);
        assert_eq!(e.z(2.0), 0.0, "an unknown error accuses nobody");
    }
}
