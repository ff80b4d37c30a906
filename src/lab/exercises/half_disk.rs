//! Exercise 1: a direction of the half disk, uniform in angle.

use super::exam::mistake;
use super::samplers::{FlatSampler, FlatTruth, flat};
use super::{Entry, Exam};
use crate::numeric::sin_cos;
use crate::sampling::half_disk;
use glam::Vec2;
use std::f32::consts::{FRAC_1_PI, FRAC_PI_2, PI, TAU};
use std::f64::consts;

/// How it is listed.
pub const ENTRY: Entry = Entry {
    number: 1,
    name: "half-disk",
    title: "draw a direction of the half disk, and know its density",
    page: "ch04-half-disk",
    points: 10,
    hints: &[
        "Which angles does the half disk have, counted from the tangent? Stretch the uniform over them.",
        "A direction at the angle θ from the tangent is (cos θ, sin θ). The densities of u and of θ = π u differ by dθ/du.",
    ],
    source: include_str!("../../../examples/exercises/ex01_half_disk.rs"),
};

fn of_angle(theta: f32) -> Vec2 {
    let (sin, cos) = sin_cos(theta);
    Vec2::new(cos, sin)
}

/// Its questions and mistakes.
pub fn exam() -> Exam<FlatSampler> {
    let right = FlatSampler {
        sample: half_disk::sample_uniform,
        pdf: half_disk::pdf_uniform,
    };
    Exam::new(
        &ENTRY,
        flat(FlatTruth {
            y: consts::FRAC_2_PI,
            x2: 0.5,
            up: consts::FRAC_1_PI,
            low: consts::FRAC_1_PI,
        }),
        vec![
            mistake(
                "whole circle",
                "that θ runs over half a turn: half of these directions lie below the surface",
                FlatSampler {
                    sample: |u| of_angle(TAU * u),
                    pdf: |_| 0.5 * FRAC_1_PI,
                },
            ),
            mistake(
                "whole circle, density of the half",
                "that θ runs over half a turn, as your density has it",
                FlatSampler {
                    sample: |u| of_angle(TAU * u),
                    ..right
                },
            ),
            mistake(
                "density of the whole circle",
                "that there are π radians above a surface, not 2π",
                FlatSampler {
                    pdf: |w| if w.y >= 0.0 { 0.5 * FRAC_1_PI } else { 0.0 },
                    ..right
                },
            ),
            mistake(
                "density of the uniform",
                "that a density changes with its variable: u has the density 1, and θ = π u the density 1/π",
                FlatSampler {
                    pdf: |w| if w.y >= 0.0 { 1.0 } else { 0.0 },
                    ..right
                },
            ),
            mistake(
                "density upside down",
                "that the density is one over the π radians above the surface, and not π",
                FlatSampler {
                    pdf: |w| if w.y >= 0.0 { PI } else { 0.0 },
                    ..right
                },
            ),
            mistake(
                "density of a sampler in space",
                "that these directions are equally likely: y/π is the density of another sampler, and of another world",
                FlatSampler {
                    pdf: |w| w.y.max(0.0) * FRAC_1_PI,
                    ..right
                },
            ),
            mistake(
                "density proportional to the cosine",
                "that all these directions are equally likely: sin θ / 2 is the density of the next exercises",
                FlatSampler {
                    pdf: half_disk::pdf_cosine,
                    ..right
                },
            ),
            mistake(
                "density below the surface",
                "that the density is 0 in directions that are never drawn",
                FlatSampler {
                    pdf: |_| FRAC_1_PI,
                    ..right
                },
            ),
            mistake(
                "sine and cosine exchanged",
                "that θ counts from the tangent: x is its cosine, and y its sine",
                FlatSampler {
                    sample: |u| {
                        let (sin, cos) = sin_cos(PI * u);
                        Vec2::new(sin, cos)
                    },
                    ..right
                },
            ),
            mistake(
                "uniform along the tangent",
                "that equal steps along the tangent are not equal angles",
                FlatSampler {
                    sample: |u| {
                        let x = 2.0 * u - 1.0;
                        Vec2::new(x, (1.0 - x * x).max(0.0).sqrt())
                    },
                    ..right
                },
            ),
            mistake(
                "a quarter",
                "that the half disk has two quarters: θ goes on to π",
                FlatSampler {
                    sample: |u| of_angle(FRAC_PI_2 * u),
                    ..right
                },
            ),
        ],
    )
}
