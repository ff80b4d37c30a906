//! A sphere that shines on one side.

use super::{Incident, LightSample, pdf_by_area, towards};
use crate::color::Rgb;
use crate::geometry::{Sphere, Surface};
use crate::numeric::one_minus_cos;
use crate::sampling::{frame::Frame, warps};
use glam::{DVec3, Vec3};
use std::f64::consts::PI;

/// A sphere of constant radiance on its front, outside or inside.
#[derive(Clone, Copy, Debug)]
pub struct SphereLight {
    /// Its shape.
    pub sphere: Sphere,
    /// In W/(m² sr), in every direction of the front.
    pub radiance: Rgb,
}

/// The cone in which a sphere is seen.
struct Cone {
    /// From the eye to the sphere's centre.
    to_center: DVec3,
    /// `1 - cos θ_max`, positive.
    one_minus_cos_max: f32,
}

impl SphereLight {
    /// Draws a direction in which the front is seen; `None` behind it, where it is dark.
    ///
    /// A ball is seen in a cone, drawn uniformly in solid angle: density `1 / (2π (1 - cos θ_max))`,
    /// in 1/sr, with `sin θ_max = r / d`. Of a room a point is drawn uniformly in area: density
    /// `d² / (A cos θ_light)`, which from a point of its own wall is `cos θ / π`, the best there is.
    pub fn sample(&self, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        if self.sphere.inward {
            let target = self
                .sphere
                .surface_towards(warps::sample_sphere(u).as_dvec3().normalize());
            let pdf = |wi| self.pdf(from, wi, &target);
            return towards(from, &target, self.radiance, pdf);
        }
        let cone = self.cone(from)?;
        let distance2 = cone.to_center.length_squared();
        let axis = cone.to_center / distance2.sqrt();
        let in_cone = warps::sample_cone(u, cone.one_minus_cos_max);
        let toward = Frame::new(axis.as_vec3()).to_world(in_cone).as_dvec3();
        // The near end of the chord along `toward`; at the rim the chord shrinks to a point.
        let along = cone.to_center.dot(toward);
        let radius = f64::from(self.sphere.radius);
        let chord = (radius * radius - (distance2 - along * along)).max(0.0);
        let from_center = toward * (along - chord.sqrt()) - cone.to_center;
        // So far away that `f64` does not tell the near end from the centre, any end will do.
        let target = self
            .sphere
            .surface_towards(from_center.try_normalize().unwrap_or(-axis));

        let shadow_ray = from.spawn_to(&target);
        Some(LightSample {
            wi: shadow_ray.direction.normalize(),
            incident: Incident::Radiance {
                li: self.radiance,
                pdf: warps::pdf_cone(cone.one_minus_cos_max),
            },
            shadow_ray,
            part: 0,
        })
    }

    /// Density of [`SphereLight::sample`] in 1/sr, in a direction `wi` that meets the sphere's front
    /// in `at`.
    pub fn pdf(&self, from: &Surface, wi: Vec3, at: &Surface) -> f32 {
        if self.sphere.inward {
            return pdf_by_area(self.area(), from, wi, at);
        }
        match self.cone(from) {
            Some(cone) if at.n.dot(wi) < 0.0 => warps::pdf_cone(cone.one_minus_cos_max),
            _ => 0.0,
        }
    }

    /// Area in square scene units.
    pub fn area(&self) -> f64 {
        4.0 * PI * f64::from(self.sphere.radius).powi(2)
    }

    /// The cone in which `from` sees the sphere; `None` inside and on it, and where it is too small for
    /// a density.
    fn cone(&self, from: &Surface) -> Option<Cone> {
        let to_center = self.sphere.center.as_dvec3() - from.p.as_dvec3();
        let radius = f64::from(self.sphere.radius);
        let distance2 = to_center.length_squared();
        let sin2_max = radius * radius / distance2;
        let one_minus_cos_max = one_minus_cos(sin2_max as f32);
        if !(sin2_max < 1.0 && one_minus_cos_max >= f32::MIN_POSITIVE) {
            return None;
        }
        // A point of the sphere itself, rounded outwards, would see the light beneath its feet.
        if distance2.sqrt() - radius <= f64::from(from.error.length()) {
            return None;
        }
        Some(Cone {
            to_center,
            one_minus_cos_max,
        })
    }
}
