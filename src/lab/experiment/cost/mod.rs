//! What accuracy costs: error against rays and seconds, for every way to make a picture.
//!
//! * [`method`](Method): the integrators, even points, and a mistake;
//! * [`plan`](Design): how many samples each takes;
//! * [`runs`](measure): independent pictures, in turns;
//! * [`reference`](Reference): the truth, whose own noise counts for nobody;
//! * [`bias`](Bias): the error that stays, and where it [levels out](Floor);
//! * [`strip`]: pictures side by side;
//! * [`size`](Size): what pictures of one size give;
//! * [`list`](PriceList), [`target`](Reach): slopes, ratios and times, with intervals or a word that
//!   there is none.
//!
//! Errors are the relative errors of [`accuracy`](crate::render::accuracy). What is measured in a small
//! picture is what a large one costs for each pixel, but for this: the 9 x 9 pixels that an error is
//! relative to are a larger part of a small picture.
//!
//! Sources: Celarek, Jakob, Wimmer, Lehtinen, Quantifying the Error of Light Transport Algorithms
//! (Computer Graphics Forum 38(4), 2019), for many short renders; Whittle, Jones, Mantiuk, Analysis of
//! Reported Error in Monte Carlo Rendered Images (The Visual Computer 33, 2017), for references.

mod bias;
mod list;
mod method;
mod plan;
mod reference;
mod runs;
mod size;
pub mod strip;
mod target;

pub use bias::{Bias, Floor};
pub use list::{PerSample, PriceList, Priced, TARGETS};
pub use method::{ALL, BASE, CLAMP, FROM_THE_EYE, Method};
pub use plan::{Budget, Design};
pub use reference::Reference;
pub use runs::{Measured, Nothing, Run, Runs, measure, measure_share};
pub use size::{Size, Verdict};
pub use target::Reach;
