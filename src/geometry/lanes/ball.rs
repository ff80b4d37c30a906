//! A sphere, and sixteen rays at once: `Sphere::intersect` and `Sphere::surface`, bit for bit.

use super::Rays;
use crate::geometry::Sphere;
use crate::geometry::sphere::SPHERE_ERROR;
use crate::numeric::gamma;
use crate::numeric::lanes::{Floats, Mask, Vector, WideVector, Wides, bits, floats};
use fearless_simd::prelude::*;

/// Distances, and the lanes that cross the sphere within their reach.
#[inline(always)]
pub(super) fn intersect<S: Simd>(s: S, sphere: &Sphere, rays: &Rays<S>) -> (Floats<S>, Mask<S>) {
    let d = rays.direction.widen();
    let from_center = rays.origin.widen() - WideVector::splat(s, sphere.center.as_dvec3());
    let radius2 = f64::from(sphere.radius) * f64::from(sphere.radius);
    let zero = Wides::splat(s, 0.0);
    let a = d.dot(d);
    let aside = from_center.cross(d);
    let discriminant = a * radius2 - aside.dot(aside);
    let real = discriminant.ge(zero);
    if bits(real) == 0 {
        return (floats(s, 0.0), real);
    }
    let h = from_center.dot(d);
    let c = from_center.dot(from_center) - radius2;
    let root = discriminant.sqrt();
    let q = Wides::select(zero.gt(h), root - h, -root - h);
    // A double root at the origin is two zeros.
    let double = q.ge(zero) & zero.ge(q);
    let t0 = Wides::select(double, zero, q / a);
    let t1 = Wides::select(double, zero, c / q);
    let ordered = t1.ge(t0);
    let near = Wides::select(ordered, t0, t1);
    let far = Wides::select(ordered, t1, t0);
    let t = Wides::select(near.gt(zero), near, far).narrow();
    (t, real & t.simd_gt(floats(s, 0.0)) & t.simd_le(rays.t_max))
}

/// The points at these distances, the bounds on their errors, and the normals.
#[inline(always)]
pub(super) fn surface<S: Simd>(
    s: S,
    sphere: &Sphere,
    rays: &Rays<S>,
    t: Floats<S>,
) -> [Vector<S>; 3] {
    let (o, d, t) = (rays.origin.widen(), rays.direction.widen(), Wides::from(t));
    let center = WideVector::splat(s, sphere.center.as_dvec3());
    let hit = WideVector {
        x: o.x + d.x * t,
        y: o.y + d.y * t,
        z: o.z + d.z * t,
    };
    let n = (hit - center).normalize(s);
    let radius = f64::from(sphere.radius);
    let p = WideVector {
        x: center.x + n.x * radius,
        y: center.y + n.y * radius,
        z: center.z + n.z * radius,
    };
    let (p, n) = (p.narrow(), n.narrow());
    let least = floats(s, sphere.radius * SPHERE_ERROR);
    let error = p.abs() * gamma(2)
        + Vector {
            x: least,
            y: least,
            z: least,
        };
    [p, error, if sphere.inward { -n } else { n }]
}
