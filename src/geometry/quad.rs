//! A parallelogram.

use super::triangle::{Sheared, distance, weights};
use super::{Aabb, Crossing, PreparedRay, Surface};
use crate::numeric::gamma;
use glam::{DVec3, Vec3};

/// The parallelogram `corner + s u + t v` for `s`, `t` in `[0, 1]`; its normal is along `u × v`.
///
/// The corners are rounded to `f32` one by one, so that quads which share a corner share its bits.
/// Far from the world's origin that bends the shape a little; its plane is then the one through
/// the middle of the corners and along both diagonals.
#[derive(Clone, Copy, Debug)]
pub struct Quad {
    /// The four corners in order: `corner`, `+ u`, `+ u + v`, `+ v`, each rounded once.
    corners: [Vec3; 4],
    normal: Vec3,
    area: f32,
}

impl Quad {
    /// The quad of a corner and two edges; `None` where these are not finite in `f32` or span no
    /// area there.
    pub fn new(corner: DVec3, u: DVec3, v: DVec3) -> Option<Self> {
        let corners = [corner, corner + u, corner + u + v, corner + v].map(DVec3::as_vec3);
        Quad::of_corners(corners)
    }

    fn of_corners(corners: [Vec3; 4]) -> Option<Self> {
        let cross = cross_product(corners);
        let length = cross.length();
        let area = (0.5 * length) as f32;
        let proper = corners.iter().all(|c| c.is_finite()) && area > 0.0 && area.is_finite();
        proper.then(|| Quad {
            corners,
            normal: (cross / length).as_vec3(),
            area,
        })
    }

    /// The quad moved by a vector, each corner rounded once more.
    ///
    /// So far away that the corners fall on a line, it has no plane and cannot be hit.
    #[must_use]
    pub fn moved(&self, by: Vec3) -> Quad {
        let corners = self.corners.map(|corner| corner + by);
        Quad::of_corners(corners).unwrap_or(Quad { corners, ..*self })
    }

    /// How far the corners may be from a common plane after they were moved, where those of the
    /// quad before were rounded once: a rounding of each.
    pub fn bend(&self, moved: &Quad) -> Vec3 {
        (self.size() + moved.size()) * gamma(2)
    }

    /// The largest coordinates of the corners, without signs.
    fn size(&self) -> Vec3 {
        let [a, b, c, d] = self.corners.map(Vec3::abs);
        a.max(b).max(c).max(d)
    }

    /// The corners in order: `corner`, `+ u`, `+ u + v`, `+ v`.
    pub fn corners(&self) -> [Vec3; 4] {
        self.corners
    }

    /// Unit normal.
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    /// Area in square scene units.
    pub fn area(&self) -> f32 {
        self.area
    }

    /// The first crossing with `0 < t <= t_max`.
    ///
    /// As two triangles with a common diagonal, so that walls which share corners are watertight
    /// along their common edge. Both lie in one plane, so that no ray that leaves the one half
    /// meets the other.
    ///
    /// Out of line, as the sphere's, for the sake of the most frequent shape: with all three in
    /// one loop triangles take half as long again.
    #[inline(never)]
    pub fn cross(&self, ray: &PreparedRay, t_max: f32) -> Option<Crossing> {
        let seen = |i: usize| Sheared::new(&self.corners[i], ray);
        let (a, b, c, d) = (seen(0), seen(1), seen(2), seen(3));
        let (u, v) = match weights([a, b, c]) {
            // a + u (b - a) + v (c - a), where c - a is the sum of the two edges.
            Some([u, v]) => (u + v, v),
            None => weights([a, c, d]).map(|[u, v]| (u, u + v))?,
        };
        let plane = (middle(self.corners), cross_product(self.corners));
        let t = distance(ray, t_max, plane, self.bounds())?;
        Some(Crossing { t, u, v })
    }

    /// The surface at a crossing.
    pub fn surface(&self, crossing: Crossing) -> Surface {
        self.surface_at(crossing.u, crossing.v)
    }

    /// The surface at `corner + s u + t v`.
    pub fn surface_at(&self, s: f32, t: f32) -> Surface {
        let [a, b, c, d] = self.corners;
        // Bilinear weights: all are non-negative, so nothing cancels.
        let parts = [
            a * ((1.0 - s) * (1.0 - t)),
            b * (s * (1.0 - t)),
            c * (s * t),
            d * ((1.0 - s) * t),
        ];
        Surface {
            p: parts.into_iter().sum(),
            // Seven roundings in the sum, one for the corners that are not quite in the plane.
            error: self.size() * gamma(8),
            n: self.normal,
        }
    }

    /// The box of the corners.
    pub fn bounds(&self) -> Aabb {
        Aabb::of(self.corners)
    }
}

/// Twice the area times the normal, as the product of the diagonals.
fn cross_product(corners: [Vec3; 4]) -> DVec3 {
    let [a, b, c, d] = corners;
    (c.as_dvec3() - a.as_dvec3()).cross(d.as_dvec3() - b.as_dvec3())
}

fn middle(corners: [Vec3; 4]) -> DVec3 {
    let [a, b, c, d] = corners;
    (a.as_dvec3() + b.as_dvec3() + c.as_dvec3() + d.as_dvec3()) * 0.25
}
