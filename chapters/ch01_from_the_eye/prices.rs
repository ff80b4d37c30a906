//! What the same error costs two ways: pictures from the light and from the eye, against the
//! number of rays.

use crate::two_ways::TwoWays;
use halfdisk::render::{Film, compare};
use halfdisk::stats::Estimate;

/// The error of one way at one number of rays.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    /// Rays traced for one picture.
    pub rays: u64,
    /// Root mean square error of a pixel, over replicates.
    pub error: Estimate,
}

/// The errors of both ways, and what they cost.
#[derive(Clone, Debug, Default)]
pub struct Prices {
    /// From the light, by number of rays.
    pub light: Vec<Measured>,
    /// From the eye, by number of rays.
    pub eye: Vec<Measured>,
    /// Logarithm of the rays from the light that buy the error of one ray from the eye, one value
    /// for each pair of pictures.
    pub log_ratio: Estimate,
}

impl Prices {
    /// The ratio itself and its standard error.
    pub fn ratio(&self) -> (f64, f64) {
        let ratio = libm::exp(self.log_ratio.mean());
        (ratio, ratio * self.log_ratio.std_error())
    }
}

/// Renders both ways with `2^k` times as many rays for `k < doublings`, `replicates` times each
/// with seeds from `seed` on, against a `reference` made from another seed.
///
/// The error of an unbiased picture falls as one over the root of its rays, so its squared error
/// times its rays is a price that does not depend on how many there were.
pub fn measure(
    view: &TwoWays,
    reference: &Film,
    doublings: u32,
    replicates: u64,
    seed: u64,
) -> Prices {
    let mut prices = Prices::default();
    for k in 0..doublings {
        let mut rays = [0; 2];
        let mut errors = [Estimate::new(); 2];
        for seed in seed..seed + replicates {
            let runs = [
                view.picture_by_light(20_000 << k, seed),
                view.picture_by_eye(1 << k, seed),
            ];
            let squares = runs
                .each_ref()
                .map(|run| compare::mse(&run.film.picture(), &reference.picture()));
            let price = |i: usize| squares[i] * runs[i].rays as f64;
            prices.log_ratio.add(libm::log(price(0) / price(1)));
            for i in 0..2 {
                rays[i] = runs[i].rays;
                errors[i].add(squares[i].sqrt());
            }
        }
        let measured = |i: usize| Measured {
            rays: rays[i],
            error: errors[i],
        };
        prices.light.push(measured(0));
        prices.eye.push(measured(1));
    }
    prices
}
