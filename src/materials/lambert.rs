//! Ideal diffuse reflection.

use super::BsdfSample;
use crate::color::Rgb;
use crate::sampling::hemisphere;
use glam::Vec3;
use std::f32::consts::FRAC_1_PI;

/// A surface of the same brightness from everywhere, on both sides: `f = albedo / π`.
///
/// Source: Lambert, Photometria (1760), part I, "De intensitate luminis".
#[derive(Clone, Copy, Debug)]
pub struct Lambert {
    /// The share of light reflected, each channel in `[0, 1]`.
    pub albedo: Rgb,
}

impl Lambert {
    /// `albedo / π` where both directions are on the same side, in 1/sr.
    pub fn f(&self, wo: Vec3, wi: Vec3) -> Rgb {
        if wo.z * wi.z > 0.0 {
            self.albedo * FRAC_1_PI
        } else {
            Rgb::BLACK
        }
    }

    /// Draws a direction on the side of `wo`, proportionally to its cosine.
    pub fn sample(&self, wo: Vec3, u: [f32; 2]) -> Option<BsdfSample> {
        let up = hemisphere::sample_cosine(u);
        let wi = if wo.z < 0.0 { -up } else { up };
        let pdf = hemisphere::pdf_cosine(up);
        (wo.z != 0.0 && pdf > 0.0).then(|| BsdfSample {
            wi,
            f: self.f(wo, wi),
            pdf,
        })
    }

    /// Density of [`Lambert::sample`], in 1/sr.
    pub fn pdf(&self, wo: Vec3, wi: Vec3) -> f32 {
        if wo.z * wi.z > 0.0 {
            hemisphere::pdf_cosine(Vec3::new(wi.x, wi.y, wi.z.abs()))
        } else {
            0.0
        }
    }
}
