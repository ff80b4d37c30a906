//! What accuracy costs: error against rays and seconds, for every way to make a picture.
//!
//! * [`method`](Method): the integrators, even points, and a mistake;
//! * [`plan`](Design): how many samples each takes;
//! * [`runs`](measure): independent pictures, in turns;
//! * [`reference`](Reference): the truth, whose own noise counts for nobody;
//! * [`bias`](Bias): the error that stays;
//! * [`strip`]: pictures side by side;
//! * [`size`](Size): what pictures of one size give;
//! * [`list`](PriceList), [`target`](Reach): slopes, ratios and times, with intervals or a word that
//!   there is none.
//!
//! Errors are relative: the root of the mean over pixels and channels of `(x - t)² / (t² + (m/3)²)`,
//! where `t` is the truth and `m` the mean of the picture. That counts each pixel by itself, so that a
//! small picture tells what a large one costs; [`accuracy`](crate::render::accuracy), which has no truth
//! to look at, counts a pixel by what is around it.
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

pub use bias::Bias;
pub use list::{PerSample, PriceList, Priced, TARGETS};
pub use method::{ALL, BASE, CLAMP, Method};
pub use plan::{Budget, Design, Planned};
pub use reference::Reference;
pub use runs::{Measured, Nothing, Run, Runs, measure};
pub use size::{Size, Verdict};
pub use target::Reach;
