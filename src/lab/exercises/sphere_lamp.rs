//! Exercise 8: a spherical lamp by solid angle.

use super::exam::mistake;
use super::samplers::is_not_one;
use super::{Entry, Exam, Question};
use crate::numeric::{one_minus_cos, sin_cos};
use crate::sampling::warps::sample_cone;
use glam::Vec3;
use std::f32::consts::{FRAC_1_PI, PI, TAU};

/// A sampler of the directions in which a ball is seen whose centre lies on the z axis.
#[derive(Clone, Copy, Debug)]
pub struct Cone {
    /// The ball's distance and radius, and two uniforms in `[0, 1)`, to a unit direction.
    pub sample: fn(f32, f32, [f32; 2]) -> Vec3,
    /// The density of these directions, per steradian, from distance and radius.
    pub pdf: fn(f32, f32) -> f32,
}

/// How it is listed.
pub const ENTRY: Entry = Entry {
    number: 8,
    name: "sphere-lamp",
    title: "draw directions to a spherical lamp, uniformly in solid angle",
    page: "ch09-aim-at-the-light",
    points: 10,
    hints: &[
        "The ball is seen in a cone. A line from the eye that touches the ball makes a right angle with the radius there: sin θ_max = r/d.",
        "The solid angle of the cone is 2π (1 − cos θ_max), and 1 − cos θ is uniform in it.",
        "For a tiny ball 1 − cos θ_max is a difference of two numbers that are nearly 1. Write it as sin² / (1 + cos).",
    ],
    source: include_str!("../../../examples/exercises/ex08_sphere_lamp.rs"),
};

/// A lamp that fills much of the view, and one that is tiny: distance and radius.
const NEAR: [f32; 2] = [2.0, 1.0];
const TINY: [f32; 2] = [1000.0, 0.1];

fn share([d, r]: [f32; 2]) -> f64 {
    let sin2 = (f64::from(r) / f64::from(d)).powi(2);
    sin2 / (1.0 + (1.0 - sin2).sqrt())
}

fn misses(w: Vec3, [d, r]: [f32; 2]) -> bool {
    let w = w.as_dvec3();
    let sin2 = w.truncate().length_squared();
    let most = (f64::from(r) / f64::from(d)).powi(2);
    w.z <= 0.0 || sin2 > most * (1.0 + 1e-4) || w.is_nan()
}

fn by_cos(cos: f32, v: f32) -> Vec3 {
    let (sin_phi, cos_phi) = sin_cos(TAU * v);
    let sin = (1.0 - cos * cos).max(0.0).sqrt();
    Vec3::new(sin * cos_phi, sin * sin_phi, cos)
}

fn cap(d: f32, r: f32) -> f32 {
    one_minus_cos((r / d) * (r / d))
}

/// Its questions and mistakes.
pub fn exam() -> Exam<Cone> {
    let right = Cone {
        sample: |d, r, u| sample_cone(u, cap(d, r)),
        pdf: |d, r| 1.0 / (TAU * cap(d, r)),
    };
    let cos = 1.0 - share(NEAR);
    let z2 = (1.0 + cos + cos * cos) / 3.0;
    let at = |a: &Cone, [d, r]: [f32; 2], u| (a.sample)(d, r, u);
    Exam::new(
        &ENTRY,
        vec![
            Question::never("directions that miss the lamp", move |a: &Cone, d| {
                misses(at(a, NEAR, d.two()), NEAR)
            }),
            Question::never("directions whose length is not 1", move |a: &Cone, d| {
                is_not_one(at(a, NEAR, d.two()).length())
            }),
            Question::mean(
                "the mean of z over your directions",
                0.5 * (1.0 + cos),
                move |a: &Cone, d| at(a, NEAR, d.two()).z.into(),
            ),
            Question::mean(
                "the mean of y over your directions",
                0.0,
                move |a: &Cone, d| at(a, NEAR, d.two()).y.into(),
            ),
            Question::mean(
                "the mean of x² over your directions",
                0.5 * (1.0 - z2),
                move |a: &Cone, d| f64::from(at(a, NEAR, d.two()).x).powi(2),
            ),
            Question::exact(
                "your density times the solid angle of the lamp, with d = 2 and r = 1,",
                1.0,
                |a: &Cone| {
                    f64::from((a.pdf)(NEAR[0], NEAR[1])) * std::f64::consts::TAU * share(NEAR)
                },
            ),
            Question::exact(
                "your density times the solid angle of a tiny lamp, with d = 1000 and r = 0.1,",
                1.0,
                |a: &Cone| {
                    f64::from((a.pdf)(TINY[0], TINY[1])) * std::f64::consts::TAU * share(TINY)
                },
            ),
            Question::never("directions that miss the tiny lamp", move |a: &Cone, d| {
                misses(at(a, TINY, d.two()), TINY)
            }),
            Question::mean(
                "the mean of sin² over that of the edge, for the tiny lamp,",
                0.5,
                move |a: &Cone, d| {
                    let w = at(a, TINY, d.two()).as_dvec3().truncate();
                    w.length_squared() / (2.0 * share(TINY))
                },
            ),
        ],
        vec![
            mistake(
                "digits lost in 1 − cos",
                "that 1 − cos θ_max of a tiny lamp cancels to nothing in f32: write it as sin² / (1 + cos)",
                Cone {
                    sample: |d, r, [u, v]| {
                        let cos_max = (1.0 - (r / d) * (r / d)).sqrt();
                        by_cos(1.0 - u * (1.0 - cos_max), v)
                    },
                    pdf: |d, r| 1.0 / (TAU * (1.0 - (1.0 - (r / d) * (r / d)).sqrt())),
                },
            ),
            mistake(
                "digits lost in the density",
                "that 1 − cos θ_max of a tiny lamp cancels to nothing in f32, in the density as well: write it as sin² / (1 + cos)",
                Cone {
                    pdf: |d, r| 1.0 / (TAU * (1.0 - (1.0 - (r / d) * (r / d)).sqrt())),
                    ..right
                },
            ),
            mistake(
                "tangent for sine",
                "that the line from the eye touches the ball at a right angle to the radius there, not at the centre: sin θ_max = r/d, and not tan",
                Cone {
                    sample: |d, r, u| sample_cone(u, one_minus_cos(r * r / (d * d + r * r))),
                    pdf: |d, r| 1.0 / (TAU * one_minus_cos(r * r / (d * d + r * r))),
                },
            ),
            mistake(
                "angle uniform",
                "that rings of equal width are not equally large: 1 − cos θ is uniform, and θ is not",
                Cone {
                    sample: |d, r, [u, v]| {
                        let (sin, cos) = sin_cos(u * libm::asinf(r / d));
                        let (sin_phi, cos_phi) = sin_cos(TAU * v);
                        Vec3::new(sin * cos_phi, sin * sin_phi, cos)
                    },
                    ..right
                },
            ),
            mistake(
                "whole sphere",
                "that only the cone holds the lamp: the whole sphere of directions is 4π",
                Cone {
                    sample: |_, _, [u, v]| by_cos(1.0 - 2.0 * u, v),
                    pdf: |_, _| 0.25 * FRAC_1_PI,
                },
            ),
            mistake(
                "hemisphere",
                "that only the cone holds the lamp: the hemisphere is 2π",
                Cone {
                    sample: |_, _, [u, v]| by_cos(1.0 - u, v),
                    pdf: |_, _| 0.5 * FRAC_1_PI,
                },
            ),
            mistake(
                "density of the area",
                "to change from area to solid angle: 1/4πr² is a density per square metre of the lamp",
                Cone {
                    pdf: |_, r| 0.25 * FRAC_1_PI / (r * r),
                    ..right
                },
            ),
            mistake(
                "2π forgotten",
                "that the cone goes all the way around: its solid angle is 2π (1 − cos θ_max)",
                Cone {
                    pdf: |d, r| 1.0 / cap(d, r),
                    ..right
                },
            ),
            mistake(
                "solid angle for density",
                "that the density is one over the solid angle",
                Cone {
                    pdf: |d, r| TAU * cap(d, r),
                    ..right
                },
            ),
            mistake(
                "half a turn",
                "that the azimuth runs over a whole turn, 2π",
                Cone {
                    sample: |d, r, [u, v]| sample_cone([u, 0.5 * v], cap(d, r)),
                    ..right
                },
            ),
            mistake(
                "solid angle of a disc",
                "that a ball is larger in the view than its disc: π r²/d² is right only for tiny lamps",
                Cone {
                    pdf: |d, r| d * d / (PI * r * r),
                    ..right
                },
            ),
        ],
    )
}
