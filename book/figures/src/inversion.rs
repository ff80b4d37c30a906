//! Chapter 05: a uniform number goes across to a distribution function and down to an angle.

use crate::within;
use halfdisk::glam::Vec2;
use halfdisk::sampling::{LAST_UNIFORM, half_disk};

/// The number that is inverted.
pub const U: [f64; 2] = [0.0, LAST_UNIFORM as f64];
/// Half the width of the interval of numbers around it.
pub const ASIDE: f64 = 1.0 / 24.0;

/// For a number `u`: the angle from the normal in radians, the density there per radian, and the distribution
/// function there; then the same three for `u` less [`ASIDE`] and for `u` plus it.
pub fn law(u: f64) -> Vec<f64> {
    let u = within(u, U);
    let around = [u, within(u - ASIDE, U), within(u + ASIDE, U)];
    around.into_iter().flat_map(inverted).collect()
}

fn inverted(u: f64) -> [f64; 3] {
    let w = half_disk::sample_cosine(u as f32);
    [
        angle(w),
        half_disk::pdf_cosine(w).into(),
        half_disk::invert_cosine(w).into(),
    ]
}

/// The angle from the normal, so that it grows with `u`: the sampler starts at the tangent, on the right.
fn angle(w: Vec2) -> f64 {
    libm::atan2(-f64::from(w.x), w.y.into())
}
