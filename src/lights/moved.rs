//! Lights in motion: each moment a light like any other, in another place.

use super::{Light, LightSample, QuadLight, SphereLight, TriangleLight};
use crate::geometry::{Sphere, Surface};
use glam::Vec3;

impl Light {
    /// [`Light::sample`] of the light moved by a vector, as [`Shape::moved`] moves its surface;
    /// those without a surface stay where they are.
    ///
    /// [`Shape::moved`]: crate::geometry::Shape::moved
    pub fn sample_moved(
        &self,
        by: Vec3,
        from: &Surface,
        pick: f64,
        u: [f32; 2],
    ) -> Option<LightSample> {
        match self {
            Light::Quad(l) => l.sample_moved(by, from, u),
            Light::Sphere(l) => l.moved(by).sample(from, u),
            Light::Triangle(l) => l.moved(by).sample(from, u),
            Light::Mesh(l) => l.sample_moved(by, from, pick, u),
            Light::Point(_)
            | Light::Directional(_)
            | Light::Environment(_)
            | Light::Sky(_)
            | Light::Custom(_) => self.sample(from, pick, u),
        }
    }

    /// [`Light::pdf`] of the light moved by a vector: density in 1/sr of [`Light::sample_moved`].
    pub fn pdf_moved(&self, by: Vec3, from: &Surface, wi: Vec3, at: Option<&Surface>) -> f32 {
        match (self, at) {
            (Light::Quad(l), Some(at)) => l.moved(by).pdf(from, wi, at),
            (Light::Sphere(l), Some(at)) => l.moved(by).pdf(from, wi, at),
            (Light::Triangle(l), Some(at)) => l.moved(by).pdf(from, wi, at),
            // The density of a mesh depends on its area and the point, and on no place of its own.
            (Light::Mesh(_), Some(_))
            | (Light::Quad(_) | Light::Sphere(_) | Light::Triangle(_) | Light::Mesh(_), None)
            | (
                Light::Point(_)
                | Light::Directional(_)
                | Light::Environment(_)
                | Light::Sky(_)
                | Light::Custom(_),
                _,
            ) => self.pdf(from, wi, at),
        }
    }
}

impl QuadLight {
    /// The same light in another place.
    pub(super) fn moved(&self, by: Vec3) -> Self {
        let there = QuadLight::new(self.quad().moved(by), self.radiance());
        match self.is_two_sided() {
            true => there.two_sided(),
            false => there,
        }
    }
}

impl SphereLight {
    fn moved(&self, by: Vec3) -> Self {
        SphereLight {
            sphere: Sphere {
                center: self.sphere.center + by,
                ..self.sphere
            },
            ..*self
        }
    }
}

impl TriangleLight {
    fn moved(&self, by: Vec3) -> Self {
        TriangleLight {
            triangle: self.triangle.moved(by),
            ..*self
        }
    }
}
