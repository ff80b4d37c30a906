//! Exercise 10: two techniques, weighted.

use super::exam::mistake;
use super::{Entry, Exam, Question};
use crate::lab::estimators::overhead::{Aim, Overhead, Technique};
use crate::sampling::mis::Heuristic;

/// One estimate of the light of a lamp overhead, by one direction of each technique: the lamp, two uniforms.
pub type Both = fn(&Overhead, [f64; 2]) -> f64;

/// How it is listed.
pub const ENTRY: Entry = Entry {
    number: 10,
    name: "mis",
    title: "combine chance and aiming by multiple importance sampling",
    page: "ch11-combine",
    points: 10,
    hints: &[
        "Each technique draws a direction and divides by its own density. What goes wrong when both are added up?",
        "Weigh each direction by how likely its own technique was to draw it, p/(p + q). For one direction both weights must add up to 1.",
    ],
    source: include_str!("../../../examples/exercises/ex10_mis.rs"),
};

/// A small lamp, at which aiming is better, and a large one, at which chance is.
const LAMPS: [Overhead; 2] = [
    Overhead {
        half_angle: 0.1,
        aim: Aim::Angle,
    },
    Overhead {
        half_angle: 1.4,
        aim: Aim::Length,
    },
];

/// The directions of both techniques, each with its weight and its density.
fn sum(lamp: &Overhead, u: [f64; 2], weight: impl Fn([f64; 2], usize) -> f64) -> f64 {
    let drawn = [lamp.sample_chance(u[0]), lamp.sample_aim(u[1])];
    let part = |i: usize| {
        let pdf = lamp.pdf(drawn[i]);
        let f = lamp.integrand(drawn[i]);
        if f > 0.0 {
            weight(pdf, i) * f / pdf[i]
        } else {
            0.0
        }
    };
    part(0) + part(1)
}

/// Its questions and mistakes.
pub fn exam() -> Exam<Both> {
    let slip = mistake::<Both>;
    let [small, large] = LAMPS;
    let draw = |lamp: Overhead| move |a: &Both, d: &mut super::Draw| a(&lamp, [d.fine(), d.fine()]);
    let mean = |what, lamp: Overhead| Question::mean(what, lamp.mean(), draw(lamp));
    let variance = |what, lamp: Overhead| {
        // Whoever weighs by either heuristic is as good as can be asked.
        let either = [Heuristic::Balance, Heuristic::Power];
        let most = either
            .map(|h| lamp.variance(Technique::Both(h)))
            .into_iter()
            .fold(0.0, f64::max);
        let draw = draw(lamp);
        Question::variance(what, lamp.mean(), 1.02 * most, move |a: &Both, d| {
            (draw(a, d), 1.0)
        })
    };
    Exam::new(
        &ENTRY,
        vec![
            mean("the light of the large lamp", large),
            mean("the light of the small lamp", small),
            variance("the variance with the large lamp", large),
            variance("the variance with the small lamp", small),
        ],
        vec![
            slip(
                "counted twice",
                "the weights: both techniques find the same light, and it counts twice",
                |lamp, u| sum(lamp, u, |_, _| 1.0),
            ),
            slip(
                "half each",
                "that equal weights keep a quarter of the worse variance: weigh by the densities",
                |lamp, u| sum(lamp, u, |_, _| 0.5),
            ),
            slip(
                "weights exchanged",
                "which weight is whose: a direction counts by the density of the technique that drew it",
                |lamp, u| sum(lamp, u, |pdf, i| pdf[1 - i] / (pdf[0] + pdf[1])),
            ),
            slip(
                "chance alone",
                "to aim: the small lamp is hardly ever met by chance",
                |lamp, u| sum(lamp, u, |_, i| [1.0, 0.0][i]),
            ),
            slip(
                "aiming alone",
                "chance: it is the better one where the lamp is large",
                |lamp, u| sum(lamp, u, |_, i| [0.0, 1.0][i]),
            ),
            slip(
                "chance not weighted",
                "the weight of what chance finds",
                |lamp, u| sum(lamp, u, |pdf, i| [1.0, pdf[1] / (pdf[0] + pdf[1])][i]),
            ),
            slip(
                "aiming not weighted",
                "the weight of what aiming finds",
                |lamp, u| sum(lamp, u, |pdf, i| [pdf[0] / (pdf[0] + pdf[1]), 1.0][i]),
            ),
            slip(
                "power without its sum",
                "that weights add up to 1: squares belong over the sum of squares, p²/(p² + q²)",
                |lamp, u| {
                    sum(lamp, u, |pdf, i| {
                        let share = pdf[i] / (pdf[0] + pdf[1]);
                        share * share
                    })
                },
            ),
            slip(
                "one weight for both directions",
                "that each direction has densities of its own: yours both have the weights of the direction drawn by chance",
                |lamp, u| {
                    let met = lamp.pdf(lamp.sample_chance(u[0]));
                    sum(lamp, u, |_, i| met[i] / (met[0] + met[1]))
                },
            ),
            slip(
                "density forgotten",
                "to divide each direction's light by its density",
                |lamp, u| sum(lamp, u, |pdf, i| pdf[i] * pdf[i] / (pdf[0] + pdf[1])),
            ),
            slip(
                "half of the lamp",
                "that the lamp reaches to both sides: your density of aiming is twice what it is, over half of the lamp",
                |lamp, u| {
                    sum(lamp, u, |[p, q], i| {
                        let q = 2.0 * q;
                        [p / (p + q), 0.5 * q / (p + q)][i]
                    })
                },
            ),
            slip(
                "averaged after weighting",
                "that weights add up to 1 already: no half on top",
                |lamp, u| 0.5 * sum(lamp, u, |pdf, i| pdf[i] / (pdf[0] + pdf[1])),
            ),
        ],
    )
}
