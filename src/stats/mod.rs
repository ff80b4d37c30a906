//! What turns samples into statements.
//!
//! * [`Estimate`]: a mean with its error;
//! * [`z_test`]: is it the truth, and which error would have been noticed?
//! * [`slope`]: how fast does an error fall?
//! * [`price`]: what does the same error cost two ways?
//! * [`chi_square`] and [`kolmogorov_smirnov`]: do samples follow a density?

pub mod chi_square;
mod estimate;
pub mod kolmogorov_smirnov;
pub mod price;
pub mod slope;
pub mod z_test;

pub use estimate::{Estimate, Interval};
