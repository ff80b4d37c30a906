//! Perfect specular reflection.

use super::{Branch, Specular};
use crate::color::Rgb;
use glam::Vec3;

/// A perfect mirror of constant reflectance, on both sides.
#[derive(Clone, Copy, Debug)]
pub struct Mirror {
    /// The share of light reflected at every angle, each channel in `[0, 1]`.
    pub reflectance: Rgb,
}

impl Mirror {
    /// The mirror direction.
    pub fn specular(&self, wo: Vec3) -> Specular {
        Specular {
            reflected: Some(Branch {
                wi: reflect(wo),
                weight: self.reflectance,
            }),
            transmitted: None,
        }
    }
}

/// The direction in which `wo` is mirrored by the plane `z = 0`.
pub(super) fn reflect(wo: Vec3) -> Vec3 {
    Vec3::new(-wo.x, -wo.y, wo.z)
}
