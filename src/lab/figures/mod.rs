//! From what was measured and walked to figures: thin adapters between the laboratory and [`drawing`].
//!
//! [`convergence_chart`], [`variance_chart`], [`cost_chart`], [`price_chart`] and [`required_chart`] fill in curves. [`flat`] fills in a
//! drawing from a flat world and the half disk over one of its points; [`walk`] draws the rays of a walk;
//! [`sketch`] draws an idea.
//!
//! [`drawing`]: crate::lab::drawing

mod convergence;
mod cost;
pub mod flat;
mod requirement;
pub mod sketch;
mod variance;
pub mod walk;

pub use convergence::convergence_chart;
pub use cost::{Against, cost_chart, price_chart};
pub use requirement::required_chart;
pub use variance::variance_chart;
