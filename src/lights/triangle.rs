//! A triangle that shines on one side or on both.

use super::{Extent, LightSample, SMALLEST_SOLID_ANGLE, faces, pdf_by_area, shining, towards};
use crate::color::Rgb;
use crate::geometry::{Intersection, Surface, Triangle};
use crate::sampling::{spherical_triangle::SphericalTriangle, warps};
use glam::{DVec3, Vec3};

/// A triangle of constant radiance on the side of its normal, or on both.
#[derive(Clone, Copy, Debug)]
pub struct TriangleLight {
    /// Its shape, which has an area.
    pub triangle: Triangle,
    /// In W/(m² sr), in every direction of a side that shines.
    pub radiance: Rgb,
    /// True for light on both sides.
    pub two_sided: bool,
}

impl TriangleLight {
    /// Draws a point of the light, uniformly in the solid angle it is seen under; uniformly in area
    /// where it is far or looks tiny. `None` where it shines away.
    ///
    /// Density: `1 / Ω`, else `d² / (A cos θ_light)`, in 1/sr.
    pub fn sample(&self, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        let Some(seen) = self.seen_from(from) else {
            let [b, c] = warps::sample_triangle(u);
            let target = shining(at(&self.triangle, b, c), self.two_sided, from);
            let sample = by_area(&target, self.triangle.area(), self.radiance, from);
            return sample.map(|sample| sample.at([b, c]));
        };
        let [b, c] = self.weights(from, seen.sample(u));
        let target = shining(at(&self.triangle, b, c), self.two_sided, from);
        let sample = towards(from, &target, self.radiance, |_| seen.pdf() as f32);
        sample.map(|sample| sample.at([b, c]))
    }

    /// Density of [`TriangleLight::sample`] in 1/sr, in the direction `wi` that meets the light in
    /// `at`.
    pub fn pdf(&self, from: &Surface, wi: Vec3, at: &Surface) -> f32 {
        let at = shining(*at, self.two_sided, from);
        if !(faces(at, from) && at.n.dot(wi) < 0.0) {
            return 0.0;
        }
        match self.seen_from(from) {
            Some(seen) => seen.pdf() as f32,
            None => pdf_by_area(self.triangle.area(), from, wi, &at),
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

/// The light of a point that was drawn uniformly in the area of a light.
pub(super) fn by_area(
    target: &Surface,
    area: f64,
    radiance: Rgb,
    from: &Surface,
) -> Option<LightSample> {
    towards(from, target, radiance, |wi| {
        pdf_by_area(area, from, wi, target)
    })
}

/// The point of a triangle whose second and third corner have these weights.
pub(super) fn at(triangle: &Triangle, u: f32, v: f32) -> Surface {
    triangle.surface(Intersection::new(0.0, u, v))
}
