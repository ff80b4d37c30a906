//! A parallelogram.

use super::triangle::{Plane, weights};
use super::{Aabb, Intersection, PreparedRay, Surface};
use crate::numeric::gamma;
use glam::{DVec3, Vec3};
use wide::{f32x4, f64x4};

/// The parallelogram `corner + s u + t v` for `s`, `t` in `[0, 1]`; its normal is along `u × v`.
///
/// The corners are rounded to `f32` one by one, so that quads which share a corner share its bits.
/// Far from the world's origin that bends the shape a little; its plane is then the one through
/// the middle of the corners and along both diagonals.
#[derive(Clone, Copy, Debug)]
pub struct Quad {
    /// The four corners in order, `corner`, `+ u`, `+ u + v`, `+ v`, each rounded once: for each
    /// coordinate that of the four.
    corners: [[f32; 4]; 3],
    normal: Vec3,
    /// Bound on the rounding error of a point, coordinate by coordinate.
    pub(super) error: Vec3,
}

impl Quad {
    /// The quad of a corner and two edges; `None` where these are not finite in `f32` or span no
    /// area there.
    pub fn new(corner: DVec3, u: DVec3, v: DVec3) -> Option<Self> {
        let corners = [corner, corner + u, corner + u + v, corner + v].map(DVec3::as_vec3);
        Quad::of_corners(corners)
    }

    fn of_corners(corners: [Vec3; 4]) -> Option<Self> {
        let mut quad = Quad {
            corners: by_coordinate(corners),
            normal: Vec3::ZERO,
            error: Vec3::ZERO,
        };
        // Seven roundings in the sum, one for the corners that are not quite in the plane.
        quad.error = quad.size() * gamma(8);
        let cross = quad.plane().normal;
        let length = cross.length();
        quad.normal = (cross / length).as_vec3();
        let area = quad.area();
        let proper = corners.iter().all(|c| c.is_finite()) && area > 0.0 && area.is_finite();
        proper.then_some(quad)
    }

    /// The quad moved by a vector, each corner rounded once more.
    ///
    /// So far away that the corners fall on a line, it has no plane and cannot be hit.
    #[must_use]
    pub fn moved(&self, by: Vec3) -> Quad {
        let corners = self.corners().map(|corner| corner + by);
        Quad::of_corners(corners).unwrap_or_else(|| Quad {
            corners: by_coordinate(corners),
            ..*self
        })
    }

    /// How far the corners may be from a common plane after they were moved, where those of the
    /// quad before were rounded once: a rounding of each.
    pub fn bend(&self, moved: &Quad) -> Vec3 {
        (self.size() + moved.size()) * gamma(2)
    }

    /// The largest coordinates of the corners, without signs.
    fn size(&self) -> Vec3 {
        let [a, b, c, d] = self.corners().map(Vec3::abs);
        a.max(b).max(c).max(d)
    }

    /// The corners in order: `corner`, `+ u`, `+ u + v`, `+ v`.
    pub fn corners(&self) -> [Vec3; 4] {
        let [x, y, z] = self.corners;
        [0, 1, 2, 3].map(|i| Vec3::new(x[i], y[i], z[i]))
    }

    /// Unit normal.
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    /// Area in square scene units.
    pub fn area(&self) -> f32 {
        (0.5 * self.plane().normal.length()) as f32
    }

    /// The plane through the middle of the corners and along both diagonals; the length of its
    /// normal is twice the area.
    pub(super) fn plane(&self) -> Plane {
        let corners = self.corners.map(|lanes| lanes.map(f64::from));
        let vector = |of: fn([f64; 4]) -> f64| DVec3::from(corners.map(of));
        Plane {
            point: vector(|[a, b, c, d]| (a + b + c + d) * 0.25),
            normal: vector(|[a, _, c, _]| c - a).cross(vector(|[_, b, _, d]| d - b)),
        }
    }

    /// The first crossing with `0 < t <= t_max`.
    ///
    /// As two triangles with a common diagonal, so that walls which share corners are watertight
    /// along their common edge. Both lie in one plane, so that no ray that leaves the one half
    /// meets the other.
    pub fn intersect(&self, ray: &PreparedRay, t_max: f32) -> Option<Intersection> {
        let entry = self.bounds().entry(ray, t_max)?;
        self.intersect_from(ray, t_max, entry)
    }

    /// [`Quad::cross`] of a ray that enters the box of the corners at `entry`: where the four sides
    /// and the diagonal are seen at once.
    ///
    /// Out of line, as the sphere's, for the sake of the most frequent shape: with all three in
    /// one loop triangles take half as long again.
    #[inline(never)]
    pub(super) fn intersect_from(
        &self,
        ray: &PreparedRay,
        t_max: f32,
        entry: f32,
    ) -> Option<Intersection> {
        let [x, y, z] = ray.axes;
        let from_origin =
            |axis: usize| f32x4::new(self.corners[axis]) - f32x4::splat(ray.origin[axis]);
        let height = from_origin(z);
        let sheared = |axis: usize, shear: f32| {
            let seen = from_origin(axis) - f32x4::splat(shear) * height;
            seen.to_array().map(f64::from)
        };
        let (xs, ys) = (sheared(x, ray.shear[0]), sheared(y, ray.shear[1]));
        // The edge functions of the four sides, and of the diagonal from c to a.
        let next = |[a, b, c, d]: [f64; 4]| f64x4::new([b, c, d, a]);
        let sides = next(xs) * f64x4::new(ys) - next(ys) * f64x4::new(xs);
        let [ab, bc, cd, da] = sides.to_array();
        let ca = xs[0] * ys[2] - ys[0] * xs[2];
        let (u, v) = match weights([bc, ca, ab]) {
            // a + u (b - a) + v (c - a), where c - a is the sum of the two edges.
            Some([u, v]) => (u + v, v),
            None => weights([cd, da, -ca]).map(|[u, v]| (u, u + v))?,
        };
        let t = self.plane().distance(ray, t_max, entry)?;
        Some(Intersection::new(t, u, v))
    }

    /// The surface at a crossing.
    pub fn surface(&self, intersection: Intersection) -> Surface {
        self.surface_at(intersection.u, intersection.v)
    }

    /// The surface at `corner + s u + t v`.
    pub fn surface_at(&self, s: f32, t: f32) -> Surface {
        // Bilinear weights: all are non-negative, so nothing cancels.
        let weights = [(1.0 - s) * (1.0 - t), s * (1.0 - t), s * t, (1.0 - s) * t];
        let at = |[a, b, c, d]: [f32; 4]| {
            let [wa, wb, wc, wd] = weights;
            a * wa + b * wb + c * wc + d * wd
        };
        Surface {
            p: Vec3::from(self.corners.map(at)),
            error: self.error,
            n: self.normal,
            time: 0.0,
        }
    }

    /// The box of the corners.
    pub fn bounds(&self) -> Aabb {
        Aabb::of(self.corners())
    }
}

/// For each coordinate that of the four corners.
fn by_coordinate(corners: [Vec3; 4]) -> [[f32; 4]; 3] {
    [0, 1, 2].map(|axis| corners.map(|corner| corner[axis]))
}
