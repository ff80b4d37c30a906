//! A quad at a glance: in `f32`, with a bound on all roundings.

use super::{LARGEST, Rays};
use crate::geometry::Quad;
use crate::numeric::UNIT_ROUNDOFF;
use crate::numeric::lanes::{Floats, Mask, Vector, floats, words};
use fearless_simd::prelude::*;
use glam::{DVec3, Vec3};

/// What a quad is looked at by: its plane, and two forms that run from -1/2 to 1/2 on it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Glance {
    /// The number of the shape, and its place among the few.
    pub(super) id: u32,
    pub(super) slot: u32,
    n: [f32; 3],
    /// The plane is where `n · p` is this.
    height: f32,
    across: [f32; 3],
    across_0: f32,
    along: [f32; 3],
    along_0: f32,
    /// The sums of the coordinates of each form without signs, times [`ROUNDINGS`].
    n_bound: f32,
    across_bound: f32,
    along_bound: f32,
}

/// A quad as sixteen rays see it.
#[derive(Clone, Copy)]
pub(super) struct Seen<S: Simd> {
    /// The distance.
    pub(super) t: Floats<S>,
    /// Bound on its error.
    pub(super) slack: Floats<S>,
    /// Lanes that may cross it ahead of them, and those that certainly do.
    pub(super) may: Mask<S>,
    pub(super) does: Mask<S>,
    /// Lanes that see nothing of it but an edge, if so much.
    pub(super) edge_on: Mask<S>,
}

/// Twice as many roundings as any form has: three products, their sum and the constant, whose terms are rounded
/// themselves, of a corner that is rounded, too; and the distance's own.
const ROUNDINGS: f32 = 16.0 * UNIT_ROUNDOFF;

impl Glance {
    /// `None` where an edge is too short for its reciprocal.
    pub(super) fn new(id: u32, slot: u32, quad: &Quad) -> Option<Glance> {
        let plane = quad.plane();
        let n = plane.normal.normalize();
        let [a, b, _, d] = quad.corners().map(Vec3::as_dvec3);
        let (u, v) = (b - a, d - a);
        // The dual basis: 1 along one edge, 0 along the other.
        let form = |along: DVec3, other: DVec3| {
            let across = other.cross(n);
            across / along.dot(across)
        };
        let (across, along) = (form(u, v), form(v, u));
        let bound = |w: DVec3| (w.abs().element_sum() as f32) * ROUNDINGS;
        let glance = Glance {
            id,
            slot,
            n: n.as_vec3().into(),
            height: n.dot(plane.point) as f32,
            across: across.as_vec3().into(),
            across_0: (-across.dot(a) - 0.5) as f32,
            along: along.as_vec3().into(),
            along_0: (-along.dot(a) - 0.5) as f32,
            n_bound: bound(n),
            across_bound: bound(across),
            along_bound: bound(along),
        };
        let small = across.abs().max_element().max(along.abs().max_element()) < f64::from(LARGEST);
        (small && n.is_finite()).then_some(glance)
    }

    /// Takes all roundings for nothing.
    #[cfg(test)]
    pub(super) fn be_rash(&mut self) {
        (self.n_bound, self.across_bound, self.along_bound) = (0.0, 0.0, 0.0);
    }

    // ANCHOR: look
    /// Where the rays cross it.
    ///
    /// * `reach`: the largest coordinate of an origin or a corner; `speed`: the largest of a direction.
    ///
    /// With `R = reach + |t| speed`, the largest coordinate on the way, each form `w · p` is off by at most
    /// [`ROUNDINGS`] `|w|₁ R`, and the distance by that of the plane over `|n · d|`; in the direction of the ray that
    /// moves the point, too.
    #[inline(always)]
    pub(super) fn look<S: Simd>(
        &self,
        s: S,
        rays: &Rays<S>,
        reach: Floats<S>,
        speed: Floats<S>,
    ) -> Seen<S> {
        let cos = form(self.n, rays.direction);
        let inverse = floats(s, 1.0) / cos;
        let t = (floats(s, self.height) - form(self.n, rays.origin)) * inverse;
        let reach = reach + t.abs() * speed;
        let slack = reach * (inverse.abs() * self.n_bound);
        // The point's share of the error beside the plane's: 1.1 for errors of errors.
        let off = reach + slack * speed * (1.1 / ROUNDINGS);
        let p = rays.origin + rays.direction * t;
        let x = (form(self.across, p) + self.across_0).abs();
        let y = (form(self.along, p) + self.along_0).abs();
        let (x_off, y_off) = (off * self.across_bound, off * self.along_bound);
        let half = floats(s, 0.5);
        let zero = floats(s, 0.0);
        let edge_on = cos.abs().simd_le(speed * self.n_bound);
        // Who leaves a flat shape on one side has it behind: its origin is certainly off on that side.
        let behind = rays.from.simd_eq(words(s, self.id));
        let may =
            x.simd_le(half + x_off) & y.simd_le(half + y_off) & (t + slack).simd_gt(zero) & !behind;
        let does =
            x.simd_lt(half - x_off) & y.simd_lt(half - y_off) & (t - slack).simd_gt(zero) & !behind;
        Seen {
            t: edge_on.select(zero, t),
            slack: edge_on.select(floats(s, f32::MAX), slack),
            may: may | edge_on,
            does: does & !edge_on,
            edge_on,
        }
    } // ANCHOR_END: look
}

#[inline(always)]
fn form<S: Simd>(w: [f32; 3], v: Vector<S>) -> Floats<S> {
    v.x * w[0] + v.y * w[1] + v.z * w[2]
}
