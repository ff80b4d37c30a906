//! Sixteen rays, each with a quad of its own: `Quad::intersect` and the point of `Quad::surface`, bit for bit.

use super::records::Facts;
use super::{Rays, clip};
use crate::geometry::aabb::EARLIER;
use crate::numeric::lanes::{Floats, Mask, Vector, Wides, floats};
use fearless_simd::prelude::*;

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

/// Where each ray crosses the quad of its lane.
#[inline(always)]
pub(super) fn intersect<S: Simd>(s: S, rays: &Rays<S>, quad: &Facts<S>) -> Crossing<S> {
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
    let (low, high) = (quad.low, quad.high);
    span = clip(s, (low.x, high.x), o.x, inverse.x, span);
    span = clip(s, (low.y, high.y), o.y, inverse.y, span);
    span = clip(s, (low.z, high.z), o.z, inverse.z, span);
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
        let from = quad.corners[i] - o;
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
    let first = Weights::new(s, [bc, ca, ab]);
    let second = Weights::new(s, [cd, da, -ca]);
    let ([p, q], in_first) = (first.or(second), first.inside);
    let u = in_first.select(p + q, p);
    let v = in_first.select(q, p + q);

    let n = quad.plane;
    let t = (n.dot(quad.point - o.widen()) / n.dot(d.widen())).narrow();
    let ahead = t.simd_gt(zero) & t.simd_le(rays.t_max);
    Crossing {
        t: t.simd_lt(entry).select(entry, t),
        u,
        v,
        refused: !(finite & in_box & (first.inside | second.inside) & ahead),
    }
}

/// The points at the coordinates `u`, `v` of quads.
#[inline(always)]
pub(super) fn point<S: Simd>(s: S, quad: &Facts<S>, u: Floats<S>, v: Floats<S>) -> Vector<S> {
    let [a, b, c, d] = quad.corners;
    let [wa, wb, wc, wd] = bilinear(s, u, v);
    a * wa + b * wb + c * wc + d * wd
}

/// The weights of the four corners at the coordinates `u`, `v`.
#[inline(always)]
pub fn bilinear<S: Simd>(s: S, u: Floats<S>, v: Floats<S>) -> [Floats<S>; 4] {
    let one = floats(s, 1.0);
    [(one - u) * (one - v), u * (one - v), u * v, (one - u) * v]
}

/// Barycentric coordinates before they are divided: `triangle::weights`.
#[derive(Clone, Copy)]
struct Weights<S: Simd> {
    v: Wides<S>,
    w: Wides<S>,
    determinant: Wides<S>,
    /// Lanes whose ray passes inside.
    inside: Mask<S>,
}

impl<S: Simd> Weights<S> {
    #[inline(always)]
    fn new(s: S, [u, v, w]: [Wides<S>; 3]) -> Self {
        let determinant = u + v + w;
        let zero = Wides::splat(s, 0.0);
        let front = u.ge(zero) & v.ge(zero) & w.ge(zero) & determinant.gt(zero);
        let back = zero.ge(u) & zero.ge(v) & zero.ge(w) & zero.gt(determinant);
        Weights {
            v,
            w,
            determinant,
            inside: front | back,
        }
    }

    /// Those of this triangle where the ray passes inside, else those of the other.
    #[inline(always)]
    fn or(self, other: Self) -> [Floats<S>; 2] {
        let determinant = Wides::select(self.inside, self.determinant, other.determinant);
        let v = Wides::select(self.inside, self.v, other.v);
        let w = Wides::select(self.inside, self.w, other.w);
        [(v / determinant).narrow(), (w / determinant).narrow()]
    }
}
