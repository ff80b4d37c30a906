//! How far two pictures are apart.

use super::Picture;
use super::accuracy::{self, true_squares};
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

/// The squared relative error of `a` against the reference `b`, mean over the pixels: the square of
/// [`true_error`](super::accuracy::true_error).
pub fn rel_mse(a: &Picture, b: &Picture) -> f64 {
    accuracy::mean(true_squares(a, b))
}

/// The share of [`rel_mse`] that the worst thousandth of the pixels carries: 0.001 if all were
/// equally far off, near 1 for a few fireflies.
pub fn top_share(a: &Picture, b: &Picture) -> f64 {
    accuracy::top_share(true_squares(a, b))
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

#[cfg(test)]
mod tests {
    use super::*;

    fn grey(values: &[f64]) -> Picture {
        Picture {
            size: [values.len() as u32, 1],
            values: values.iter().map(|x| [*x; 3]).collect(),
            errors: None,
        }
    }

    #[test]
    fn errors_are_relative_to_the_reference_and_not_to_the_estimate() {
        let (estimate, truth) = (grey(&[3.0, 1.0]), grey(&[1.0, 1.0]));
        // A difference of 2, of one pixel of two: relative to 1, or the other way round to 2.
        assert_eq!(rel_mse(&estimate, &truth), 2.0);
        assert_eq!(rel_mse(&truth, &estimate), 0.5);
        // All of it scaled is the same error: no constant in it has a unit.
        let scaled = |p: &[f64]| grey(&p.iter().map(|x| x / 1024.0).collect::<Vec<_>>());
        assert_eq!(rel_mse(&scaled(&[3.0, 1.0]), &scaled(&[1.0, 1.0])), 2.0);
    }

    #[test]
    fn the_top_share_is_that_of_the_reference() {
        // Of two equal differences one is at a dark place and one beside bright pixels: the first counts
        // sixteen times as much. In the estimate the places are exchanged.
        let row = |left: f64, right: f64| {
            let mut values = vec![1.0; 40];
            values[..9].fill(left);
            values[31..].fill(right);
            values
        };
        let mut truth = row(1.0, 17.0);
        let mut estimate = truth.clone();
        truth[4] = 1.0;
        estimate[4] += 2.0;
        estimate[35] += 2.0;
        let [a, b] = [&estimate, &truth].map(|values| grey(values));
        let scale = accuracy::brightness(&b);
        let [dark, bright] = [4, 35].map(|i| (2.0 / scale[i]).powi(2));
        assert!(dark > 4.0 * bright, "{dark} {bright}");
        let share = top_share(&a, &b);
        assert!((share - dark / (dark + bright)).abs() < 1e-12, "{share}");
        // Of no difference there is no share.
        assert_eq!(top_share(&b, &b), 0.0);
    }

    #[test]
    fn what_is_black_has_no_error_unless_something_is_there() {
        let black = grey(&[0.0, 0.0]);
        assert_eq!(rel_mse(&black, &black), 0.0);
        assert_eq!(rel_mse(&grey(&[0.1, 0.0]), &black), f64::INFINITY);
    }
}
