//! How far a picture is from the truth, by its own account, and what it would take to be closer.
//!
//! # The relative error
//!
//! One definition serves renders, maps, prices, effects and comparisons. With values `x` of a pixel and
//! the truth `t`, the squared relative error of the pixel is the mean over its three channels of
//!
//! ```text
//! (x - t)² / b²
//! ```
//!
//! where `b` is the brightness around the pixel in the truth: the mean over channels of the 9 x 9 pixels
//! around it, or of the whole picture where that is brighter ([`brightness`]). The relative error of the
//! picture is the root of the mean over its pixels. Where there is no truth to compare with, the squared
//! standard error stands for `(x - t)²` and the picture itself for the truth.
//!
//! The square is a relMSE, as in Rousselle, Knaus, Zwicker, Adaptive Sampling and Reconstruction using
//! Greedy Error Minimization (SIGGRAPH Asia 2011). There a pixel counts relative to its own value, and a
//! small constant keeps black ones from counting without bound. Such a constant has a unit, so the error
//! would change with the exposure; and relative to its own value, a dark pixel that a single bright
//! sample hits would seem to have a small error. Without any division, the edge of a lamp would count
//! more than all the rest of the picture.

use super::{Film, Picture, Pixel};
use crate::stats::{Estimate, quantile};

/// How the errors of all pixels become one number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Measure {
    /// The root of their mean square.
    #[default]
    RootMeanSquare,
    /// The error that this share of the pixels, in (0, 1], does not exceed. One pixel's error is known
    /// from few runs, so that of few samples this is a rough guide.
    Quantile(f64),
}

impl Measure {
    fn of(self, squares: Vec<f64>) -> f64 {
        match self {
            Measure::RootMeanSquare => mean(squares).sqrt(),
            Measure::Quantile(share) => quantile(squares, share).sqrt(),
        }
    }
}

/// The mean of squares; infinite where one of them is, for an estimate would make it no number.
pub(super) fn mean(squares: Vec<f64>) -> f64 {
    if squares.contains(&f64::INFINITY) {
        return f64::INFINITY;
    }
    squares.into_iter().collect::<Estimate>().mean()
}

/// The standard error of each pixel of a film, relative to the brightness around it.
#[derive(Clone, Debug)]
pub struct Accuracy {
    width: u32,
    /// Row by row from the top.
    pixels: Vec<Known>,
}

#[derive(Clone, Copy, Debug)]
struct Known {
    /// Squared standard error, mean over the channels.
    square: f64,
    /// The same relative to the squared brightness around.
    relative: f64,
    samples: u64,
}

impl Accuracy {
    /// The accuracy of a film. Pixels without a single finite sample have no part in it.
    pub fn of(film: &Film) -> Self {
        let scale = Scale::of(&film.picture());
        let known = |(i, pixel): (usize, &Pixel)| {
            let square = match pixel.count() {
                0 => 0.0,
                _ => pixel.std_errors().iter().map(|e| e * e).sum::<f64>() / 3.0,
            };
            Known {
                square,
                relative: scale.relative(i, square),
                samples: pixel.count(),
            }
        };
        Accuracy {
            width: film.width(),
            pixels: film.pixels().iter().enumerate().map(known).collect(),
        }
    }

    /// Width of the picture in pixels.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// The relative errors of all pixels as one number; infinite where one is not known.
    pub fn error(&self, measure: Measure) -> f64 {
        measure.of(self.squares().collect())
    }

    /// The relative standard error of the root mean square, as far as the scatter of pixels tells.
    pub fn uncertainty(&self) -> f64 {
        let squares: Estimate = self.squares().collect();
        0.5 * squares.std_error() / squares.mean()
    }

    /// The share of pixels whose error is at most `error`.
    pub fn share_within(&self, error: f64) -> f64 {
        let within = self.squares().filter(|&s| s <= error * error).count();
        within as f64 / self.pixels.len() as f64
    }

    /// The share of the squared error that the worst thousandth of the pixels carries: 0.001 if all
    /// were alike, near 1 for a few fireflies.
    pub fn top_share(&self) -> f64 {
        top_share(self.squares().collect())
    }

    /// For each pixel, the samples it would take for a relative error of `target`, if the variance
    /// falls as one over their number; infinite where the error is not known.
    pub fn required(&self, target: f64) -> Vec<f64> {
        let need = |p: &Known| p.samples as f64 * p.relative / (target * target);
        self.pixels.iter().map(need).collect()
    }

    /// For each pixel, the variance of one sample, mean over the channels; where samples lie evenly,
    /// the variance each is worth, which is less than it would have alone.
    pub fn variances(&self) -> Vec<f64> {
        let variance = |p: &Known| p.samples as f64 * p.square;
        self.pixels.iter().map(variance).collect()
    }

    fn squares(&self) -> impl Iterator<Item = f64> {
        self.pixels.iter().map(|p| p.relative)
    }
}

/// What the errors of a picture's pixels are relative to: the brightness around each.
#[derive(Clone, Debug)]
pub struct Scale(Vec<f64>);

impl Scale {
    /// The scale of errors against this picture: the truth, or the best that is known of it.
    pub fn of(picture: &Picture) -> Scale {
        Scale(brightness(picture))
    }

    /// The squared relative error of pixel `i`, from the mean over its channels of the squared error.
    /// No error is no relative error, also where all is black.
    pub fn relative(&self, i: usize, square: f64) -> f64 {
        if square == 0.0 {
            0.0
        } else {
            square / (self.0[i] * self.0[i])
        }
    }

    /// The root mean square of what errors are relative to, over the pixels.
    pub fn root_mean_square(&self) -> f64 {
        let squares: Estimate = self.0.iter().map(|b| b * b).collect();
        squares.mean().sqrt()
    }

    /// An error with its sign, of pixel `i`, relative in the same way.
    pub fn signed(&self, i: usize, off: f64) -> f64 {
        if off == 0.0 { 0.0 } else { off / self.0[i] }
    }
}

/// The relative error of a picture against a reference, whose brightness counts: what
/// [`Accuracy::error`] estimates of an unbiased picture without one.
///
/// # Panics
///
/// Where the pictures are not of the same size.
pub fn true_error(picture: &Picture, reference: &Picture, measure: Measure) -> f64 {
    measure.of(true_squares(picture, reference))
}

/// The squared relative error of each pixel of a picture against a reference.
///
/// # Panics
///
/// Where the pictures are not of the same size.
pub fn true_squares(picture: &Picture, reference: &Picture) -> Vec<f64> {
    assert_eq!(picture.size, reference.size);
    let scale = Scale::of(reference);
    let pixels = picture.values.iter().zip(&reference.values);
    let square =
        |(a, b): (&[f64; 3], &[f64; 3])| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>() / 3.0;
    let squares = pixels.map(square).enumerate();
    squares.map(|(i, s)| scale.relative(i, s)).collect()
}

/// The share of the sum of squared errors that the worst thousandth of the pixels carries; 0 of no
/// error.
pub fn top_share(mut squares: Vec<f64>) -> f64 {
    squares.sort_by(|x, y| y.total_cmp(x));
    let total: f64 = squares.iter().sum();
    let top = &squares[..squares.len().div_ceil(1000)];
    if total > 0.0 {
        top.iter().sum::<f64>() / total
    } else {
        0.0
    }
}

/// How far the surroundings of a pixel reach to each side.
const REACH: usize = 4;

/// The brightness around each pixel: the mean over channels of the pixels around it, or of the whole
/// picture where that is brighter. Pixels without a sample count as black.
pub fn brightness(picture: &Picture) -> Vec<f64> {
    let [width, height] = picture.size.map(|n| n as usize);
    let value = |x: usize, y: usize| {
        let grey = picture.values[y * width + x].iter().sum::<f64>() / 3.0;
        if grey.is_nan() { 0.0 } else { grey }
    };
    // sums[y][x]: over all pixels left of x and above y.
    let mut sums = vec![vec![0.0; width + 1]; height + 1];
    for y in 0..height {
        for x in 0..width {
            sums[y + 1][x + 1] = value(x, y) + sums[y][x + 1] + sums[y + 1][x] - sums[y][x];
        }
    }
    let whole = sums[height][width] / (width * height) as f64;
    let around = |(x, y): (usize, usize)| {
        let [left, top] = [x, y].map(|i| i.saturating_sub(REACH));
        let (right, bottom) = ((x + REACH + 1).min(width), (y + REACH + 1).min(height));
        let sum = sums[bottom][right] - sums[top][right] - sums[bottom][left] + sums[top][left];
        (sum / ((right - left) * (bottom - top)) as f64).max(whole)
    };
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    places.map(around).collect()
}
