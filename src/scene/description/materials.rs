//! What a scene file says about materials.

use super::Color;

/// A material: exactly one of its kinds.
#[derive(Clone, Debug, Default, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Ideal diffuse reflection.
    pub lambert: Option<Lambert>,
    /// A perfect mirror.
    pub mirror: Option<Mirror>,
    /// A smooth transparent medium.
    pub glass: Option<Glass>,
    /// A rough mirror.
    pub glossy: Option<Glossy>,
    /// A rough transparent medium.
    pub rough_glass: Option<RoughGlass>,
    /// Diffuse, specular and transmitted light in constant shares.
    pub mixture: Option<Mixture>,
}

/// Ideal diffuse reflection.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lambert {
    /// Share of light reflected.
    pub albedo: Color,
}

/// A perfect mirror.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mirror {
    /// Share of light reflected.
    pub reflectance: Color,
}

/// A smooth transparent medium.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Glass {
    /// Index of refraction behind the surface.
    pub ior: f64,
}

/// A rough mirror.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Glossy {
    /// Share of light that each facet reflects.
    pub reflectance: Color,
    /// The roughness α of the facets, in `(0, 1]`.
    pub roughness: f64,
}

/// A rough transparent medium.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RoughGlass {
    /// Index of refraction behind the surface.
    pub ior: f64,
    /// The roughness α of the facets, in `(0, 1]`.
    pub roughness: f64,
}

/// Diffuse, specular and transmitted light in constant shares.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mixture {
    /// Share scattered diffusely.
    pub kd: Color,
    /// Share mirrored.
    pub ks: Color,
    /// Share refracted.
    pub kt: Color,
    /// Index of refraction behind the surface.
    #[serde(default = "usual_glass")]
    pub ior: f64,
}

fn usual_glass() -> f64 {
    1.5
}
