//! Photons: where the light of walks from the lights lands, and how much of it there is around a point.
//!
//! A [`Photon`] is a place where such a walk meets a surface, with the power that it brings. A
//! [`PhotonMap`] finds those around a point and makes of them an estimate of the light that the surface
//! scatters there: the power on a small disc, divided by its area. That blurs: what is estimated is the
//! mean over the disc. [`radius`] says how large discs are, and how fast they shrink; [`Kernel`] how much a photon
//! counts by its distance; [`nearest`] chooses the disc by the photons themselves, and [`edge`] knows how much of
//! one lies on its surface. All of it is the same in the flat world, where a disc is a piece of a line.
//!
//! Source: Jensen, Global Illumination Using Photon Maps (Rendering Techniques 1996).

pub mod edge;
mod kernel;
mod map;
pub mod nearest;
pub mod radius;

pub use kernel::Kernel;
pub use map::PhotonMap;

use crate::color::Rgb;
use crate::space::{Solid, Space};

/// Light that lands on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Photon<S: Space = Solid> {
    /// Where, in coordinates of the scene.
    pub p: S::Vector,
    /// The unit normal there, on the front side of the surface.
    pub n: S::Vector,
    /// The unit direction that it came from.
    pub wi: S::Vector,
    /// The power that its path stands for, in W, were it the only one.
    pub power: Rgb,
    /// The segments of its path so far, 1 for light straight from its source.
    pub segments: u32,
}
