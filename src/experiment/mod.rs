//! Repeated runs that end in data.

pub mod price;
