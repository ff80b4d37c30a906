//! Transforms of shapes.

use super::description as said;
use super::field::{self, Checked, Field};
use glam::{DMat3, DVec3, Vec3};

/// Where a shape is put: scaled, then rotated, then shifted, all in `f64`.
pub(super) struct Placement {
    linear: DMat3,
    scale: DVec3,
    shift: DVec3,
}

impl Placement {
    pub(super) fn new(field: &Field, said: Option<&said::Transform>) -> Checked<Self> {
        let said = said.cloned().unwrap_or_default();
        let scale_field = field.key("scale");
        let scale = match said.scale {
            Some(said::Color(factors)) => field::vector(&scale_field, said::Exactly(factors))?,
            None => DVec3::ONE,
        };
        // As f32, like every other length: what is zero there leaves nothing to hit.
        if scale.as_vec3().cmpeq(Vec3::ZERO).any() {
            let what = "must not be 0 along any axis: the shape would have no volume left";
            return Err(scale_field.problem(what));
        }
        let rotation = match &said.rotate {
            Some(r) => {
                let field = field.key("rotate");
                let axis = field::direction(&field.key("axis"), r.axis)?;
                let degrees = field::finite(&field.key("degrees"), r.degrees)?;
                rotation(axis, degrees.to_radians())
            }
            None => DMat3::IDENTITY,
        };
        let shift = match said.translate {
            Some(t) => field::vector(&field.key("translate"), t)?,
            None => DVec3::ZERO,
        };
        Ok(Placement {
            linear: rotation * DMat3::from_diagonal(scale),
            scale,
            shift,
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

    /// True where front and back change places.
    pub(super) fn mirrors(&self) -> bool {
        self.scale
            .to_array()
            .into_iter()
            .filter(|s| *s < 0.0)
            .count()
            % 2
            == 1
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
