//! A mesh that shines on the front of each of its triangles.

use super::triangle::sample_by_area;
use super::{LightSample, faces, pdf_by_area};
use crate::color::Rgb;
use crate::geometry::{Surface, Triangle};
use crate::sampling::discrete::Discrete;
use glam::Vec3;

/// Triangles of one radiance on their front sides.
#[derive(Clone, Debug)]
pub struct MeshLight {
    triangles: Vec<Triangle>,
    by_area: Discrete,
    radiance: Rgb,
}

impl MeshLight {
    /// The light of these triangles; `None` where they have no area.
    ///
    /// * `radiance`: in W/(m² sr), in every direction of the front sides.
    pub fn new(triangles: Vec<Triangle>, radiance: Rgb) -> Option<Self> {
        Some(MeshLight {
            by_area: Discrete::new(triangles.iter().map(Triangle::area))?,
            triangles,
            radiance,
        })
    }

    /// Draws a point of the light, uniformly in area: a triangle by its share of all area, then a
    /// point of the triangle. `None` where the point shines away.
    ///
    /// Density: `d² / (A cos θ_light)` with the area `A` of the whole mesh, in 1/sr.
    pub fn sample(&self, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        self.sample_moved(Vec3::ZERO, from, u)
    }

    /// [`MeshLight::sample`] of the light moved by a vector.
    pub(super) fn sample_moved(
        &self,
        by: Vec3,
        from: &Surface,
        u: [f32; 2],
    ) -> Option<LightSample> {
        let choice = self.by_area.sample(u[0]);
        let u = [choice.rest, u[1]];
        let triangle = self.triangles[choice.index].moved(by);
        sample_by_area(&triangle, self.area(), self.radiance, from, u)
    }

    /// Density of [`MeshLight::sample`] in 1/sr, of the point `at` in the direction `wi`.
    ///
    /// What a ray meets first is at most one point of the mesh, so that no other triangle adds to
    /// it: those behind it are in its shadow.
    pub fn pdf(&self, from: &Surface, wi: Vec3, at: &Surface) -> f32 {
        if faces(*at, from) {
            pdf_by_area(self.area(), from, wi, at)
        } else {
            0.0
        }
    }

    /// Area in square scene units.
    pub fn area(&self) -> f64 {
        self.by_area.total()
    }

    /// In W/(m² sr), in every direction of the front sides.
    pub fn radiance(&self) -> Rgb {
        self.radiance
    }
}
