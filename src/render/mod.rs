//! The pixel loop: samples in, film out.
//!
//! A picture is a pure function of scene, integrator, seed and samples. Pixels are independent:
//! each draws its own random numbers and adds its samples in their order, so neither the number
//! of threads nor the size of the tiles changes a bit.

pub mod accuracy;
mod blur;
mod clock;
pub mod compare;
mod film;
mod film_loop;
mod goal;
mod options;
mod picture;
mod progress;
mod recorder;
mod rendered;
mod shard;
mod shots;
mod state;
pub mod stopping;
mod tile;
mod watch;

pub use blur::Blur;
pub use film::{BadSample, Film, Pixel};
pub use film_loop::{Session, record, render};
pub use options::Options;
pub use picture::Picture;
pub use progress::Progress;
pub use recorder::{Recorded, Recorder};
pub(crate) use rendered::known_mean;
pub use rendered::{Rendered, rounding};
pub use shard::Shard;
pub use state::{State, Tally};
pub use tile::camera_sample;
pub use watch::{Faults, too_bright};
