//! Ideal diffuse reflection.

use super::{BsdfSample, Event};
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

    /// Draws a direction on the side of `wo`, proportionally to its cosine; `None` for a `wo` along
    /// the surface.
    pub fn sample(&self, wo: Vec3, u: [f32; 2]) -> Option<Vec3> {
        let up = hemisphere::sample_cosine(u);
        (wo.z != 0.0).then_some(if wo.z < 0.0 { -up } else { up })
    }

    /// Density of [`Lambert::sample`], in 1/sr.
    pub fn pdf(&self, wo: Vec3, wi: Vec3) -> f32 {
        if wo.z * wi.z > 0.0 {
            hemisphere::pdf_cosine(Vec3::new(wi.x, wi.y, wi.z.abs()))
        } else {
            0.0
        }
    }

    /// Goes on in the direction of [`Lambert::sample`], with weight `f cos / pdf`, the albedo.
    pub fn scatter(&self, wo: Vec3, u: [f32; 2]) -> Option<BsdfSample> {
        let wi = self.sample(wo, u).filter(|_| !self.albedo.is_black())?;
        Some(BsdfSample {
            wi,
            weight: self.albedo,
            pdf: Some(self.pdf(wo, wi)),
            event: Event::Diffuse,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_goes_on_with_exactly_the_albedo() {
        let albedo = Rgb::new(0.73, 0.1, 0.0);
        let lambert = Lambert { albedo };
        for (wo, u) in [
            (Vec3::Z, [0.0, 0.0]),
            (Vec3::new(0.6, 0.0, -0.8), [0.99, 0.3]),
        ] {
            let next = lambert.scatter(wo, u).expect("a direction");
            assert_eq!(next.weight, albedo);
            let pdf = next.pdf.expect("a density");
            assert_eq!(pdf, lambert.pdf(wo, next.wi));
            let spelt_out = lambert.f(wo, next.wi).r * next.wi.z.abs() / pdf;
            assert!((spelt_out - albedo.r).abs() < 1e-6, "{spelt_out}");
        }
        let black = Lambert { albedo: Rgb::BLACK };
        assert!(black.scatter(Vec3::Z, [0.5, 0.5]).is_none());
        assert!(lambert.scatter(Vec3::X, [0.5, 0.5]).is_none());
    }
}
