//! Axis-aligned boxes.

use super::PreparedRay;
use crate::numeric::gamma;
use glam::{DVec3, Vec3};

/// What moves an entry forward: the roundings of difference, reciprocal and product on each side,
/// and one of the shape's own.
pub(super) const EARLIER: f32 = 1.0 - 2.0 * gamma(4);

/// An axis-aligned box, corners included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The corner with the smallest coordinates.
    pub min: Vec3,
    /// The corner with the largest coordinates.
    pub max: Vec3,
}

impl Aabb {
    /// The box of nothing, which any union replaces.
    pub const EMPTY: Aabb = Aabb {
        min: Vec3::INFINITY,
        max: Vec3::NEG_INFINITY,
    };

    /// The box of a set of points.
    pub fn of(points: impl IntoIterator<Item = Vec3>) -> Self {
        points.into_iter().fold(Aabb::EMPTY, |b, p| Aabb {
            min: b.min.min(p),
            max: b.max.max(p),
        })
    }

    /// The box of two boxes.
    #[must_use]
    pub fn union(self, other: Aabb) -> Aabb {
        Aabb {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// True where every coordinate is finite (never for [`Aabb::EMPTY`]).
    pub fn is_finite(&self) -> bool {
        self.min.is_finite() && self.max.is_finite()
    }

    /// The middle; halves are added, so that no finite box overflows.
    pub fn center(&self) -> Vec3 {
        self.min * 0.5 + self.max * 0.5
    }

    /// Half the surface area, in `f64` so that no finite box overflows; 0 for an empty box.
    pub fn half_area(&self) -> f64 {
        let d = (self.max.as_dvec3() - self.min.as_dvec3()).max(DVec3::ZERO);
        d.x * d.y + d.y * d.z + d.z * d.x
    }

    /// A lower bound on where the ray enters the box, if it meets it within `[0, t_max]`.
    ///
    /// A ray that lies in a face of the box gives `0 · ∞ = NaN` for that axis; the comparisons are
    /// written so that NaN changes nothing, which counts the face as inside. The entry is moved
    /// forward by the roundings of both distances and of the shape inside, so that rays through
    /// edges and corners are not lost, and nothing in the box is crossed before its entry.
    ///
    /// Source: Ize, Robust BVH Ray Traversal (JCGT 2(2), 2013).
    #[inline]
    pub fn entry(&self, ray: &PreparedRay, t_max: f32) -> Option<f32> {
        let mut t0 = 0.0;
        let mut t1 = t_max;
        let mut axis = |min: f32, max: f32, origin: f32, inverse: f32| {
            let (near, far) = if inverse < 0.0 {
                (max, min)
            } else {
                (min, max)
            };
            let near = (near - origin) * inverse;
            let far = (far - origin) * inverse;
            if near > t0 {
                t0 = near;
            }
            if far < t1 {
                t1 = far;
            }
        };
        let (o, i) = (ray.origin, ray.inverse);
        axis(self.min.x, self.max.x, o.x, i.x);
        axis(self.min.y, self.max.y, o.y, i.y);
        axis(self.min.z, self.max.z, o.z, i.z);
        let entry = t0 * EARLIER;
        (entry <= t1).then_some(entry)
    }
}
