//! A BSDF known to be one of a few kinds.

use super::{Bsdf, BsdfSample, CustomBsdf, Event};
use crate::color::Rgb;
use glam::Vec3;

/// Sets of BSDFs besides `Lambert`, which is in each, as bits: what stands between the angle
/// brackets of [`Among`].
pub mod kinds {
    /// Only what is ideally diffuse.
    pub const DIFFUSE: u8 = 0;
    /// Perfectly specular parts: `Mirror`, `Glass`, `Mixture`.
    pub const SPECULAR: u8 = 1;
    /// Lobes of some width: `Glossy`, `RoughGlass`.
    pub const GLOSS: u8 = 2;
    /// One's own: `Custom`.
    pub const CUSTOM: u8 = 4;
    /// Every BSDF.
    pub const ALL: u8 = SPECULAR | GLOSS | CUSTOM;
}

/// A BSDF among those of the set `KINDS`, a constant of [`kinds`]: code for the others is not there. A
/// BSDF outside the set is black.
#[derive(Clone, Copy, Debug)]
pub struct Among<'a, const KINDS: u8>(pub &'a Bsdf<'a>);

impl<const KINDS: u8> Among<'_, KINDS> {
    const SPECULAR: bool = KINDS & kinds::SPECULAR != 0;
    const GLOSS: bool = KINDS & kinds::GLOSS != 0;
    const CUSTOM: bool = KINDS & kinds::CUSTOM != 0;

    /// See [`Bsdf::f`].
    #[inline]
    pub fn f(&self, wo: Vec3, wi: Vec3) -> Rgb {
        match self.0 {
            Bsdf::Lambert(m) => m.f(wo, wi),
            Bsdf::Glossy(m) if Self::GLOSS => m.f(wo, wi),
            Bsdf::RoughGlass(m) if Self::GLOSS => m.f(wo, wi),
            Bsdf::Mixture(m) if Self::SPECULAR => m.f(wo, wi),
            Bsdf::Custom(m) if Self::CUSTOM => m.f(wo, wi),
            Bsdf::Mirror(_)
            | Bsdf::Glass(_)
            | Bsdf::Glossy(_)
            | Bsdf::RoughGlass(_)
            | Bsdf::Mixture(_)
            | Bsdf::Custom(_) => Rgb::BLACK,
        }
    }

    /// See [`Bsdf::scatter`].
    #[inline]
    pub fn scatter(&self, wo: Vec3, choice: f32, u: [f32; 2]) -> Option<BsdfSample> {
        match self.0 {
            Bsdf::Lambert(m) => m.scatter(wo, u),
            Bsdf::Mirror(m) if Self::SPECULAR => m.specular(wo).scatter(choice),
            Bsdf::Glass(m) if Self::SPECULAR => m.specular(wo).scatter(choice),
            Bsdf::Glossy(m) if Self::GLOSS => m.scatter(wo, u),
            Bsdf::RoughGlass(m) if Self::GLOSS => m.scatter(wo, choice, u),
            Bsdf::Mixture(m) if Self::SPECULAR => m.scatter(wo, choice, u),
            Bsdf::Custom(m) if Self::CUSTOM => custom(*m, wo, choice, u),
            Bsdf::Mirror(_)
            | Bsdf::Glass(_)
            | Bsdf::Glossy(_)
            | Bsdf::RoughGlass(_)
            | Bsdf::Mixture(_)
            | Bsdf::Custom(_) => None,
        }
    }

    /// See [`Bsdf::pdf`].
    #[inline]
    pub fn pdf(&self, wo: Vec3, wi: Vec3) -> f32 {
        match self.0 {
            Bsdf::Lambert(m) => m.pdf(wo, wi),
            Bsdf::Glossy(m) if Self::GLOSS => m.pdf(wo, wi),
            Bsdf::RoughGlass(m) if Self::GLOSS => m.pdf(wo, wi),
            Bsdf::Mixture(m) if Self::SPECULAR => m.pdf(wo, wi),
            Bsdf::Custom(m) if Self::CUSTOM => m.pdf(wo, wi),
            Bsdf::Mirror(_)
            | Bsdf::Glass(_)
            | Bsdf::Glossy(_)
            | Bsdf::RoughGlass(_)
            | Bsdf::Mixture(_)
            | Bsdf::Custom(_) => 0.0,
        }
    }

    /// See [`Bsdf::smooth_event`].
    #[inline]
    pub fn smooth_event(&self) -> Option<Event> {
        match self.0 {
            Bsdf::Lambert(_) => Some(Event::Diffuse),
            Bsdf::Glossy(_) | Bsdf::RoughGlass(_) if Self::GLOSS => Some(Event::Gloss),
            Bsdf::Mixture(m) if Self::SPECULAR => (!m.kd.is_black()).then_some(Event::Diffuse),
            Bsdf::Custom(m) if Self::CUSTOM => Some(m.event()),
            Bsdf::Mirror(_)
            | Bsdf::Glass(_)
            | Bsdf::Glossy(_)
            | Bsdf::RoughGlass(_)
            | Bsdf::Mixture(_)
            | Bsdf::Custom(_) => None,
        }
    }
}

/// How a path goes on by a BSDF of one's own.
#[inline(never)]
fn custom(bsdf: &dyn CustomBsdf, wo: Vec3, choice: f32, u: [f32; 2]) -> Option<BsdfSample> {
    let wi = bsdf.sample(wo, choice, u)?;
    let pdf = bsdf.pdf(wo, wi);
    let weight = bsdf.f(wo, wi) * (wi.z.abs() / pdf);
    (pdf > 0.0 && !weight.is_black()).then(|| BsdfSample {
        wi,
        weight,
        pdf: Some(pdf),
        event: bsdf.event(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::materials::{Glass, Glossy, Lambert};

    fn diffuse<'a>(bsdf: &'a Bsdf<'a>) -> Among<'a, { kinds::DIFFUSE }> {
        Among(bsdf)
    }

    fn gloss<'a>(bsdf: &'a Bsdf<'a>) -> Among<'a, { kinds::GLOSS }> {
        Among(bsdf)
    }

    fn specular<'a>(bsdf: &'a Bsdf<'a>) -> Among<'a, { kinds::SPECULAR }> {
        Among(bsdf)
    }

    #[test]
    fn what_is_in_the_set_is_itself_and_what_is_not_is_black() {
        let (wo, wi) = (Vec3::new(0.6, 0.0, 0.8), Vec3::new(0.0, 0.6, 0.8));
        let lambert = Bsdf::Lambert(Lambert {
            albedo: Rgb::grey(0.5),
        });
        let glossy = Bsdf::Glossy(Glossy {
            reflectance: Rgb::WHITE,
            alpha: 0.5,
        });
        let glass = Bsdf::Glass(Glass { ior: 1.5 });
        assert_eq!(diffuse(&lambert).f(wo, wi), lambert.f(wo, wi));
        assert_eq!(diffuse(&lambert).pdf(wo, wi), lambert.pdf(wo, wi));
        for absent in [glossy, glass] {
            assert_eq!(diffuse(&absent).f(wo, wi), Rgb::BLACK);
            assert!(diffuse(&absent).scatter(wo, 0.5, [0.5; 2]).is_none());
            assert_eq!(diffuse(&absent).smooth_event(), None);
        }
        assert!(!glossy.f(wo, wi).is_black());
        assert_eq!(gloss(&glossy).f(wo, wi), glossy.f(wo, wi));
        assert!(gloss(&glass).scatter(wo, 0.5, [0.5; 2]).is_none());
        assert!(specular(&glass).scatter(wo, 0.5, [0.5; 2]).is_some());
    }
}
