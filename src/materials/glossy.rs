//! Reflection by a rough mirror.

use super::ggx::Ggx;
use super::{BsdfSample, Event};
use crate::color::Rgb;
use glam::{DVec3, Vec3};

/// A rough mirror on both sides: facets spread as [`Ggx`] says, each reflecting the same share.
///
/// `f = reflectance D(h) G1(wo) G1(wi) / (4 cos cos)`, with `h` half way between the directions.
/// Light that a facet sends onto another one is lost: under white light from everywhere a surface
/// of reflectance 1 and roughness 1, seen from straight above, sends back `1 - ln 2`.
///
/// Source: Walter, Marschner, Li, Torrance, Microfacet Models for Refraction through Rough Surfaces
/// (EGSR 2007), equation 20.
#[derive(Clone, Copy, Debug)]
pub struct Glossy {
    /// The share of light that each facet reflects, each channel in `[0, 1]`.
    pub reflectance: Rgb,
    /// The roughness α in `[1e-3, 1]`; smoother ones are mirrors, see
    /// [`Bsdf::glossy`](super::Bsdf::glossy).
    pub alpha: f32,
}

impl Glossy {
    /// The BSDF in 1/sr, without cosine.
    pub fn f(&self, wo: Vec3, wi: Vec3) -> Rgb {
        let Some([o, i]) = above(wo, wi) else {
            return Rgb::BLACK;
        };
        let ggx = self.ggx();
        let grey = 0.25 * ggx.d(o + i) * ggx.g1_per_cos(o) * ggx.g1_per_cos(i);
        self.reflectance * grey as f32
    }

    /// Draws a facet that `wo` sees, and the direction mirrored by it; `None` where that leads into
    /// the surface.
    pub fn sample(&self, wo: Vec3, u: [f32; 2]) -> Option<Vec3> {
        let [o, _] = above(wo, wo)?;
        let h = self.ggx().sample_visible(o, u);
        let i = (2.0 * o.dot(h) * h - o).as_vec3();
        (i.z > 0.0).then_some(if wo.z < 0.0 {
            Vec3::new(i.x, i.y, -i.z)
        } else {
            i
        })
    }

    /// Density of [`Glossy::sample`], in 1/sr: that of the facet, divided by `4 wo · h`. Over all
    /// directions it integrates to the share of samples that do not lead into the surface.
    pub fn pdf(&self, wo: Vec3, wi: Vec3) -> f32 {
        above(wo, wi).map_or(0.0, |[o, i]| {
            let ggx = self.ggx();
            (0.25 * ggx.d(o + i) * ggx.g1_per_cos(o)) as f32
        })
    }

    /// Goes on in the direction of [`Glossy::sample`]. Of `f cos / pdf` the reflectance and
    /// `G1(wi)` remain, never more than 1.
    pub fn scatter(&self, wo: Vec3, u: [f32; 2]) -> Option<BsdfSample> {
        let wi = self
            .sample(wo, u)
            .filter(|_| !self.reflectance.is_black())?;
        let [_, i] = above(wo, wi)?;
        Some(BsdfSample {
            wi,
            weight: self.reflectance * self.ggx().g1(i) as f32,
            pdf: Some(self.pdf(wo, wi)),
            event: Event::Gloss,
        })
    }

    fn ggx(&self) -> Ggx {
        Ggx {
            alpha: f64::from(self.alpha),
        }
    }
}

/// Both directions, turned to the upper side; `None` where they are not on one side.
fn above(wo: Vec3, wi: Vec3) -> Option<[DVec3; 2]> {
    let same = (wo.z > 0.0 && wi.z > 0.0) || (wo.z < 0.0 && wi.z < 0.0);
    same.then(|| [wo, wi].map(|w| Vec3::new(w.x, w.y, w.z.abs()).as_dvec3()))
}
