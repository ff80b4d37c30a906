//! One integral in as many dimensions as you like, by a grid and by chance.
//!
//! The integrand is `Π (π/2) sin(π xᵢ)` over the unit cube; its integral is 1 in every dimension.

use crate::sampling::stream::{Purpose, Stream};
use crate::stats::Estimate;
use std::f64::consts::PI;

/// By the middles of a grid with `steps` cells along each of `dimensions` axes.
///
/// `N = steps^dimensions` points, and the error is close to `dimensions · π² / 24 · N^(-2/d)`. The
/// sum of a product over a grid is the product of the sums, so no more than `steps` points have to
/// be looked at: large grids can be judged here that nobody could afford.
pub fn grid(dimensions: u32, steps: u32) -> f64 {
    let middle = |i| (f64::from(i) + 0.5) / f64::from(steps);
    let along_one_axis = (0..steps).map(|i| factor(middle(i))).sum::<f64>() / f64::from(steps);
    (0..dimensions).fold(1.0, |product, _| product * along_one_axis)
}

/// By `n` random points. The error is `√((π²/8)^d - 1) / √n`: the dimension changes its size, and
/// never its slope.
pub fn monte_carlo(dimensions: u32, n: u32, seed: u64) -> Estimate {
    let mut u = Stream::new(seed, dimensions, 0).at(0, Purpose::Integrand);
    (0..n)
        .map(|_| {
            let mut product = 1.0;
            for _ in 0..dimensions {
                product *= factor(f64::from(u.one()));
            }
            product
        })
        .collect()
}

/// The standard deviation of one random point.
pub fn deviation(dimensions: u32) -> f64 {
    (libm::pow(PI * PI / 8.0, f64::from(dimensions)) - 1.0).sqrt()
}

fn factor(x: f64) -> f64 {
    0.5 * PI * libm::sin(PI * x)
}
