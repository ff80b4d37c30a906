//! Lights one can aim at: where light comes from, as seen from a surface.

mod delta;
mod quad;
mod sphere;

pub use delta::{DirectionalLight, PointLight};
pub use quad::QuadLight;
pub use sphere::SphereLight;

use crate::color::Rgb;
use crate::geometry::{Ray, Surface};
use glam::Vec3;

/// Everything that shines. To add a light: a file, a variant, and follow the compiler.
#[derive(Clone, Copy, Debug)]
pub enum Light {
    /// A point.
    Point(PointLight),
    /// A direction.
    Directional(DirectionalLight),
    /// A parallelogram, on its normal's side.
    Quad(QuadLight),
    /// A sphere, outwards.
    Sphere(SphereLight),
}

/// Light that would arrive if nothing were in its way.
#[derive(Clone, Copy, Debug)]
pub struct LightSample {
    /// The direction it comes from, unit.
    pub wi: Vec3,
    /// How much it is.
    pub incident: Incident,
    /// The ray that must be free for it to arrive.
    pub shadow_ray: Ray,
}

/// How much light comes from one direction.
#[derive(Clone, Copy, Debug)]
pub enum Incident {
    /// Radiance from a direction drawn with density `pdf`.
    Radiance {
        /// In W/(m² sr).
        li: Rgb,
        /// In 1/sr, positive.
        pdf: f32,
    },
    /// All the light there is from a light without extent, which has no density: the irradiance of
    /// a surface that faces it, in W/m².
    Irradiance(Rgb),
}

impl Incident {
    /// The estimate of the irradiance of a surface that faces the light, `li / pdf`.
    pub fn facing_irradiance(&self) -> Rgb {
        match *self {
            Incident::Radiance { li, pdf } => li * (1.0 / pdf),
            Incident::Irradiance(e) => e,
        }
    }
}

impl Light {
    /// Draws a direction in which `from` may receive light; `None` where it receives none.
    pub fn sample(&self, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        match self {
            Light::Point(l) => l.sample(from),
            Light::Directional(l) => Some(l.sample(from)),
            Light::Quad(l) => l.sample(from, u),
            Light::Sphere(l) => l.sample(from, u),
        }
    }
}

/// Converts a density per area into one per solid angle: `p_ω = p_A d² / |cos θ_light|`.
///
/// * `distance2`: squared distance between the two points.
/// * `cos_light`: cosine at the light, positive.
pub fn area_to_solid_angle(pdf_area: f32, distance2: f32, cos_light: f32) -> f32 {
    pdf_area * distance2 / cos_light
}
