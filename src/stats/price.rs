//! What the same error costs two ways.
//!
//! The squared error of an unbiased estimate falls as one over what is paid for it, so squared error
//! times cost is a price that does not depend on how much was paid.

use super::{jackknife, slope::student_95};
use serde::Serialize;

/// One replicate: its squared error, and what it cost.
pub type Paid = [f64; 2];

/// How many times the cost one way needs for the error of another, with its 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Ratio {
    /// The ratio.
    pub ratio: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
}

/// The price of `a` over the price of `b`, from replicates that were run side by side.
///
/// Prices are products of means, so that rare large errors count in full; the interval is on the
/// logarithm, from leaving out one pair of replicates after the other. What slows down both of a pair
/// cancels. `None` below two pairs, or where a mean is not positive.
///
/// ```
/// use halfdisk::stats::price;
///
/// // Half the squared error for three times the time.
/// let a = [[0.5, 3.1], [0.6, 3.0], [0.4, 2.9]];
/// let b = [[1.1, 1.0], [0.9, 1.1], [1.0, 0.9]];
/// let found = price::ratio(&a, &b).unwrap();
/// assert!((found.ratio - 1.5).abs() < 1e-12 && found.low < 1.5 && found.high > 1.5);
/// ```
pub fn ratio(a: &[Paid], b: &[Paid]) -> Option<Ratio> {
    let pairs = a.len().min(b.len());
    if pairs < 2 {
        return None;
    }
    let (a, b) = (&a[..pairs], &b[..pairs]);
    let log_of = |left_out: Option<usize>| -> Option<f64> {
        let log_price = |runs: &[Paid]| {
            let kept = || (0..pairs).filter(|i| Some(*i) != left_out);
            let mean =
                |part: usize| kept().map(|i| runs[i][part]).sum::<f64>() / kept().count() as f64;
            libm::log(mean(0) * mean(1))
        };
        let log = log_price(a) - log_price(b);
        log.is_finite().then_some(log)
    };
    let log = log_of(None)?;
    let others: Vec<f64> = (0..pairs).map(|i| log_of(Some(i))).collect::<Option<_>>()?;
    let half = student_95(pairs - 1) * jackknife(&others);
    Some(Ratio {
        ratio: libm::exp(log),
        low: libm::exp(log - half),
        high: libm::exp(log + half),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::stream::{Purpose, Stream};

    /// Runs whose squared errors are sums of `n` squares of uniforms, and whose times share a load.
    fn runs(seed: u64, n: u32, seconds: f64) -> Vec<Paid> {
        let run = |r| {
            let mut u = Stream::new(seed, r, 0).at(0, Purpose::Pixel);
            let load = Stream::new(7000 + seed % 1000, r, 0)
                .at(0, Purpose::Pixel)
                .one();
            let load = 1.0 + f64::from(load);
            let square: f64 = (0..50).map(|_| f64::from(u.one() - 0.5).powi(2)).sum();
            [square / f64::from(n), seconds * load]
        };
        (0..10).map(run).collect()
    }

    #[test]
    fn the_interval_holds_the_ratio_as_often_as_it_says() {
        let mut covered = 0;
        for seed in 0..400 {
            let (a, b) = (runs(1000 + seed, 1, 2.0), runs(seed, 3, 1.0));
            let found = ratio(&a, &b).expect("ten pairs");
            covered += i32::from(found.low <= 6.0 && 6.0 <= found.high);
        }
        let share = f64::from(covered) / 400.0;
        assert!((share - 0.95).abs() < 0.04, "{share}");
    }

    #[test]
    fn pairs_cancel_what_both_suffer_from() {
        // Half the variance is that of the loads, so that paired intervals are 0.55 times as wide; the
        // mean of a hundred is known to 3 %.
        let width = |a: &[Paid], b: &[Paid]| {
            let found = ratio(a, b).expect("ten pairs");
            libm::log(found.high / found.low)
        };
        let (mut paired, mut shuffled) = (0.0, 0.0);
        for seed in 0..100 {
            let (a, mut b) = (runs(1000 + seed, 1, 2.0), runs(seed, 1, 1.0));
            paired += width(&a, &b);
            b.rotate_left(1);
            shuffled += width(&a, &b);
        }
        let narrower = paired / shuffled;
        assert!((0.4..0.75).contains(&narrower), "{narrower}");
    }

    #[test]
    fn one_pair_or_no_error_has_no_interval() {
        assert_eq!(ratio(&[[1.0, 1.0]], &[[1.0, 1.0]]), None);
        assert_eq!(ratio(&[[0.0, 1.0]; 3], &[[1.0, 1.0]; 3]), None);
    }
}
