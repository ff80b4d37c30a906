//! A flat triangle, and the watertight test it shares with the quad.

use super::{Aabb, Intersection, PreparedRay, Surface};
use crate::numeric::gamma;
use glam::{DVec3, Vec3};

/// Bound on how far a weighted sum of corners lies off their plane, relative to the sum of the
/// terms' sizes.
///
/// Five roundings, and one for all that is of second order: two in `1 - u - v`, one in each
/// product, two in the sum; the worst of a million random points was off by 2.7. The first two let
/// the weights not add up to one, which moves the point towards the world's origin: measured along
/// the normal that is no more than two roundings of the terms, for all corners are equally far from
/// the origin along it.
const CORNER_SUM_ERROR: f32 = gamma(6);

/// A flat triangle; its normal is on the side from which `a`, `b`, `c` run counter-clockwise.
#[derive(Clone, Copy, Debug)]
pub struct Triangle {
    /// First corner.
    pub a: Vec3,
    /// Second corner.
    pub b: Vec3,
    /// Third corner.
    pub c: Vec3,
}

impl Triangle {
    /// True where the corners are finite and span an area; all others cannot be hit.
    pub fn is_proper(&self) -> bool {
        let n = self.cross_product();
        n.is_finite() && n.length_squared() > 0.0
    }

    /// The triangle moved by a vector, each corner rounded once.
    #[must_use]
    pub fn moved(&self, by: Vec3) -> Triangle {
        Triangle {
            a: self.a + by,
            b: self.b + by,
            c: self.c + by,
        }
    }

    /// Area in square scene units.
    pub fn area(&self) -> f64 {
        0.5 * self.cross_product().length()
    }

    /// Unit normal.
    pub fn normal(&self) -> Vec3 {
        self.cross_product().normalize().as_vec3()
    }

    /// Twice the area times the normal, in `f64`: the products of `f32` edges neither vanish nor
    /// overflow there.
    fn cross_product(&self) -> DVec3 {
        let a = self.a.as_dvec3();
        (self.b.as_dvec3() - a).cross(self.c.as_dvec3() - a)
    }

    /// The first crossing with `0 < t <= t_max`.
    #[inline]
    pub fn intersect(&self, ray: &PreparedRay, t_max: f32) -> Option<Intersection> {
        let [a, b, c] = [&self.a, &self.b, &self.c].map(|corner| Sheared::new(corner, ray));
        let [u, v] = weights([edge(b, c), edge(c, a), edge(a, b)])?;
        let t = self.distance(ray, t_max)?;
        Some(Intersection::new(t, u, v))
    }

    /// How far along the ray its plane is. Few rays come this far, so it stays out of line and the
    /// loop over a leaf's triangles short.
    #[inline(never)]
    fn distance(&self, ray: &PreparedRay, t_max: f32) -> Option<f32> {
        let entry = self.bounds().entry(ray, t_max)?;
        self.plane().distance(ray, t_max, entry)
    }

    #[inline(always)]
    pub(super) fn plane(&self) -> Plane {
        Plane {
            point: self.a.as_dvec3(),
            normal: self.cross_product(),
        }
    }

    /// The surface at a crossing.
    pub fn surface(&self, intersection: Intersection) -> Surface {
        let (u, v) = (intersection.u, intersection.v);
        let parts = [self.a * (1.0 - u - v), self.b * u, self.c * v];
        Surface {
            p: parts[0] + parts[1] + parts[2],
            error: (parts[0].abs() + parts[1].abs() + parts[2].abs()) * CORNER_SUM_ERROR,
            n: self.normal(),
            time: 0.0,
        }
    }

    /// The box of the corners.
    pub fn bounds(&self) -> Aabb {
        Aabb::of([self.a, self.b, self.c])
    }
}

/// A corner seen from the ray: the origin at zero, the ray straight along the axis left out.
#[derive(Clone, Copy)]
struct Sheared {
    x: f64,
    y: f64,
}

impl Sheared {
    #[inline]
    fn new(corner: &Vec3, ray: &PreparedRay) -> Self {
        // Each coordinate straight from memory, without a detour for the order of the axes.
        let (corner, origin): (&[f32; 3], &[f32; 3]) = (corner.as_ref(), ray.origin.as_ref());
        let [x, y, z] = ray.axes;
        let height = corner[z] - origin[z];
        Sheared {
            x: f64::from(corner[x] - origin[x] - ray.shear[0] * height),
            y: f64::from(corner[y] - origin[y] - ray.shear[1] * height),
        }
    }
}

// ANCHOR: edge
/// The edge function of two corners: on which side of the edge between them the ray passes.
///
/// Two triangles that share an edge compute the same for it, bit for bit but for the sign, and its
/// sign is exact, for the products of `f32` numbers are exact in `f64`: no ray slips between them.
///
/// Source: Woop, Benthin, Wald, Watertight Ray/Triangle Intersection (JCGT 2(1), 2013).
#[inline]
fn edge(p: Sheared, q: Sheared) -> f64 {
    q.x * p.y - q.y * p.x
}
// ANCHOR_END: edge

// ANCHOR: weights
/// The weights of the second and third corner from the edge functions opposite to each; `None`
/// where the ray passes outside.
#[inline]
pub(super) fn weights([u, v, w]: [f64; 3]) -> Option<[f32; 2]> {
    let determinant = u + v + w;
    // Without shortcuts, for nobody can predict these signs. A determinant of zero is a triangle
    // seen edge on; a NaN makes every comparison false.
    let front = (u >= 0.0) & (v >= 0.0) & (w >= 0.0) & (determinant > 0.0);
    let back = (u <= 0.0) & (v <= 0.0) & (w <= 0.0) & (determinant < 0.0);
    (front | back).then(|| [(v / determinant) as f32, (w / determinant) as f32])
}
// ANCHOR_END: weights

/// The plane of a flat shape.
pub(super) struct Plane {
    /// Any point of it.
    pub(super) point: DVec3,
    /// Of any length.
    pub(super) normal: DVec3,
}

impl Plane {
    /// How far a point is from the plane, positive on the side of its normal.
    pub(super) fn height(&self, p: DVec3) -> f64 {
        (p - self.point).dot(self.normal.normalize())
    }

    /// How far along the ray a flat shape is whose corners it passes between, and whose box it enters
    /// at `entry`; `None` where that is not within `0 < t <= t_max`.
    ///
    /// The plane decides in `f64`, from the corners as they are, on which side of it the ray begins: a
    /// weighted sum of the sheared corners' distances would be off by some roundings of the largest,
    /// so that rays leaving a long triangle would meet it again. Where the ray grazes the plane, the
    /// distance to it is ill-conditioned; that to the box is not, and no answer is nearer than the box,
    /// or a hierarchy of boxes would not find what a plain loop does.
    #[inline]
    pub(super) fn distance(&self, ray: &PreparedRay, t_max: f32, entry: f32) -> Option<f32> {
        let n = self.normal;
        let to_plane = n.dot(self.point - ray.origin.as_dvec3()) / n.dot(ray.direction.as_dvec3());
        let t = to_plane as f32;
        (t > 0.0 && t <= t_max).then(|| t.max(entry))
    }
}
