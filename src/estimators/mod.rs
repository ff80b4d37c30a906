//! Estimators that answer one question each, smaller than a picture.

pub mod aperture;
pub mod two_ways;
