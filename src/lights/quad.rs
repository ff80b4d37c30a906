//! A parallelogram that shines on one side.

use super::{Incident, LightSample, area_to_solid_angle};
use crate::color::Rgb;
use crate::geometry::{Quad, Surface};

/// A parallelogram of constant radiance on the side of its normal.
#[derive(Clone, Copy, Debug)]
pub struct QuadLight {
    /// Its shape.
    pub quad: Quad,
    /// In W/(m² sr), in every direction of the front side.
    pub radiance: Rgb,
}

impl QuadLight {
    /// Draws a point of the light, uniformly in area; `None` where the point shines away.
    ///
    /// Density: `d² / (A cos θ_light)`, in 1/sr.
    pub fn sample(&self, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        let target = self.quad.surface_at(u[0], u[1]);
        let shadow_ray = from.spawn_to(&target);
        let wi = shadow_ray.direction;
        let cos_light = -target.n.dot(wi);
        let distance2 = (target.p - from.p).length_squared();
        let pdf = area_to_solid_angle(1.0 / self.quad.area(), distance2, cos_light);
        // Edge-on and from behind the cosine is not positive; on the light itself pdf is 0.
        (cos_light > 0.0 && pdf > 0.0 && pdf.is_finite()).then_some(LightSample {
            wi,
            incident: Incident::Radiance {
                li: self.radiance,
                pdf,
            },
            shadow_ray,
        })
    }
}
