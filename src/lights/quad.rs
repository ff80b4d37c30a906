//! A parallelogram that shines on one side or on both.

use super::{Extent, LightSample, SMALLEST_SOLID_ANGLE, faces, pdf_by_area, shining, towards};
use crate::color::Rgb;
use crate::geometry::{Quad, Surface};
use crate::sampling::spherical_rectangle::SphericalRectangle;
use glam::{DVec3, Vec3};

/// Quads whose edges have a cosine of at most this between them are rectangles: as much as the
/// rounding of corners bends most of them.
const RIGHT_ANGLE: f64 = 1e-5;

/// A parallelogram of constant radiance on the side of its normal, or on both.
#[derive(Clone, Copy, Debug)]
pub struct QuadLight {
    quad: Quad,
    radiance: Rgb,
    two_sided: bool,
    area: f64,
    extent: Extent,
    /// `None` where its edges are not at a right angle.
    rectangle: Option<Rectangle>,
}

/// A rectangle as all points before it see it, whatever their own place.
#[derive(Clone, Copy, Debug)]
struct Rectangle {
    corner: DVec3,
    /// Along the edges, and across.
    axes: [DVec3; 3],
    /// Lengths of the edges.
    size: [f64; 2],
}

impl Rectangle {
    fn of(quad: &Quad) -> Option<Self> {
        let [a, b, _, d] = quad.corners().map(Vec3::as_dvec3);
        let (u, v) = (b - a, d - a);
        let size = [u.length(), v.length()];
        let (x, y) = (u / size[0], v / size[1]);
        (x.dot(y).abs() <= RIGHT_ANGLE).then_some(Rectangle {
            corner: a,
            axes: [x, y, x.cross(y)],
            size,
        })
    }
}

impl QuadLight {
    /// The light of a shape and its radiance in W/(m² sr), in every direction of the front side.
    pub fn new(quad: Quad, radiance: Rgb) -> Self {
        QuadLight {
            quad,
            radiance,
            two_sided: false,
            area: f64::from(quad.area()),
            extent: Extent::of(quad.corners()),
            rectangle: Rectangle::of(&quad),
        }
    }

    /// The same light on both sides.
    #[must_use]
    pub fn two_sided(self) -> Self {
        QuadLight {
            two_sided: true,
            ..self
        }
    }

    /// True for light on both sides.
    pub fn is_two_sided(&self) -> bool {
        self.two_sided
    }

    /// Its shape.
    pub fn quad(&self) -> &Quad {
        &self.quad
    }

    /// Its middle, and the square of the distance from there beyond which it is sampled by area.
    pub(super) fn by_area_beyond(&self) -> (Vec3, f32) {
        (self.extent.middle, self.extent.far)
    }

    /// In W/(m² sr), in every direction of a side that shines.
    pub fn radiance(&self) -> Rgb {
        self.radiance
    }

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
        if self.is_behind(from) {
            return None;
        }
        let Some(seen) = self.seen_from(from) else {
            return self.sample_area_bent(bend, from, u);
        };
        let [s, t] = seen.place(seen.rectangle.sample(u));
        let target = shining(self.bent_surface(bend, s, t), self.two_sided, from);
        let sample = towards(from, &target, self.radiance, |_| {
            seen.rectangle.pdf() as f32
        });
        sample.map(|sample| sample.at([s, t]))
    }

    /// Draws a point of the light, uniformly in area: simpler, and as good from far away. Close to
    /// the light its variance grows like `A / (3π h²)` with the height `h`.
    ///
    /// Density: `d² / (A cos θ_light)`, in 1/sr.
    pub fn sample_area(&self, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        self.sample_area_bent(Vec3::ZERO, from, u)
    }

    fn sample_area_bent(&self, bend: Vec3, from: &Surface, u: [f32; 2]) -> Option<LightSample> {
        let target = shining(self.bent_surface(bend, u[0], u[1]), self.two_sided, from);
        let sample = towards(from, &target, self.radiance, |wi| {
            pdf_by_area(self.area, from, wi, &target)
        });
        sample.map(|sample| sample.at(u))
    }

    fn bent_surface(&self, bend: Vec3, s: f32, t: f32) -> Surface {
        let mut surface = self.quad.surface_at(s, t);
        surface.error += bend;
        surface
    }

    /// Density of [`QuadLight::sample`] in 1/sr, in the direction `wi` that meets the light in `at`.
    pub fn pdf(&self, from: &Surface, wi: Vec3, at: &Surface) -> f32 {
        let at = shining(*at, self.two_sided, from);
        if !(faces(at, from) && at.n.dot(wi) < 0.0) {
            return 0.0;
        }
        match self.seen_from(from) {
            Some(seen) => seen.rectangle.pdf() as f32,
            None => pdf_by_area(self.area, from, wi, &at),
        }
    }

    /// True where a point is behind all corners of a light that shines on one side: what would be sampled shines away.
    fn is_behind(&self, from: &Surface) -> bool {
        let n = self.quad.normal().as_dvec3();
        let height = |corner: Vec3| (from.p.as_dvec3() - corner.as_dvec3()).dot(n);
        !self.two_sided && self.quad.corners().into_iter().all(|c| height(c) <= 0.0)
    }

    /// The rectangle as a point before it sees it; `None` where it is none, far or too small.
    fn seen_from(&self, from: &Surface) -> Option<Seen> {
        if self.extent.is_far(from) {
            return None;
        }
        let Rectangle { corner, axes, size } = self.rectangle?;
        let way = corner - from.p.as_dvec3();
        let [left, low, across] = axes.map(|axis| axis.dot(way));
        let (x, y) = ([left, left + size[0]], [low, low + size[1]]);
        let rectangle = SphericalRectangle::new(x, y, across.abs());
        (rectangle.solid_angle() >= SMALLEST_SOLID_ANGLE).then_some(Seen {
            rectangle,
            corner: [left, low],
            size,
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
