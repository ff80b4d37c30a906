//! Materials, and the BSDF that they have at a point, in local coordinates (`z` is the normal).
//!
//! A [`Material`] is what a scene file describes; its colours may be textures. Where a ray meets it, it is
//! evaluated to a [`Bsdf`], which is what integrators evaluate and sample.
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
mod material;
mod mirror;
mod mixture;
mod rough_glass;
mod specular;
mod texture;

pub use among::{Among, kinds};
pub use glass::Glass;
pub use glossy::Glossy;
pub use lambert::Lambert;
pub use material::Material;
pub use mirror::Mirror;
pub use mixture::{Choice, Mixture};
pub use rough_glass::RoughGlass;
pub use specular::{Branch, Specular};
pub use texture::{Color, Texture};

use crate::color::Rgb;
use crate::notation::Letter;
use glam::Vec3;
use std::fmt::Debug;

/// The BSDF at a point of a surface, the distribution of the light that it scatters. To add one: a file,
/// a variant, and follow the compiler.
#[derive(Clone, Copy, Debug)]
pub enum Bsdf<'a> {
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
    /// One's own.
    Custom(&'a dyn CustomBsdf),
}

/// A BSDF of one's own, in local coordinates. Its directions are unit.
///
/// Scenes that use one are rendered by code for every BSDF; scene files cannot name it.
pub trait CustomBsdf: Debug + Send + Sync {
    /// The BSDF in 1/sr, without cosine.
    fn f(&self, wo: Vec3, wi: Vec3) -> Rgb;

    /// Samples a direction; `None` where the path ends.
    ///
    /// * `choice`, `u`: in `[0, 1)`, independent of each other.
    fn sample(&self, wo: Vec3, choice: f32, u: [f32; 2]) -> Option<Vec3>;

    /// Density of [`CustomBsdf::sample`], in 1/sr.
    fn pdf(&self, wo: Vec3, wi: Vec3) -> f32;

    /// A bound on the share of light that comes back, channel by channel at most 1.
    fn albedo(&self) -> Rgb;

    /// The letter of its light in a path's word.
    fn event(&self) -> Event {
        Event::Gloss
    }
}

/// A direction drawn from a BSDF: how a path goes on from a surface.
#[derive(Clone, Copy, Debug)]
pub struct BsdfSample {
    /// The direction of its next segment, unit.
    pub wi: Vec3,
    /// `f |cos| / pdf`, with the probability of every choice in it; not black.
    pub weight: Rgb,
    /// The density in 1/sr with which [`Bsdf::scatter`] draws `wi` from the smooth part, the
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

impl<'a> Bsdf<'a> {
    /// A rough mirror, or below α = [`SMOOTH`] a perfect one.
    ///
    /// * `alpha`: in `(0, 1]`.
    pub fn glossy(reflectance: Rgb, alpha: f32) -> Self {
        if alpha < SMOOTH {
            Bsdf::Mirror(Mirror { reflectance })
        } else {
            Bsdf::Glossy(Glossy { reflectance, alpha })
        }
    }

    /// Rough glass, or smooth one below α = [`SMOOTH`], and where the index is so close to 1 that
    /// roughness bends light by less than 1e-4 radian.
    ///
    /// * `alpha`: in `(0, 1]`.
    pub fn rough_glass(ior: f32, alpha: f32) -> Self {
        if alpha < SMOOTH || alpha * (ior - 1.0).abs() < 1e-4 {
            Bsdf::Glass(Glass { ior })
        } else {
            Bsdf::RoughGlass(RoughGlass { ior, alpha })
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
    pub fn scatter(&self, wo: Vec3, choice: f32, u: [f32; 2]) -> Option<BsdfSample> {
        self.any().scatter(wo, choice, u)
    }

    /// Density in 1/sr with which [`Bsdf::scatter`] draws `wi` from the smooth part; 0 where
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
            Bsdf::Lambert(_) => kinds::DIFFUSE,
            Bsdf::Mirror(_) | Bsdf::Glass(_) | Bsdf::Mixture(_) => kinds::SPECULAR,
            Bsdf::Glossy(_) | Bsdf::RoughGlass(_) => kinds::GLOSS,
            Bsdf::Custom(_) => kinds::CUSTOM,
        }
    }

    /// Its colours, in the order in which a scene file describes them.
    pub(super) fn colors_mut(&mut self) -> [Option<&mut Rgb>; 3] {
        match self {
            Bsdf::Lambert(m) => [Some(&mut m.albedo), None, None],
            Bsdf::Mirror(m) => [Some(&mut m.reflectance), None, None],
            Bsdf::Glossy(m) => [Some(&mut m.reflectance), None, None],
            Bsdf::Mixture(m) => [Some(&mut m.kd), Some(&mut m.ks), Some(&mut m.kt)],
            Bsdf::Glass(_) | Bsdf::RoughGlass(_) | Bsdf::Custom(_) => [None, None, None],
        }
    }

    fn any(&self) -> Among<'_, { kinds::ALL }> {
        Among(self)
    }

    /// False where all light goes through perfectly specular directions: `f` is black there, and
    /// shadow rays are in vain.
    pub fn is_smooth(&self) -> bool {
        self.smooth_event().is_some()
    }

    /// True where some light goes through perfectly specular directions.
    pub fn is_specular(&self) -> bool {
        match self {
            Bsdf::Mirror(_) | Bsdf::Glass(_) => true,
            Bsdf::Mixture(m) => !(m.ks + m.kt).is_black(),
            Bsdf::Lambert(_) | Bsdf::Glossy(_) | Bsdf::RoughGlass(_) | Bsdf::Custom(_) => false,
        }
    }

    /// The square of the index of refraction on the side of `wo` over that on the side of `wi`, both in local
    /// coordinates; 1 where they are on the same side.
    pub fn index_ratio2(&self, wo: Vec3, wi: Vec3) -> f32 {
        let ior = match self {
            Bsdf::Glass(g) => g.ior,
            Bsdf::RoughGlass(g) => g.ior,
            Bsdf::Mixture(m) => m.ior,
            Bsdf::Lambert(_) | Bsdf::Mirror(_) | Bsdf::Glossy(_) | Bsdf::Custom(_) => return 1.0,
        };
        match wo.z * wi.z < 0.0 {
            false => 1.0,
            true if wo.z > 0.0 => 1.0 / (ior * ior),
            true => ior * ior,
        }
    }

    /// True where light enters what lies behind the surface.
    pub fn refracts(&self) -> bool {
        match self {
            Bsdf::Glass(_) | Bsdf::RoughGlass(_) => true,
            Bsdf::Mixture(m) => !m.kt.is_black(),
            Bsdf::Lambert(_) | Bsdf::Mirror(_) | Bsdf::Glossy(_) | Bsdf::Custom(_) => false,
        }
    }

    /// The perfectly specular directions and their weights.
    pub fn specular(&self, wo: Vec3) -> Specular {
        match self {
            Bsdf::Mirror(m) => m.specular(wo),
            Bsdf::Glass(m) => m.specular(wo),
            Bsdf::Mixture(m) => m.specular(wo),
            Bsdf::Lambert(_) | Bsdf::Glossy(_) | Bsdf::RoughGlass(_) | Bsdf::Custom(_) => {
                Specular::default()
            }
        }
    }

    /// The share of light that comes back under white light from everywhere; of rough surfaces, what
    /// each of their facets sends back, before some of it is lost between them.
    pub fn albedo(&self) -> Rgb {
        match self {
            Bsdf::Lambert(m) => m.albedo,
            Bsdf::Mirror(m) => m.reflectance,
            Bsdf::Glossy(m) => m.reflectance,
            Bsdf::Mixture(m) => m.k_tot(),
            Bsdf::Glass(_) | Bsdf::RoughGlass(_) => Rgb::WHITE,
            Bsdf::Custom(m) => m.albedo(),
        }
    }
}
