//! Balls around things, and how they are seen.

use crate::geometry::{Aabb, Shape};
use crate::numeric::one_minus_cos;
use glam::{DVec3, Vec3};
use std::f64::consts::PI;

/// The sine of the smallest angle under which the radius of a ball is seen that is worth aiming at. The
/// roundings of a direction in `f32` are a ten thousandth of it. Of smaller balls they would be more,
/// so that a direction drawn inside one could count as outside.
const SMALLEST: f64 = 1e-3;

/// A ball around something.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ball {
    pub(super) center: DVec3,
    pub(super) radius: f64,
}

/// A ball as it is seen from a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight {
    /// Unit, towards its centre.
    pub(super) axis: Vec3,
    /// The square of the sine of the angle under which its radius is seen, below 1.
    pub(super) size2: f32,
    /// 1 - cos of that angle, positive.
    pub(super) one_minus_cos: f32,
}

impl Ball {
    /// A ball around some shapes; `None` around none, or where it is not finite.
    pub(super) fn around(shapes: &[Shape]) -> Option<Ball> {
        if let [Shape::Sphere(sphere)] = shapes {
            return Some(Ball {
                center: sphere.center.as_dvec3(),
                radius: f64::from(sphere.radius),
            });
        }
        let bounds = shapes
            .iter()
            .fold(Aabb::EMPTY, |all, shape| all.union(shape.bounds()));
        bounds.is_finite().then(|| {
            let (low, high) = (bounds.min.as_dvec3(), bounds.max.as_dvec3());
            Ball {
                center: (low + high) * 0.5,
                radius: (high - low).length() * 0.5,
            }
        })
    }

    /// The solid angle in which it is seen from far away, in sr; from nearby more.
    pub(super) fn solid_angle(&self, p: Vec3) -> f32 {
        let distance2 = (self.center - p.as_dvec3()).length_squared();
        (PI * self.radius * self.radius / distance2) as f32
    }

    /// How it is seen from `p`; `None` where that is within it, or it is too small to be aimed at.
    pub(super) fn seen_from(&self, p: Vec3) -> Option<Sight> {
        let way = self.center - p.as_dvec3();
        let distance2 = way.length_squared();
        let sin2 = self.radius * self.radius / distance2;
        (SMALLEST * SMALLEST..1.0).contains(&sin2).then(|| Sight {
            axis: (way / distance2.sqrt()).as_vec3(),
            size2: sin2 as f32,
            one_minus_cos: one_minus_cos(sin2 as f32),
        })
    }
}
