//! Eight triangles side by side, of which a glance leaves one or two to be tested.

use super::node::{Eight, WIDTH};
use crate::geometry::{PreparedRay, Triangle};
use fearless_simd::prelude::*;
use fearless_simd::{f32x8, mask32x8};
use glam::Vec3;

/// Up to eight triangles.
#[derive(Clone, Debug)]
pub(super) struct Packet {
    /// The three corners, for each the three coordinates, for each the triangles.
    corners: [[Eight; 3]; 3],
    /// Each triangle's index in the list that the tree was built from.
    pub(super) ids: [u32; WIDTH],
    /// A bit for each triangle.
    present: u32,
}

impl Packet {
    /// The packet of at most eight triangles with their indices.
    pub(super) fn new(triangles: &[(u32, Triangle)]) -> Self {
        // Lanes without a triangle have corners, which nobody looks at.
        let none = (0, [Vec3::ZERO; 3]);
        let lane = |i: usize| {
            triangles
                .get(i)
                .map_or(none, |(id, t)| (*id, [t.a, t.b, t.c]))
        };
        let all: [(u32, [Vec3; 3]); WIDTH] = std::array::from_fn(lane);
        let lanes = |corner: usize, axis: usize| Eight(all.map(|(_, t)| t[corner][axis]));
        Packet {
            corners: [0, 1, 2].map(|corner| [0, 1, 2].map(|axis| lanes(corner, axis))),
            ids: all.map(|(id, _)| id),
            present: (1 << triangles.len()) - 1,
        }
    }

    /// The triangles with their indices.
    pub(super) fn triangles(&self) -> impl Iterator<Item = (u32, Triangle)> {
        let count = self.present.count_ones() as usize;
        (0..count).map(|lane| (self.ids[lane], self.triangle(lane)))
    }

    /// One of the triangles.
    #[inline(always)]
    pub(super) fn triangle(&self, lane: usize) -> Triangle {
        let [a, b, c] = &self.corners;
        Triangle {
            a: corner(a, lane),
            b: corner(b, lane),
            c: corner(c, lane),
        }
    }

    /// A mask of the triangles that the ray may cross; certainly not the others.
    ///
    /// The edge functions of [`Triangle::cross`], from the same corners, but with products rounded
    /// to `f32`: of two numbers the larger is never rounded to less than the smaller, so where the
    /// rounded products differ, the exact ones differ in the same sense. A triangle is out where
    /// one edge has the ray on its left and another on its right; NaN is on neither side.
    #[inline(always)]
    pub(super) fn candidates<S: Simd>(&self, s: S, ray: &PreparedRay) -> u32 {
        let [x, y, z] = ray.axes;
        let (ox, oy, oz) = (ray.origin[x], ray.origin[y], ray.origin[z]);
        let zero = f32x8::splat(s, 0.0);
        let mut corners = [(zero, zero); 3];
        for (sheared, corner) in corners.iter_mut().zip(&self.corners) {
            let height = corner[z].get(s) - oz;
            *sheared = (
                corner[x].get(s) - ox - height * ray.shear[0],
                corner[y].get(s) - oy - height * ray.shear[1],
            );
        }
        let [a, b, c] = corners;
        let mut positive = mask32x8::splat(s, false);
        let mut negative = positive;
        for (p, q) in [(b, c), (c, a), (a, b)] {
            let (left, right) = (q.0 * p.1, q.1 * p.0);
            positive |= left.simd_gt(right);
            negative |= left.simd_lt(right);
        }
        self.present & !(positive & negative).to_bitmask() as u32
    }
}

#[inline(always)]
fn corner([x, y, z]: &[Eight; 3], lane: usize) -> Vec3 {
    Vec3::new(x.0[lane], y.0[lane], z.0[lane])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Ray;
    use crate::sampling::stream::{Purpose, Stream};
    use fearless_simd::{Level, dispatch};

    #[test]
    fn no_triangle_that_is_crossed_is_passed_over() {
        let (mut crossed, mut candidates, mut lost_by_strict) = (0, 0, 0);
        for i in 0..40_000 {
            let mut numbers = Stream::new(2, i, 0).at(0, Purpose::Direction);
            let size = libm::exp2(f64::from(numbers.one() * 80.0 - 40.0)) as f32;
            let mut point = || Vec3::from([(); 3].map(|()| (numbers.one() - 0.5) * size));
            let triangles = [(); 5].map(|()| {
                let (a, b, c) = (point(), point(), point());
                Triangle { a, b, c }
            });
            let numbered: Vec<(u32, Triangle)> = (7..).zip(triangles).collect();
            let packet = Packet::new(&numbered);
            // Exactly at a corner, into an edge, or anywhere.
            let t = triangles[i as usize % 5];
            let target = match i % 3 {
                0 => t.a,
                1 => t.a * 0.5 + t.b * 0.5,
                _ => point(),
            };
            let origin = point() * 3.0;
            let ray = Ray::new(origin, target - origin);
            if !ray.is_valid() {
                continue;
            }
            let ray = PreparedRay::from(&ray);
            let found = dispatch!(Level::new(), s => packet.candidates(s, &ray));
            candidates += found.count_ones();
            assert_eq!(found >> 5, 0, "lanes without a triangle");
            for (lane, t) in triangles.iter().enumerate() {
                assert_eq!(
                    (packet.ids[lane], packet.triangle(lane).a),
                    (7 + lane as u32, t.a)
                );
                if t.intersect(&ray, f32::MAX).is_some() {
                    crossed += 1;
                    assert!(found >> lane & 1 == 1, "{t:?} {ray:?}");
                    lost_by_strict += u32::from(is_out_where_an_edge_is_zero(t, &ray));
                }
            }
        }
        println!(
            "{crossed} crossings, {candidates} candidates, {lost_by_strict} lost without edges"
        );
        assert!(
            crossed > 20_000 && candidates < 2 * crossed && lost_by_strict > 100,
            "{candidates}"
        );
    }

    /// The same edge functions, where a ray on an edge counts as outside.
    fn is_out_where_an_edge_is_zero(t: &Triangle, ray: &PreparedRay) -> bool {
        let [x, y, z] = ray.axes;
        let [a, b, c] = [t.a, t.b, t.c].map(|v| {
            let v = (v - ray.origin).to_array();
            [v[x] - ray.shear[0] * v[z], v[y] - ray.shear[1] * v[z]]
        });
        let edges = [(b, c), (c, a), (a, b)].map(|(p, q)| q[0] * p[1] - q[1] * p[0]);
        edges.iter().any(|e| *e >= 0.0) && edges.iter().any(|e| *e <= 0.0)
    }
}
