//! Light of one colour from everywhere around the scene.

use super::{Incident, LightSample};
use crate::color::Rgb;
use crate::geometry::Surface;
use crate::sampling::frame::Frame;
use crate::sampling::hemisphere;
use glam::Vec3;
use std::f32::consts::FRAC_1_PI;

/// The same radiance from every direction in which nothing else is.
#[derive(Clone, Copy, Debug)]
pub struct SkyLight {
    /// In W/(m² sr).
    pub radiance: Rgb,
}

impl SkyLight {
    /// Draws a direction on the side of the normal, by the cosine to it: so a sky counts on a diffuse
    /// surface. `None` edge-on.
    ///
    /// Density: `cos θ / π`, in 1/sr ([`SkyLight::pdf`]).
    pub fn sample(&self, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        let local = hemisphere::sample_cosine(u);
        let wi = Frame::new(from.n).to_world(local).normalize();
        let pdf = self.pdf(from, wi);
        (pdf > 0.0).then(|| {
            let li = self.radiance;
            LightSample::from_afar(from, wi, Incident::Radiance { li, pdf })
        })
    }

    /// Density of [`SkyLight::sample`] at the unit direction `wi`, in 1/sr; 0 behind the surface.
    pub fn pdf(&self, from: &Surface, wi: Vec3) -> f32 {
        FRAC_1_PI * from.n.dot(wi).max(0.0)
    }
}
