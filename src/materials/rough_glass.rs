//! A rough interface between air and a transparent medium.

use super::ggx::Ggx;
use super::glass::eta;
use super::{BsdfSample, Event, fresnel};
use crate::color::Rgb;
use glam::{DVec3, Vec3};

/// A rough dielectric: facets spread as [`Ggx`] says, each a smooth interface with the exact
/// Fresnel reflectance. The medium lies behind the surface, index 1 in front of it.
///
/// Radiance is not scaled by the squared index on refraction, as in [`Glass`](super::Glass); so
/// reciprocity reads `f(wo, wi) / n_i² = f(wi, wo) / n_o²`, with the index on the side of each
/// direction. Light that a facet sends onto another one is lost.
///
/// Source: Walter, Marschner, Li, Torrance, Microfacet Models for Refraction through Rough Surfaces
/// (EGSR 2007), equations 16 to 21; their refraction scales radiance.
#[derive(Clone, Copy, Debug)]
pub struct RoughGlass {
    /// Index of refraction of the medium behind the surface.
    pub ior: f32,
    /// The roughness α in `[1e-3, 1]`; what is smoother is glass, see
    /// [`Bsdf::rough_glass`](super::Bsdf::rough_glass).
    pub alpha: f32,
}

impl RoughGlass {
    /// The BSDF in 1/sr, without cosine.
    pub fn f(&self, wo: Vec3, wi: Vec3) -> Rgb {
        let density = self.density(wo, wi);
        let i = wi.as_dvec3().abs();
        Rgb::grey((density * self.ggx().g1_per_cos(i)) as f32)
    }

    /// Draws a facet that `wo` sees, and one of its two directions: `choice` below the Fresnel
    /// reflectance mirrors, the rest refracts. `None` where that leads to the wrong side.
    pub fn sample(&self, wo: Vec3, choice: f32, u: [f32; 2]) -> Option<Vec3> {
        if wo.z == 0.0 {
            return None;
        }
        let (o, eta) = self.seen_from(wo);
        let h = self.ggx().sample_visible(o, u);
        let cos_o = o.dot(h).clamp(0.0, 1.0);
        let i = if f64::from(choice) < fresnel::dielectric(cos_o, eta) {
            let mirrored = 2.0 * cos_o * h - o;
            (mirrored.z > 0.0).then_some(mirrored)
        } else {
            let cos_t = fresnel::cos_refracted(cos_o, eta)?;
            let refracted = (cos_o / eta - cos_t) * h - o / eta;
            (refracted.z < 0.0).then_some(refracted)
        }?;
        let side = if wo.z < 0.0 { -1.0 } else { 1.0 };
        Some(DVec3::new(i.x, i.y, side * i.z).as_vec3())
    }

    /// Density of [`RoughGlass::sample`], in 1/sr. Over all directions it integrates to the share
    /// of samples that do not lead to the wrong side.
    pub fn pdf(&self, wo: Vec3, wi: Vec3) -> f32 {
        self.density(wo, wi) as f32
    }

    /// Goes on in the direction of [`RoughGlass::sample`]. Of `f cos / pdf` only `G1(wi)` remains,
    /// never more than 1.
    pub fn scatter(&self, wo: Vec3, choice: f32, u: [f32; 2]) -> Option<BsdfSample> {
        let wi = self.sample(wo, choice, u)?;
        let pdf = self.pdf(wo, wi);
        (pdf > 0.0).then(|| BsdfSample {
            wi,
            weight: Rgb::grey(self.ggx().g1(wi.as_dvec3().abs()) as f32),
            pdf: Some(pdf),
            event: Event::Gloss,
        })
    }

    /// The density in `f64`: that of the facet, times the share of its light that goes to `wi`,
    /// times `dh / dwi = η² |wi · h| / |wo + η wi|²`. The half vector `h` lies along `wo + η wi`,
    /// with η the index at `wi` over the index at `wo`: 1 where `wi` is mirrored.
    fn density(&self, wo: Vec3, wi: Vec3) -> f64 {
        if wo.z == 0.0 || wi.z == 0.0 {
            return 0.0;
        }
        let (o, eta) = self.seen_from(wo);
        let mirrored = (wi.z > 0.0) == (wo.z > 0.0);
        let height = f64::from(wi.z.abs());
        let i = wi
            .as_dvec3()
            .with_z(if mirrored { height } else { -height });
        let eta_i = if mirrored { 1.0 } else { eta };
        let sum = o + eta_i * i;
        let Some(h) = sum.try_normalize().map(|h| if h.z < 0.0 { -h } else { h }) else {
            return 0.0;
        };
        let (cos_o, cos_i) = (o.dot(h), i.dot(h));
        // A facet is seen from its front by `wo`, and from the side that its light goes to by `wi`.
        if cos_o <= 0.0 || cos_i == 0.0 || (cos_i > 0.0) != mirrored {
            return 0.0;
        }
        let reflected = fresnel::dielectric(cos_o.min(1.0), eta);
        let share = if mirrored { reflected } else { 1.0 - reflected };
        let stretch = eta_i * eta_i * cos_i.abs() / sum.length_squared();
        share * self.ggx().pdf_visible(o, h) * stretch
    }

    /// `wo` turned to the upper side, and the index on the far side over that on the near one.
    fn seen_from(&self, wo: Vec3) -> (DVec3, f64) {
        let o = Vec3::new(wo.x, wo.y, wo.z.abs());
        (o.as_dvec3(), eta(wo, self.ior))
    }

    fn ggx(&self) -> Ggx {
        Ggx {
            alpha: f64::from(self.alpha),
        }
    }
}
