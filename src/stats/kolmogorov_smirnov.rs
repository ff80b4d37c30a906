//! Do samples of one variable follow a distribution function?

/// What a Kolmogorov-Smirnov test found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KolmogorovSmirnov {
    /// The largest distance between the samples' distribution function and the one expected.
    pub distance: f64,
    /// Probability that right samples lie at least so far away.
    pub p: f64,
}

/// Compares samples, in any order, with the continuous distribution function `cdf`.
///
/// No cells have to be chosen, which is why it sees a shift that chi-square spreads over many
/// cells; a fine ripple it does not see.
///
/// Sources: Kolmogorov, Sulla determinazione empirica di una legge di distribuzione (Giornale
/// dell'Istituto Italiano degli Attuari 4, 1933), for the limit law; Stephens, Use of the
/// Kolmogorov-Smirnov ... Statistics (Journal of the Royal Statistical Society B 32, 1970), for
/// finite samples: right to three digits from five samples on.
///
/// ```
/// use halfdisk::stats::kolmogorov_smirnov::kolmogorov_smirnov;
///
/// let mut even: Vec<f64> = (0..100).map(|i| (f64::from(i) + 0.5) / 100.0).collect();
/// assert!(kolmogorov_smirnov(&mut even, |x| x).p > 0.999);
/// assert!(kolmogorov_smirnov(&mut even, |x| x * x).p < 0.001);
/// ```
pub fn kolmogorov_smirnov(samples: &mut [f64], cdf: impl Fn(f64) -> f64) -> KolmogorovSmirnov {
    samples.sort_by(f64::total_cmp);
    let n = samples.len() as f64;
    let distance = samples
        .iter()
        .enumerate()
        .map(|(i, &x)| {
            let expected = cdf(x);
            let below = i as f64 / n;
            (expected - below).max(below + 1.0 / n - expected)
        })
        .fold(0.0, f64::max);
    let scaled = (n.sqrt() + 0.12 + 0.11 / n.sqrt()) * distance;
    KolmogorovSmirnov {
        distance,
        p: tail(scaled),
    }
}

/// Probability that the supremum of a Brownian bridge exceeds `x`: `2 Σ (-1)^(k-1) e^(-2 k² x²)`.
fn tail(x: f64) -> f64 {
    // Below, the probability is 1 to twelve digits and the alternating sum converges slowly.
    if x < 0.2 {
        return 1.0;
    }
    let term = |k: i32| {
        let sign = if k % 2 == 1 { 2.0 } else { -2.0 };
        sign * libm::exp(-2.0 * f64::from(k * k) * x * x)
    };
    (1..=20).map(term).sum::<f64>().clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::stream::{Purpose, Stream};

    #[test]
    fn tail_probabilities_are_the_tables() {
        for (x, p) in [
            (1.358_1, 0.05),
            (1.627_6, 0.01),
            (1.949_5, 0.001),
            (0.5, 0.963_945),
        ] {
            assert!((tail(x) - p).abs() < 1e-5, "{x}: {}", tail(x));
        }
    }

    #[test]
    fn the_law_of_few_samples_is_the_tables() {
        // Miller, Table of Percentage Points of Kolmogorov Statistics (JASA 51, 1956): distances that
        // one in twenty, and one in a hundred, exceeds.
        for (n, distance, p) in [
            (5, 0.563_3, 0.05),
            (10, 0.409_2, 0.05),
            (20, 0.294_1, 0.05),
            (10, 0.488_9, 0.01),
            (20, 0.352_4, 0.01),
        ] {
            // Even samples, all too high by as much.
            let sample = |i| f64::from(i) / f64::from(n) + distance;
            let mut samples: Vec<f64> = (0..n).map(sample).collect();
            let found = kolmogorov_smirnov(&mut samples, |x| x.min(1.0));
            assert!((found.distance - distance).abs() < 1e-12, "{found:?}");
            assert!((found.p - p).abs() < 0.05 * p, "{n}: {found:?} for {p}");
        }
    }

    #[test]
    fn right_samples_are_rejected_as_often_as_the_level_says() {
        let mut rejected = 0;
        for run in 0..2000 {
            let mut u = Stream::new(9, run, 0).at(0, Purpose::Pixel);
            let mut samples: Vec<f64> = (0..100).map(|_| f64::from(u.one())).collect();
            rejected += u32::from(kolmogorov_smirnov(&mut samples, |x| x).p < 0.05);
        }
        // Four standard errors of a binomial count.
        assert!((f64::from(rejected) - 100.0).abs() < 39.0, "{rejected}");
    }
}
