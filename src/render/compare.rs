//! How far two pictures are apart.

use super::{Film, Pixel};
use crate::stats::Estimate;

/// Mean squared difference of the means, over all pixels and channels.
///
/// # Panics
///
/// Where the pictures are not of the same size.
pub fn mse(a: &Film, b: &Film) -> f64 {
    pixels(a, b)
        .flat_map(|(p, q)| p.channels.into_iter().zip(q.channels))
        .map(|(x, y)| (x.mean() - y.mean()).powi(2))
        .collect::<Estimate>()
        .mean()
}

/// How many standard errors two independent pictures are apart, pixel by pixel.
#[derive(Clone, Copy, Debug)]
pub struct ZScores {
    /// The mean of z² over pixels, which is 1 for pictures of the same thing; each pixel counts
    /// with the mean of its channels, which share their samples.
    pub squares: Estimate,
    /// The largest |z| of any pixel and channel.
    pub largest: f64,
}

/// The z score of each pixel and channel: the difference of the means over its standard error.
///
/// Where neither picture has any variance, equal means have z = 0 and others an infinite one.
///
/// # Panics
///
/// Where the pictures are not of the same size.
pub fn z_scores(a: &Film, b: &Film) -> ZScores {
    let mut all = ZScores {
        squares: Estimate::new(),
        largest: 0.0,
    };
    for (p, q) in pixels(a, b) {
        let z = [0, 1, 2].map(|i| {
            let (x, y) = (p.channels[i], q.channels[i]);
            let difference = x.mean() - y.mean();
            let error = (x.std_error().powi(2) + y.std_error().powi(2)).sqrt();
            if difference == 0.0 {
                0.0
            } else {
                difference / error
            }
        });
        all.squares.add(z.iter().map(|z| z * z).sum::<f64>() / 3.0);
        all.largest = z.iter().fold(all.largest, |l, z| l.max(z.abs()));
    }
    all
}

fn pixels<'a>(a: &'a Film, b: &'a Film) -> impl Iterator<Item = (&'a Pixel, &'a Pixel)> {
    assert_eq!((a.width(), a.height()), (b.width(), b.height()));
    a.pixels().iter().zip(b.pixels())
}
