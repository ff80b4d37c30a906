//! A sphere.

use super::{Aabb, Intersection, PreparedRay, Ray, Surface};
use crate::numeric::{gamma, quadratic};
use glam::Vec3;

/// Bound on how far off a sphere `f64` puts a point or sees a ray's origin, relative to its radius:
/// eight roundings.
pub(super) const SPHERE_ERROR: f32 = 4.0 * f64::EPSILON as f32;

/// A sphere; its front is outside, or inside.
#[derive(Clone, Copy, Debug)]
pub struct Sphere {
    /// Its centre.
    pub center: Vec3,
    /// Its radius, positive.
    pub radius: f32,
    /// True where its normal points to the centre: a room, not a ball.
    pub inward: bool,
}

impl Sphere {
    /// A ball: its front is outside.
    pub fn new(center: Vec3, radius: f32) -> Self {
        Sphere {
            center,
            radius,
            inward: false,
        }
    }

    // ANCHOR: intersect
    /// The first crossing with `0 < t <= t_max`.
    ///
    /// Numbers go in and out as `f32`, the quadratic runs in `f64`: ten thousand radii away the
    /// `f32` form loses hits and hits with rays that miss, as chapter 17 counts. The discriminant
    /// comes from the distance between centre and line, by `(f·d)² - f²d² = -|f × d|²`, for a hundred
    /// million radii away the plain difference fails in `f64` too.
    #[inline(never)]
    pub fn intersect(&self, ray: &PreparedRay, t_max: f32) -> Option<Intersection> {
        let d = ray.direction.as_dvec3();
        let from_center = ray.origin.as_dvec3() - self.center.as_dvec3();
        let radius2 = f64::from(self.radius) * f64::from(self.radius);
        let a = d.length_squared();
        let roots = quadratic(
            a * radius2 - from_center.cross(d).length_squared(),
            a,
            from_center.dot(d),
            from_center.length_squared() - radius2,
        )?;
        let t = roots.ahead() as f32;
        (t > 0.0 && t <= t_max).then_some(Intersection::new(t, 0.0, 0.0))
    }
    // ANCHOR_END: intersect

    /// How far a point is from the sphere, positive on its front.
    pub(super) fn height(&self, p: glam::DVec3) -> f64 {
        let outside = (p - self.center.as_dvec3()).length() - f64::from(self.radius);
        if self.inward { -outside } else { outside }
    }

    /// The surface where `ray` crosses.
    pub fn surface(&self, ray: &Ray, intersection: Intersection) -> Surface {
        let hit = ray.origin.as_dvec3() + ray.direction.as_dvec3() * f64::from(intersection.t);
        self.surface_towards((hit - self.center.as_dvec3()).normalize())
    }

    /// The surface in the unit direction `n` from the centre.
    pub fn surface_towards(&self, n: glam::DVec3) -> Surface {
        let p = (self.center.as_dvec3() + n * f64::from(self.radius)).as_vec3();
        Surface {
            p,
            // One rounding to f32, one to spare, and those of the sum in f64, which matter only
            // where a huge sphere passes close to the world's origin.
            error: p.abs() * gamma(2) + self.radius * SPHERE_ERROR,
            n: if self.inward {
                -n.as_vec3()
            } else {
                n.as_vec3()
            },
            time: 0.0,
        }
    }

    /// The box of the sphere, rounded outwards.
    pub fn bounds(&self) -> Aabb {
        let out = |f: fn(f32) -> f32, v: Vec3| Vec3::new(f(v.x), f(v.y), f(v.z));
        Aabb {
            min: out(f32::next_down, self.center - self.radius),
            max: out(f32::next_up, self.center + self.radius),
        }
    }
}
