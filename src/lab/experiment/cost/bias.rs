//! The error that no number of samples removes.

use super::reference::Reference;
use crate::stats::Estimate;
use serde::Serialize;
use std::fmt;

/// What independent pictures of a method add up to.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
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
    /// The mean of the picture over the root mean square of what errors are relative to.
    pub evenness: f64,
}

/// The relative error at which a biased method levels out, and its 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Floor {
    /// The likeliest value.
    pub error: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
}

impl Floor {
    /// The same where pictures were measured to be at most `most` off: what stays is a part of that.
    #[must_use]
    pub(super) fn at_most(self, most: f64) -> Floor {
        let high = self.high.min(most).max(self.low);
        Floor {
            error: self.error.min(high),
            high,
            ..self
        }
    }

    /// True where it is known to some digits; else only its interval says anything.
    pub fn is_known(&self) -> bool {
        self.high < 2.0 * self.low
    }
}

/// In so many standard errors it is no chance: one unbiased method in 60 000 is accused.
const CERTAIN: f64 = 4.4;
/// In so many standard errors lie 95 %.
const INTERVAL: f64 = 1.96;

impl fmt::Display for Floor {
    /// `at 5.6 % [5.2, 6.0]`, or `between 2.1 % and 12.3 %`.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let [at, low, high] = [self.error, self.low, self.high].map(|e| 100.0 * e);
        // A tenth of a percent, and finer where that is coarse.
        let digits = if low < 1.0 { 2 } else { 1 };
        match self.is_known() {
            true => write!(f, "at {at:.digits$} % [{low:.digits$}, {high:.digits$}]"),
            false => write!(f, "between {low:.digits$} % and {high:.digits$} %"),
        }
    }
}

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

    /// Adds those of other pictures of the same method.
    pub(super) fn join(&mut self, other: &Sums) {
        self.pictures += other.pictures;
        let values = self.values.iter_mut().flatten();
        values
            .zip(other.values.iter().flatten())
            .for_each(|(sum, x)| *sum += x);
        for (own, its) in [
            (&mut self.squares, &other.squares),
            (&mut self.greys, &other.greys),
        ] {
            own.iter_mut().zip(its).for_each(|(sum, x)| *sum += x);
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
            evenness: truth.evenness(),
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

    /// The relative error that no number of samples removes.
    ///
    /// The squares of the pixels tell it where they are above their noise. Where they are not, as of few
    /// pictures with bright dots, what is missing from the mean still does: with distances `d` of the
    /// pixels and the brightness `b` around them, the mean of `d` is at most the root of the mean of
    /// `(d / b)²` times that of `b²` (Cauchy and Schwarz), so that the relative error is at least
    /// `mean` times `evenness`.
    pub fn levels_out(&self) -> Floor {
        let at = |z: f64| (self.square + z * self.error).max(0.0).sqrt();
        let missing = (self.mean.abs() - INTERVAL * self.mean_error).max(0.0) * self.evenness;
        let low = at(-INTERVAL).max(missing);
        let high = at(INTERVAL).max(low);
        Floor {
            error: at(0.0).clamp(low, high),
            low,
            high,
        }
    }

    /// The relative error above which it stays, but for one chance in forty.
    pub fn floor(&self) -> f64 {
        self.levels_out().low
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::experiment::cost::reference::film_of;
    use crate::render::Film;

    /// Pictures of `spp` samples each, and a truth of `reference` samples in each half, all of
    /// [`film_of`] with a value around `mean`.
    fn bias(seed: u64, pictures: u32, spp: u32, reference: u32, mean: f64) -> Bias {
        let film = |k: u64, spp, mean| film_of(1000 * seed + k, spp, mean);
        let truth = Reference::new(
            &film(1, reference, 0.5),
            &film(2, reference, 0.5),
            reference,
        );
        let mut sums = Sums::none(truth.picture.values.len());
        for k in 0..pictures {
            let film: Film = film(10 + u64::from(k), spp, mean);
            sums.add(&film.picture().values, &truth.squares(&film));
        }
        sums.bias(&truth).unwrap()
    }

    /// Where the reference is no better than a single picture, most of what is between them and it is
    /// the reference's noise. The mean of z² over 300 runs is 1 within 0.082 (its standard error), so
    /// the test, at four of them, sees a stated error that is 14 % off; without the noise of the
    /// reference it is too small by a factor of 2.2.
    #[test]
    fn the_error_of_a_bias_counts_the_noise_of_the_reference() {
        let squares: Estimate = (0..300)
            .map(|seed| {
                let bias = bias(seed, 8, 2, 2, 0.5);
                (bias.mean / bias.mean_error).powi(2)
            })
            .collect();
        assert!(
            (squares.mean() - 1.0).abs() < 4.0 * squares.std_error().max(0.08),
            "{squares:?}"
        );
        assert!(squares.std_error() < 0.12, "{squares:?}");
    }

    /// The same of the square, by its scatter: its stated error is the scatter of the estimates.
    #[test]
    fn the_square_of_no_bias_is_zero_within_its_error() {
        let z: Estimate = (0..200)
            .map(|seed| {
                let bias = bias(seed, 4, 2, 2, 0.5);
                bias.square / bias.error
            })
            .collect();
        assert!(z.mean().abs() < 4.0 * z.std_error(), "{z:?}");
        // The mean square of 200 is within 40 % of its expectation in 15 786 of 15 787 runs.
        let spread = z.variance();
        assert!((spread - 1.0).abs() < 0.4, "{spread}");
    }

    #[test]
    fn a_bias_levels_out_within_its_interval() {
        let known = bias(1, 8, 64, 64, 0.55);
        let floor = known.levels_out();
        assert!(known.is_certain() && floor.is_known(), "{floor:?}");
        // The interval misses in one of twenty; so far off is one estimate in 26 000.
        let half = 0.5 * (floor.high - floor.low);
        assert!((floor.error - 0.1).abs() < 2.15 * half, "{floor:?}");
        assert!(floor.to_string().starts_with("at "), "{floor}");
    }

    /// Of bright dots that lie apart, few pictures do not tell the square: it came out below zero. But
    /// what is missing in all is certain, and an error of 0.00 % is not the answer.
    #[test]
    fn a_bias_of_the_mean_alone_does_not_level_out_at_nothing() {
        let bias = Bias {
            square: -0.02,
            error: 0.03,
            mean: -0.2,
            mean_error: 0.01,
            evenness: 0.8,
        };
        assert!(bias.is_certain());
        let floor = bias.levels_out();
        assert!(
            (floor.low - 0.8 * (0.2 - 0.0196)).abs() < 1e-12,
            "{floor:?}"
        );
        assert!((floor.high - 0.197_180).abs() < 1e-3, "{floor:?}");
        assert_eq!(bias.floor(), floor.low);
        let unknown = Floor {
            error: 0.02,
            low: 0.014,
            high: 0.2,
        };
        assert_eq!(unknown.to_string(), "between 1.4 % and 20.0 %");
    }
}
