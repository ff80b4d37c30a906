//! The light that a point gets from a polygon of constant radiance, exactly: Lambert's formula.
//!
//! Sources: Lambert, Photometria (1760); Baum, Rushmeier, Winget, Improving Radiosity Solutions
//! Through the Use of Analytically Determined Form-Factors (SIGGRAPH 1989), for its use as the inner
//! integral; Sutherland, Hodgman, Reentrant Polygon Clipping (CACM 17(1), 1974).

use glam::DVec3;
use std::f64::consts::TAU;

/// The form factor from a point to a polygon that nothing hides, in `[0, 1]`: irradiance over π times
/// the polygon's radiance.
///
/// * `n`: the unit normal at `p`. Only what lies above the horizon counts.
/// * `polygon`: convex and flat, wound either way; `p` does not lie within it.
pub fn point_to_polygon(p: DVec3, n: DVec3, polygon: &[DVec3]) -> f64 {
    let mut above = Vec::with_capacity(polygon.len() + 1);
    above_horizon(p, n, polygon, &mut above);
    projected(n, &above)
}

/// Clips a polygon to the half space above a point, into `above`: corners relative to `p`, none where
/// no area is above.
pub(super) fn above_horizon(p: DVec3, n: DVec3, polygon: &[DVec3], above: &mut Vec<DVec3>) {
    above.clear();
    let Some(&last) = polygon.last() else { return };
    let mut before = last - p;
    let mut height_before = n.dot(before);
    for &corner in polygon {
        let here = corner - p;
        let height = n.dot(here);
        if (height > 0.0) != (height_before > 0.0) {
            // A corner just on the horizon is one end of this edge.
            let share = height_before / (height_before - height);
            above.push(before + (here - before) * share);
        }
        if height > 0.0 {
            above.push(here);
        }
        (before, height_before) = (here, height);
    }
    if above.len() < 3 {
        above.clear();
    }
}

/// The share of the projected hemisphere that a polygon takes up, its corners relative to the point.
///
/// Each edge is a great circle's arc on the sphere around the point; seen from above it bounds, with the
/// centre, the projection of a disk's sector whose area is half its angle.
pub(super) fn projected(n: DVec3, polygon: &[DVec3]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    let arcs = polygon.iter().zip(next).map(|(a, b)| {
        let cross = a.cross(*b);
        let length = cross.length();
        if length > 0.0 {
            libm::atan2(length, a.dot(*b)) * (n.dot(cross) / length)
        } else {
            0.0
        }
    });
    (arcs.sum::<f64>() / TAU).abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(z: f64, half: f64) -> [DVec3; 4] {
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[x, y]| DVec3::new(x * half, y * half, z))
    }

    fn near(x: f64, y: f64, tolerance: f64) {
        assert!((x - y).abs() < tolerance, "{x} is not {y}");
    }

    #[test]
    fn a_square_overhead_is_its_closed_form() {
        // Four times that of a corner: a/√(1+a²) atan(b/√(1+a²)) + ..., over 2π.
        let (half, z) = (0.7, 1.3);
        let a = half / z;
        let root = libm::sqrt(1.0 + a * a);
        let corner = 2.0 * a / root * libm::atan(a / root) / TAU;
        let found = point_to_polygon(DVec3::ZERO, DVec3::Z, &square(z, half));
        near(found, 4.0 * corner, 1e-15);
        let mut turned = square(z, half);
        turned.reverse();
        near(
            point_to_polygon(DVec3::ZERO, DVec3::Z, &turned),
            found,
            1e-15,
        );
    }

    #[test]
    fn all_that_is_above_is_one() {
        near(
            point_to_polygon(DVec3::ZERO, DVec3::Z, &square(1e-9, 1.0)),
            1.0,
            1e-8,
        );
        assert_eq!(
            point_to_polygon(DVec3::ZERO, -DVec3::Z, &square(1.0, 1.0)),
            0.0
        );
    }

    #[test]
    fn what_is_below_the_horizon_does_not_count() {
        // A wall at x = 1 from far below to far above: half of what a wall around would be.
        let wall = |low: f64| {
            [[-1.0, low], [1.0, low], [1.0, 2.0], [-1.0, 2.0]].map(|[y, z]| DVec3::new(1.0, y, z))
        };
        let above = point_to_polygon(DVec3::ZERO, DVec3::Z, &wall(0.0));
        near(
            point_to_polygon(DVec3::ZERO, DVec3::Z, &wall(-7.0)),
            above,
            1e-15,
        );
        let unclipped = projected(DVec3::Z, &wall(-7.0));
        assert!(
            (unclipped - above).abs() > 0.05,
            "{unclipped}: the plain form"
        );
    }
}
