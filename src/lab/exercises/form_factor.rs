//! Exercise 12: a form factor by crossed strings.

use super::exam::mistake;
use super::{Entry, Exam, Question};
use glam::DVec2;
use std::f64::consts::{FRAC_1_PI, SQRT_2};

/// The form factor from one wall to another that nothing hides, each given by its two ends. A wall's front is on the
/// left of the way from its first end to its second.
pub type FormFactor = fn([DVec2; 2], [DVec2; 2]) -> f64;

/// How it is listed.
pub const ENTRY: Entry = Entry {
    number: 12,
    name: "form-factor",
    title: "compute a form factor with crossed strings",
    page: "ch15-patches",
    points: 10,
    hints: &[
        "Four strings join the ends of the two walls. Two of them cross, two do not.",
        "Crossed strings less the others, over twice the length of the wall that sends.",
        "Both fronts are on the left, so the first end of one wall is opposite the second end of the other.",
    ],
    source: include_str!("../../../examples/exercises/ex12_form_factor.rs"),
};

const fn wall(x0: f64, y0: f64, x1: f64, y1: f64) -> [DVec2; 2] {
    [DVec2::new(x0, y0), DVec2::new(x1, y1)]
}

/// The walls of a unit square, seen from within, and a long wall below a short one.
const FLOOR: [DVec2; 2] = wall(0.0, 0.0, 1.0, 0.0);
const RIGHT: [DVec2; 2] = wall(1.0, 0.0, 1.0, 1.0);
const CEILING: [DVec2; 2] = wall(1.0, 1.0, 0.0, 1.0);
const LEFT: [DVec2; 2] = wall(0.0, 1.0, 0.0, 0.0);
const LONG: [DVec2; 2] = wall(-1.0, 0.0, 1.0, 0.0);
const SHORT: [DVec2; 2] = wall(0.5, 1.0, -0.5, 1.0);

/// Crossed strings less the others.
fn strings(a: [DVec2; 2], b: [DVec2; 2]) -> f64 {
    crossed(a, b) - uncrossed(a, b)
}

fn crossed(a: [DVec2; 2], b: [DVec2; 2]) -> f64 {
    a[0].distance(b[0]) + a[1].distance(b[1])
}

fn uncrossed(a: [DVec2; 2], b: [DVec2; 2]) -> f64 {
    a[0].distance(b[1]) + a[1].distance(b[0])
}

fn length(a: [DVec2; 2]) -> f64 {
    a[0].distance(a[1])
}

fn middle(a: [DVec2; 2]) -> DVec2 {
    0.5 * (a[0] + a[1])
}

/// Its questions and mistakes.
pub fn exam() -> Exam<FormFactor> {
    let slip = mistake::<FormFactor>;
    let from_long = (13.0_f64.sqrt() - 5.0_f64.sqrt()) / 4.0;
    let ask = |what, truth, a: [DVec2; 2], b: [DVec2; 2]| {
        Question::exact(what, truth, move |f: &FormFactor| f(a, b))
    };
    Exam::new(
        &ENTRY,
        vec![
            ask(
                "the form factor of the floor and ceiling of a unit square",
                SQRT_2 - 1.0,
                FLOOR,
                CEILING,
            ),
            ask(
                "the form factor of two walls that meet at a right angle",
                1.0 - 0.5 * SQRT_2,
                FLOOR,
                RIGHT,
            ),
            ask(
                "the form factor from a wall of length 2 to one of length 1 above it",
                from_long,
                LONG,
                SHORT,
            ),
            ask(
                "the form factor from a wall of length 1 to one of length 2 below it",
                2.0 * from_long,
                SHORT,
                LONG,
            ),
            Question::exact(
                "the sum of a row of a square room",
                1.0,
                |f: &FormFactor| {
                    [RIGHT, CEILING, LEFT]
                        .into_iter()
                        .map(|other| f(FLOOR, other))
                        .sum()
                },
            ),
        ],
        vec![
            slip(
                "not halved",
                "the half: crossed strings less the others, over twice the length",
                |a, b| strings(a, b) / length(a),
            ),
            slip(
                "not divided by the length",
                "the length of the wall that sends: form factors are shares of its light",
                |a, b| 0.5 * strings(a, b),
            ),
            slip(
                "divided by the other length",
                "which wall sends: a row of the matrix belongs to the first wall, and yours is its column",
                |a, b| 0.5 * strings(a, b) / length(b),
            ),
            slip(
                "multiplied by the length",
                "that form factors are shares: divide by the length",
                |a, b| 0.5 * strings(a, b) * length(a),
            ),
            slip(
                "strings exchanged",
                "which strings cross: both fronts are on the left, so first end and first end are joined by a crossed one",
                |a, b| -0.5 * strings(a, b) / length(a),
            ),
            slip(
                "crossed strings alone",
                "to take the uncrossed strings away",
                |a, b| 0.5 * crossed(a, b) / length(a),
            ),
            slip(
                "strings added",
                "to take the uncrossed strings away: yours are added",
                |a, b| 0.5 * (crossed(a, b) + uncrossed(a, b)) / length(a),
            ),
            slip(
                "squared strings",
                "the roots: strings are lengths, not squares of lengths",
                |a, b| {
                    let square = |i: usize, j: usize| a[i].distance_squared(b[j]);
                    let crossed = square(0, 0) + square(1, 1);
                    0.5 * (crossed - square(0, 1) - square(1, 0)) / length(a)
                },
            ),
            slip(
                "from middle to middle",
                "that walls have an extent: the formula at their middles is right only far away",
                |a, b| {
                    let way = middle(b) - middle(a);
                    let normal = |w: [DVec2; 2]| (w[1] - w[0]).perp().normalize();
                    let wi = way.normalize();
                    0.5 * normal(a).dot(wi) * -normal(b).dot(wi) * length(b) / way.length()
                },
            ),
            slip(
                "over π",
                "that this is the flat world: 1/π belongs to space",
                |a, b| FRAC_1_PI * strings(a, b) / length(a),
            ),
            slip(
                "half of the strings",
                "that there are two crossed strings and two others",
                |a, b| 0.5 * (a[0].distance(b[0]) - a[0].distance(b[1])) / length(a),
            ),
        ],
    )
}
