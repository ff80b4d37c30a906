//! A ray, and a ray made ready for many tests.

use crate::space::{self, Solid};
use glam::{Vec3, Vec3A};

/// A ray of the world with three dimensions.
pub type Ray = space::Ray<Solid>;

impl Ray {
    /// How far an intersection may be: a number, where `t_max` may be infinite.
    pub(super) fn reach(&self) -> f32 {
        self.t_max.min(f32::MAX)
    }

    /// True for finite rays that go somewhere, however far; all others hit nothing.
    pub fn is_valid(&self) -> bool {
        let (origin, direction) = (Vec3A::from(self.origin), Vec3A::from(self.direction));
        origin.is_finite() && direction.is_finite() && direction != Vec3A::ZERO && self.t_max > 0.0
    }
}

/// A ray with what every box and triangle test needs, computed once.
#[derive(Clone, Copy, Debug)]
pub struct PreparedRay {
    pub(super) origin: Vec3,
    pub(super) direction: Vec3,
    /// Componentwise reciprocal of the direction; infinite where that is as good as zero.
    pub(super) inverse: Vec3,
    /// The axes in the order (x', y', z'), where z' is the one the ray runs along most.
    pub(super) axes: [usize; 3],
    /// The shears along x' and y' that make the ray run straight along z'.
    pub(super) shear: [f32; 2],
    /// When it looks, in `[0, 1]`.
    pub(super) time: f32,
}

/// For each axis that a ray runs along, forwards and backwards, the two others: in the order that
/// keeps the winding of triangles.
const AXES: [[[usize; 2]; 2]; 3] = [[[1, 2], [2, 1]], [[2, 0], [0, 2]], [[0, 1], [1, 0]]];

impl From<&Ray> for PreparedRay {
    #[inline]
    fn from(ray: &Ray) -> Self {
        // A component so small that its reciprocal is none counts as zero, for shapes as for boxes:
        // or the two would not agree on where the ray goes.
        let direction = Vec3A::from(ray.direction);
        let inverse = direction.recip();
        let d = Vec3A::select(inverse.is_finite_mask(), direction, direction * 0.0);
        let size = d.abs();
        // By arithmetic and a table, for nobody can predict where a ray goes.
        let largest_is_x = (size.x > size.y) & (size.x > size.z);
        let z = if largest_is_x {
            0
        } else {
            2 - usize::from(size.y > size.z)
        };
        let [x, y] = AXES[z][usize::from(d[z] < 0.0)];
        PreparedRay {
            origin: ray.origin,
            direction: d.into(),
            inverse: inverse.into(),
            axes: [x, y, z],
            shear: [d[x] / d[z], d[y] / d[z]],
            time: ray.time,
        }
    }
}
