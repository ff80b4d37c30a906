//! What a point sees of a lamp in a ball: pieces of rings.

use super::RINGS;
use crate::numeric;
use glam::Vec3;

/// A lamp in a ball as a point sees it: a piece of each ring.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Image {
    /// Unit, towards the middle of the ball.
    axis: Vec3,
    /// Unit, across the axis: the side on which the lamp is.
    pub(super) sideways: Vec3,
    /// The square of the sine of the angle under which the ball's radius is seen.
    size2: f32,
    /// For each ring the cosine of half the angle ψ around the axis that its piece takes: infinite
    /// where there is none, -1 or less where it goes all the way round.
    cosines: [f32; RINGS],
    /// A bit for each ring in which the middle of the piece is on the side opposite to the lamp.
    opposite: u32,
    /// Of all pieces, in sr.
    solid_angle: f32,
    /// How much of the light goes this way, roughly.
    pub(in crate::scene) strength: f32,
}

impl Image {
    /// No piece of a ball yet, seen along `axis` under an angle whose sine has the square `size2`.
    pub(super) fn new(axis: Vec3, sideways: Vec3, size2: f32, strength: f32) -> Self {
        Image {
            axis,
            sideways,
            size2,
            cosines: [f32::INFINITY; RINGS],
            opposite: 0,
            solid_angle: 0.0,
            strength,
        }
    }

    /// How much light comes from it, roughly: its solid angle in sr, as far as it is bright.
    pub(in crate::scene) fn worth(&self) -> f32 {
        self.strength * self.solid_angle
    }

    /// In sr.
    pub(in crate::scene) fn solid_angle(&self) -> f32 {
        self.solid_angle
    }

    /// Adds the piece of a ring in which `factor cos ψ >= least`.
    pub(super) fn add(&mut self, ring: usize, factor: f32, least: f32) {
        self.cosines[ring] = least / factor.abs();
        self.opposite |= u32::from(factor < 0.0) << ring;
        self.solid_angle += self.area(ring);
    }

    /// Half the angle ψ around the axis that the piece of a ring takes.
    fn half(&self, ring: usize) -> f32 {
        numeric::acos(self.cosines[ring].max(-1.0))
    }

    /// The solid angle of the piece of a ring in sr.
    fn area(&self, ring: usize) -> f32 {
        2.0 * self.half(ring) * self.height(ring)
    }

    /// 1 where the middle of a piece is on the lamp's side, -1 where it is opposite.
    fn side(&self, ring: usize) -> f32 {
        if self.opposite >> ring & 1 == 0 {
            1.0
        } else {
            -1.0
        }
    }

    /// `1 - cos θ` where a ring begins, θ counted from the axis.
    pub(super) fn one_minus_cos(&self, ring: usize) -> f32 {
        numeric::one_minus_cos(self.size2 * (ring as f32 / RINGS as f32))
    }

    /// The difference of the cosines between which a ring lies, as that of their squares over their
    /// sum.
    fn height(&self, ring: usize) -> f32 {
        let cosines = 2.0 - self.one_minus_cos(ring) - self.one_minus_cos(ring + 1);
        self.size2 / (RINGS as f32 * cosines)
    }

    /// Draws a direction, uniformly in the solid angle of all pieces.
    ///
    /// * Domain: `u` in `[0, 1)²` → a unit direction into one of the pieces, up to rounding.
    /// * Density: the reciprocal of the solid angle where [`Image::shows`], in 1/sr.
    /// * Method: a ring by its share, in the ring `cos θ` and the angle around the axis uniformly.
    pub(in crate::scene) fn sample(&self, u: [f32; 2]) -> Vec3 {
        let mut rest = u[0] * self.solid_angle;
        let (mut at, mut share) = (0, 0.0);
        for ring in (0..RINGS).filter(|&ring| self.cosines[ring] < 1.0) {
            let area = self.area(ring);
            (at, share) = (ring, (rest / area).min(1.0));
            if rest < area {
                break;
            }
            rest -= area;
        }
        let one_minus_cos = self.one_minus_cos(at) + share * self.height(at);
        let sin = (one_minus_cos * (2.0 - one_minus_cos)).sqrt();
        let (sin_psi, cos_psi) = numeric::sin_cos((2.0 * u[1] - 1.0) * self.half(at));
        let across = self.axis.cross(self.sideways);
        self.axis * (1.0 - one_minus_cos)
            + self.sideways * (self.side(at) * sin * cos_psi)
            + across * (sin * sin_psi)
    }

    /// True for the unit directions `wi` that [`Image::sample`] draws.
    pub(in crate::scene) fn shows(&self, wi: Vec3) -> bool {
        // 1 - cos of the angle between unit vectors, in which nothing cancels.
        let one_minus_cos = 0.5 * (wi - self.axis).length_squared();
        let sin2 = one_minus_cos * (2.0 - one_minus_cos);
        let ring = sin2 / self.size2 * RINGS as f32;
        if !(one_minus_cos < 1.0 && ring < RINGS as f32) {
            return false;
        }
        let ring = ring as usize;
        self.side(ring) * wi.dot(self.sideways) >= self.cosines[ring] * sin2.sqrt()
    }
}
