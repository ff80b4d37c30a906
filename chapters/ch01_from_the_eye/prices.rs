//! What the same error costs two ways: pictures from the light and from the eye, against the
//! number of rays.

use crate::two_ways::TwoWays;
use halfdisk::lab::chapter::{Desk, Number};
use halfdisk::render::{Film, compare};
use halfdisk::stats::Estimate;

/// The error of one way at one number of rays.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    /// Rays traced for one picture.
    pub rays: u64,
    /// Root mean square error of a pixel of the floor, over replicates.
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
    /// The same for the floor alone.
    pub log_ratio_floor: Estimate,
}

/// Records both prices with their errors.
pub fn record(desk: &mut Desk, prices: &Prices) {
    let says = "rays from the light for the error of one ray from the eye";
    for (name, says, log) in [
        ("price", says, &prices.log_ratio),
        (
            "price_floor",
            "  for the floor alone",
            &prices.log_ratio_floor,
        ),
    ] {
        let ratio = libm::exp(log.mean());
        let error = Some(ratio * log.std_error());
        let number = Number::new(says, ratio);
        desk.number(name, Number { error, ..number });
    }
}

/// The part of a picture that shows the floor alone: no ray through it meets the lamp.
fn floor(film: &Film) -> Film {
    let height = film.height();
    film.rows(3 * height / 5..height)
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
                view.picture_by_eye(16 << k, seed),
            ];
            let square =
                |film: &Film, right: &Film| compare::mse(&film.picture(), &right.picture());
            let whole = runs.each_ref().map(|run| square(&run.film, reference));
            let right = floor(reference);
            let squares = (runs.each_ref()).map(|run| square(&floor(&run.film), &right));
            let ratio = |squares: [f64; 2]| {
                let [light, eye] = [0, 1].map(|i| squares[i] * runs[i].rays as f64);
                libm::log(light / eye)
            };
            prices.log_ratio.add(ratio(whole));
            prices.log_ratio_floor.add(ratio(squares));
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
