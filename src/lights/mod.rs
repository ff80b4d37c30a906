//! Lights one can aim at: where light comes from, as seen from a surface.

mod bounding_sphere;
mod bounds;
mod choice;
mod custom;
mod delta;
mod emission;
mod environment;
pub mod lanes;
mod mesh;
mod moved;
mod quad;
mod sky;
mod sphere;
mod targets;
mod tree;
mod triangle;

pub use bounding_sphere::BoundingSphere;
pub use bounds::LightBounds;
pub use choice::{ChosenLight, LightChoice};
pub use custom::{Arrival, CustomLight, PlacedLight};
pub use delta::{DirectionalLight, PointLight};
pub use emission::{EmissionChoice, EmissionSample, EmissionUniforms};
pub use environment::EnvironmentLight;
pub use mesh::MeshLight;
pub use quad::QuadLight;
pub use sky::SkyLight;
pub use sphere::SphereLight;
pub use targets::Targets;
pub use tree::LightTree;
pub use triangle::TriangleLight;

use crate::color::Rgb;
use crate::geometry::{Ray, Surface};
use glam::Vec3;
use std::f64::consts::PI;

/// Everything that shines. To add a light: a file, a variant, and follow the compiler.
#[derive(Clone, Debug)]
pub enum Light {
    /// A point.
    Point(PointLight),
    /// A direction.
    Directional(DirectionalLight),
    /// A parallelogram, on its normal's side or on both.
    Quad(QuadLight),
    /// A sphere, outwards.
    Sphere(SphereLight),
    /// A triangle, on its front side or on both.
    Triangle(TriangleLight),
    /// A mesh, on the front sides of its triangles or on both.
    Mesh(MeshLight),
    /// An image around the scene.
    Environment(EnvironmentLight),
    /// The same radiance from everywhere around the scene.
    Sky(SkyLight),
    /// One's own.
    Custom(PlacedLight),
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
    /// Which of the light's surfaces it comes from: the number of a triangle of a mesh, 0 for all
    /// other lights.
    pub part: u32,
    /// The point on a quad or triangle, as in [`Intersection`](crate::geometry::Intersection).
    pub place: [f32; 2],
    /// The unit normal of a surface at the point, on a side that shines.
    pub n: Vec3,
}

impl LightSample {
    /// Light that comes from infinitely far away.
    fn from_afar(from: &Surface, wi: Vec3, incident: Incident) -> Self {
        LightSample {
            wi,
            incident,
            shadow_ray: from.spawn(wi),
            part: 0,
            place: [0.0; 2],
            n: -wi,
        }
    }

    /// The same at a place of a quad or triangle.
    fn at(self, place: [f32; 2]) -> Self {
        LightSample { place, ..self }
    }
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
    ///
    /// * `u` in `[0, 1)²` chooses a point of it.
    /// * `pick` in `[0, 1)` refines `u` where one of many is chosen, a triangle of a mesh or a pixel
    ///   of an image. Other lights do not look at it.
    pub fn sample(&self, from: &Surface, pick: f64, u: [f32; 2]) -> Option<LightSample> {
        match self {
            Light::Point(l) => l.sample(from),
            Light::Directional(l) => Some(l.sample(from)),
            Light::Quad(l) => l.sample(from, u),
            Light::Sphere(l) => l.sample(from, u),
            Light::Triangle(l) => l.sample(from, u),
            Light::Mesh(l) => l.sample(from, pick, u),
            Light::Environment(l) => l.sample(from, pick, u),
            Light::Sky(l) => l.sample(from, u),
            Light::Custom(l) => l.sample(from, u),
        }
    }

    /// Density in 1/sr with which [`Light::sample`] draws the unit direction `wi`, seen from `from`.
    ///
    /// * `at` is the point of this light that a ray along `wi` meets; `None` where the ray leaves the
    ///   scene, and can only meet an environment.
    ///
    /// 0 for lights without extent, which no ray meets, and where [`Light::sample`] draws nothing.
    pub fn pdf(&self, from: &Surface, wi: Vec3, at: Option<&Surface>) -> f32 {
        match (self, at) {
            (Light::Quad(l), Some(at)) => l.pdf(from, wi, at),
            (Light::Sphere(l), Some(at)) => l.pdf(from, wi, at),
            (Light::Triangle(l), Some(at)) => l.pdf(from, wi, at),
            (Light::Mesh(l), Some(at)) => l.pdf(from, wi, at),
            (Light::Environment(l), None) => l.pdf(wi),
            (Light::Sky(l), None) => l.pdf(from, wi),
            (Light::Quad(_) | Light::Sphere(_) | Light::Triangle(_) | Light::Mesh(_), None)
            | (Light::Environment(_) | Light::Sky(_), Some(_))
            | (Light::Point(_) | Light::Directional(_) | Light::Custom(_), _) => 0.0,
        }
    }

    /// True for a light without extent, which no ray meets.
    pub fn is_delta(&self) -> bool {
        matches!(
            self,
            Light::Point(_) | Light::Directional(_) | Light::Custom(_)
        )
    }

    /// True where there is any light, however faint.
    pub fn shines(&self) -> bool {
        match self {
            Light::Point(l) => !l.intensity.is_black(),
            Light::Directional(l) => !l.irradiance.is_black(),
            Light::Quad(l) => !l.radiance().is_black(),
            Light::Sphere(l) => !l.radiance.is_black(),
            Light::Triangle(l) => !l.radiance.is_black(),
            Light::Mesh(l) => !l.radiance().is_black(),
            Light::Environment(_) => true,
            Light::Sky(l) => !l.radiance.is_black(),
            Light::Custom(l) => l.fluence() > 0.0,
        }
    }

    /// The fluence `∫ L dω` of a light that is infinitely far away, in W/m², mean over channels; 0
    /// for all others, whose fluence depends on the point.
    pub fn fluence_from_afar(&self) -> f64 {
        match self {
            Light::Directional(l) => mean(l.irradiance),
            Light::Environment(l) => l.fluence(),
            Light::Sky(l) => 4.0 * PI * mean(l.radiance),
            Light::Custom(l) => l.fluence(),
            _ => 0.0,
        }
    }
}

fn mean(light: Rgb) -> f64 {
    light.channels().map(f64::from).iter().sum::<f64>() / 3.0
}

/// A light seen under less than this, in sr, is sampled by area: as good from so far away, while
/// solid angles lose their digits.
const SMALLEST_SOLID_ANGLE: f64 = 1e-6;

/// A light is far where its middle is at least so many times as far away as its farthest corner is
/// from the middle.
const FAR: f32 = 2.5;

/// How large a flat light is.
#[derive(Clone, Copy, Debug)]
struct Extent {
    middle: Vec3,
    /// Square of the distance from which on it is far.
    far: f32,
}

impl Extent {
    fn of<const N: usize>(corners: [Vec3; N]) -> Self {
        let middle = corners.iter().sum::<Vec3>() / N as f32;
        let farthest = corners
            .iter()
            .map(|corner| (*corner - middle).length_squared())
            .fold(0.0, f32::max);
        Extent {
            middle,
            far: FAR * FAR * farthest,
        }
    }

    /// True where it is so far from `from` that points drawn uniformly in area serve as well:
    /// `cos θ / d²` hardly differs between them, and the many functions of angles that a solid angle
    /// costs are saved.
    fn is_far(&self, from: &Surface) -> bool {
        (self.middle - from.p).length_squared() >= self.far
    }
}

/// The point `at` of a flat light with its normal on the side that shines towards `from`: for a light
/// with two sides that on which `from` is.
fn shining(at: Surface, two_sided: bool, from: &Surface) -> Surface {
    let way = from.p.as_dvec3() - at.p.as_dvec3();
    if two_sided && way.dot(at.n.as_dvec3()) < 0.0 {
        Surface { n: -at.n, ..at }
    } else {
        at
    }
}

/// True where `from` is before the front of a flat light and surely not on it: a point of the light
/// itself, rounded outwards, would see the light beneath its feet.
fn faces(light: Surface, from: &Surface) -> bool {
    let height = (from.p.as_dvec3() - light.p.as_dvec3()).dot(light.n.as_dvec3());
    height > f64::from(light.n.abs().dot(light.error + from.error))
}

/// The light that comes from the point `target` of a one-sided light, whose direction was drawn
/// with density `pdf`; `None` where it shines away.
fn towards(
    from: &Surface,
    target: &Surface,
    radiance: Rgb,
    pdf: impl Fn(Vec3) -> f32,
) -> Option<LightSample> {
    if !faces(*target, from) {
        return None;
    }
    // Not the direction of the shadow ray, which keeps a distance from both surfaces: seen from a
    // point close to the light, that would be another one.
    let wi = (target.p.as_dvec3() - from.p.as_dvec3())
        .normalize()
        .as_vec3();
    let pdf = pdf(wi);
    (target.n.dot(wi) < 0.0 && pdf > 0.0).then(|| LightSample {
        wi,
        incident: Incident::Radiance { li: radiance, pdf },
        shadow_ray: from.spawn_to(target),
        part: 0,
        place: [0.0; 2],
        n: target.n,
    })
}

/// Density in 1/sr of the direction `wi` from `from` to the point `at` of a one-sided light that was
/// drawn uniformly in its area `A`, `d² / (A cos θ_light)`; 0 edge-on, from behind and on the light.
fn pdf_by_area(area: f64, from: &Surface, wi: Vec3, at: &Surface) -> f32 {
    let cos_light = -f64::from(at.n.dot(wi));
    let distance2 = (at.p.as_dvec3() - from.p.as_dvec3()).length_squared();
    let pdf = (distance2 / (area * cos_light)) as f32;
    if cos_light > 0.0 && pdf.is_finite() {
        pdf
    } else {
        0.0
    }
}
