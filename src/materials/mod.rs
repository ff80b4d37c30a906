//! What a surface does with light: the BSDF, in local coordinates (`z` is the normal).
//!
//! A BSDF has a smooth part, a function `f` in 1/sr that can be evaluated and sampled, and a
//! perfectly specular part, a short list of directions with weights. `f` does not contain the
//! cosine.

pub mod fresnel;
mod glass;
mod lambert;
mod mirror;

pub use glass::Glass;
pub use lambert::Lambert;
pub use mirror::Mirror;

use crate::color::Rgb;
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
}

/// A direction drawn from the smooth part of a BSDF.
#[derive(Clone, Copy, Debug)]
pub struct BsdfSample {
    /// The direction drawn, unit.
    pub wi: Vec3,
    /// The BSDF for it, in 1/sr, without cosine.
    pub f: Rgb,
    /// The density it was drawn with, in 1/sr; positive.
    pub pdf: f32,
}

/// One perfectly specular direction.
#[derive(Clone, Copy, Debug)]
pub struct Branch {
    /// Where the light comes from, unit.
    pub wi: Vec3,
    /// The share of its radiance that goes on to `wo`.
    pub weight: Rgb,
}

/// The perfectly specular part of a BSDF for one `wo`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Specular {
    /// The mirror direction.
    pub reflected: Option<Branch>,
    /// The refracted direction.
    pub transmitted: Option<Branch>,
}

impl Material {
    /// The smooth part of the BSDF in 1/sr, without cosine.
    pub fn f(&self, wo: Vec3, wi: Vec3) -> Rgb {
        match self {
            Material::Lambert(m) => m.f(wo, wi),
            Material::Mirror(_) | Material::Glass(_) => Rgb::BLACK,
        }
    }

    /// Draws a direction from the smooth part; `None` where there is none.
    pub fn sample(&self, wo: Vec3, u: [f32; 2]) -> Option<BsdfSample> {
        match self {
            Material::Lambert(m) => m.sample(wo, u),
            Material::Mirror(_) | Material::Glass(_) => None,
        }
    }

    /// Density of [`Material::sample`] at `wi`, in 1/sr.
    pub fn pdf(&self, wo: Vec3, wi: Vec3) -> f32 {
        match self {
            Material::Lambert(m) => m.pdf(wo, wi),
            Material::Mirror(_) | Material::Glass(_) => 0.0,
        }
    }

    /// The perfectly specular directions and their weights.
    pub fn specular(&self, wo: Vec3) -> Specular {
        match self {
            Material::Lambert(_) => Specular::default(),
            Material::Mirror(m) => m.specular(wo),
            Material::Glass(m) => m.specular(wo),
        }
    }

    /// The share of light that comes back under white light from everywhere.
    pub fn albedo(&self) -> Rgb {
        match self {
            Material::Lambert(m) => m.albedo,
            Material::Mirror(m) => m.reflectance,
            Material::Glass(_) => Rgb::WHITE,
        }
    }
}
