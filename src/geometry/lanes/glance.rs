//! Quads at a glance: in `f32`, with a bound on all roundings.

use super::{LARGEST, Rays};
use crate::geometry::Quad;
use crate::numeric::UNIT_ROUNDOFF;
use crate::numeric::lanes::{Floats, Mask, Vector, Words, floats, words};
use fearless_simd::prelude::*;
use glam::{DVec2, DVec3, Vec3};

/// Parallel quads: what their common normal decides is computed once for all of them.
#[derive(Clone, Debug)]
pub(super) struct Parallel {
    n: [f32; 3],
    /// The two axes onto whose plane the quads are projected: not the one that `n` runs along most.
    axes: [usize; 2],
    /// Bound on the error of `n · p` for points `p` of a quad whose coordinates are at most 1.
    n_bound: f32,
    pub(super) quads: Vec<Glance>,
}

/// What a quad is looked at by: its plane, and two forms that run from -1/2 to 1/2 on it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Glance {
    /// The number of the shape, and its place among the few.
    pub(super) id: u32,
    pub(super) slot: u32,
    /// The plane is where `n · p` is this.
    height: f32,
    /// The first form, `across · p + across_0`, of the two projected coordinates of a point.
    across: [f32; 2],
    across_0: f32,
    along: [f32; 2],
    along_0: f32,
    /// The larger of the sums of either form's factors without signs, times [`ROUNDINGS`].
    bound: f32,
}

/// How sixteen rays run to the planes of parallel quads.
#[derive(Clone, Copy)]
pub(super) struct Incidence<S: Simd> {
    /// One over the cosine, with its sign and without.
    inverse: Floats<S>,
    inverse_size: Floats<S>,
    /// The height of the origins.
    origin: Floats<S>,
    /// The projected rays.
    o: [Floats<S>; 2],
    d: [Floats<S>; 2],
    /// Lanes that see nothing of the quads but an edge, if so much.
    pub(super) edge_on: Mask<S>,
}

/// How far each ray can get and how fast: the largest coordinate of its origin or of a corner, and the largest of its
/// direction.
#[derive(Clone, Copy)]
pub(super) struct Scale<S: Simd> {
    pub(super) reach: Floats<S>,
    pub(super) speed: Floats<S>,
}

/// Where sixteen rays cross the plane of a quad.
#[derive(Clone, Copy)]
pub(super) struct AtPlane<S: Simd> {
    t: Floats<S>,
    /// Between which distances, all roundings taken into account.
    pub(super) near: Floats<S>,
    pub(super) far: Floats<S>,
    /// Bound on the error of a coordinate of the point, over [`ROUNDINGS`].
    off: Floats<S>,
    /// Lanes that cross it ahead of them, if at all.
    pub(super) ahead: Mask<S>,
}

/// Twice as many roundings as any form has: three products, their sum and the constant, whose terms are rounded
/// themselves, of a corner that is rounded, too; and the distance's own.
const ROUNDINGS: f32 = 16.0 * UNIT_ROUNDOFF;
/// Normals that differ by less are parallel.
const PARALLEL: f64 = 1e-6;
/// Smaller cosines count as this, so that nothing overflows; they are far below the bound on their error.
const LEAST_COSINE: f32 = 1e-12;

impl Parallel {
    /// Adds a quad to those that are parallel to it; `false` where an edge is too short for its reciprocal.
    pub(super) fn add(all: &mut Vec<Parallel>, id: u32, slot: u32, quad: &Quad) -> bool {
        let n = quad.plane().normal.normalize();
        let is_parallel = |other: &Parallel| {
            let own = Vec3::from(other.n).as_dvec3();
            (own * own.dot(n).signum() - n).abs().max_element() < PARALLEL
        };
        let place = all.iter().position(is_parallel).unwrap_or(all.len());
        if place == all.len() {
            all.push(Parallel::new(n));
        }
        all[place].push(id, slot, quad)
    }

    fn new(n: DVec3) -> Parallel {
        let n = n.as_vec3();
        let most = n.abs().max_position();
        Parallel {
            n: n.into(),
            axes: [(most + 1) % 3, (most + 2) % 3],
            n_bound: n.abs().element_sum() * ROUNDINGS,
            quads: Vec::new(),
        }
    }

    fn push(&mut self, id: u32, slot: u32, quad: &Quad) -> bool {
        let n = Vec3::from(self.n).as_dvec3();
        let corners = quad.corners().map(Vec3::as_dvec3);
        let height = n.dot(quad.plane().point);
        // What the common normal is off by.
        let (mut off, mut size) = (0.0_f64, f64::MIN_POSITIVE);
        for corner in corners {
            off = off.max((n.dot(corner) - height).abs());
            size = size.max(corner.abs().max_element());
        }
        let bound = n.abs().element_sum() * f64::from(ROUNDINGS) + off / size;
        self.n_bound = self.n_bound.max(bound as f32);

        let [i, j] = self.axes;
        let [a, b, _, d] = corners.map(|corner| DVec2::new(corner[i], corner[j]));
        let (u, v) = (b - a, d - a);
        // The dual basis: 1 along one edge, 0 along the other.
        let (across, along) = (v.perp() / v.perp_dot(u), u.perp() / u.perp_dot(v));
        let sum = |w: DVec2| w.abs().element_sum() as f32;
        self.quads.push(Glance {
            id,
            slot,
            height: height as f32,
            across: across.as_vec2().into(),
            across_0: (-across.dot(a) - 0.5) as f32,
            along: along.as_vec2().into(),
            along_0: (-along.dot(a) - 0.5) as f32,
            bound: sum(across).max(sum(along)) * ROUNDINGS,
        });
        let largest = across.abs().max_element().max(along.abs().max_element());
        largest < f64::from(LARGEST) && n.is_finite()
    }

    /// Takes all roundings for nothing.
    #[cfg(test)]
    pub(super) fn be_rash(&mut self) {
        self.n_bound = 0.0;
        self.quads.iter_mut().for_each(|quad| quad.bound = 0.0);
    }

    /// How the rays run to the planes of all of these quads.
    #[inline(always)]
    pub(super) fn incidence<S: Simd>(&self, s: S, rays: &Rays<S>, scale: Scale<S>) -> Incidence<S> {
        let (o, d) = (rays.origin, rays.direction);
        let cos = form(self.n, d);
        let inverse_size = floats(s, 1.0) / cos.abs().max(floats(s, LEAST_COSINE));
        let [i, j] = self.axes;
        Incidence {
            inverse: inverse_size.copysign(cos),
            inverse_size,
            origin: form(self.n, o),
            o: [o.coordinate(i), o.coordinate(j)],
            d: [d.coordinate(i), d.coordinate(j)],
            edge_on: cos.abs().simd_le(scale.speed * self.n_bound),
        }
    }

    // ANCHOR: look
    /// Where the rays cross the plane of a quad.
    ///
    /// With `R = reach + |t| speed`, the largest coordinate on the way, each form `w · p` is off by at most
    /// [`ROUNDINGS`] `|w|₁ R`, and the distance by that of the plane over the cosine; in the direction of the ray that
    /// moves the point, too. Of a ray along the plane the distance is so uncertain that it may be behind the origin.
    #[inline(always)]
    pub(super) fn meet<S: Simd>(
        &self,
        s: S,
        quad: &Glance,
        at: &Incidence<S>,
        from: Words<S>,
        scale: Scale<S>,
    ) -> AtPlane<S> {
        let t = (floats(s, quad.height) - at.origin) * at.inverse;
        let reach = scale.reach + t.abs() * scale.speed;
        let slack = reach * (at.inverse_size * self.n_bound);
        let far = t + slack;
        // Who leaves a flat shape on one side has it behind: its origin is certainly off on that side.
        let behind = from.simd_eq(words(s, quad.id));
        AtPlane {
            t,
            near: t - slack,
            far,
            // The point's share of the error beside the plane's: 1.1 for errors of errors.
            off: reach + slack * (scale.speed * (1.1 / ROUNDINGS)),
            ahead: far.simd_gt(floats(s, 0.0)) & !behind,
        }
    }
}

impl Glance {
    /// The rays that may cross the quad where they cross its plane, and those that certainly do.
    #[inline(always)]
    pub(super) fn look<S: Simd>(
        &self,
        s: S,
        at: &Incidence<S>,
        plane: &AtPlane<S>,
    ) -> (Mask<S>, Mask<S>) {
        let p = at.o[0] + at.d[0] * plane.t;
        let q = at.o[1] + at.d[1] * plane.t;
        let x = p * self.across[0] + q * self.across[1] + self.across_0;
        let y = p * self.along[0] + q * self.along[1] + self.along_0;
        let (outer, off) = (x.abs().max(y.abs()), plane.off * self.bound);
        let half = floats(s, 0.5);
        let may = outer.simd_le(half + off) & plane.ahead;
        let does = outer.simd_lt(half - off) & plane.ahead & plane.near.simd_gt(floats(s, 0.0));
        (may, does)
    }
} // ANCHOR_END: look

#[inline(always)]
fn form<S: Simd>(w: [f32; 3], v: Vector<S>) -> Floats<S> {
    v.x * w[0] + v.y * w[1] + v.z * w[2]
}
