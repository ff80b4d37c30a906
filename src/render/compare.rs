//! How far two pictures are apart.

use super::Picture;
use crate::stats::Estimate;
use crate::stats::z_test::{critical, sidak};

/// Mean squared difference, over all pixels and channels.
///
/// # Panics
///
/// As all functions here: where the pictures are not of the same size.
pub fn mse(a: &Picture, b: &Picture) -> f64 {
    mean(channels(a, b).map(|(x, y)| (x - y).powi(2)))
}

/// Mean squared relative difference `(a - b)² / (b² + 0.01)`, over all pixels and channels; `b` is
/// the reference. The summand keeps black pixels from counting without bound.
pub fn rel_mse(a: &Picture, b: &Picture) -> f64 {
    mean(rel_squares(a, b).into_iter())
}

/// The share of [`rel_mse`] that the worst thousandth of all pixels and channels carries: 0.001 if
/// all were equally far off, near 1 for a few fireflies.
pub fn top_share(a: &Picture, b: &Picture) -> f64 {
    let mut squares = rel_squares(a, b);
    squares.sort_by(|x, y| y.total_cmp(x));
    let top = squares.len().div_ceil(1000);
    let total: f64 = squares.iter().sum();
    squares[..top].iter().sum::<f64>() / total
}

fn rel_squares(a: &Picture, b: &Picture) -> Vec<f64> {
    let relative = |(x, y): (f64, f64)| (x - y).powi(2) / (y * y + 0.01);
    channels(a, b).map(relative).collect()
}

/// How many standard errors two independent pictures are apart, pixel by pixel.
#[derive(Clone, Copy, Debug)]
pub struct ZScores {
    /// The mean of z² over pixels, which is 1 for pictures of the same thing; each pixel counts
    /// with the mean of its channels, which share their samples.
    pub squares: Estimate,
    /// The largest |z| of any pixel and channel.
    pub largest: f64,
    /// The share of pixels and channels that a two-sided test of level 1 % over the whole picture
    /// (Šidák) rejects one by one.
    pub rejected: f64,
    /// The z score of the difference of the two pictures' means.
    pub of_means: f64,
}

/// The z score of each pixel and channel: the difference of the values over its standard error;
/// `None` where either picture does not know its errors.
///
/// Where neither picture has any error, equal values have z = 0 and others an infinite one.
pub fn z_scores(a: &Picture, b: &Picture) -> Option<ZScores> {
    let (a_errors, b_errors) = (a.errors.as_ref()?, b.errors.as_ref()?);
    let mut squares = Estimate::new();
    let (mut largest, mut rejected) = (0.0_f64, 0_usize);
    let count = 3 * a.values.len();
    let line = critical(sidak(0.01, count as u32));
    let errors = a_errors.iter().zip(b_errors);
    for ((x, y), (s, t)) in pixels(a, b).zip(errors) {
        let z = [0, 1, 2].map(|i| {
            let difference = x[i] - y[i];
            if difference == 0.0 {
                0.0
            } else {
                difference / s[i].hypot(t[i])
            }
        });
        squares.add(z.iter().map(|z| z * z).sum::<f64>() / 3.0);
        largest = z.iter().fold(largest, |l, z| l.max(z.abs()));
        rejected += z.iter().filter(|z| z.abs() > line).count();
    }
    let ((a_mean, a_error), (b_mean, b_error)) = (a.mean(), b.mean());
    Some(ZScores {
        squares,
        largest,
        rejected: rejected as f64 / count as f64,
        of_means: (a_mean - b_mean) / a_error?.hypot(b_error?),
    })
}

fn pixels<'a>(
    a: &'a Picture,
    b: &'a Picture,
) -> impl Iterator<Item = (&'a [f64; 3], &'a [f64; 3])> {
    assert_eq!(a.size, b.size);
    a.values.iter().zip(&b.values)
}

fn channels<'a>(a: &'a Picture, b: &'a Picture) -> impl Iterator<Item = (f64, f64)> + 'a {
    pixels(a, b).flat_map(|(p, q)| p.iter().copied().zip(q.iter().copied()))
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    values.collect::<Estimate>().mean()
}
