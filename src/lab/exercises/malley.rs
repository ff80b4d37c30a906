//! Exercise 5: Malley's method.

use super::exam::mistake;
use super::samplers::{SolidSampler, cosine_in_space};
use super::{Entry, Exam};
use crate::numeric::sin_cos;
use crate::sampling::hemisphere;
use glam::Vec3;
use std::f32::consts::{FRAC_1_PI, FRAC_PI_2, PI, TAU};

/// How it is listed.
pub const ENTRY: Entry = Entry {
    number: 5,
    name: "malley",
    title: "draw directions proportional to the cosine in space, by Malley's method",
    page: "ch05-importance-sampling",
    points: 10,
    hints: &[
        "Draw a point of the unit disk, uniformly in area, and lift it to the hemisphere above.",
        "A disk of half the radius has a quarter of the area. So which share of the points is closer to the middle than r?",
        "r = √u₀, φ = 2π u₁, z = √(1 − r²). The density is z/π.",
    ],
    source: include_str!("../../../examples/exercises/ex05_malley.rs"),
};

/// A direction with this distance from the axis, height and azimuth.
fn at(r: f32, z: f32, phi: f32) -> Vec3 {
    let (sin, cos) = sin_cos(phi);
    Vec3::new(r * cos, r * sin, z)
}

fn root(x: f32) -> f32 {
    x.max(0.0).sqrt()
}

/// Its questions and mistakes.
pub fn exam() -> Exam<SolidSampler> {
    let right = SolidSampler {
        sample: |[u, v]| at(u.sqrt(), root(1.0 - u), TAU * v),
        pdf: hemisphere::pdf_cosine,
    };
    Exam::new(
        &ENTRY,
        cosine_in_space(),
        vec![
            mistake(
                "radius without a root",
                "that a ring of the disk has an area proportional to its radius: r is √u",
                SolidSampler {
                    sample: |[u, v]| at(u, root(1.0 - u * u), TAU * v),
                    ..right
                },
            ),
            mistake(
                "uniform directions",
                "to draw from the disk: z = 1 − u makes all directions of the hemisphere equally likely",
                SolidSampler {
                    sample: hemisphere::sample_uniform,
                    ..right
                },
            ),
            mistake(
                "uniform directions and their density",
                "that these directions shall be proportional to the cosine: yours are uniform over the hemisphere",
                SolidSampler {
                    sample: hemisphere::sample_uniform,
                    pdf: hemisphere::pdf_uniform,
                },
            ),
            mistake(
                "polar angle uniform",
                "that equal steps of the angle from the normal are not equal solid angles",
                SolidSampler {
                    sample: |[u, v]| {
                        let (sin, cos) = sin_cos(FRAC_PI_2 * u);
                        at(sin, cos, TAU * v)
                    },
                    ..right
                },
            ),
            mistake(
                "half a turn",
                "that the azimuth runs over a whole turn, 2π",
                SolidSampler {
                    sample: |[u, v]| at(u.sqrt(), root(1.0 - u), PI * v),
                    ..right
                },
            ),
            mistake(
                "height without Pythagoras",
                "that a direction has length 1: z = √(1 − r²), and not 1 − r",
                SolidSampler {
                    sample: |[u, v]| at(u.sqrt(), 1.0 - u.sqrt(), TAU * v),
                    ..right
                },
            ),
            mistake(
                "height without a square",
                "the square of the radius: z = √(1 − r²), and not √(1 − r)",
                SolidSampler {
                    sample: |[u, v]| at(u.sqrt(), root(1.0 - u.sqrt()), TAU * v),
                    ..right
                },
            ),
            mistake(
                "a square for the disk",
                "that the corners of the square lie outside of the disk",
                SolidSampler {
                    sample: |[u, v]| {
                        let [x, y] = [u, v].map(|u| 2.0 * u - 1.0);
                        Vec3::new(x, y, (1.0 - x * x - y * y).sqrt())
                    },
                    ..right
                },
            ),
            mistake(
                "density not normalised",
                "to divide the density by its integral: the cosine integrates to π over the hemisphere",
                SolidSampler {
                    pdf: |w| w.z.max(0.0),
                    ..right
                },
            ),
            mistake(
                "density of the flat world",
                "that the cosine integrates to 2 in the flat world only; over the hemisphere it is π",
                SolidSampler {
                    pdf: |w| 0.5 * w.z.max(0.0),
                    ..right
                },
            ),
            mistake(
                "density of the disk",
                "that a density changes with its variable: 1/π is the density on the disk, and the cosine leads from its area to solid angle",
                SolidSampler {
                    pdf: |w| if w.z >= 0.0 { FRAC_1_PI } else { 0.0 },
                    ..right
                },
            ),
            mistake(
                "uniform density",
                "that the density is no longer 1/2π: it is larger where directions are likelier",
                SolidSampler {
                    pdf: hemisphere::pdf_uniform,
                    ..right
                },
            ),
        ],
    )
}
