//! Choosing one of many, each with a weight of its own.

/// A distribution over the indices `0..n`, proportional to weights.
///
/// Sums of weights are `f64`. A weight that vanishes beside the sum of those before it is never
/// chosen, and has the probability 0; a weight of 0 is never chosen at all.
#[derive(Clone, Debug)]
pub struct Discrete {
    /// `sums[i]`: the sum of the weights up to and including that of `i`.
    sums: Vec<f64>,
    total: f64,
}

/// What was chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    /// Its index.
    pub index: usize,
    /// Its probability, positive.
    pub probability: f32,
    /// Where in the chosen one's share of `[0, 1)` the uniform lay: a uniform again, independent of
    /// what was chosen, with as many bits fewer as the choice took.
    pub rest: f64,
}

/// A uniform of 24 bits, as they place points, with as many again below them, taken from `below`
/// in `[0, 1)`: what places evenly chooses evenly too.
pub fn refined(u: f32, below: f64) -> f64 {
    f64::from(u) + below * (0.5 * f64::from(f32::EPSILON))
}

/// The largest uniform of 53 bits.
pub const LAST_FINE: f64 = 1.0 - f64::EPSILON / 2.0;

impl Discrete {
    /// The distribution of these weights, finite and not negative; `None` where none is positive.
    pub fn new(weights: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut total = 0.0;
        let sums: Vec<f64> = weights
            .into_iter()
            .map(|weight| {
                debug_assert!(weight >= 0.0 && weight.is_finite(), "weight {weight}");
                total += weight;
                total
            })
            .collect();
        (total > 0.0 && f64::is_finite(total)).then_some(Discrete { sums, total })
    }

    /// Draws an index.
    ///
    /// * Domain: `u` in `[0, 1)` with the 53 bits of [`Numbers::fine`]. A share between two
    ///   neighbouring uniforms is never drawn: of the 24 bits that place a point, that would take
    ///   away whatever has less than a sixteen-millionth of the weight.
    /// * Probability: weight over sum of weights ([`Discrete::probability`]).
    /// * Method: inversion, by bisection of the sums.
    ///
    /// [`Numbers::fine`]: super::stream::Numbers::fine
    pub fn sample(&self, u: f64) -> Choice {
        let x = u * self.total;
        // The first sum above x: where nothing was added, the sum before is above x as well.
        let index = self.sums.partition_point(|sum| *sum <= x);
        let (low, high) = self.share(index);
        Choice {
            index,
            probability: ((high - low) / self.total) as f32,
            // Rounding may lift it to 1, where no uniform lies.
            rest: ((x - low) / (high - low)).clamp(0.0, LAST_FINE),
        }
    }

    /// The probability with which [`Discrete::sample`] draws `index`.
    pub fn probability(&self, index: usize) -> f32 {
        let (low, high) = self.share(index);
        ((high - low) / self.total) as f32
    }

    /// The sum of the weights.
    pub fn total(&self) -> f64 {
        self.total
    }

    fn share(&self, index: usize) -> (f64, f64) {
        let low = if index == 0 {
            0.0
        } else {
            self.sums[index - 1]
        };
        (low, self.sums[index])
    }
}
