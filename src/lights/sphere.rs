//! A sphere that shines outwards.

use super::{Incident, LightSample};
use crate::color::Rgb;
use crate::geometry::{Sphere, Surface};
use crate::numeric::one_minus_cos;
use crate::sampling::{frame::Frame, warps};

/// A sphere of constant radiance on its outside.
#[derive(Clone, Copy, Debug)]
pub struct SphereLight {
    /// Its shape.
    pub sphere: Sphere,
    /// In W/(m² sr), in every outward direction.
    pub radiance: Rgb,
}

impl SphereLight {
    /// Draws a direction of the cone in which the sphere is seen, uniformly in solid angle; `None`
    /// inside, where it is dark, and on it.
    ///
    /// Density: `1 / (2π (1 - cos θ_max))`, in 1/sr, with `sin θ_max = r / d`.
    pub fn sample(&self, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        let to_center = self.sphere.center.as_dvec3() - from.p.as_dvec3();
        let radius = f64::from(self.sphere.radius);
        let distance2 = to_center.length_squared();
        let sin2_max = radius * radius / distance2;
        let one_minus_cos_max = one_minus_cos(sin2_max as f32);
        if !(sin2_max < 1.0 && one_minus_cos_max > 0.0) {
            return None;
        }
        // A point of the sphere itself, rounded outwards, would see the light beneath its feet.
        if distance2.sqrt() - radius <= f64::from(from.error.length()) {
            return None;
        }
        let axis = to_center / distance2.sqrt();
        let in_cone = warps::sample_cone(u, one_minus_cos_max);
        let toward = Frame::new(axis.as_vec3()).to_world(in_cone).as_dvec3();
        // The near end of the chord along `toward`; at the rim the chord shrinks to a point.
        let along = to_center.dot(toward);
        let chord = (radius * radius - (distance2 - along * along)).max(0.0);
        let from_center = toward * (along - chord.sqrt()) - to_center;
        let target = self.sphere.surface_towards(from_center.normalize());

        let shadow_ray = from.spawn_to(&target);
        Some(LightSample {
            wi: shadow_ray.direction,
            incident: Incident::Radiance {
                li: self.radiance,
                pdf: warps::pdf_cone(one_minus_cos_max),
            },
            shadow_ray,
        })
    }
}
