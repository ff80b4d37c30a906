//! Transforms of shapes.

use super::Mapping;
use super::description as said;
use super::field::{Checked, Within};
use glam::{DMat3, DVec3};

/// Where a shape is put: scaled, then rotated, then shifted, all in `f64`.
pub(super) struct Placement {
    linear: DMat3,
    scale: DVec3,
    shift: DVec3,
}

impl Placement {
    pub(super) fn new(said: &said::Transform) -> Checked<Self> {
        let scale = said.scale.get().within("scale")?;
        let rotation = match &said.rotate {
            Some(r) => rotation(r.axis.get()?, r.degrees.get()?.to_radians()),
            None => DMat3::IDENTITY,
        };
        Ok(Placement {
            linear: rotation * DMat3::from_diagonal(scale),
            scale,
            shift: said.translate.get().within("translate")?,
        })
    }

    /// The same place, shifted further.
    pub(super) fn shifted(self, by: DVec3) -> Self {
        Placement {
            shift: self.shift + by,
            ..self
        }
    }

    pub(super) fn vector(&self, v: DVec3) -> DVec3 {
        self.linear * v
    }

    pub(super) fn point(&self, p: DVec3) -> DVec3 {
        self.linear * p + self.shift
    }

    /// The matrix and the shift that follows.
    pub(super) fn affine(&self) -> (DMat3, DVec3) {
        (self.linear, self.shift)
    }

    /// True where front and back change places.
    pub(super) fn mirrors(&self) -> bool {
        let signs = self.scale.to_array().map(|s| s < 0.0);
        signs[0] ^ signs[1] ^ signs[2]
    }

    /// Texture coordinates of a sphere that is put here.
    pub(super) fn of_sphere(&self, inward: bool) -> Mapping {
        let outwards = if inward { -1.0 } else { 1.0 };
        Mapping::Sphere {
            turn: (self.linear.transpose() * (outwards / self.scale.x.abs())).as_mat3(),
        }
    }

    /// The factor all lengths change by, if it is one.
    pub(super) fn uniform_scale(&self) -> Option<f64> {
        let s = self.scale.abs();
        (s.x == s.y && s.y == s.z).then_some(s.x)
    }
}

/// The rotation about a unit axis (Rodrigues 1840), with sines that are the same everywhere.
fn rotation(axis: DVec3, angle: f64) -> DMat3 {
    let (sin, cos) = libm::sincos(angle);
    let turn = |v: DVec3| v * cos + axis.cross(v) * sin + axis * (axis.dot(v) * (1.0 - cos));
    DMat3::from_cols(turn(DVec3::X), turn(DVec3::Y), turn(DVec3::Z))
}
