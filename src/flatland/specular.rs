//! Mirrors and glass of the flat world: a slice of those in space.

use crate::color::Rgb;
use crate::materials::{Glass, Mirror, Specular};
use glam::{Vec2, Vec3};

/// A perfectly smooth material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FlatSpecular {
    /// A mirror on both sides.
    Mirror {
        /// The share of light reflected, each channel in `[0, 1]`.
        reflectance: Rgb,
    },
    /// Glass behind the surface, index 1 in front of it. What is reflected is as for unpolarised light in
    /// space: the flat world has no polarisation of its own.
    Glass {
        /// Index of refraction behind the surface.
        ior: f32,
    },
}

impl FlatSpecular {
    /// The directions of light that is scattered to the unit direction of local coordinates `(x, y)`, where `y`
    /// is the front's normal; in space, in the plane of the first and third axis.
    pub fn specular(&self, wo: Vec2) -> Specular {
        let wo = Vec3::new(wo.x, 0.0, wo.y);
        match *self {
            FlatSpecular::Mirror { reflectance } => Mirror { reflectance }.specular(wo),
            FlatSpecular::Glass { ior } => Glass { ior }.specular(wo),
        }
    }
}
