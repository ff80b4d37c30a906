//! Exercise 2: from local to world coordinates.

use super::exam::mistake;
use super::{Entry, Exam, Question};
use crate::numeric::sin_cos;
use glam::Vec2;
use std::f32::consts::FRAC_PI_6;

/// Turns a local direction (`y` is the normal) into world coordinates, given the unit normal.
pub type ToWorld = fn(Vec2, Vec2) -> Vec2;

/// How it is listed.
pub const ENTRY: Entry = Entry {
    number: 2,
    name: "turn",
    title: "turn a direction from the surface's axes to those of the world",
    page: "ch04-half-disk",
    points: 5,
    hints: &[
        "Where must the local direction (0, 1) point? And where (1, 0)?",
        "The tangent is (n.y, −n.x). A local direction is x times the tangent plus y times the normal.",
    ],
    source: include_str!("../../../examples/exercises/ex02_turn.rs"),
};

/// The normal of a surface that is tilted by 30 degrees to the right.
fn tilted() -> Vec2 {
    let (sin, cos) = sin_cos(FRAC_PI_6);
    Vec2::new(sin, cos)
}

/// A local direction in general position.
const LOCAL: Vec2 = Vec2::new(0.8, 0.6);

fn tangent(n: Vec2) -> Vec2 {
    Vec2::new(n.y, -n.x)
}

/// Its questions and mistakes.
pub fn exam() -> Exam<ToWorld> {
    let root = 3.0_f64.sqrt();
    let slip = mistake::<ToWorld>;
    let exact = |what, truth, n: Vec2, w: Vec2, part: fn(Vec2, Vec2) -> f32| {
        Question::exact(what, truth, move |turn: &ToWorld| {
            part(turn(n, w), n).into()
        })
    };
    Exam::new(
        &ENTRY,
        vec![
            exact(
                "with an upright normal, x of (0.8, 0.6)",
                0.8,
                Vec2::Y,
                LOCAL,
                |w, _| w.x,
            ),
            exact(
                "with an upright normal, y of (0.8, 0.6)",
                0.6,
                Vec2::Y,
                LOCAL,
                |w, _| w.y,
            ),
            exact(
                "with a normal tilted by 30 degrees, the cosine of (0.8, 0.6) with the normal",
                0.6,
                tilted(),
                LOCAL,
                |w, n| w.dot(n),
            ),
            exact(
                "with a normal tilted by 30 degrees, x of (0.8, 0.6)",
                0.4 * root + 0.3,
                tilted(),
                LOCAL,
                |w, _| w.x,
            ),
            exact(
                "with a normal tilted by 30 degrees, y of (0.8, 0.6)",
                -0.4 + 0.3 * root,
                tilted(),
                LOCAL,
                |w, _| w.y,
            ),
            exact(
                "with a normal to the left, x of (0, 1)",
                -1.0,
                Vec2::NEG_X,
                Vec2::Y,
                |w, _| w.x,
            ),
            exact(
                "with a normal downwards, y of (0, 1)",
                -1.0,
                Vec2::NEG_Y,
                Vec2::Y,
                |w, _| w.y,
            ),
        ],
        vec![
            slip(
                "not turned",
                "to turn: your directions stay in the surface's own axes",
                |_, w| w,
            ),
            slip(
                "matrix transposed",
                "that tangent and normal are the columns of the matrix, not its rows",
                |n, w| Vec2::new(w.dot(tangent(n)), w.dot(n)),
            ),
            slip(
                "tangent to the left",
                "that the tangent is the normal turned to the right, (n.y, −n.x): your world is mirrored",
                |n, w| -tangent(n) * w.x + n * w.y,
            ),
            slip(
                "tangent for normal",
                "which axis is which: x goes along the tangent, and y along the normal",
                |n, w| n * w.x + tangent(n) * w.y,
            ),
            slip(
                "tangent not turned",
                "that the tangent turns together with the normal; it is not always (1, 0)",
                |n, w| Vec2::X * w.x + n * w.y,
            ),
            slip(
                "normal not turned",
                "that y goes along the normal; it is not always (0, 1)",
                |n, w| tangent(n) * w.x + Vec2::Y * w.y,
            ),
            slip(
                "tangent not perpendicular",
                "to exchange the coordinates: (n.x, −n.y) is not perpendicular to the normal, and (n.y, −n.x) is",
                |n, w| Vec2::new(n.x, -n.y) * w.x + n * w.y,
            ),
            slip(
                "normal added",
                "to turn: adding the normal moves a direction, and changes its length",
                |n, w| w + n,
            ),
            slip(
                "multiplied",
                "that turning is not a product of coordinates",
                |n, w| n * w,
            ),
        ],
    )
}
