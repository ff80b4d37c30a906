//! The truth that errors are measured against: two pictures that share no random number.
//!
//! A reference has noise of its own, and a squared difference from it counts that noise as the
//! estimate's error. The product of the differences from two independent references does not: its
//! expectation is the squared distance from the truth, whatever their noise.

use crate::render::accuracy::Scale;
use crate::render::{Film, Picture, Pixel};
use crate::stats::Estimate;

/// Two independent pictures of the same thing.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
#[serde(into = "Halves", from = "Halves")]
pub struct Reference {
    /// One and the other.
    pub halves: [Picture; 2],
    /// Their mean, without errors.
    pub picture: Picture,
    /// What errors of each pixel are relative to.
    scale: Scale,
    /// Samples per pixel of each half.
    pub spp: u32,
}

/// All that a reference is made of.
#[derive(serde::Serialize, serde::Deserialize)]
struct Halves {
    halves: [Picture; 2],
    spp: u32,
}

impl From<Reference> for Halves {
    fn from(Reference { halves, spp, .. }: Reference) -> Self {
        Halves { halves, spp }
    }
}

impl From<Halves> for Reference {
    fn from(Halves { halves, spp }: Halves) -> Self {
        let pairs = halves[0].values.iter().zip(&halves[1].values);
        let middle = |(x, y): (&[f64; 3], &[f64; 3])| [0, 1, 2].map(|i| 0.5 * (x[i] + y[i]));
        let picture = Picture {
            size: halves[0].size,
            values: pairs.map(middle).collect(),
            errors: None,
        };
        Reference {
            scale: Scale::of(&picture),
            halves,
            picture,
            spp,
        }
    }
}

impl Reference {
    /// A reference from two films of different seeds.
    pub fn new(a: &Film, b: &Film, spp: u32) -> Self {
        let halves = [a, b].map(|film| Picture {
            errors: None,
            ..film.picture()
        });
        Halves { halves, spp }.into()
    }

    // ANCHOR: squares
    /// Squared relative distances from the truth, without bias: for each pixel the mean over its
    /// channels of `(x - a)(x - b)` with the halves `a` and `b`, over the squared brightness around it.
    pub fn squares(&self, film: &Film) -> Vec<f64> {
        let values = film.pixels().iter().map(|p| p.mean().unwrap_or([0.0; 3]));
        values
            .enumerate()
            .map(|(i, x)| self.product(i, &x, &x))
            .collect()
    }
    // ANCHOR_END: squares

    /// Squared relative distances from the truth of what two independent films of one method tend to, for
    /// each pixel and without bias: the noise of neither counts.
    pub fn squared_bias(&self, [a, b]: [&Film; 2]) -> Vec<f64> {
        let pairs = a.pixels().iter().zip(b.pixels()).enumerate();
        let product = |(i, (a, b)): (usize, (&Pixel, &Pixel))| {
            let [a, b] = [a, b].map(|pixel| pixel.mean().unwrap_or([0.0; 3]));
            self.product(i, &a, &b)
        };
        pairs.map(product).collect()
    }

    /// The product of the differences of `x` from one half and of `y` from the other, relative, in
    /// pixel `i`.
    pub(super) fn product(&self, i: usize, x: &[f64; 3], y: &[f64; 3]) -> f64 {
        let [a, b] = [&self.halves[0].values[i], &self.halves[1].values[i]];
        self.relative(i, |c| (x[c] - a[c]) * (y[c] - b[c]))
    }

    /// The mean over channels of squares in pixel `i`, relative.
    fn relative(&self, i: usize, square: impl Fn(usize) -> f64) -> f64 {
        self.scale
            .relative(i, (square(0) + square(1) + square(2)) / 3.0)
    }

    /// For each pixel the samples it takes for a relative error, from the variances in a film of
    /// independent samples.
    pub fn required(&self, film: &Film, error: f64) -> Vec<f64> {
        let pixels = film.pixels().iter().enumerate();
        pixels
            .map(|(i, p)| self.relative(i, |c| p.channels[c].variance()) / (error * error))
            .collect()
    }

    /// The mean of the picture over the root mean square of what errors are relative to.
    pub(super) fn evenness(&self) -> f64 {
        let scale = self.scale.root_mean_square();
        if scale > 0.0 {
            self.picture.mean().0 / scale
        } else {
            0.0
        }
    }

    /// The signed difference of the halves in pixel `i`, mean over channels.
    pub(super) fn apart(&self, i: usize) -> f64 {
        let [a, b] = [&self.halves[0].values[i], &self.halves[1].values[i]];
        (0..3).map(|c| a[c] - b[c]).sum::<f64>() / 3.0
    }

    /// The reference's own root mean squared relative error, from how far its halves are apart.
    pub fn error(&self) -> f64 {
        let [a, b] = [&self.halves[0].values, &self.halves[1].values];
        let square = |i: usize, c: usize| (a[i][c] - b[i][c]) * (a[i][c] - b[i][c]);
        let squares: Estimate = (0..a.len())
            .map(|i| self.relative(i, |c| square(i, c)))
            .collect();
        // The halves' difference has four times the variance of their mean.
        (0.25 * squares.mean()).sqrt()
    }
}

/// A grey film of 64 x 64 pixels with `spp` samples in each, uniform within 1/2 of `mean`.
#[cfg(test)]
pub(super) fn film_of(seed: u64, spp: u32, mean: f64) -> Film {
    use crate::render::Pixel;
    use crate::sampling::stream::{Purpose, Stream};
    let pixel = |i| {
        let mut u = Stream::new(seed, i, 0).at(0, Purpose::Pixel);
        let e: Estimate = (0..spp).map(|_| mean - 0.5 + f64::from(u.one())).collect();
        Pixel {
            channels: [e; 3],
            ..Pixel::default()
        }
    };
    Film::new(64, (0..4096).map(pixel).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::compare;

    fn film(seed: u64, spp: u32) -> Film {
        film_of(seed, spp, 0.5)
    }

    /// Level: four standard errors, one in 15 787. It sees errors of the square of 5 %; the plain square
    /// would be 50 % too large.
    #[test]
    fn a_poor_reference_adds_nothing_to_the_error() {
        let mut ratio = Estimate::new();
        for k in 0..16 {
            // As many samples as the estimate has.
            let reference = Reference::new(&film(3 * k + 1, 8), &film(3 * k + 2, 8), 8);
            let found = reference.squares(&film(3 * k + 3, 8));
            for (i, square) in found.into_iter().enumerate() {
                let expected = reference.relative(i, |_| 1.0 / 12.0 / 8.0);
                ratio.add(square / expected);
            }
        }
        let (off, error) = (ratio.mean() - 1.0, ratio.std_error());
        assert!(off.abs() < 4.0 * error && error < 0.01, "{off} ± {error}");
        // The plain square counts the reference's noise, half as large as the estimate's.
        let reference = Reference::new(&film(1, 8), &film(2, 8), 8);
        let plain = compare::mse(&film(3, 8).picture(), &reference.picture);
        assert!(plain > 1.4 / 12.0 / 8.0, "{plain}");
    }

    #[test]
    fn a_reference_knows_its_own_error() {
        let reference = Reference::new(&film(1, 64), &film(2, 64), 64);
        let expected = libm::sqrt(1.0 / 12.0 / 128.0 / 0.25);
        assert!(
            (reference.error() / expected - 1.0).abs() < 0.05,
            "{}",
            reference.error()
        );
    }

    #[test]
    fn the_relative_error_is_that_of_every_picture() {
        use crate::render::accuracy::{Measure, true_error};
        // Where both halves are the truth itself, the product of differences is the square.
        let (film, truth) = (film(1, 8), film_of(2, 512, 0.7));
        let squares = Reference::new(&truth, &truth, 512).squares(&film);
        let root = squares.into_iter().collect::<Estimate>().mean().sqrt();
        let measure = Measure::RootMeanSquare;
        let same = true_error(&film.picture(), &truth.picture(), measure);
        assert!((root / same - 1.0).abs() < 1e-12, "{root} {same}");
        let squared = compare::rel_mse(&film.picture(), &truth.picture());
        assert!((squared.sqrt() / same - 1.0).abs() < 1e-12);
    }
}
