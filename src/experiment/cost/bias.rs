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
}

/// How far the expectation of a method's pictures is from the truth.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Bias {
    /// Mean square of the relative distance, estimated without bias: it may come out below zero.
    pub square: f64,
    /// Its standard error, over pixels.
    pub error: f64,
}

/// In so many standard errors it is no chance: one unbiased method in 90 000 is accused.
const CERTAIN: f64 = 4.4;

impl Sums {
    pub(super) fn none(pixels: usize) -> Self {
        Sums {
            pictures: 0,
            values: vec![[0.0; 3]; pixels],
            squares: vec![0.0; pixels],
        }
    }

    pub(super) fn add(&mut self, values: &[[f64; 3]], squares: &[f64]) {
        self.pictures += 1;
        for (sum, x) in self.values.iter_mut().zip(values) {
            (0..3).for_each(|c| sum[c] += x[c]);
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
        Some(Bias {
            square: square.mean(),
            error: square.std_error(),
        })
    }
}

impl Bias {
    /// True where chance cannot explain it.
    pub fn is_certain(&self) -> bool {
        self.square > CERTAIN * self.error
    }

    /// The relative error below which no number of samples leads: the floor where it is certain,
    /// else what it may be at most.
    pub fn floor(&self) -> f64 {
        if self.is_certain() {
            self.square.sqrt()
        } else {
            (self.square.max(0.0) + CERTAIN * self.error).sqrt()
        }
    }
}
