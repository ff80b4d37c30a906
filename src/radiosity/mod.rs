//! Radiosity: the light of diffuse surfaces on patches, all of it at once.
//!
//! The finite elements of the rendering equation: surfaces are cut into patches of one radiance each,
//! which turns the integral over directions into a sum over patches and the equation into a linear
//! [`System`]. The solution depends on no view, and holds nothing but diffuse light: `LD*`.
//!
//! * [`Patches`]: from a scene, cut where surfaces touch.
//! * [`FormFactors`]: how much patches see of each other, a [`Matrix`].
//! * [`form_factor`]: of two patches alone, to any number of digits.
//! * [`System`]: solved by Gauss-Seidel, Jacobi or Southwell.
//! * [`Solution`]: looked at as it is, interpolated, or gathered once more.
//!
//! The integrator that asks for direct light and looks up the rest is
//! [`integrators::Radiosity`](crate::integrators::Radiosity).
//!
//! Source: Goral, Torrance, Greenberg, Battaile, Modeling the Interaction of Light Between Diffuse
//! Surfaces (SIGGRAPH 1984); Cohen, Wallace, Radiosity and Realistic Image Synthesis (1993).

mod coarse;
mod direct;
mod error;
mod factors;
pub mod flat;
mod lambert;
mod matrix;
mod mesh_error;
mod pair;
mod patches;
mod pieces;
mod quadrature;
mod solution;
mod system;
mod touching;
mod watch;

pub use error::{MOST_PATCHES, RadiosityError};
pub use factors::FormFactors;
pub use lambert::point_to_polygon;
pub use matrix::Matrix;
pub use mesh_error::Report;
pub use pair::form_factor;
pub use patches::{Patch, PatchSize, Patches};
pub use quadrature::{gauss_legendre, graded, points_on};
pub use solution::{Effort, POINTS, Solution, system};
pub use system::{Channels, Solved, System};
pub use watch::Watch;
