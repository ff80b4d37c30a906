//! Two patches that touch: from centre to centre, and exactly.

use glam::DVec3;
use halfdisk::radiosity::{Patch, RadiosityError, form_factor};
use std::f64::consts::PI;

/// The form factor of a strip of the floor to the wall that it lies along: plain and ours.
///
/// * `width`: of the strip. Both are of length 1, and the wall is of height 1.
pub fn along_a_wall(width: f64) -> Result<[f64; 2], RadiosityError> {
    let square = |corners: [[f64; 3]; 4]| {
        let corners = corners.map(DVec3::from).to_vec();
        Patch::new(corners, [0.5; 3], [0.0; 3])
    };
    let strip = square([[0., 0., 0.], [0., 0., 1.], [width, 0., 1.], [width, 0., 0.]])?;
    let wall = square([[0., 0., 0.], [0., 1., 0.], [0., 1., 1.], [0., 0., 1.]])?;
    Ok([centres(&strip, &wall), form_factor(&strip, &wall, 1e-10)[0]])
}

/// The kernel at the centres, times an area.
fn centres(from: &Patch, to: &Patch) -> f64 {
    let [p, q] = [from, to].map(|patch| patch.polygon.iter().sum::<DVec3>() / 4.0);
    let way = q - p;
    let cosines = from.normal.dot(way) * -to.normal.dot(way);
    cosines.max(0.0) * to.area / (PI * way.length_squared().powi(2))
}
