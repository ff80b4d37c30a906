//! Where paths from the lights are aimed: balls around the surfaces that focus light.
//!
//! Source: Jensen, Global Illumination Using Photon Maps (Rendering Techniques 1996), "Projection maps".

use super::bounding_sphere::BoundingSphere;
use crate::numeric::one_minus_cos;
use crate::sampling::frame::Frame;
use crate::sampling::{as_uniform, hemisphere, warps};
use glam::Vec3;
use std::f64::consts::PI;

/// The least sine of half the angle of a cone. Directions in `f32` are rounded by a ten thousandth of it:
/// rays into a much narrower cone would miss its rim.
const NARROWEST: f64 = 1e-3;

/// Balls that paths from the lights are aimed at, each as often as the others.
///
/// From outside a ball, directions are uniform in the cone in which it is seen. From within, they are those of
/// an emitter that nobody aims. What balls overlap counts for all of them.
#[derive(Clone, Debug, Default)]
pub struct Targets {
    balls: Vec<BoundingSphere>,
}

/// In which directions a point emits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Emitter {
    /// A point without a surface: in all of them alike.
    Point,
    /// A surface with this unit normal: on its side alone, by the cosine.
    OneSided(Vec3),
    /// On both sides, by the cosine.
    TwoSided(Vec3),
}

impl Emitter {
    /// A surface with this unit normal.
    pub(super) fn of(n: Vec3, two_sided: bool) -> Self {
        match two_sided {
            false => Emitter::OneSided(n),
            true => Emitter::TwoSided(n),
        }
    }

    /// Cosine of the unit direction `w` where it emits, 0 where it does not; 1 for a point.
    pub(super) fn cos(self, w: Vec3) -> f32 {
        match self {
            Emitter::Point => 1.0,
            Emitter::OneSided(n) => n.dot(w).max(0.0),
            Emitter::TwoSided(n) => n.dot(w).abs(),
        }
    }

    /// Draws a direction in which it emits, for `u` in `[0, 1)²`: by the cosine, or uniformly for a point.
    pub(super) fn sample(self, [a, b]: [f32; 2]) -> Vec3 {
        let about = |n: Vec3, a: f32| Frame::new(n).to_world(hemisphere::sample_cosine([a, b]));
        match self {
            Emitter::Point => warps::sample_sphere([a, b]),
            Emitter::OneSided(n) => about(n, a),
            // One half of the uniforms for each side.
            Emitter::TwoSided(n) if a < 0.5 => about(n, 2.0 * a),
            Emitter::TwoSided(n) => about(-n, as_uniform(2.0 * a - 1.0)),
        }
    }

    /// The cosine of a direction of [`Emitter::sample`] over its density, in sr: the same for all.
    pub(super) fn cos_over_pdf(self) -> f64 {
        match self {
            Emitter::Point => f64::from(1.0 / warps::pdf_sphere()),
            Emitter::OneSided(_) => PI,
            Emitter::TwoSided(_) => 2.0 * PI,
        }
    }

    /// Density of [`Emitter::sample`] at the unit direction `w`, in 1/sr.
    fn pdf(self, w: Vec3) -> f32 {
        self.cos(w) / self.cos_over_pdf() as f32
    }
}

/// A cone of directions.
struct Cone {
    axis: Vec3,
    one_minus_cos: f32,
}

impl Cone {
    /// The cone in which `p` sees a ball, or one of [`NARROWEST`] around it; `None` within the ball.
    fn of(ball: &BoundingSphere, p: Vec3) -> Option<Cone> {
        let way = ball.center.as_dvec3() - p.as_dvec3();
        let distance2 = way.length_squared();
        let sin2 = f64::from(ball.radius).powi(2) / distance2;
        (sin2 < 1.0).then(|| Cone {
            axis: (way / distance2.sqrt()).as_vec3().normalize(),
            one_minus_cos: one_minus_cos(sin2.max(NARROWEST * NARROWEST) as f32),
        })
    }

    fn contains(&self, w: Vec3) -> bool {
        // 1 - cos of the angle between unit vectors, in which nothing cancels.
        0.5 * (w - self.axis).length_squared() <= self.one_minus_cos
    }
}

impl Targets {
    /// These balls.
    pub fn new(balls: Vec<BoundingSphere>) -> Self {
        Targets { balls }
    }

    /// The balls.
    pub fn balls(&self) -> &[BoundingSphere] {
        &self.balls
    }

    /// True where there are none.
    pub fn is_empty(&self) -> bool {
        self.balls.is_empty()
    }

    /// The ball of the uniform `aim`; `None` where there are none.
    fn choose(&self, aim: f32) -> Option<(usize, &BoundingSphere)> {
        let index = (aim * self.balls.len() as f32) as usize;
        let index = index.min(self.balls.len().checked_sub(1)?);
        Some((index, &self.balls[index]))
    }

    /// Draws a unit direction from `p` towards a ball, and its density in 1/sr; `None` where there are no balls.
    ///
    /// * `aim` in `[0, 1)` and `u` in `[0, 1)²`.
    pub(super) fn sample_direction(
        &self,
        p: Vec3,
        emitter: Emitter,
        aim: f32,
        u: [f32; 2],
    ) -> Option<(Vec3, f32)> {
        let (index, ball) = self.choose(aim)?;
        let w = match Cone::of(ball, p) {
            Some(cone) => Frame::new(cone.axis).to_world(warps::sample_cone(u, cone.one_minus_cos)),
            None => emitter.sample(u),
        };
        let w = w.normalize();
        Some((w, self.pdf_direction(p, emitter, w, index)))
    }

    /// Density in 1/sr of [`Targets::sample_direction`] at `w`, which lies in the cone of the ball `drawn` whatever
    /// rounding says.
    fn pdf_direction(&self, p: Vec3, emitter: Emitter, w: Vec3, drawn: usize) -> f32 {
        let of = |(index, ball): (usize, &BoundingSphere)| match Cone::of(ball, p) {
            Some(cone) if index == drawn || cone.contains(w) => warps::pdf_cone(cone.one_minus_cos),
            Some(_) => 0.0,
            None => emitter.pdf(w),
        };
        let sum: f32 = self.balls.iter().enumerate().map(of).sum();
        sum / self.balls.len() as f32
    }

    /// Draws a line against the unit direction `from` through a ball: how far it passes the centre of `around`,
    /// and its density in 1/m² among such lines; `None` where there are no balls.
    ///
    /// * `aim` in `[0, 1)` and `u` in `[0, 1)²`.
    pub(super) fn sample_line(
        &self,
        around: &BoundingSphere,
        from: Vec3,
        aim: f32,
        u: [f32; 2],
    ) -> Option<(Vec3, f64)> {
        // Discs across the direction, no smaller than what the origin of a ray is rounded by.
        let least = f64::from(around.radius) * NARROWEST * NARROWEST;
        let disc = |ball: &BoundingSphere| {
            let way = ball.center.as_dvec3() - around.center.as_dvec3();
            let from = from.as_dvec3();
            (
                way - from * way.dot(from),
                f64::from(ball.radius).max(least),
            )
        };
        let (index, ball) = self.choose(aim)?;
        let (center, radius) = disc(ball);
        let aside = warps::sample_disk_concentric(u).extend(0.0);
        let line = center + Frame::new(from).to_world(aside).as_dvec3() * radius;
        let density = |(other, ball): (usize, &BoundingSphere)| {
            let (center, radius) = disc(ball);
            let meets = other == index || (line - center).length() <= radius;
            f64::from(u8::from(meets)) / (PI * radius * radius)
        };
        let sum: f64 = self.balls.iter().enumerate().map(density).sum();
        Some((line.as_vec3(), sum / self.balls.len() as f64))
    }
}
