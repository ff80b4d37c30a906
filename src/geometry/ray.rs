//! A ray, and a ray made ready for many tests.

use glam::Vec3;

/// A half line from `origin`, as far as `t_max`.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vec3,
    /// Where it goes; distances along it count in units of this vector's length.
    pub direction: Vec3,
    /// How far it reaches; infinite for all but shadow rays.
    pub t_max: f32,
}

impl Ray {
    /// A ray without end.
    pub fn new(origin: Vec3, direction: Vec3) -> Self {
        Ray {
            origin,
            direction,
            t_max: f32::INFINITY,
        }
    }

    /// The point at distance `t`.
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + self.direction * t
    }

    /// How far a crossing may be: a number, where `t_max` may be infinite.
    pub(super) fn reach(&self) -> f32 {
        self.t_max.min(f32::MAX)
    }

    /// True for finite rays that go somewhere, however far; all others hit nothing.
    pub fn is_valid(&self) -> bool {
        self.origin.is_finite()
            && self.direction.is_finite()
            && self.direction != Vec3::ZERO
            && self.t_max > 0.0
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
}

impl From<&Ray> for PreparedRay {
    fn from(ray: &Ray) -> Self {
        // A component so small that its reciprocal is none counts as zero, for shapes as for boxes:
        // or the two would not agree on where the ray goes.
        let inverse = ray.direction.recip();
        let d = Vec3::select(inverse.is_finite_mask(), ray.direction, ray.direction * 0.0);
        let size = d.abs();
        let z = if size.x > size.y && size.x > size.z {
            0
        } else if size.y > size.z {
            1
        } else {
            2
        };
        let (mut x, mut y) = ((z + 1) % 3, (z + 2) % 3);
        if d[z] < 0.0 {
            // Keeps the winding of triangles.
            std::mem::swap(&mut x, &mut y);
        }
        PreparedRay {
            origin: ray.origin,
            direction: d,
            inverse,
            axes: [x, y, z],
            shear: [d[x] / d[z], d[y] / d[z]],
        }
    }
}
