//! Photons: where the light of walks from the lights lands, and how much of it there is around a point.
//!
//! A [`Photon`] is a place where such a walk meets a surface, with the power that it brings. A
//! [`PhotonMap`] finds those around a point and makes of them an estimate of the light that the surface
//! scatters there: the power on a small disc, divided by its area. That blurs: what is estimated is the
//! mean over the disc. [`radius`] says how large discs are, and how fast they shrink.
//!
//! Source: Jensen, Global Illumination Using Photon Maps (Rendering Techniques 1996).

mod map;
pub mod radius;

pub use map::PhotonMap;

use crate::color::Rgb;
use glam::Vec3;

/// Light that lands on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Photon {
    /// Where, in coordinates of the scene.
    pub p: Vec3,
    /// The unit normal there, on the front side of the surface.
    pub n: Vec3,
    /// The unit direction that it came from.
    pub wi: Vec3,
    /// The power that its path stands for, in W, were it the only one.
    pub power: Rgb,
    /// The segments of its path so far, 1 for light straight from its source.
    pub segments: u32,
}
