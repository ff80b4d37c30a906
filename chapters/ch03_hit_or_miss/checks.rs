//! What this chapter measures, beside what it should be.

use halfdisk::lab::chapter::{Desk, Number};
use halfdisk::lab::experiment::convergence::Convergence;
use halfdisk::stats::Estimate;
use rayon::prelude::*;
use std::f64::consts::PI;

/// Runs whose variances are compared, to know the error of a variance.
pub const BATCHES: u64 = 64;

/// The mean of all batches together, and the variance of a sample as the mean over batches.
pub fn spread(batch: impl Fn(u64) -> Estimate + Send + Sync) -> [Estimate; 2] {
    let batches: Vec<Estimate> = (0..BATCHES).into_par_iter().map(batch).collect();
    let empty = Estimate::new();
    let mean = batches.iter().fold(empty, |sum, batch| sum.merge(batch));
    [mean, batches.iter().map(Estimate::variance).collect()]
}

/// The relative error of a product or quotient of independent estimates.
pub fn relative(factors: &[Estimate]) -> f64 {
    let part = |factor: &Estimate| factor.std_error() / factor.mean();
    let squares = factors.iter().map(|factor| part(factor) * part(factor));
    squares.sum::<f64>().sqrt()
}

/// Records a value with its error and the truth; how many standard errors it lies above it.
pub fn checked(desk: &mut Desk, name: &str, says: &str, [value, error, exact]: [f64; 3]) -> f64 {
    let number = Number {
        error: Some(error),
        ..Number::new(says, value).exact(exact)
    };
    desk.number(name, number);
    (value - exact) / error
}

/// Records the slope of an error against samples; how far above the truth, in standard errors.
pub fn slope(desk: &mut Desk, run: &Convergence, exact: f64) -> f64 {
    let Some(fit) = run.line() else {
        return f64::INFINITY;
    };
    let short = run.name.trim_start_matches("sample-");
    let short = short.trim_end_matches("-darts");
    let says = format!("power with which the error falls: {}", run.name);
    let found = [fit.line.slope, fit.std_error, exact];
    checked(desk, &format!("slope_{short}"), &says, found)
}

/// The chance that the band of `n` darts holds pi: the chances of all the hit counts whose band
/// does, by the binomial law.
pub fn coverage(n: u32) -> f64 {
    let hit = PI / 4.0;
    // The chance of no hit at all, then from each count to the next.
    let mut chance = libm::pow(1.0 - hit, n.into());
    let mut sum = 0.0;
    for hits in 0..=n {
        let band = Estimate::from_hits(hits.into(), n.into()).interval(2.0);
        if band.contains(hit) {
            sum += chance;
        }
        chance *= f64::from(n - hits) / f64::from(hits + 1) * hit / (1.0 - hit);
    }
    sum
}
