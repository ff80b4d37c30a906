//! The error that no number of samples removes.

use super::reference::Reference;
use crate::stats::Estimate;
use serde::Serialize;

/// What independent pictures of a method add up to.
#[derive(Clone, Debug)]
pub(super) struct Sums {
    pictures: u32,
    /// Of each pixel.
    values: Vec<[f64; 3]>,
    /// Squared relative distances from the truth, of each pixel.
    squares: Vec<f64>,
    /// Squares of the mean over channels, of each pixel.
    greys: Vec<f64>,
}

/// How far the expectation of a method's pictures is from the truth.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Bias {
    /// Mean square of the relative distance, estimated without bias: it may come out below zero.
    pub square: f64,
    /// Its standard error, over pixels.
    pub error: f64,
    /// Mean of the signed distance over the mean of the picture: below zero where light is lost.
    pub mean: f64,
    /// Its standard error.
    pub mean_error: f64,
}

/// In so many standard errors it is no chance: one unbiased method in 60 000 is accused.
const CERTAIN: f64 = 4.4;

impl Sums {
    pub(super) fn none(pixels: usize) -> Self {
        Sums {
            pictures: 0,
            values: vec![[0.0; 3]; pixels],
            squares: vec![0.0; pixels],
            greys: vec![0.0; pixels],
        }
    }

    pub(super) fn add(&mut self, values: &[[f64; 3]], squares: &[f64]) {
        self.pictures += 1;
        for ((sum, grey), x) in self.values.iter_mut().zip(&mut self.greys).zip(values) {
            (0..3).for_each(|c| sum[c] += x[c]);
            *grey += third(x).powi(2);
        }
        for (sum, x) in self.squares.iter_mut().zip(squares) {
            *sum += x;
        }
    }

    /// The bias; `None` below two pictures.
    ///
    /// The product of the distances of two *different* pictures from the truth has the squared bias
    /// as its expectation, for their noise is independent. This is its mean over all pairs: the
    /// square of the sum, less the squares. Pixels are independent, so their scatter tells its error.
    pub(super) fn bias(&self, truth: &Reference) -> Option<Bias> {
        let n = f64::from(self.pictures);
        if self.pictures < 2 {
            return None;
        }
        let pixels = self.values.iter().zip(&self.squares).enumerate();
        let square: Estimate = pixels
            .map(|(i, (sum, squares))| {
                let mean = sum.map(|x| x / n);
                (n * n * truth.product(i, &mean, &mean) - squares) / (n * (n - 1.0))
            })
            .collect();
        // Of the mean: each pixel has its own noise, that of the pictures and that of the reference.
        let (mut off, mut noise) = (0.0, 0.0);
        for (i, (sum, greys)) in self.values.iter().zip(&self.greys).enumerate() {
            let mean = third(sum) / n;
            off += mean - third(&truth.picture.values[i]);
            noise += (greys / n - mean * mean).max(0.0) / (n - 1.0);
            noise += (0.5 * truth.apart(i)).powi(2);
        }
        let whole = truth.picture.mean().0 * self.values.len() as f64;
        Some(Bias {
            square: square.mean(),
            error: square.std_error(),
            mean: off / whole,
            mean_error: noise.sqrt() / whole,
        })
    }
}

fn third(x: &[f64; 3]) -> f64 {
    (x[0] + x[1] + x[2]) / 3.0
}

impl Bias {
    /// True where chance cannot explain it, pixel by pixel or of the light in all.
    pub fn is_certain(&self) -> bool {
        self.square > CERTAIN * self.error || self.mean.abs() > CERTAIN * self.mean_error
    }

    /// The relative error below which no number of samples leads: the floor where it is certain,
    /// else what it may be at most.
    pub fn floor(&self) -> f64 {
        if self.is_certain() {
            self.square.max(0.0).sqrt()
        } else {
            (self.square.max(0.0) + CERTAIN * self.error).sqrt()
        }
    }
}
