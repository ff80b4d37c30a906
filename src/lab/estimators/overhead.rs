//! A lamp straight above a white floor of the flat world, found by chance, by aiming, by both.
//!
//! The lamp is a segment one above the floor, of radiance 1, seen up to the angle `a` from the
//! normal to both sides; the floor reflects `∫ cos θ / 2 dθ = sin a` of it. Everything is one
//! integral over one angle, so the variance of each way to find the lamp is a quadrature: all of
//! this is `f64`, for walks in the same world to be compared with.
//!
//! Source: Veach, Guibas, Optimally Combining Sampling Techniques for Monte Carlo Rendering
//! (SIGGRAPH 1995), from whom the bound is.

use crate::flatland::{FlatWorld, gallery};
use crate::integrators::world::World;
use crate::integrators::{Combine, Kajiya, NextEvent};
use crate::sampling::mis::Heuristic;
use crate::sampling::stream::Stream;
use crate::scene::SceneError;
use crate::scene::read::Source;
use crate::space::{Flat, Ray};
use glam::Vec2;

/// The lamp, and how one aims at it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overhead {
    /// Angle from the normal to each end of the lamp, in radians, in `(0, π/2)`.
    pub half_angle: f64,
    /// What a point of the lamp is drawn uniformly in.
    pub aim: Aim,
}

/// What a point of a lamp is drawn uniformly in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// The angle at which it is seen, as the walks do.
    Angle,
    /// Its length: the ends of a long lamp are drawn too often.
    Length,
}

/// Steps of Simpson's rule.
const STEPS: i32 = 4000;

/// How the lamp is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Technique {
    /// By one direction of density `cos θ / 2`.
    Chance,
    /// By one point of the lamp.
    Aiming,
    /// By one of each, weighted.
    Both(Heuristic),
}

impl Technique {
    /// One walk from the eye to the floor and on to the lamp, by the integrator that uses this
    /// technique.
    pub fn walk(self, world: &mut impl World<Flat>, stream: &Stream) -> f64 {
        let eye = Overhead::eye();
        let max_depth = 2;
        let li = match self {
            Technique::Chance => Kajiya { max_depth }.walk(world, &eye, stream),
            Technique::Aiming => NextEvent { max_depth }.walk(world, &eye, stream),
            Technique::Both(heuristic) => {
                let walk = Combine {
                    max_depth,
                    heuristic,
                };
                let shares = walk.walk(world, &eye, stream);
                shares.by_chance + shares.by_aiming
            }
        };
        f64::from(li.r)
    }
}

impl Overhead {
    /// The lamp at which one aims by angle.
    pub fn new(half_angle: f64) -> Self {
        Overhead {
            half_angle,
            aim: Aim::Angle,
        }
    }

    /// Radiance of the floor, `sin a`.
    pub fn mean(&self) -> f64 {
        libm::sin(self.half_angle)
    }

    /// Light from the direction at `theta` from the normal that the floor reflects, per radian.
    pub fn integrand(&self, theta: f64) -> f64 {
        if theta.abs() <= self.half_angle {
            0.5 * libm::cos(theta)
        } else {
            0.0
        }
    }

    /// Draws a direction by its cosine; its density is the first of [`Overhead::pdf`].
    pub fn sample_chance(&self, u: f64) -> f64 {
        libm::asin(2.0 * u - 1.0)
    }

    /// Draws a direction to the lamp; its density is the second of [`Overhead::pdf`].
    pub fn sample_aim(&self, u: f64) -> f64 {
        match self.aim {
            Aim::Angle => (2.0 * u - 1.0) * self.half_angle,
            Aim::Length => libm::atan((2.0 * u - 1.0) * libm::tan(self.half_angle)),
        }
    }

    /// Densities of a direction by chance and by aiming, per radian.
    pub fn pdf(&self, theta: f64) -> [f64; 2] {
        let cos = libm::cos(theta);
        let aim = match self.aim {
            _ if theta.abs() > self.half_angle => 0.0,
            Aim::Angle => 0.5 / self.half_angle,
            Aim::Length => 0.5 / (libm::tan(self.half_angle) * cos * cos),
        };
        [0.5 * cos, aim]
    }

    /// How much a sample by chance and one by aiming count where they find this direction.
    pub fn weights(&self, technique: Technique, theta: f64) -> [f64; 2] {
        let [chance, aim] = self.pdf(theta);
        match technique {
            Technique::Chance => [1.0, 0.0],
            Technique::Aiming => [0.0, 1.0],
            Technique::Both(heuristic) => [
                heuristic.weight_f64(chance, aim),
                heuristic.weight_f64(aim, chance),
            ],
        }
    }

    /// One estimate of [`Overhead::mean`], from two uniforms.
    pub fn estimate(&self, technique: Technique, [u, v]: [f64; 2]) -> f64 {
        let drawn = [self.sample_chance(u), self.sample_aim(v)];
        let part = |i: usize| {
            let theta = drawn[i];
            self.weights(technique, theta)[i] * self.integrand(theta) / self.pdf(theta)[i]
        };
        part(0) + part(1)
    }

    /// Variance of one estimate, by quadrature.
    pub fn variance(&self, technique: Technique) -> f64 {
        // What a direction brings by each technique, and its densities: all integrals are made of these.
        let at = |k| {
            let theta = self.place(k);
            let light = self.integrand(theta);
            let found = self.weights(technique, theta).map(|w| w * light);
            (found, self.pdf(theta))
        };
        let places: Vec<([f64; 2], [f64; 2])> = (0..=STEPS).map(at).collect();
        let part = |i: usize| {
            let integral = |f: &dyn Fn(f64, f64) -> f64| {
                self.simpson(places.iter().map(|(found, pdf)| f(found[i], pdf[i])))
            };
            let mean = integral(&|found, _| found);
            // A sample that misses the lamp finds nothing.
            let misses = 1.0 - integral(&|_, pdf| pdf).min(1.0);
            let spread = |found: f64, pdf: f64| pdf * (found / pdf - mean).powi(2);
            integral(&spread) + misses * mean * mean
        };
        part(0) + part(1)
    }

    // ANCHOR: bound
    /// What the variance of both techniques by the balance heuristic cannot exceed, whatever the
    /// weights might have done better: `min Vᵢ + (1/min nᵢ - 1/Σ nᵢ) μ²`, with one sample of each.
    pub fn bound(&self) -> f64 {
        let [chance, aiming] = [Technique::Chance, Technique::Aiming].map(|t| self.variance(t));
        chance.min(aiming) + (1.0 - 1.0 / 2.0) * self.mean() * self.mean()
    }
    // ANCHOR_END: bound

    /// What someone would reach who knows the better technique, and takes both samples by it.
    pub fn oracle(&self) -> f64 {
        let [chance, aiming] = [Technique::Chance, Technique::Aiming].map(|t| self.variance(t));
        0.5 * chance.min(aiming)
    }

    /// The integral over the directions to the lamp, by Simpson's rule.
    pub fn integral(&self, f: impl Fn(f64) -> f64) -> f64 {
        self.simpson((0..=STEPS).map(|k| f(self.place(k))))
    }

    /// The same from the values at all places of the rule.
    fn simpson(&self, values: impl Iterator<Item = f64>) -> f64 {
        let step = 2.0 * self.half_angle / f64::from(STEPS);
        let weighted = (0..).zip(values).map(|(k, value)| {
            let factor = match k {
                0 | STEPS => 1.0,
                _ if k % 2 == 1 => 4.0,
                _ => 2.0,
            };
            factor * value
        });
        weighted.sum::<f64>() * step / 3.0
    }

    /// A direction to the lamp, in radians from the normal, where Simpson's rule looks.
    fn place(&self, k: i32) -> f64 {
        // The middle is the symmetric one: no end falls beyond the lamp.
        self.half_angle * (2.0 * f64::from(k) / f64::from(STEPS) - 1.0)
    }

    /// The same floor and lamp to walk in; the lamp is cut into parts that are seen at equal angles,
    /// each a lamp of its own.
    pub fn world(&self, parts: u32) -> Result<FlatWorld, SceneError> {
        let mut text = "name = 'overhead'\n\
                        [[objects]]\nalbedo = 1\nsegment = { from = [-1, 0], to = [1, 0] }\n"
            .to_owned();
        let cut = |k: u32| {
            let share = f64::from(k) / f64::from(parts);
            libm::tan(self.half_angle * (1.0 - 2.0 * share))
        };
        for k in 0..parts {
            let (from, to) = (cut(k), cut(k + 1));
            text += "[[objects]]\nemits = 1\n";
            text += &format!("segment = {{ from = [{from}, 1], to = [{to}, 1] }}\n");
        }
        gallery::from_text(Source {
            file: "overhead",
            text: &text,
        })
    }

    /// A ray from below the lamp to the middle of the floor.
    pub fn eye() -> Ray<Flat> {
        Ray::new(Vec2::new(0.0, 0.5), Vec2::NEG_Y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Technique::{Aiming, Both, Chance};

    fn variances(half_angle: f64, aim: Aim) -> [f64; 4] {
        let lamp = Overhead { half_angle, aim };
        let all = [
            Chance,
            Aiming,
            Both(Heuristic::Balance),
            Both(Heuristic::Power),
        ];
        all.map(|technique| lamp.variance(technique))
    }

    #[test]
    fn closed_forms() {
        for a in [0.01, 0.1, 0.5, 1.0, 1.5] {
            let sin = libm::sin(a);
            let [chance, aiming, ..] = variances(a, Aim::Angle);
            assert!((chance / (sin * (1.0 - sin)) - 1.0).abs() < 1e-6, "{a}");
            let exact = 0.5 * a * (a + sin * libm::cos(a)) - sin * sin;
            // Of the difference little is left for a small lamp.
            assert!(
                (aiming - exact).abs() < 1e-6 * aiming + 1e-16,
                "{a}: {aiming} {exact}"
            );
            let found = Overhead::new(a).integral(|t| Overhead::new(a).integrand(t));
            assert!((found - sin).abs() < 1e-12);
        }
    }

    #[test]
    fn numbers_found_elsewhere() {
        // Irradiances are twice the radiance of the floor, and variances four times.
        for (a, aim, unit, known) in [
            (0.1, Aim::Angle, 4.0, [0.3595, 8.88e-8, 0.00296, 3.51e-5]),
            (0.5, Aim::Angle, 4.0, [0.998, 0.00134, 0.1054, 0.0357]),
            (1.2, Aim::Angle, 4.0, [0.2534, 0.2158, 0.0936, 0.1112]),
        ] {
            for (found, known) in variances(a, aim).into_iter().zip(known) {
                assert!((unit * found / known - 1.0).abs() < 5e-3, "{a}: {found}");
            }
        }
    }

    #[test]
    fn samples_have_their_densities() {
        for aim in [Aim::Angle, Aim::Length] {
            let lamp = Overhead {
                half_angle: 1.3,
                aim,
            };
            // The derivative of a direction by its uniform is one over its density.
            for k in 1..100 {
                let (u, h) = (f64::from(k) / 100.0, 1e-6);
                let rate = |f: &dyn Fn(f64) -> f64| (f(u + h) - f(u - h)) / (2.0 * h);
                let chance = rate(&|u| lamp.sample_chance(u));
                let aiming = rate(&|u| lamp.sample_aim(u));
                let at_chance = lamp.pdf(lamp.sample_chance(u))[0];
                let at_aiming = lamp.pdf(lamp.sample_aim(u))[1];
                assert!((chance * at_chance - 1.0).abs() < 1e-6);
                assert!((aiming * at_aiming - 1.0).abs() < 1e-6);
            }
        }
    }
}
