//! Roulette in a furnace: everything about it is known.
//!
//! In a closed furnace of radiance 1 and albedo `ρ` a walk that survives each surface with
//! probability `q` is worth `S = 1 + r + r² + … + rᴷ` with `r = ρ/q`, where it survives `K` surfaces
//! with probability `qᴷ (1 - q)`. The mean of `S` is `1 / (1 - ρ)` for every `q`; its variance is
//! not the same for every `q`, nor finite for every `q`.

use halfdisk::integrators::{Roulette, Survival};
use halfdisk::lab::estimators::worlds::{Counted, Furnace};
use halfdisk::sampling::stream::Stream;
use halfdisk::space::Flat;

/// Roulette with a constant survival in a furnace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Game {
    /// The share of light the walls reflect, in `(0, 1)`.
    pub albedo: f64,
    /// The probability to survive each surface, in `(0, 1)`.
    pub survival: f64,
}

impl Game {
    /// The mean of a walk, `1 / (1 - ρ)`.
    pub fn mean(&self) -> f64 {
        1.0 / (1.0 - self.albedo)
    }

    // ANCHOR: variance
    /// The variance of a walk: `(1 + ρ) / (1 - ρ) / (1 - ρ²/q)` less the squared mean; infinite for
    /// `q <= ρ²`.
    pub fn variance(&self) -> f64 {
        let (albedo, q) = (self.albedo, self.survival);
        if q <= albedo * albedo {
            return f64::INFINITY;
        }
        let square = (1.0 + albedo) / (1.0 - albedo) / (1.0 - albedo * albedo / q);
        square - self.mean() * self.mean()
    }
    // ANCHOR_END: variance

    /// True where walks have a fourth moment, so that a measured variance settles.
    pub fn settles(&self) -> bool {
        self.albedo.powi(4) < self.survival.powi(3)
    }

    /// The mean number of segments of a walk, `1 / (1 - q)`.
    pub fn rays(&self) -> f64 {
        1.0 / (1.0 - self.survival)
    }

    /// Variance times rays: the price of certainty.
    pub fn price(&self) -> f64 {
        self.variance() * self.rays()
    }

    /// The value of one walk, and its segments.
    pub fn walk(&self, stream: &Stream) -> (f64, u64) {
        let albedo = self.albedo as f32;
        let mut room = Counted::new(Furnace { albedo });
        let roulette = Roulette {
            survival: Survival::Constant(self.survival as f32),
        };
        let li = roulette.walk::<Flat>(&mut room, &Furnace::eye(), stream);
        (f64::from(li.r), room.rays)
    }

    /// The mean of `f` over walks that survive fewer than `surfaces`; longer ones count as zero.
    pub fn mean_of(&self, surfaces: u32, f: impl Fn(f64) -> f64) -> f64 {
        let mut chance = 1.0 - self.survival;
        let mut value = 1.0;
        let mut sum = 0.0;
        for _ in 0..surfaces {
            // What is less likely than this never happens, and its value may be no number.
            if chance < f64::MIN_POSITIVE {
                break;
            }
            sum += chance * f(value);
            chance *= self.survival;
            value = 1.0 + self.albedo / self.survival * value;
        }
        sum
    }

    /// The mean of walks of which none may be worth more than `most`.
    pub fn clamped(&self, most: f64) -> f64 {
        self.mean_of(10_000, |value| value.min(most))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_closed_forms_are_sums_over_all_walks() {
        for albedo in [0.3, 0.5, 0.8, 0.9] {
            for survival in [0.5, 0.65, 0.8, 0.85, 0.9, 0.95] {
                let game = Game { albedo, survival };
                let mean = game.mean_of(5000, |s| s);
                assert!((mean / game.mean() - 1.0).abs() < 1e-9, "{game:?}: {mean}");
                if survival > albedo * albedo {
                    let square = game.mean_of(5000, |s| s * s);
                    let variance = square - mean * mean;
                    assert!((variance / game.variance() - 1.0).abs() < 1e-7, "{game:?}");
                } else {
                    assert_eq!(game.variance(), f64::INFINITY);
                }
            }
        }
    }

    #[test]
    fn known_variances() {
        for (albedo, survival, known) in [
            (0.8, 0.65, 560.0),
            (0.8, 0.8, 20.0),
            (0.8, 0.9, 6.15),
            (0.8, 0.95, 2.58),
            (0.9, 0.85, 303.75),
            (0.9, 0.9, 90.0),
            (0.9, 0.95, 28.93),
            (0.9, 0.99, 4.5),
        ] {
            let game = Game { albedo, survival };
            assert!((game.variance() / known - 1.0).abs() < 2e-3, "{game:?}");
        }
    }

    #[test]
    fn values_of_walks() {
        let game = Game {
            albedo: 0.8,
            survival: 0.4,
        };
        let surviving_up_to = |k| game.mean_of(k + 1, |value| value);
        for (k, value) in [(1, 3.0), (2, 7.0), (3, 15.0)] {
            let chance = 0.6 * 0.4_f64.powi(k);
            let seen = (surviving_up_to(k as u32) - surviving_up_to(k as u32 - 1)) / chance;
            assert!((seen - value).abs() < 1e-12, "{k} surfaces: {seen}");
        }
        assert!(game.clamped(1.0) > 0.999_999 && game.clamped(7.0) < game.mean());
    }
}
