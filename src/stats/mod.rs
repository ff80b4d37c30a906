//! What turns samples into statements: estimates with their errors.

mod estimate;

pub use estimate::{Estimate, Interval};
