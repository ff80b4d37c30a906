//! What turns samples into statements.
//!
//! * [`Estimate`]: a mean with its error; [`Measurement`]: any number with its error;
//! * [`jackknife`]: the error of what is computed from many runs;
//! * [`z_test`]: is it the truth, and which error would have been noticed?
//! * [`slope`]: how fast does an error fall?
//! * [`quantile`]: what do so many not exceed?
//! * [`price`]: what does the same error cost two ways?
//! * [`chi_square`] and [`kolmogorov_smirnov`]: do samples follow a density?

pub mod chi_square;
mod estimate;
pub mod kolmogorov_smirnov;
pub mod price;
pub mod slope;
pub mod z_test;

pub use estimate::{Estimate, Interval, Measurement};

/// The standard error of a statistic of independent replicates, from its values with one of them left out
/// after the other.
///
/// Source: Efron, Stein, The Jackknife Estimate of Variance (Annals of Statistics 9(3), 1981).
pub fn jackknife(left_out: &[f64]) -> f64 {
    let n = left_out.len() as f64;
    let mean = left_out.iter().sum::<f64>() / n;
    let squared: f64 = left_out.iter().map(|x| (x - mean) * (x - mean)).sum();
    ((n - 1.0) / n * squared).sqrt()
}

/// The smallest of the values that a share of them does not exceed.
pub fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let rank = (share * values.len() as f64).ceil() as usize;
    values[rank.clamp(1, values.len()) - 1]
}
