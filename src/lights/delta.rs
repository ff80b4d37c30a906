//! Lights without extent: a point and a direction.

use super::{Incident, LightSample};
use crate::color::Rgb;
use crate::geometry::Surface;
use glam::Vec3;

/// A point that sends the same light everywhere.
#[derive(Clone, Copy, Debug)]
pub struct PointLight {
    /// Where it is.
    pub position: Vec3,
    /// In W/sr.
    pub intensity: Rgb,
}

impl PointLight {
    /// The only direction there is, with irradiance `I / d²`; `None` at the light itself.
    pub fn sample(&self, from: &Surface) -> Option<LightSample> {
        let distance2 = (self.position - from.p).length_squared();
        let irradiance = self.intensity * (1.0 / distance2);
        let shadow_ray = from.spawn_to_point(self.position);
        (distance2 > 0.0 && irradiance.is_finite()).then_some(LightSample {
            shadow_ray,
            ..LightSample::from_afar(
                from,
                shadow_ray.direction.normalize(),
                Incident::Irradiance(irradiance),
            )
        })
    }
}

/// Parallel light from infinitely far away.
#[derive(Clone, Copy, Debug)]
pub struct DirectionalLight {
    /// The direction the light comes from, unit.
    pub from: Vec3,
    /// Irradiance of a surface that faces the light, in W/m².
    pub irradiance: Rgb,
}

impl DirectionalLight {
    /// The only direction there is.
    pub fn sample(&self, from: &Surface) -> LightSample {
        LightSample::from_afar(from, self.from, Incident::Irradiance(self.irradiance))
    }
}
