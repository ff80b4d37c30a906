//! A sphere that shines on one side.

use super::{Incident, LightSample, pdf_by_area, towards};
use crate::color::Rgb;
use crate::geometry::{Sphere, Surface};
use crate::numeric::one_minus_cos;
use crate::sampling::warps;
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
    /// Unit, from the eye to the sphere's centre.
    axis: DVec3,
    /// `sin² θ_max`, below 1.
    sin2_max: f64,
    /// `1 - cos θ_max`, positive.
    one_minus_cos_max: f32,
}

impl Cone {
    /// Draws a direction, and the unit normal of the sphere where it first meets it.
    ///
    /// The ray passes the centre at `k = sin θ / sin θ_max` radii, so it meets the sphere at the
    /// angle `α = asin k - θ` from the eye, seen from the centre. No distance is in it, and nothing
    /// cancels: a chord reckoned from `d² - (d cos θ)²` is noise where the sphere is small.
    fn sample(&self, u: [f32; 2]) -> (DVec3, DVec3) {
        let local = warps::sample_cone(u, self.one_minus_cos_max).as_dvec3();
        let sin2 = local.truncate().length_squared();
        let cos = (1.0 - sin2).max(0.0).sqrt();
        let sin_max = self.sin2_max.sqrt();
        let chord = (1.0 - sin2 / self.sin2_max).max(0.0).sqrt();
        let (sin_alpha_over_sin, cos_alpha) = (cos / sin_max - chord, cos * chord + sin2 / sin_max);

        let (tangent, bitangent) = self.axis.any_orthonormal_pair();
        let aside = tangent * local.x + bitangent * local.y;
        let n = aside * sin_alpha_over_sin - self.axis * cos_alpha;
        (aside + self.axis * cos, n.normalize())
    }
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
        let (toward, n) = cone.sample(u);
        let target = self.sphere.surface_towards(n);
        Some(LightSample {
            wi: toward.as_vec3(),
            incident: Incident::Radiance {
                li: self.radiance,
                pdf: warps::pdf_cone(cone.one_minus_cos_max),
            },
            shadow_ray: from.spawn_to(&target),
            part: 0,
            place: [0.0; 2],
            n: target.n,
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
            axis: to_center / distance2.sqrt(),
            sin2_max,
            one_minus_cos_max,
        })
    }
}
