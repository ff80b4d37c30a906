//! A mesh that shines on the front of each of its triangles, or on both sides.

use super::triangle::{at, by_area};
use super::{LightSample, faces, pdf_by_area, shining};
use crate::color::Rgb;
use crate::geometry::{Surface, Triangle};
use crate::sampling::discrete::{Discrete, refined};
use crate::sampling::{as_uniform, warps};
use glam::Vec3;

/// Triangles of one radiance on their front sides, or on both.
#[derive(Clone, Debug)]
pub struct MeshLight {
    triangles: Vec<Triangle>,
    by_area: Discrete,
    radiance: Rgb,
    two_sided: bool,
}

impl MeshLight {
    /// The light of these triangles; `None` where they have no area.
    ///
    /// * `radiance`: in W/(m² sr), in every direction of a side that shines.
    pub fn new(triangles: Vec<Triangle>, radiance: Rgb) -> Option<Self> {
        Some(MeshLight {
            by_area: Discrete::new(triangles.iter().map(Triangle::area))?,
            triangles,
            radiance,
            two_sided: false,
        })
    }

    /// The same light on both sides.
    #[must_use]
    pub fn two_sided(self) -> Self {
        MeshLight {
            two_sided: true,
            ..self
        }
    }

    /// True for light on both sides.
    pub fn is_two_sided(&self) -> bool {
        self.two_sided
    }

    /// Its triangles.
    pub fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// Draws a point of the light, uniformly in area: a triangle by its share of all area, then a
    /// point of the triangle. `None` where the point shines away.
    ///
    /// * Domain: `u` in `[0, 1)²`; `pick` in `[0, 1)` refines the first, so that no triangle is too
    ///   small to be drawn.
    ///
    /// Density: `d² / (A cos θ_light)` with the area `A` of the whole mesh, in 1/sr.
    pub fn sample(&self, from: &Surface, pick: f64, u: [f32; 2]) -> Option<LightSample> {
        self.sample_moved(Vec3::ZERO, from, pick, u)
    }

    /// [`MeshLight::sample`] of the light moved by a vector.
    pub(super) fn sample_moved(
        &self,
        by: Vec3,
        from: &Surface,
        pick: f64,
        u: [f32; 2],
    ) -> Option<LightSample> {
        let (part, [b, c]) = self.sample_point(pick, u);
        let target = at(&self.triangles[part].moved(by), b, c);
        let target = shining(target, self.two_sided, from);
        let sample = by_area(&target, self.area(), self.radiance, from)?;
        Some(LightSample {
            part: part as u32,
            ..sample.at([b, c])
        })
    }

    /// Draws a point uniformly in area: the number of a triangle, and the weights of its second and third
    /// corner.
    pub(super) fn sample_point(&self, pick: f64, u: [f32; 2]) -> (usize, [f32; 2]) {
        let chosen = self.by_area.sample(refined(u[0], pick));
        let weights = warps::sample_triangle([as_uniform(chosen.rest as f32), u[1]]);
        (chosen.index, weights)
    }

    /// Density of [`MeshLight::sample`] in 1/sr, of the point `at` in the direction `wi`.
    ///
    /// What a ray meets first is at most one point of the mesh, so that no other triangle adds to
    /// it: those behind it are in its shadow.
    pub fn pdf(&self, from: &Surface, wi: Vec3, at: &Surface) -> f32 {
        let at = shining(*at, self.two_sided, from);
        if faces(at, from) {
            pdf_by_area(self.area(), from, wi, &at)
        } else {
            0.0
        }
    }

    /// Area in square scene units.
    pub fn area(&self) -> f64 {
        self.by_area.total()
    }

    /// In W/(m² sr), in every direction of a side that shines.
    pub fn radiance(&self) -> Rgb {
        self.radiance
    }
}
