//! Exercise 4: directions proportional to the cosine, by inversion.

use super::exam::mistake;
use super::samplers::{FlatSampler, FlatTruth, flat};
use super::{Entry, Exam};
use crate::numeric::sin_cos;
use crate::sampling::half_disk;
use glam::Vec2;
use std::f32::consts::FRAC_1_PI;
use std::f64::consts::FRAC_PI_4;

/// How it is listed.
pub const ENTRY: Entry = Entry {
    number: 4,
    name: "cosine",
    title: "draw directions proportional to the cosine, by inversion",
    page: "ch05-importance-sampling",
    points: 10,
    hints: &[
        "The cosine with the normal is sin θ. What is its integral over (0, π)? Divide by it, and you have the density.",
        "Integrate the density from 0 to θ, set the result equal to u, and solve for cos θ. You need no θ at all.",
        "cos θ = 1 − 2u. The sine follows from Pythagoras.",
    ],
    source: include_str!("../../../examples/exercises/ex04_cosine.rs"),
};

fn over(x: f32) -> Vec2 {
    Vec2::new(x, (1.0 - x * x).max(0.0).sqrt())
}

/// Its questions and mistakes.
pub fn exam() -> Exam<FlatSampler> {
    let right = FlatSampler {
        sample: half_disk::sample_cosine,
        pdf: half_disk::pdf_cosine,
    };
    Exam::new(
        &ENTRY,
        flat(FlatTruth {
            y: FRAC_PI_4,
            x2: 1.0 / 3.0,
            up: 0.5,
            low: 0.25,
        }),
        vec![
            mistake(
                "uniform directions",
                "to bend the uniform: your directions are uniform in angle, though your density says otherwise",
                FlatSampler {
                    sample: half_disk::sample_uniform,
                    ..right
                },
            ),
            mistake(
                "uniform directions and their density",
                "that these directions shall be proportional to the cosine: yours are uniform, as in exercise 1",
                FlatSampler {
                    sample: half_disk::sample_uniform,
                    pdf: half_disk::pdf_uniform,
                },
            ),
            mistake(
                "uniform density",
                "that the density is no longer 1/π: it is larger where directions are likelier",
                FlatSampler {
                    pdf: half_disk::pdf_uniform,
                    ..right
                },
            ),
            mistake(
                "density not normalised",
                "to divide the density by its integral: the cosine integrates to 2 over the half disk",
                FlatSampler {
                    pdf: |w| w.y.max(0.0),
                    ..right
                },
            ),
            mistake(
                "density of space",
                "that the cosine integrates to π over the hemisphere only; over the half disk it is 2",
                FlatSampler {
                    pdf: |w| w.y.max(0.0) * FRAC_1_PI,
                    ..right
                },
            ),
            mistake(
                "density of the angle from the normal",
                "that y is the cosine with the normal already",
                FlatSampler {
                    pdf: |w| if w.y >= 0.0 { 0.5 * w.x.abs() } else { 0.0 },
                    ..right
                },
            ),
            mistake(
                "a quarter",
                "that cos θ runs from 1 to −1: the distribution is (1 − cos θ)/2",
                FlatSampler {
                    sample: |u| over(1.0 - u),
                    ..right
                },
            ),
            mistake(
                "density inverted, not its integral",
                "to integrate: it is the distribution that is set equal to u, and not the density",
                FlatSampler {
                    sample: |u| Vec2::new((1.0 - u * u).max(0.0).sqrt(), u),
                    ..right
                },
            ),
            mistake(
                "no root",
                "the root: x² + y² = 1, and y² is not y",
                FlatSampler {
                    sample: |u| {
                        let x = 1.0 - 2.0 * u;
                        Vec2::new(x, 1.0 - x * x)
                    },
                    ..right
                },
            ),
            mistake(
                "sine and cosine exchanged",
                "that θ counts from the tangent: x is its cosine, and y its sine",
                FlatSampler {
                    sample: |u| {
                        let w = over(1.0 - 2.0 * u);
                        Vec2::new(w.y, w.x)
                    },
                    ..right
                },
            ),
            mistake(
                "cosine of the uniform",
                "that inversion comes first: 1 − 2u is the cosine of the angle, and not the angle",
                FlatSampler {
                    sample: |u| {
                        let (sin, cos) = sin_cos(1.0 - 2.0 * u);
                        Vec2::new(sin, cos)
                    },
                    ..right
                },
            ),
        ],
    )
}
