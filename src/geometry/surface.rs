//! A point on a surface, and the rays that leave it.

use super::Ray;
use crate::numeric::{gamma, offset_origin, scale_and_direction};
use glam::Vec3;

/// A point on a surface with all that rays need to leave it.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// The point, recomputed on the shape (not as `origin + t direction`, which is the real cause
    /// of most self-shadowing).
    pub p: Vec3,
    /// Bound on the rounding error of `p`, coordinate by coordinate, in scene units; it is sure
    /// for what counts, the distance off the surface along `n`.
    pub error: Vec3,
    /// Geometric unit normal on the shape's front side.
    pub n: Vec3,
    /// The moment at which the point is there, in `[0, 1]`; rays that leave it look at that moment.
    pub time: f32,
}

impl Surface {
    /// The same point with its normal on the side from which `direction` leaves.
    #[must_use]
    pub fn facing(self, direction: Vec3) -> Surface {
        if self.n.dot(direction) < 0.0 {
            Surface { n: -self.n, ..self }
        } else {
            self
        }
    }

    /// A ray that leaves the surface in `direction`.
    pub fn spawn(&self, direction: Vec3) -> Ray {
        Ray::new(
            offset_origin(self.p, self.error, self.n, direction),
            direction,
        )
        .at_time(self.time)
    }

    /// A ray from here to the free point `target`; it ends there. Its direction is of any length.
    pub fn spawn_to_point(&self, target: Vec3) -> Ray {
        let origin = offset_origin(self.p, self.error, self.n, target - self.p);
        segment(origin, target, self.time)
    }

    /// A ray from here to a point of another surface, which ends just before that surface. Its
    /// direction is of any length.
    ///
    /// From far away the ray's direction, rounded, leads past the target by more than the target's
    /// own error: the end keeps that distance too, or a lamp would stand in its own light.
    pub fn spawn_to(&self, target: &Surface) -> Ray {
        let back = self.p - target.p;
        let error = target.error + back.abs() * gamma(3);
        let end = offset_origin(target.p, error, target.n, back);
        self.spawn_to_point(end)
    }
}

fn segment(from: Vec3, to: Vec3, time: f32) -> Ray {
    let (scale, direction) = scale_and_direction(to - from);
    Ray {
        origin: from,
        direction,
        // The rounded direction may overshoot by a few roundings.
        t_max: scale * (1.0 - gamma(8)),
        time,
    }
}
