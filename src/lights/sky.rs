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
    /// Draws a direction, on either side of the surface as often: on each by the cosine to its
    /// normal, which is how a sky counts on a diffuse surface. `None` edge-on.
    ///
    /// Density: `|cos θ| / 2π`, in 1/sr ([`SkyLight::pdf`]).
    pub fn sample(&self, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        let below = u[0] < 0.5;
        let twice = 2.0 * u[0] - f32::from(u8::from(!below));
        let local = hemisphere::sample_cosine([twice, u[1]]);
        let n = if below { -from.n } else { from.n };
        let wi = Frame::new(n).to_world(local).normalize();
        let pdf = self.pdf(from, wi);
        (pdf > 0.0).then(|| LightSample {
            wi,
            incident: Incident::Radiance {
                li: self.radiance,
                pdf,
            },
            shadow_ray: from.spawn(wi),
            part: 0,
        })
    }

    /// Density of [`SkyLight::sample`] at the unit direction `wi`, in 1/sr.
    pub fn pdf(&self, from: &Surface, wi: Vec3) -> f32 {
        0.5 * FRAC_1_PI * from.n.dot(wi).abs()
    }
}
