//! The truth that errors are measured against: two pictures that share no random number.
//!
//! A reference has noise of its own, and a squared difference from it counts that noise as the
//! estimate's error. The product of the differences from two independent references does not: its
//! expectation is the squared distance from the truth, whatever their noise.

use crate::render::{Film, Picture, compare};

/// Two independent pictures of the same thing.
#[derive(Clone, Debug)]
pub struct Reference {
    /// One and the other.
    pub halves: [Picture; 2],
    /// Their mean, without errors.
    pub picture: Picture,
    /// Samples per pixel of each half.
    pub spp: u32,
}

/// Keeps black pixels from counting without bound, as in [`compare::rel_mse`].
const FLOOR: f64 = 0.01;

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
            halves,
            picture,
            spp,
        }
    }

    // ANCHOR: squares
    /// Squared relative distances from the truth, without bias: for each pixel the mean over its
    /// channels of `(x - a)(x - b) / (r² + 0.01)` with the halves `a`, `b` and their mean `r`.
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
        let r = &self.picture.values[i];
        let channel = |c: usize| (x[c] - a[c]) * (y[c] - b[c]) / (r[c] * r[c] + FLOOR);
        (channel(0) + channel(1) + channel(2)) / 3.0
    }

    /// The reference's own root mean squared relative error, from how far its halves are apart.
    pub fn error(&self) -> f64 {
        // The halves' difference has four times the variance of their mean.
        (0.25 * compare::rel_mse(&self.halves[0], &self.halves[1])).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::Pixel;
    use crate::sampling::stream::{Purpose, Stream};
    use crate::stats::Estimate;

    /// A grey film of `spp` samples of mean 1/2 and variance 1/12 in each pixel.
    fn film(seed: u64, spp: u32) -> Film {
        let pixel = |i| {
            let mut u = Stream::new(seed, i, 0).at(0, Purpose::Pixel);
            let e: Estimate = (0..spp).map(|_| f64::from(u.one())).collect();
            Pixel { channels: [e; 3], ..Pixel::default() }
        };
        Film::new(64, (0..4096).map(pixel).collect())
    }

    #[test]
    fn a_poor_reference_adds_nothing_to_the_error() {
        // As many samples as the estimate has: the plain square would read twice the variance.
        let reference = Reference::new(&film(1, 8), &film(2, 8), 8);
        let squares: Estimate = reference.squares(&film(3, 8)).into_iter().collect();
        let variance = 1.0 / 12.0 / 8.0;
        let expected: f64 = reference
            .picture
            .values
            .iter()
            .map(|r| variance / (r[0] * r[0] + FLOOR))
            .sum();
        let expected = expected / 4096.0;
        assert!(squares.z(expected).abs() < 4.0, "{}", squares.z(expected));
        let plain = compare::rel_mse(&film(3, 8).picture(), &reference.picture);
        assert!(plain > 1.3 * expected, "{plain} for {expected}");
    }

    #[test]
    fn a_reference_knows_its_own_error() {
        let reference = Reference::new(&film(1, 64), &film(2, 64), 64);
        let expected = (1.0 / 12.0 / 128.0 / 0.26_f64).sqrt();
        assert!((reference.error() / expected - 1.0).abs() < 0.05);
    }
}
