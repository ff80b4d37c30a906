//! The form factor between two patches alone, to as many digits as are asked for.

use super::lambert::{above_horizon, projected};
use super::patches::Patch;
use super::quadrature::{graded, points_on};
use glam::DVec3;

/// Points along each side of the receiver in the first answer, and at most.
const POINTS: [usize; 2] = [8, 1024];

/// The form factor from one patch to another where nothing comes between, in `[0, 1]`, and how far the last
/// answer but one was from it.
///
/// Points on the receiver are doubled along each side until two answers differ by at most `tolerance`; by
/// more where 1024 along a side do not suffice. They crowd towards the edges ([`graded`]): at the ends of an
/// edge that both share, the view jumps from nothing to half of the other patch, and points that lie evenly
/// gain four bits a doubling there and no more.
///
/// Corners are taken as exact: unlike the rows of [`FormFactors`](super::FormFactors), which come of a scene
/// in `f32`, points as near to the other patch as its rounding count.
pub fn form_factor(from: &Patch, to: &Patch, tolerance: f64) -> [f64; 2] {
    let mut above = Vec::with_capacity(8);
    let [mut points, most] = POINTS;
    let mut before = mean(from, to, points, &mut above);
    loop {
        points *= 2;
        let found = mean(from, to, points, &mut above);
        let apart = (found - before).abs();
        if apart <= tolerance || points >= most {
            return [found, apart];
        }
        before = found;
    }
}

/// The mean over so many points along each side of the receiver.
fn mean(from: &Patch, to: &Patch, points: usize, above: &mut Vec<DVec3>) -> f64 {
    let mut sum = 0.0;
    for (p, weight) in points_on(&from.polygon, &graded(points)) {
        if to.height(p) > 0.0 {
            above_horizon(p, from.normal, &to.polygon, above);
            sum += weight * projected(from.normal, above);
        }
    }
    sum
}
