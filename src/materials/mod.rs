//! What a surface does with light: the BSDF, in local coordinates (`z` is the normal).
//!
//! A BSDF has a smooth part, a function `f` in 1/sr that can be evaluated and sampled, and a
//! perfectly specular part, a short list of directions with weights. `f` does not contain the
//! cosine.

mod among;
pub mod fresnel;
pub mod ggx;
mod glass;
mod glossy;
mod lambert;
mod mirror;
mod mixture;
mod rough_glass;
mod specular;

pub use among::{Among, kinds};
pub use glass::Glass;
pub use glossy::Glossy;
pub use lambert::Lambert;
pub use mirror::Mirror;
pub use mixture::{Choice, Mixture};
pub use rough_glass::RoughGlass;
pub use specular::{Branch, Specular};

use crate::color::Rgb;
use crate::notation::Letter;
use glam::Vec3;

/// Everything a surface can be made of. To add a material: a file, a variant, and follow the
/// compiler.
#[derive(Clone, Copy, Debug)]
pub enum Material {
    /// Ideal diffuse reflection.
    Lambert(Lambert),
    /// Perfect specular reflection.
    Mirror(Mirror),
    /// A smooth interface to a transparent medium.
    Glass(Glass),
    /// Reflection by a rough mirror.
    Glossy(Glossy),
    /// A rough interface to a transparent medium.
    RoughGlass(RoughGlass),
    /// Diffuse, specular and transmitted light in constant shares.
    Mixture(Mixture),
}

/// How a path goes on from a surface.
#[derive(Clone, Copy, Debug)]
pub struct Scattered {
    /// The direction of its next segment, unit.
    pub wi: Vec3,
    /// `f |cos| / pdf`, with the probability of every choice in it; not black.
    pub weight: Rgb,
    /// The density in 1/sr with which [`Material::scatter`] draws `wi` from the smooth part, the
    /// probability of choosing that part included; `None` for a perfectly specular direction.
    pub pdf: Option<f32>,
    /// What happened there.
    pub event: Event,
}

/// What happens to light at a surface, in Heckbert's letters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// `D`: scattered in all directions alike.
    Diffuse,
    /// `G`: scattered around a specular direction.
    Gloss,
    /// `S`: mirrored or refracted in one direction.
    Specular,
}

/// Below this α roughness does not show: the specular twin stands in, of which scattered directions
/// differ by a few thousandths of a radian, and shadow rays would be in vain.
pub const SMOOTH: f32 = 1e-3;

impl From<Event> for Letter {
    fn from(event: Event) -> Letter {
        match event {
            Event::Diffuse => Letter::Diffuse,
            Event::Gloss => Letter::Gloss,
            Event::Specular => Letter::Specular,
        }
    }
}

impl Material {
    /// A rough mirror, or below α = [`SMOOTH`] a perfect one.
    ///
    /// * `alpha`: in `(0, 1]`.
    pub fn glossy(reflectance: Rgb, alpha: f32) -> Material {
        if alpha < SMOOTH {
            Material::Mirror(Mirror { reflectance })
        } else {
            Material::Glossy(Glossy { reflectance, alpha })
        }
    }

    /// Rough glass, or smooth one below α = [`SMOOTH`], and where the index is so close to 1 that
    /// roughness bends light by less than 1e-4 radian.
    ///
    /// * `alpha`: in `(0, 1]`.
    pub fn rough_glass(ior: f32, alpha: f32) -> Material {
        if alpha < SMOOTH || alpha * (ior - 1.0).abs() < 1e-4 {
            Material::Glass(Glass { ior })
        } else {
            Material::RoughGlass(RoughGlass { ior, alpha })
        }
    }

    /// The smooth part of the BSDF in 1/sr, without cosine.
    pub fn f(&self, wo: Vec3, wi: Vec3) -> Rgb {
        self.any().f(wo, wi)
    }

    /// Draws the direction in which a path that came from `wo` goes on; `None` where it ends.
    ///
    /// * `choice`, `u`: in `[0, 1)`. `choice` decides between the parts of the BSDF, `u` on a
    ///   direction of a smooth one.
    pub fn scatter(&self, wo: Vec3, choice: f32, u: [f32; 2]) -> Option<Scattered> {
        self.any().scatter(wo, choice, u)
    }

    /// Density in 1/sr with which [`Material::scatter`] draws `wi` from the smooth part; 0 where
    /// there is none.
    pub fn pdf(&self, wo: Vec3, wi: Vec3) -> f32 {
        self.any().pdf(wo, wi)
    }

    /// What happens to light that the smooth part scatters; `None` where there is none.
    pub fn smooth_event(&self) -> Option<Event> {
        self.any().smooth_event()
    }

    /// Which of the materials besides `Lambert` it is: one bit of [`kinds`].
    pub fn kind(&self) -> u8 {
        match self {
            Material::Lambert(_) => kinds::DIFFUSE,
            Material::Mirror(_) | Material::Glass(_) | Material::Mixture(_) => kinds::SPECULAR,
            Material::Glossy(_) | Material::RoughGlass(_) => kinds::GLOSS,
        }
    }

    fn any(&self) -> Among<{ kinds::ALL }> {
        Among(*self)
    }

    /// False where all light goes through perfectly specular directions: `f` is black there, and
    /// shadow rays are in vain.
    pub fn is_smooth(&self) -> bool {
        self.smooth_event().is_some()
    }

    /// The perfectly specular directions and their weights.
    pub fn specular(&self, wo: Vec3) -> Specular {
        match self {
            Material::Mirror(m) => m.specular(wo),
            Material::Glass(m) => m.specular(wo),
            Material::Mixture(m) => m.specular(wo),
            Material::Lambert(_) | Material::Glossy(_) | Material::RoughGlass(_) => {
                Specular::default()
            }
        }
    }

    /// The share of light that comes back under white light from everywhere; of rough surfaces, what
    /// each of their facets sends back, before some of it is lost between them.
    pub fn albedo(&self) -> Rgb {
        match self {
            Material::Lambert(m) => m.albedo,
            Material::Mirror(m) => m.reflectance,
            Material::Glossy(m) => m.reflectance,
            Material::Mixture(m) => m.k_tot(),
            Material::Glass(_) | Material::RoughGlass(_) => Rgb::WHITE,
        }
    }
}
