//! A parallelogram that shines on one side.

use super::{LightSample, SMALLEST_SOLID_ANGLE, faces, is_far, pdf_by_area, towards};
use crate::color::Rgb;
use crate::geometry::{Quad, Surface};
use crate::sampling::spherical_rectangle::SphericalRectangle;
use glam::Vec3;

/// Quads whose edges have a cosine of at most this between them are rectangles: as much as the
/// rounding of corners bends most of them.
const RIGHT_ANGLE: f64 = 1e-5;

/// A parallelogram of constant radiance on the side of its normal.
#[derive(Clone, Copy, Debug)]
pub struct QuadLight {
    /// Its shape.
    pub quad: Quad,
    /// In W/(m² sr), in every direction of the front side.
    pub radiance: Rgb,
}

impl QuadLight {
    /// Draws a point of the light, uniformly in the solid angle it is seen under; uniformly in area
    /// where its edges are not at a right angle, it is far or looks tiny. `None` where it shines away.
    ///
    /// Density: `1 / Ω`, in 1/sr; else as [`QuadLight::sample_area`].
    pub fn sample(&self, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        self.sample_bent(Vec3::ZERO, from, u)
    }

    /// [`QuadLight::sample`] of the light moved by a vector, whose corners rounded anew bend it.
    pub(super) fn sample_moved(
        &self,
        by: Vec3,
        from: &Surface,
        u: [f32; 2],
    ) -> Option<LightSample> {
        let there = self.moved(by);
        there.sample_bent(self.quad.bend(&there.quad), from, u)
    }

    /// [`QuadLight::sample`] of a quad whose corners are off their plane by up to `bend`.
    fn sample_bent(&self, bend: Vec3, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        let Some(seen) = self.seen_from(from) else {
            return self.sample_area_bent(bend, from, u);
        };
        let [s, t] = seen.place(seen.rectangle.sample(u));
        let target = self.bent_surface(bend, s, t);
        towards(from, &target, self.radiance, |_| {
            seen.rectangle.pdf() as f32
        })
    }

    /// Draws a point of the light, uniformly in area: simpler, and as good from far away. Close to
    /// the light its variance grows like `A / (3π h²)` with the height `h`.
    ///
    /// Density: `d² / (A cos θ_light)`, in 1/sr.
    pub fn sample_area(&self, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        self.sample_area_bent(Vec3::ZERO, from, u)
    }

    fn sample_area_bent(&self, bend: Vec3, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        let target = self.bent_surface(bend, u[0], u[1]);
        towards(from, &target, self.radiance, |wi| {
            pdf_by_area(f64::from(self.quad.area()), from, wi, &target)
        })
    }

    fn bent_surface(&self, bend: Vec3, s: f32, t: f32) -> Surface {
        let mut surface = self.quad.surface_at(s, t);
        surface.error += bend;
        surface
    }

    /// Density of [`QuadLight::sample`] in 1/sr, in the direction `wi` that meets the light in `at`.
    pub fn pdf(&self, from: &Surface, wi: Vec3, at: &Surface) -> f32 {
        if !(faces(*at, from) && at.n.dot(wi) < 0.0) {
            return 0.0;
        }
        match self.seen_from(from) {
            Some(seen) => seen.rectangle.pdf() as f32,
            None => pdf_by_area(f64::from(self.quad.area()), from, wi, at),
        }
    }

    /// The rectangle as a point before it sees it; `None` where it is none, far or too small.
    fn seen_from(&self, from: &Surface) -> Option<Seen> {
        let corners = self.quad.corners();
        if is_far(corners, from) {
            return None;
        }
        let [a, b, _, d] = corners.map(|corner| corner.as_dvec3() - from.p.as_dvec3());
        let (u, v) = (b - a, d - a);
        let (width, height) = (u.length(), v.length());
        let (x, y) = (u / width, v / height);
        let [left, low] = [x, y].map(|axis| axis.dot(a));
        let z = x.cross(y).dot(a).abs();
        let rectangle = SphericalRectangle::new([left, left + width], [low, low + height], z);
        (x.dot(y).abs() <= RIGHT_ANGLE && rectangle.solid_angle() >= SMALLEST_SOLID_ANGLE)
            .then_some(Seen {
                rectangle,
                corner: [left, low],
                size: [width, height],
            })
    }
}

/// A rectangle in coordinates along its edges, the eye at the origin.
struct Seen {
    rectangle: SphericalRectangle,
    corner: [f64; 2],
    size: [f64; 2],
}

impl Seen {
    /// The coordinates of a point as shares of the edges.
    fn place(&self, point: [f64; 2]) -> [f32; 2] {
        [0, 1].map(|i| (((point[i] - self.corner[i]) / self.size[i]) as f32).clamp(0.0, 1.0))
    }
}
