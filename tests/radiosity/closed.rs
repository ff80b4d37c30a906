//! Form factors of axis-parallel rectangles in closed form.
//!
//! Sources: Gross, Spindler, Hahne, Shapefactor-Equations for Radiation Heat Transfer Between Plane
//! Rectangular Surfaces of Arbitrary Position and Size (Letters in Heat and Mass Transfer 8, 1981); Ehlert,
//! Smith, View Factors for Perpendicular and Parallel, Rectangular Plates (JTHT 7(1), 1993).

use std::f64::consts::TAU;

/// A rectangle across an axis, from its lowest to its highest corner.
#[derive(Clone, Copy, Debug)]
pub struct Rectangle {
    pub axis: usize,
    pub low: [f64; 3],
    pub high: [f64; 3],
}

impl Rectangle {
    pub fn area(&self) -> f64 {
        let sides = (0..3).filter(|d| *d != self.axis);
        sides.map(|d| self.high[d] - self.low[d]).product()
    }
}

/// The form factor from `i` to `j`, which face each other wholly.
pub fn form_factor(i: &Rectangle, j: &Rectangle) -> f64 {
    let sum = if i.axis == j.axis {
        parallel(i, j)
    } else {
        perpendicular(i, j)
    };
    sum.abs() / i.area()
}

/// Sixteen combinations of ends, with a sign each.
fn over_ends(term: impl Fn([usize; 4]) -> f64) -> f64 {
    let bits = |k: usize| [k & 1, k >> 1 & 1, k >> 2 & 1, k >> 3 & 1];
    let sign = |k: usize| {
        if k.count_ones().is_multiple_of(2) {
            1.0
        } else {
            -1.0
        }
    };
    (0..16).map(|k| sign(k) * term(bits(k))).sum()
}

fn parallel(i: &Rectangle, j: &Rectangle) -> f64 {
    let [a, b] = [(i.axis + 1) % 3, (i.axis + 2) % 3];
    let z = i.low[i.axis] - j.low[j.axis];
    let [ends_i, ends_j] = [[i.low, i.high], [j.low, j.high]];
    over_ends(|[l, k, n, m]| {
        let (x, y) = (ends_i[l][a] - ends_j[k][a], ends_i[n][b] - ends_j[m][b]);
        let [p, q] = [x, y].map(|s| libm::sqrt(s * s + z * z));
        let arcs = y * p * libm::atan(y / p) + x * q * libm::atan(x / q);
        (arcs - 0.5 * z * z * libm::log(x * x + y * y + z * z)) / TAU
    })
}

fn perpendicular(i: &Rectangle, j: &Rectangle) -> f64 {
    // Along the common edge line, and away from it.
    let e = 3 - i.axis - j.axis;
    let [ends_i, ends_j] = [[i.low, i.high], [j.low, j.high]];
    over_ends(|[l, k, n, m]| {
        let x = ends_i[l][j.axis] - j.low[j.axis];
        let y = ends_j[k][i.axis] - i.low[i.axis];
        let along = ends_i[n][e] - ends_j[m][e];
        let square = x * x + y * y;
        let root = libm::sqrt(square);
        let arc = if root > 0.0 {
            along * root * libm::atan(along / root)
        } else {
            0.0
        };
        let all = square + along * along;
        let log = if all > 0.0 {
            (square - along * along) * libm::log(all)
        } else {
            0.0
        };
        (arc - 0.25 * log) / TAU
    })
}

#[test]
fn known_form_factors_of_squares() {
    let floor = Rectangle {
        axis: 2,
        low: [0.0; 3],
        high: [1.0, 1.0, 0.0],
    };
    let ceiling = Rectangle {
        low: [0.0, 0.0, 1.0],
        high: [1.0; 3],
        ..floor
    };
    let wall = Rectangle {
        axis: 0,
        low: [0.0; 3],
        high: [0.0, 1.0, 1.0],
    };
    let off = |found: f64, known: f64| assert!((found - known).abs() < 1e-10, "{found} {known}");
    off(form_factor(&floor, &ceiling), 0.199_824_895_7);
    off(form_factor(&floor, &wall), 0.200_043_776_1);
    // One floor sees a ceiling and four walls, and nothing else.
    let all = form_factor(&floor, &ceiling) + 4.0 * form_factor(&floor, &wall);
    assert!((all - 1.0).abs() < 1e-14, "{all}");
}
