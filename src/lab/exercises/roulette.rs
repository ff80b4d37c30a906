//! Exercise 7: a path that ends by chance.

use super::exam::mistake;
use super::{Entry, Exam, Question};
use crate::sampling::stream::Numbers;

/// One path in a room whose walls emit 1 and reflect the share `rho`; it survives each of them with the probability `q`.
pub type Path = fn(f64, f64, &mut Numbers) -> f64;

/// How it is listed.
pub const ENTRY: Entry = Entry {
    number: 7,
    name: "roulette",
    title: "end a path by Russian roulette, without losing light",
    page: "ch10-roulette",
    points: 10,
    hints: &[
        "A loop: add what the wall emits, then ask whether the path goes on.",
        "A path that goes on also stands for those that ended: what it brings counts 1/q.",
    ],
    source: include_str!("../../../examples/exercises/ex07_roulette.rs"),
};

/// The second moment of a path: chapter 10's first exercise.
fn second_moment(rho: f64, q: f64) -> f64 {
    (1.0 + rho) / (1.0 - rho) / (1.0 - rho * rho / q)
}

/// A path that goes on by `survives`, with the factor `on` on its throughput; `last` is what it adds at its end.
fn walk(
    u: &mut Numbers,
    survives: impl Fn(f64) -> bool,
    on: f64,
    last: impl Fn(f64) -> f64,
) -> f64 {
    let (mut li, mut beta) = (0.0, 1.0);
    for _ in 0..10_000 {
        li += beta;
        if !survives(u.fine()) {
            return li + last(beta);
        }
        beta *= on;
    }
    li
}

/// Its questions and mistakes.
pub fn exam() -> Exam<Path> {
    let slip = mistake::<Path>;
    let mean = |what, rho: f64, q: f64| {
        Question::mean(what, 1.0 / (1.0 - rho), move |a: &Path, d| {
            a(rho, q, d.numbers())
        })
    };
    let variance = |what, rho: f64, q: f64| {
        let mean = 1.0 / (1.0 - rho);
        let truth = second_moment(rho, q) - mean * mean;
        Question::variance(what, mean, truth, move |a: &Path, d| {
            (a(rho, q, d.numbers()), 1.0)
        })
    };
    Exam::new(
        &ENTRY,
        vec![
            mean("the room with ρ = 0.5, at q = 0.8,", 0.5, 0.8),
            mean("the room with ρ = 0.8, at q = 0.9,", 0.8, 0.9),
            mean("the room with ρ = 0.5, at q = 0.5,", 0.5, 0.5),
            mean("the room with ρ = 0, at q = 0.5,", 0.0, 0.5),
            variance("the variance with ρ = 0.5, at q = 0.8,", 0.5, 0.8),
            variance("the variance with ρ = 0.8, at q = 0.9,", 0.8, 0.9),
        ],
        vec![
            slip(
                "survivors not weighted",
                "to divide by q: a path that goes on stands for those that ended, and every wall looks darker by q",
                |rho, q, u| walk(u, |u| u < q, rho, |_| 0.0),
            ),
            slip(
                "survivors weighted the wrong way",
                "that survivors count more, 1/q, and not less",
                |rho, q, u| walk(u, |u| u < q, rho * q, |_| 0.0),
            ),
            slip(
                "survival and end exchanged",
                "that q is the probability to go on, and not to end",
                |rho, q, u| walk(u, |u| u >= q, rho / q, |_| 0.0),
            ),
            slip(
                "first light lost",
                "what the first wall emits: it reaches the eye undimmed, before any roulette",
                |rho, q, u| walk(u, |u| u < q, rho / q, |_| 0.0) - 1.0,
            ),
            slip(
                "roulette before the first light",
                "that the first wall is seen for certain: roulette comes after its light is added",
                |rho, q, u| match u.fine() < q {
                    true => walk(u, |u| u < q, rho / q, |_| 0.0),
                    false => 0.0,
                },
            ),
            slip(
                "only the last light",
                "to add: every wall on the way emits, and not only the last one",
                |rho, q, u| {
                    let mut beta = 1.0;
                    while u.fine() < q {
                        beta *= rho / q;
                    }
                    beta
                },
            ),
            slip(
                "cut off",
                "that no path may be cut: the light of the longer ones is lost for good",
                |rho, q, u| {
                    let (mut li, mut beta) = (0.0, 1.0);
                    for _ in 0..8 {
                        li += beta;
                        if u.fine() >= q {
                            break;
                        }
                        beta *= rho / q;
                    }
                    li
                },
            ),
            slip(
                "the dead paid as well",
                "that a path that ended brings nothing more: only survivors count 1/q",
                |rho, q, u| walk(u, |u| u < q, rho / q, |beta| beta * (1.0 / q - 1.0)),
            ),
            slip(
                "reflected with its own light",
                "that a wall's own light is not dimmed by it: add first, then multiply by ρ",
                |rho, q, u| rho * walk(u, |u| u < q, rho / q, |_| 0.0),
            ),
            slip(
                "a new throughput",
                "that throughput is a product over all walls so far; yours knows the last wall only",
                |rho, q, u| {
                    let mut li = 1.0;
                    while u.fine() < q {
                        li += rho / q;
                    }
                    li
                },
            ),
        ],
    )
}
