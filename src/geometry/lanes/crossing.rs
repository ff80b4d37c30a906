//! Sixteen rays, each with a quad of its own: `Quad::intersect` and `Quad::surface`, bit for bit.

use super::{Column, MOST_SHAPES, Rays, clip, gather, gather_vector};
use crate::geometry::Quad;
use crate::geometry::aabb::EARLIER;
use crate::numeric::lanes::{Floats, LANES, Mask, Vector, WideVector, Wides, WordRow, floats};
use fearless_simd::prelude::*;

/// A number of each shape in `f64`.
type WideColumn = [f64; MOST_SHAPES];

/// What quads are intersected by, column by column.
#[derive(Clone, Debug)]
pub(super) struct Crossings {
    /// For each coordinate that of the four corners.
    corners: [[Column; 4]; 3],
    normal: [Column; 3],
    error: [Column; 3],
    /// The box of the corners.
    low: [Column; 3],
    high: [Column; 3],
    /// A point of the plane, and its normal.
    point: [WideColumn; 3],
    plane: [WideColumn; 3],
}

impl Default for Crossings {
    fn default() -> Self {
        let columns = [[0.0; MOST_SHAPES]; 3];
        Crossings {
            corners: [[[0.0; MOST_SHAPES]; 4]; 3],
            normal: columns,
            error: columns,
            low: columns,
            high: columns,
            point: [[0.0; MOST_SHAPES]; 3],
            plane: [[0.0; MOST_SHAPES]; 3],
        }
    }
}

/// Where rays cross quads.
#[derive(Clone, Copy)]
pub(super) struct Crossing<S: Simd> {
    pub(super) t: Floats<S>,
    pub(super) u: Floats<S>,
    pub(super) v: Floats<S>,
    /// Lanes that do not cross theirs, or whose direction has a coordinate without a reciprocal.
    pub(super) refused: Mask<S>,
}

/// Which axis each ray runs along most, and whether backwards: `PreparedRay::axes`.
#[derive(Clone, Copy)]
struct Axes<S: Simd> {
    x: Mask<S>,
    y: Mask<S>,
    backwards: Mask<S>,
}

impl<S: Simd> Axes<S> {
    #[inline(always)]
    fn new(s: S, d: Vector<S>) -> Self {
        let size = d.abs();
        let axes = Axes {
            x: size.x.simd_gt(size.y) & size.x.simd_gt(size.z),
            y: size.y.simd_gt(size.z),
            backwards: d.z.simd_lt(d.z),
        };
        let backwards = axes.along(d).simd_lt(floats(s, 0.0));
        Axes { backwards, ..axes }
    }

    /// The coordinate along that axis.
    #[inline(always)]
    fn along(self, v: Vector<S>) -> Floats<S> {
        self.x.select(v.x, self.y.select(v.y, v.z))
    }

    /// The two others.
    #[inline(always)]
    fn across(self, v: Vector<S>) -> [Floats<S>; 2] {
        let first = self.x.select(v.y, self.y.select(v.z, v.x));
        let second = self.x.select(v.z, self.y.select(v.x, v.y));
        [
            self.backwards.select(second, first),
            self.backwards.select(first, second),
        ]
    }
}

impl Crossings {
    /// Stores a quad.
    pub(super) fn set(&mut self, at: usize, quad: &Quad) {
        let (plane, bounds) = (quad.plane(), quad.bounds());
        for axis in 0..3 {
            for (column, corner) in self.corners[axis].iter_mut().zip(quad.corners()) {
                column[at] = corner[axis];
            }
            self.normal[axis][at] = quad.normal()[axis];
            self.error[axis][at] = quad.error[axis];
            self.low[axis][at] = bounds.min[axis];
            self.high[axis][at] = bounds.max[axis];
            self.point[axis][at] = plane.point[axis];
            self.plane[axis][at] = plane.normal[axis];
        }
    }

    /// Where each ray crosses the quad of its lane.
    #[inline(always)]
    pub(super) fn intersect<S: Simd>(&self, s: S, rays: &Rays<S>, slot: &WordRow) -> Crossing<S> {
        let (o, d) = (rays.origin, rays.direction);
        let (zero, one) = (floats(s, 0.0), floats(s, 1.0));
        let inverse = Vector {
            x: one / d.x,
            y: one / d.y,
            z: one / d.z,
        };
        let finite = inverse
            .abs()
            .max_element()
            .simd_lt(floats(s, f32::INFINITY));

        let mut span = (zero, rays.t_max);
        span = clip(s, self.faces(s, slot, 0), o.x, inverse.x, span);
        span = clip(s, self.faces(s, slot, 1), o.y, inverse.y, span);
        span = clip(s, self.faces(s, slot, 2), o.z, inverse.z, span);
        let entry = span.0 * EARLIER;
        let in_box = entry.simd_le(span.1);

        // The corners as the ray sees them, and on which side of it the edges pass.
        let axes = Axes::new(s, d);
        let [dx, dy] = axes.across(d);
        let dz = axes.along(d);
        let shear = [dx / dz, dy / dz];
        let mut xs = [Wides::splat(s, 0.0); 4];
        let mut ys = xs;
        for i in 0..4 {
            let [x, y, z] = &self.corners;
            let corner = Vector {
                x: gather(s, &x[i], slot),
                y: gather(s, &y[i], slot),
                z: gather(s, &z[i], slot),
            };
            let from = corner - o;
            let height = axes.along(from);
            let [x, y] = axes.across(from);
            xs[i] = Wides::from(x - shear[0] * height);
            ys[i] = Wides::from(y - shear[1] * height);
        }
        let ab = xs[1] * ys[0] - ys[1] * xs[0];
        let bc = xs[2] * ys[1] - ys[2] * xs[1];
        let cd = xs[3] * ys[2] - ys[3] * xs[2];
        let da = xs[0] * ys[3] - ys[0] * xs[3];
        let ca = xs[0] * ys[2] - ys[0] * xs[2];
        let (first, in_first) = weights(s, [bc, ca, ab]);
        let (second, in_second) = weights(s, [cd, da, -ca]);
        let u = in_first.select(first[0] + first[1], second[0]);
        let v = in_first.select(first[1], second[0] + second[1]);

        let point = gather_wide(s, &self.point, slot);
        let n = gather_wide(s, &self.plane, slot);
        let t = (n.dot(point - o.widen()) / n.dot(d.widen())).narrow();
        let ahead = t.simd_gt(zero) & t.simd_le(rays.t_max);
        Crossing {
            t: t.simd_lt(entry).select(entry, t),
            u,
            v,
            refused: !(finite & in_box & (in_first | in_second) & ahead),
        }
    }

    /// The lower and the upper face of each lane's box along an axis.
    #[inline(always)]
    fn faces<S: Simd>(&self, s: S, slot: &WordRow, axis: usize) -> (Floats<S>, Floats<S>) {
        (
            gather(s, &self.low[axis], slot),
            gather(s, &self.high[axis], slot),
        )
    }

    /// The points at the coordinates `u`, `v` of quads, the bounds on their errors, and the normals.
    #[inline(always)]
    pub(super) fn surface<S: Simd>(
        &self,
        s: S,
        slot: &WordRow,
        u: Floats<S>,
        v: Floats<S>,
    ) -> (Vector<S>, Vector<S>, Vector<S>) {
        let weights = bilinear(s, u, v);
        let [x, y, z] = &self.corners;
        let p = Vector {
            x: weighted(s, x, slot, weights),
            y: weighted(s, y, slot, weights),
            z: weighted(s, z, slot, weights),
        };
        (
            p,
            gather_vector(s, &self.error, slot),
            gather_vector(s, &self.normal, slot),
        )
    }
}

/// The weights of the four corners at the coordinates `u`, `v`.
#[inline(always)]
pub fn bilinear<S: Simd>(s: S, u: Floats<S>, v: Floats<S>) -> [Floats<S>; 4] {
    let one = floats(s, 1.0);
    [(one - u) * (one - v), u * (one - v), u * v, (one - u) * v]
}

#[inline(always)]
fn weighted<S: Simd>(s: S, corners: &[Column; 4], slot: &WordRow, w: [Floats<S>; 4]) -> Floats<S> {
    let [a, b, c, d] = corners;
    gather(s, a, slot) * w[0]
        + gather(s, b, slot) * w[1]
        + gather(s, c, slot) * w[2]
        + gather(s, d, slot) * w[3]
}

/// `triangle::weights`, and the lanes that have some.
#[inline(always)]
fn weights<S: Simd>(s: S, [u, v, w]: [Wides<S>; 3]) -> ([Floats<S>; 2], Mask<S>) {
    let determinant = u + v + w;
    let zero = Wides::splat(s, 0.0);
    let front = u.ge(zero) & v.ge(zero) & w.ge(zero) & determinant.gt(zero);
    let back = zero.ge(u) & zero.ge(v) & zero.ge(w) & zero.gt(determinant);
    (
        [(v / determinant).narrow(), (w / determinant).narrow()],
        front | back,
    )
}

#[inline(always)]
fn gather_wide<S: Simd>(s: S, columns: &[WideColumn; 3], slot: &WordRow) -> WideVector<S> {
    let [x, y, z] = columns;
    WideVector {
        x: gather_f64(s, x, slot),
        y: gather_f64(s, y, slot),
        z: gather_f64(s, z, slot),
    }
}

#[inline(always)]
fn gather_f64<S: Simd>(s: S, column: &WideColumn, slot: &WordRow) -> Wides<S> {
    let mut row = [0.0; LANES];
    for (x, slot) in row.iter_mut().zip(&slot.0) {
        *x = column[*slot as usize % MOST_SHAPES];
    }
    Wides::load(s, &row)
}
