//! Is an estimate the truth? And if the test says yes: which error would it have noticed?

use super::Estimate;
use statrs::function::erf::{erfc, erfc_inv};
use std::f64::consts::SQRT_2;
use std::fmt;

/// Where a check of one number draws its line, in standard errors: one right estimate in 15 787
/// lies beyond.
pub const FOUR: f64 = 4.0;

/// A difference below this share of the truth is rounding: transport runs in `f32`, and an
/// estimator without variance has no other error.
pub const ROUNDING: f64 = 1e-6;

/// With 90 % probability a normal variable lies below this.
const NINETY_PERCENT: f64 = 1.281_551_565_544_600_4;

/// What a z test found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ZTest {
    /// Distance of the estimate from the truth in standard errors; 0 within [`ROUNDING`].
    pub z: f64,
    /// Probability that a right estimate lies at least so far away, on either side.
    pub p: f64,
    /// The line: beyond it the test rejects.
    pub critical: f64,
    /// The smallest bias the test rejects with 90 % power, in units of the estimate.
    pub detects: f64,
}

/// Compares an estimate with the truth and rejects beyond `critical` standard errors.
///
/// The normal law stands in for the means of a hundred samples or more. A test that passes says
/// nothing about errors smaller than [`ZTest::detects`] `= (critical + 1.28) · standard error`.
///
/// ```
/// use halfdisk::stats::{Estimate, z_test::{FOUR, z_test}};
///
/// let fair: Estimate = (0..10_000).map(|i| f64::from(i % 2)).collect();
/// let test = z_test(&fair, 0.5, FOUR);
/// assert!(test.passes());
/// assert!((test.detects - 5.28 * 0.005).abs() < 1e-4);
/// assert!(!z_test(&fair, 0.53, FOUR).passes());
/// ```
pub fn z_test(estimate: &Estimate, truth: f64, critical: f64) -> ZTest {
    let difference = estimate.mean() - truth;
    let z = if difference.abs() <= ROUNDING * truth.abs() {
        0.0
    } else {
        difference / estimate.std_error()
    };
    let noticed = (critical + NINETY_PERCENT) * estimate.std_error();
    ZTest {
        z,
        p: two_sided(z),
        critical,
        detects: noticed.max(ROUNDING * truth.abs()),
    }
}

impl ZTest {
    /// True where the estimate is close enough. An infinite error accuses nobody, and proves
    /// nothing: look at [`ZTest::detects`].
    pub fn passes(&self) -> bool {
        self.z.abs() <= self.critical
    }
}

impl fmt::Display for ZTest {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(
            f,
            "z {:+.2}, p {:.4}, would notice {:.1e}",
            self.z, self.p, self.detects
        )
    }
}

/// Probability that a standard normal variable lies at least `|z|` from zero.
pub fn two_sided(z: f64) -> f64 {
    erfc(z.abs() / SQRT_2)
}

/// The distance from zero that a standard normal variable exceeds with probability `level`, in
/// `(0, 1)`: the inverse of [`two_sided`].
pub fn critical(level: f64) -> f64 {
    SQRT_2 * erfc_inv(level)
}

/// The level of each of `tests` independent tests that together reject with probability `family`.
///
/// Source: Šidák, Rectangular Confidence Regions for the Means of Multivariate Normal
/// Distributions (JASA 62, 1967), corollary 1.
pub fn sidak(family: f64, tests: u32) -> f64 {
    // 1 - (1 - family)^(1 / tests), in which nothing cancels.
    -libm::expm1(libm::log1p(-family) / f64::from(tests))
}

/// A right family of comparisons has a larger |z| than its [`Largest::surprising`] in one of so many.
const SURPRISE: f64 = 1000.0;

/// The largest |z| of several comparisons with known truths. The more there are, the larger it is by
/// chance alone: it means something only beside their number.
///
/// ```
/// use halfdisk::stats::z_test::Largest;
///
/// let mut largest = Largest::default();
/// [-2.8, 1.1].into_iter().chain([0.3; 22]).for_each(|z| largest.add(z));
/// assert_eq!((largest.z, largest.of), (2.8, 24));
/// assert!((largest.surprising() - 4.10).abs() < 0.01);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Largest {
    /// The largest distance of an estimate from its truth in standard errors, on either side.
    pub z: f64,
    /// Of so many comparisons.
    pub of: u32,
}

impl Largest {
    /// Counts a comparison. One whose z is no number is beyond all others.
    pub fn add(&mut self, z: f64) {
        let z = if z.is_nan() { f64::INFINITY } else { z.abs() };
        self.z = self.z.max(z);
        self.of += 1;
    }

    /// The largest of these comparisons and of others.
    #[must_use]
    pub fn with(self, other: Largest) -> Largest {
        Largest {
            z: self.z.max(other.z),
            of: self.of + other.of,
        }
    }

    /// What the largest |z| of so many independent comparisons exceeds by chance once in a thousand
    /// times ([`sidak`]); where they are not independent, less often. 0 without any comparison.
    pub fn surprising(&self) -> f64 {
        match self.of {
            0 => 0.0,
            tests => critical(sidak(1.0 / SURPRISE, tests)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_and_lines_are_the_tables() {
        assert!((two_sided(1.959_964) - 0.05).abs() < 1e-7);
        assert!((critical(0.01) - 2.575_829).abs() < 1e-5);
        assert!((1.0 / two_sided(FOUR) - 15_787.0).abs() < 1.0);
        for (tests, line) in [(1, 2.58), (100, 3.89), (1000, 4.42), (65_536, 5.25)] {
            assert!(
                (critical(sidak(0.01, tests)) - line).abs() < 0.006,
                "{tests}"
            );
        }
    }

    #[test]
    fn what_it_says_it_notices_it_notices_nine_times_of_ten() {
        use crate::sampling::stream::{Purpose, Stream};
        let mut noticed = 0;
        for run in 0..2000 {
            let mut u = Stream::new(8, run, 0).at(0, Purpose::Pixel);
            let e: Estimate = (0..400).map(|_| f64::from(u.one())).collect();
            let bias = z_test(&e, 0.5, 3.0).detects;
            noticed += u32::from(!z_test(&e, 0.5 - bias, 3.0).passes());
        }
        assert!(
            (f64::from(noticed) / 2000.0 - 0.9).abs() < 0.03,
            "{noticed}"
        );
    }

    #[test]
    fn rounding_is_no_bias_and_a_constant_error_is() {
        let constant: Estimate = [1.0 + 1e-7; 10].into_iter().collect();
        assert_eq!(z_test(&constant, 1.0, FOUR).z, 0.0);
        assert!(!z_test(&constant, 1.001, FOUR).passes());
    }
}
