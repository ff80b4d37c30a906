//! The truth that errors are measured against: two pictures that share no random number.
//!
//! A reference has noise of its own, and a squared difference from it counts that noise as the
//! estimate's error. The product of the differences from two independent references does not: its
//! expectation is the squared distance from the truth, whatever their noise.

use crate::render::{Film, Picture};
use crate::stats::Estimate;

/// Two independent pictures of the same thing.
#[derive(Clone, Debug)]
pub struct Reference {
    /// One and the other.
    pub halves: [Picture; 2],
    /// Their mean, without errors.
    pub picture: Picture,
    /// The square of what errors in each pixel and channel are relative to.
    scale: Vec<[f64; 3]>,
    /// Samples per pixel of each half.
    pub spp: u32,
}

impl Reference {
    /// A reference from two films of different seeds.
    pub fn new(a: &Film, b: &Film, spp: u32) -> Self {
        let halves = [a.picture(), b.picture()];
        let pairs = halves[0].values.iter().zip(&halves[1].values);
        let middle = |(x, y): (&[f64; 3], &[f64; 3])| [0, 1, 2].map(|i| 0.5 * (x[i] + y[i]));
        let picture = Picture {
            size: halves[0].size,
            values: pairs.map(middle).collect(),
            errors: None,
        };
        Reference {
            scale: scale(&picture),
            halves,
            picture,
            spp,
        }
    }

    // ANCHOR: squares
    /// Squared relative distances from the truth, without bias: for each pixel the mean over its
    /// channels of `(x - a)(x - b)` with the halves `a` and `b`, over the squared scale.
    pub fn squares(&self, film: &Film) -> Vec<f64> {
        let values = film.pixels().iter().map(|p| p.mean().unwrap_or([0.0; 3]));
        values
            .enumerate()
            .map(|(i, x)| self.product(i, &x, &x))
            .collect()
    }
    // ANCHOR_END: squares

    /// The product of the differences of `x` from one half and of `y` from the other, relative, in
    /// pixel `i`.
    pub(super) fn product(&self, i: usize, x: &[f64; 3], y: &[f64; 3]) -> f64 {
        let [a, b] = [&self.halves[0].values[i], &self.halves[1].values[i]];
        self.relative(i, |c| (x[c] - a[c]) * (y[c] - b[c]))
    }

    /// The mean over channels of squares in pixel `i`, relative. What is black and has no error has no
    /// relative one.
    fn relative(&self, i: usize, square: impl Fn(usize) -> f64) -> f64 {
        let channel = |c: usize| match square(c) {
            0.0 => 0.0,
            square => square / self.scale[i][c],
        };
        (channel(0) + channel(1) + channel(2)) / 3.0
    }

    /// For each pixel the samples it takes for a relative error, from the variances in a film of
    /// independent samples.
    pub fn required(&self, film: &Film, error: f64) -> Vec<f64> {
        let pixels = film.pixels().iter().enumerate();
        pixels
            .map(|(i, p)| self.relative(i, |c| p.channels[c].variance()) / (error * error))
            .collect()
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

/// What errors are relative to, squared: the value itself, and where it is dark a third of the mean
/// of the picture, so that black does not count without bound.
fn scale(picture: &Picture) -> Vec<[f64; 3]> {
    let third = picture.mean().0 / 3.0;
    let channel = |x: f64| x * x + third * third;
    picture.values.iter().map(|v| v.map(channel)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::Pixel;
    use crate::render::compare;
    use crate::sampling::stream::{Purpose, Stream};
    use crate::stats::z_test::{FOUR, z_test};

    /// A grey film of `spp` samples of mean 1/2 and variance 1/12 in each pixel.
    fn film(seed: u64, spp: u32) -> Film {
        let pixel = |i| {
            let mut u = Stream::new(seed, i, 0).at(0, Purpose::Pixel);
            let e: Estimate = (0..spp).map(|_| f64::from(u.one())).collect();
            Pixel {
                channels: [e; 3],
                ..Pixel::default()
            }
        };
        Film::new(256, (0..256 * 256).map(pixel).collect())
    }

    #[test]
    fn a_poor_reference_adds_nothing_to_the_error() {
        // As many samples as the estimate has: the plain square would read half as much again.
        const SPP: u32 = 64;
        let variance = 1.0 / 12.0 / f64::from(SPP);
        let reference = Reference::new(&film(1, SPP), &film(2, SPP), SPP);
        let squares: Estimate = reference.squares(&film(3, SPP)).into_iter().collect();
        // The inverse of what it is relative to is larger in the mean where the reference is noisy.
        let inverse: Estimate = reference.scale.iter().map(|s| 1.0 / s[0]).collect();
        // At a level of 6e-5 a bias of 5 % is noticed; that of a scale which is noisy, too, is 0.6 %.
        let expected = variance * inverse.mean();
        let test = z_test(&squares, expected, FOUR);
        assert!(test.passes(), "{} for {expected}: {test}", squares.mean());
        assert!(test.detects < 0.05 * expected, "{test}");
        // The plain square counts the reference's noise, half as large as the estimate's.
        let plain = compare::mse(&film(3, SPP).picture(), &reference.picture) / variance;
        assert!((plain - 1.5).abs() < 0.05, "{plain}");
    }

    #[test]
    fn a_reference_knows_its_own_error() {
        let reference = Reference::new(&film(1, 64), &film(2, 64), 64);
        let expected = libm::sqrt(1.0 / 12.0 / 128.0 / (0.25 + 0.25 / 9.0));
        assert!(
            (reference.error() / expected - 1.0).abs() < 0.05,
            "{}",
            reference.error()
        );
    }
}
