//! Do counts in cells follow what was expected of them?

use statrs::function::gamma::gamma_ur;

/// Cells that expect fewer samples than this are pooled: the distribution the statistic is
/// compared with is that of many samples in each cell.
///
/// Source: Cochran, The χ² Test of Goodness of Fit (Annals of Mathematical Statistics 23(3),
/// 1952), section 7.
pub const FEWEST_EXPECTED: f64 = 5.0;

/// What a chi-square test found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChiSquare {
    /// Sum over cells of (observed - expected)² / expected.
    pub statistic: f64,
    /// Degrees of freedom: cells after pooling, less one.
    pub freedom: u32,
    /// Probability that right samples lie at least so far from what was expected.
    pub p: f64,
}

/// Compares the counts observed in cells with those expected, which sum to the same total.
///
/// Source: Pearson, On the Criterion that a Given System of Deviations ... (Philosophical Magazine
/// 50, 1900).
///
/// ```
/// use halfdisk::stats::chi_square::chi_square;
///
/// let die = chi_square(&[16, 18, 16, 14, 12, 12], &[88.0 / 6.0; 6]);
/// assert!((die.statistic - 2.0).abs() < 1e-12 && die.freedom == 5);
/// assert!((die.p - 0.8491).abs() < 1e-4);
/// ```
pub fn chi_square(observed: &[u64], expected: &[f64]) -> ChiSquare {
    debug_assert_eq!(observed.len(), expected.len());
    let cells = pooled(observed, expected);
    let statistic = cells.iter().map(|cell| cell.distance()).sum();
    let freedom = cells.len().saturating_sub(1) as u32;
    let p = if freedom == 0 || statistic == 0.0 {
        1.0
    } else if f64::is_infinite(statistic) {
        0.0
    } else {
        // The upper tail of the chi-square distribution is a regularised incomplete gamma function.
        gamma_ur(f64::from(freedom) / 2.0, statistic / 2.0)
    };
    ChiSquare {
        statistic,
        freedom,
        p,
    }
}

#[derive(Clone, Copy, Debug, Default)]
struct Cell {
    observed: f64,
    expected: f64,
}

impl Cell {
    fn distance(&self) -> f64 {
        let off = self.observed - self.expected;
        if off == 0.0 {
            0.0
        } else {
            off * off / self.expected
        }
    }

    fn join(&mut self, other: Cell) {
        self.observed += other.observed;
        self.expected += other.expected;
    }
}

/// The cells, those that expect little joined into one, the smallest first.
fn pooled(observed: &[u64], expected: &[f64]) -> Vec<Cell> {
    let mut cells: Vec<Cell> = observed
        .iter()
        .zip(expected)
        .map(|(&observed, &expected)| Cell {
            observed: observed as f64,
            expected,
        })
        .collect();
    cells.sort_by(|a, b| a.expected.total_cmp(&b.expected));
    let mut pool = Cell::default();
    let mut pooling = true;
    let mut kept = Vec::new();
    for cell in cells {
        pooling &= cell.expected < FEWEST_EXPECTED
            || (pool.expected > 0.0 && pool.expected < FEWEST_EXPECTED);
        if pooling {
            pool.join(cell);
        } else {
            kept.push(cell);
        }
    }
    // A cell that expects nothing keeps its samples in the pool: they are a fault, not a rarity.
    if pool.expected > 0.0 || pool.observed > 0.0 {
        kept.push(pool);
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_cells_are_pooled_and_no_sample_is_lost() {
        let cells = pooled(&[1, 2, 3, 50, 44], &[1.0, 1.5, 3.5, 50.0, 44.0]);
        assert_eq!(cells.len(), 3);
        let total: f64 = cells.iter().map(|c| c.observed).sum();
        assert_eq!(total, 100.0);
        assert!(cells.iter().all(|c| c.expected >= FEWEST_EXPECTED));
    }

    #[test]
    fn samples_where_none_may_be_are_rejected() {
        assert_eq!(chi_square(&[100, 0], &[100.0, 0.0]).p, 1.0);
        assert!(chi_square(&[60, 40, 30], &[65.0, 65.0, 0.0]).p < 1e-3);
        assert_eq!(chi_square(&[10, 10], &[10.0, 10.0]).p, 1.0);
    }

    #[test]
    fn cells_less_one_are_the_degrees_of_freedom() {
        // Of an even number of degrees the tail is closed: e^(-x / 2), and (1 + x / 2) times that.
        let three = chi_square(&[10, 20, 30], &[20.0; 3]);
        assert_eq!((three.statistic, three.freedom), (10.0, 2));
        assert!((three.p - libm::exp(-5.0)).abs() < 1e-12, "{three:?}");
        let five = chi_square(&[10, 20, 20, 20, 30], &[20.0; 5]);
        assert_eq!((five.statistic, five.freedom), (10.0, 4));
        assert!((five.p - 6.0 * libm::exp(-5.0)).abs() < 1e-12, "{five:?}");
        // Two of four cells are pooled: three cells are left.
        let pooled = chi_square(&[5, 1, 20, 14], &[3.0, 3.0, 17.0, 17.0]);
        assert_eq!(pooled.freedom, 2);
        assert!((pooled.p - libm::exp(-0.5 * pooled.statistic)).abs() < 1e-12);
    }

    #[test]
    fn right_counts_are_rejected_as_often_as_the_level_says() {
        use crate::sampling::stream::{Purpose, Stream};
        use crate::stats::Estimate;
        // Cells of equal weight, and such of which the smallest are pooled.
        let weights: [&[f64]; 3] = [
            &[0.5, 0.5],
            &[0.1; 10],
            &[0.002, 0.002, 0.002, 0.294, 0.3, 0.4],
        ];
        const RUNS: u32 = 2000;
        for weights in weights {
            let expected: Vec<f64> = weights.iter().map(|w| 1000.0 * w).collect();
            let p_value = |run| {
                let mut u = Stream::new(9, run, 0).at(0, Purpose::Pixel);
                let mut counts = vec![0; weights.len()];
                for _ in 0..1000 {
                    let mut x = f64::from(u.one());
                    let found = weights.iter().position(|w| {
                        x -= w;
                        x < 0.0
                    });
                    counts[found.unwrap_or(weights.len() - 1)] += 1;
                }
                chi_square(&counts, &expected).p
            };
            let all: Vec<f64> = (0..RUNS).map(p_value).collect();
            for level in [0.05, 0.3] {
                let hits = all.iter().filter(|p| **p < level).count() as u64;
                let rejected = Estimate::from_hits(hits, u64::from(RUNS));
                // 4.4 standard errors, and the steps of the counts. Of 1, 2, 3 and 9 degrees one too
                // many rejects 0.16, 0.21, 0.22 and 0.25 instead of 0.3.
                let off = (rejected.mean() - level).abs();
                let error = (level * (1.0 - level) / f64::from(RUNS)).sqrt();
                assert!(off < 4.4 * error + 0.012, "{weights:?}: {rejected:?}");
            }
        }
    }

    #[test]
    fn tail_probabilities_are_the_tables() {
        // 0.05 and 0.001 points of 1, 10 and 100 degrees of freedom.
        for (freedom, x, p) in [
            (1.0, 3.841_459, 0.05),
            (10.0, 29.588_3, 0.001),
            (100.0, 124.342, 0.05),
        ] {
            assert!((gamma_ur(freedom / 2.0, x / 2.0) - p).abs() < 1e-5);
        }
    }
}
