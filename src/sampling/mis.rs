//! Weights that combine two ways of drawing the same thing.
//!
//! Each sample counts by how likely its own technique was to draw it, against the other. The two
//! weights of one thing add up to one, so nothing is counted twice, and a thing that one technique
//! hardly ever draws is left to the other.
//!
//! Source: Veach, Guibas, Optimally Combining Sampling Techniques for Monte Carlo Rendering
//! (SIGGRAPH 1995), "Multiple importance sampling".

/// How the weights follow the densities.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Heuristic {
    /// `p / (p + q)`: no other weighting has a much smaller variance.
    Balance,
    /// `p² / (p² + q²)`: better where one of the two is nearly perfect.
    #[default]
    Power,
}

impl Heuristic {
    // ANCHOR: weight
    /// The weight of a sample drawn with density `own`, which the other technique would have drawn
    /// with density `other`; both in the same unit and not negative.
    ///
    /// Written as `1 / (1 + r)` and `1 / (1 + r²)` with `r = other / own`: squares of densities
    /// overflow `f32` from 2e19 on, and both vanish below 3e-23.
    pub fn weight(self, own: f32, other: f32) -> f32 {
        if own == 0.0 {
            return 0.0;
        }
        let ratio = other / own;
        match self {
            Heuristic::Balance => 1.0 / (1.0 + ratio),
            Heuristic::Power => 1.0 / (1.0 + ratio * ratio),
        }
    }
    // ANCHOR_END: weight

    /// The same weight in double precision, for quadratures.
    pub fn weight_f64(self, own: f64, other: f64) -> f64 {
        if own == 0.0 {
            return 0.0;
        }
        let ratio = other / own;
        match self {
            Heuristic::Balance => 1.0 / (1.0 + ratio),
            Heuristic::Power => 1.0 / (1.0 + ratio * ratio),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::naive::power_weight;

    #[test]
    fn the_weights_of_one_thing_add_up_to_one() {
        let densities: Vec<f32> = (-38..=38)
            .map(|k| libm::pow(10.0, f64::from(k)) as f32)
            .chain([0.0, f32::MIN_POSITIVE, 2e19, 1e-23, 0.7, 1.3])
            .collect();
        for heuristic in [Heuristic::Balance, Heuristic::Power] {
            for &f in &densities {
                for &g in densities.iter().filter(|&&g| f + g > 0.0) {
                    let sum = heuristic.weight(f, g) + heuristic.weight(g, f);
                    assert!((sum - 1.0).abs() <= 1.2e-7, "{heuristic:?} {f} {g}: {sum}");
                }
            }
        }
    }

    #[test]
    fn the_plain_power_heuristic_fails_where_ours_holds() {
        for (f, g) in [(2e19, 1.0), (1e-23, 1e-23)] {
            assert!(power_weight(f, g).is_nan());
            let ours = Heuristic::Power.weight(f, g);
            assert!((0.5..=1.0).contains(&ours), "{ours}");
        }
    }

    #[test]
    fn known_weights() {
        assert_eq!(Heuristic::Balance.weight(3.0, 1.0), 0.75);
        assert_eq!(Heuristic::Power.weight(3.0, 1.0), 0.9);
        assert_eq!(Heuristic::Power.weight(5.0, 0.0), 1.0);
        assert_eq!(Heuristic::Power.weight(0.0, 5.0), 0.0);
    }
}
