//! What turns samples into statements.
//!
//! * [`Estimate`]: a mean with its error;
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

pub use estimate::{Estimate, Interval};

/// The smallest of the values that a share of them does not exceed.
pub fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let rank = (share * values.len() as f64).ceil() as usize;
    values[rank.clamp(1, values.len()) - 1]
}
