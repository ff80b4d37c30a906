//! A parallelogram that shines on one side.

use super::{Incident, LightSample, pdf_by_area};
use crate::color::Rgb;
use crate::geometry::{Quad, Surface};
use glam::Vec3;

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
        let pdf = self.pdf(from, wi, &target);
        (pdf > 0.0).then_some(LightSample {
            wi,
            incident: Incident::Radiance {
                li: self.radiance,
                pdf,
            },
            shadow_ray,
        })
    }

    /// Density of [`QuadLight::sample`] in 1/sr, in the direction `wi` that meets the light in `at`.
    pub fn pdf(&self, from: &Surface, wi: Vec3, at: &Surface) -> f32 {
        pdf_by_area(self.quad.area(), from, wi, at)
    }
}
