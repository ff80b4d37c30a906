//! Lights of one's own.

use super::{Incident, LightSample};
use crate::color::Rgb;
use crate::geometry::Surface;
use glam::{DVec3, Vec3};
use std::fmt::Debug;
use std::sync::Arc;

/// A light of one's own, which no ray can meet: it is found by sampling it, as a point light is.
///
/// Coordinates are those of the scene, in `f64`.
pub trait CustomLight: Debug + Send + Sync {
    /// Samples a direction from which light arrives at `p`; `None` where none does.
    ///
    /// * `u`: in `[0, 1)²`.
    fn sample(&self, p: DVec3, u: [f32; 2]) -> Option<Arrival>;

    /// About how much light it gives where it gives most, in W/m²: it is sampled the more often the larger
    /// this is among the scene's lights. Any positive number is right in the mean.
    fn fluence(&self) -> f64;
}

/// Light that would arrive if nothing were in its way.
#[derive(Clone, Copy, Debug)]
pub struct Arrival {
    /// The unit direction it comes from.
    pub wi: Vec3,
    /// How far away it begins, in scene units; may be infinite.
    pub distance: f32,
    /// The irradiance of a surface that faces it, in W/m²; where directions are drawn from many, the radiance
    /// over the density.
    pub irradiance: Rgb,
}

/// A light of one's own in a scene, whose coordinates are relative to the camera.
#[derive(Clone, Debug)]
pub struct PlacedLight {
    light: Arc<dyn CustomLight>,
    camera: DVec3,
}

impl PlacedLight {
    /// The light, seen by a scene whose camera is there.
    pub fn new(light: Arc<dyn CustomLight>, camera: DVec3) -> Self {
        PlacedLight { light, camera }
    }

    /// About how much light it gives, in W/m².
    pub fn fluence(&self) -> f64 {
        self.light.fluence()
    }

    /// Samples it as a light without extent. What is no proper direction, or no light, is none.
    pub fn sample(&self, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        let arrival = self.light.sample(from.p.as_dvec3() + self.camera, u)?;
        let Arrival {
            wi,
            distance,
            irradiance,
        } = arrival;
        let proper = wi.is_normalized() && distance > 0.0 && irradiance.is_finite();
        let shadow_ray = match distance.is_finite() {
            true => from.spawn_to_point(from.p + wi * distance),
            false => from.spawn(wi),
        };
        (proper && !irradiance.is_black()).then(|| LightSample {
            shadow_ray,
            ..LightSample::from_afar(from, wi, Incident::Irradiance(irradiance))
        })
    }
}
