//! Repeated runs that end in data.
//!
//! * [`study`]: runs at several sizes, many times, and what they say; what the next two stand on;
//! * [`convergence`]: how an estimator's error falls with its samples;
//! * [`cost`]: what accuracy costs, for every way to make a picture;
//! * [`named`]: the estimators one can ask for by name;
//! * [`robustness`]: computations in plain forms and in those that hold in hard cases;
//! * [`stopwatch`]: how long one thing takes for the time of another.

pub mod convergence;
pub mod cost;
pub mod named;
pub mod robustness;
pub mod stopwatch;
pub mod study;
