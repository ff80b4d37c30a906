//! How fast does an error fall? The slope of its line on logarithmic axes, with an interval.
//!
//! The points of one run that goes on and on are correlated, and an interval fitted through them
//! is too narrow. Here every size is run `R` times with random numbers of its own, and the
//! interval comes from leaving out one replicate after the other.

use super::jackknife;
use crate::numeric::fixed;
use serde::Serialize;
use statrs::distribution::{ContinuousCDF, StudentsT};
use std::fmt::{Display, Formatter};

/// A slope is known well enough where half its 95 % interval is at most this.
pub const WIDEST: f64 = 0.1;

/// A straight line on logarithmic axes: `y = exp(intercept) · x^slope`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Line {
    /// The power of `x`.
    pub slope: f64,
    /// Natural logarithm of `y` at `x = 1`.
    pub intercept: f64,
}

/// A line through root mean squared errors, and how sure its slope is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Fit {
    /// The line of error against samples.
    pub line: Line,
    /// Standard error of the slope.
    pub std_error: f64,
    /// Half the 95 % interval of the slope, by Student's law for the replicates.
    pub half_width: f64,
}

/// Why a slope cannot be stated.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error, Serialize)]
pub enum Insufficient {
    /// A line needs two sizes.
    #[error("fewer than two sizes")]
    Sizes,
    /// An interval needs two replicates.
    #[error("fewer than two replicates")]
    Replicates,
    /// The logarithm of no error does not exist.
    #[error("an error of exactly zero has no logarithm")]
    NoError,
    /// The interval is wider than [`WIDEST`] to each side: more replicates or sizes are needed.
    #[error("the interval is too wide: {0}")]
    Wide(Fit),
}

impl Line {
    /// The least-squares line through the logarithms of positive points; `None` where there are
    /// fewer than two different `x`.
    pub fn through(points: &[(f64, f64)]) -> Option<Line> {
        let logs = || points.iter().map(|&(x, y)| (libm::log(x), libm::log(y)));
        let n = points.len() as f64;
        let (sum_x, sum_y) = logs().fold((0.0, 0.0), |(a, b), (x, y)| (a + x, b + y));
        let (mean_x, mean_y) = (sum_x / n, sum_y / n);
        let spread: f64 = logs().map(|(x, _)| (x - mean_x) * (x - mean_x)).sum();
        let shared: f64 = logs().map(|(x, y)| (x - mean_x) * (y - mean_y)).sum();
        let slope = shared / spread;
        (spread > 0.0 && slope.is_finite()).then_some(Line {
            slope,
            intercept: mean_y - slope * mean_x,
        })
    }

    /// The line's `y` at `x`.
    pub fn at(&self, x: f64) -> f64 {
        libm::exp(self.intercept + self.slope * libm::log(x))
    }
}

impl Display for Fit {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        let slope = fixed(self.line.slope, 3);
        write!(f, "slope {slope} ± {:.3}", self.half_width)
    }
}

impl Fit {
    /// True where `slope` lies within the 95 % interval.
    pub fn agrees_with(&self, slope: f64) -> bool {
        (self.line.slope - slope).abs() <= self.half_width
    }
}

/// Fits root mean squared errors against costs.
///
/// * `costs[r][k]`: what replicate `r` paid at size `k`, positive: samples, rays or seconds. A point's place
///   is the mean of its costs, and leaving out a replicate leaves out its cost, too.
/// * `squares[r][k]`: its squared error, all of them independent.
/// * `R` replicates of `K` doublings of normal errors give a standard error of
///   `1 / √(2R) / √Σ(x - x̄)²`, with `x = ln N`: 0.006 for `R = 256`, `K = 11`.
pub fn fit(costs: &[Vec<f64>], squares: &[Vec<f64>]) -> Result<Fit, Insufficient> {
    let replicates = squares.len();
    if replicates < 2 {
        return Err(Insufficient::Replicates);
    }
    let sums_of = |rows: &[Vec<f64>]| -> Vec<f64> {
        (0..rows[0].len())
            .map(|k| rows.iter().map(|row| row[k]).sum())
            .collect()
    };
    let (paid, sums) = (sums_of(costs), sums_of(squares));
    let line = line_of(&paid, &sums, replicates as f64)?;
    // The slope without replicate r, for each r in turn.
    let mut slopes = Vec::with_capacity(replicates);
    for (cost, square) in costs.iter().zip(squares) {
        let without = |sums: &[f64], row: &[f64]| -> Vec<f64> {
            sums.iter().zip(row).map(|(sum, own)| sum - own).collect()
        };
        let (paid, sums) = (without(&paid, cost), without(&sums, square));
        slopes.push(line_of(&paid, &sums, (replicates - 1) as f64)?.slope);
    }
    let std_error = jackknife(&slopes);
    let fit = Fit {
        line,
        std_error,
        half_width: std_error * student_95(replicates - 1),
    };
    if fit.half_width <= WIDEST {
        Ok(fit)
    } else {
        Err(Insufficient::Wide(fit))
    }
}

/// The line through the means of costs and the roots of the means of squares.
fn line_of(paid: &[f64], sums: &[f64], replicates: f64) -> Result<Line, Insufficient> {
    if sums.iter().any(|&sum| sum <= 0.0) {
        return Err(Insufficient::NoError);
    }
    let points: Vec<(f64, f64)> = paid
        .iter()
        .zip(sums)
        .map(|(paid, sum)| (paid / replicates, (sum / replicates).sqrt()))
        .collect();
    Line::through(&points).ok_or(Insufficient::Sizes)
}

/// Student's 97.5 % point: half a 95 % interval in standard errors.
pub fn student_95(freedom: usize) -> f64 {
    StudentsT::new(0.0, 1.0, freedom as f64).map_or(f64::INFINITY, |t| t.inverse_cdf(0.975))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::stream::{Numbers, Purpose, Stream};

    /// Nearly normal: the sum of twelve uniforms less six.
    fn normal(u: &mut Numbers) -> f64 {
        (0..12).map(|_| f64::from(u.one())).sum::<f64>() - 6.0
    }

    /// A fit against sizes that every replicate has.
    fn fit(sizes: &[f64], squares: &[Vec<f64>]) -> Result<Fit, Insufficient> {
        super::fit(&vec![sizes.to_vec(); squares.len()], squares)
    }

    fn runs(seed: u64, replicates: u32, sizes: &[f64]) -> Vec<Vec<f64>> {
        let run = |r| {
            let mut u = Stream::new(seed, r, 0).at(0, Purpose::Pixel);
            sizes.iter().map(|n| normal(&mut u).powi(2) / n).collect()
        };
        (0..replicates).map(run).collect()
    }

    #[test]
    fn an_exact_power_is_found() {
        let points: Vec<(f64, f64)> = (1..6).map(f64::from).map(|x| (x, 3.0 / (x * x))).collect();
        let line = Line::through(&points).expect("five points");
        assert!((line.slope + 2.0).abs() < 1e-12 && (line.at(10.0) - 0.03).abs() < 1e-12);
        assert_eq!(Line::through(&points[..1]), None);
    }

    #[test]
    fn the_interval_holds_the_slope_as_often_as_it_says() {
        let sizes: Vec<f64> = (0..8).map(|k| f64::from(1 << k)).collect();
        let mut covered = 0;
        for seed in 0..400 {
            covered += match fit(&sizes, &runs(seed, 32, &sizes)) {
                Ok(fit) | Err(Insufficient::Wide(fit)) => i32::from(fit.agrees_with(-0.5)),
                Err(other) => panic!("{other}"),
            };
        }
        assert!(
            (f64::from(covered) / 400.0 - 0.95).abs() < 0.04,
            "{covered}"
        );
    }

    #[test]
    fn its_error_is_the_one_the_design_promises() {
        let sizes: Vec<f64> = (0..11).map(|k| f64::from(1 << k)).collect();
        let fit = fit(&sizes, &runs(1, 256, &sizes)).expect("enough");
        assert!((fit.std_error - 0.0061).abs() < 0.001, "{}", fit.std_error);
        assert!((fit.line.slope + 0.5).abs() < 0.02);
    }

    #[test]
    fn half_intervals_are_the_tables_of_students_law() {
        for (freedom, table) in [
            (1, 12.706),
            (2, 4.303),
            (9, 2.262),
            (31, 2.040),
            (1000, 1.962),
        ] {
            let found = student_95(freedom);
            assert!((found - table).abs() < 6e-4, "{freedom}: {found}");
        }
    }

    #[test]
    fn what_does_not_suffice_says_why() {
        let sizes = [1.0, 2.0, 4.0];
        assert_eq!(fit(&sizes, &[vec![1.0; 3]]), Err(Insufficient::Replicates));
        assert_eq!(
            fit(&sizes, &vec![vec![0.0; 3]; 9]),
            Err(Insufficient::NoError)
        );
        assert_eq!(
            fit(&sizes[..1], &vec![vec![1.0]; 9]),
            Err(Insufficient::Sizes)
        );
        let wide = fit(&sizes, &runs(3, 4, &sizes));
        assert!(matches!(wide, Err(Insufficient::Wide(_))), "{wide:?}");
    }
}
