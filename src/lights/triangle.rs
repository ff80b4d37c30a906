//! A triangle that shines on one side.

use super::{Extent, LightSample, SMALLEST_SOLID_ANGLE, faces, pdf_by_area, towards};
use crate::color::Rgb;
use crate::geometry::{Crossing, Surface, Triangle};
use crate::sampling::{spherical_triangle::SphericalTriangle, warps};
use glam::{DVec3, Vec3};

/// A triangle of constant radiance on the side of its normal.
#[derive(Clone, Copy, Debug)]
pub struct TriangleLight {
    /// Its shape, which has an area.
    pub triangle: Triangle,
    /// In W/(m² sr), in every direction of the front side.
    pub radiance: Rgb,
}

impl TriangleLight {
    /// Draws a point of the light, uniformly in the solid angle it is seen under; uniformly in area
    /// where it is far or looks tiny. `None` where it shines away.
    ///
    /// Density: `1 / Ω`, else `d² / (A cos θ_light)`, in 1/sr.
    pub fn sample(&self, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        let Some(seen) = self.seen_from(from) else {
            return sample_by_area(&self.triangle, self.triangle.area(), self.radiance, from, u);
        };
        let [b, c] = self.weights(from, seen.sample(u));
        towards(from, &at(&self.triangle, b, c), self.radiance, |_| {
            seen.pdf() as f32
        })
    }

    /// Density of [`TriangleLight::sample`] in 1/sr, in the direction `wi` that meets the light in
    /// `at`.
    pub fn pdf(&self, from: &Surface, wi: Vec3, at: &Surface) -> f32 {
        if !(faces(*at, from) && at.n.dot(wi) < 0.0) {
            return 0.0;
        }
        match self.seen_from(from) {
            Some(seen) => seen.pdf() as f32,
            None => pdf_by_area(self.triangle.area(), from, wi, at),
        }
    }

    /// Its corners relative to a point.
    fn corners(&self, from: &Surface) -> [DVec3; 3] {
        let Triangle { a, b, c } = self.triangle;
        [a, b, c].map(|corner| corner.as_dvec3() - from.p.as_dvec3())
    }

    /// The triangle as a point before it sees it; `None` where it is far or too small.
    fn seen_from(&self, from: &Surface) -> Option<SphericalTriangle> {
        let Triangle { a, b, c } = self.triangle;
        if Extent::of([a, b, c]).is_far(from) {
            return None;
        }
        let seen = SphericalTriangle::new(self.corners(from))?;
        (seen.solid_angle() >= SMALLEST_SOLID_ANGLE).then_some(seen)
    }

    /// The weights of the second and third corner where a ray along `w` meets the triangle.
    fn weights(&self, from: &Surface, w: DVec3) -> [f32; 2] {
        let [a, b, c] = self.corners(from);
        let volumes = [w.dot(b.cross(c)), w.dot(c.cross(a)), w.dot(a.cross(b))];
        // All of one sign, up to rounding.
        let sign = a.dot(b.cross(c)).signum();
        let [wa, wb, wc] = volumes.map(|volume| (volume * sign).max(0.0));
        [wb, wc].map(|weight| (weight / (wa + wb + wc)) as f32)
    }
}

/// Draws a point of a triangle, uniformly in its area, as one of a light of area `area`.
pub(super) fn sample_by_area(
    triangle: &Triangle,
    area: f64,
    radiance: Rgb,
    from: &Surface,
    u: [f32; 2],
) -> Option<LightSample> {
    let [b, c] = warps::sample_triangle(u);
    let target = at(triangle, b, c);
    towards(from, &target, radiance, |wi| {
        pdf_by_area(area, from, wi, &target)
    })
}

/// The point of a triangle whose second and third corner have these weights.
fn at(triangle: &Triangle, u: f32, v: f32) -> Surface {
    triangle.surface(Crossing { t: 0.0, u, v })
}
