//! What samples are worth: the squared error of a picture times its samples.
//!
//! Of independent samples that is the same for any number of them. Even samples are worth more in long
//! runs, so it falls with their number until all runs are of full length.

use crate::render::goal::Pilot;
use crate::sampling::stream::Sampler;
use std::ops::Mul;

/// The squared error of a run of 16, 32 and 64 samples, times its samples.
#[derive(Clone, Copy, Debug)]
pub(super) struct Worth {
    of_16: f64,
    of_32: f64,
    of_64: f64,
}

/// The share of its squared error that a run may lose by twice its length, at most; more is the chance
/// of few samples.
const MOST: f64 = 0.5;

impl Worth {
    /// From the looks at a pilot after 32, 64, 128 ... samples.
    pub(super) fn new(looks: &[Pilot], sampler: Sampler) -> Self {
        let worth = |look: &Pilot| f64::from(look.spp) * look.error * look.error;
        let last = &looks[looks.len() - 1];
        if sampler == Sampler::Independent {
            let all = worth(last);
            return Worth {
                of_16: all,
                of_32: all,
                of_64: all,
            };
        }
        let between = |x: f64, shorter: f64| x.clamp(MOST * shorter, shorter);
        let of_16 = worth(&looks[0]);
        // Half of 64 samples are two runs of 16.
        let of_32 = looks
            .get(1)
            .map_or(of_16, |l| between(2.0 * worth(l) - of_16, of_16));
        let first = 0.5 * (of_16 + of_32);
        let of_64 = match looks.len() {
            // Nothing is known of longer runs, but that the next doubling does as the last one did.
            0..3 if of_16 > 0.0 => of_32 * (of_32 / of_16),
            0..3 => of_32,
            _ => {
                let runs = f64::from(last.spp) / 64.0;
                let long = (runs * worth(last) - first) / (runs - 1.0);
                long.clamp(MOST * worth(last), worth(last))
            }
        };
        // A longer run is worth no less than a shorter one: where it seems to be, the shorter ones were lucky.
        let of_32 = of_32.max(of_64);
        Worth {
            of_16: of_16.max(of_32),
            of_32,
            of_64,
        }
    }

    /// The squared error of `spp` samples.
    pub(super) fn square(&self, spp: f64) -> f64 {
        let sum = spp.min(32.0) * self.of_16
            + (spp.min(64.0) - 32.0).max(0.0) * self.of_32
            + (spp - 64.0).max(0.0) * self.of_64;
        sum / (spp * spp)
    }

    /// How many samples, at least one, have no larger squared error.
    pub(super) fn samples(&self, square: f64) -> f64 {
        // The error falls with the samples: N² square = their sum, solved from above.
        let mut spp = (self.of_16 / square).max(1.0);
        for _ in 0..50 {
            spp = (spp * self.square(spp) / square).max(1.0);
        }
        spp
    }
}

/// Samples of so many times the squared error.
impl Mul<Worth> for f64 {
    type Output = Worth;

    fn mul(self, worth: Worth) -> Worth {
        Worth {
            of_16: self * worth.of_16,
            of_32: self * worth.of_32,
            of_64: self * worth.of_64,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn look(spp: u32, worth: f64) -> Pilot {
        Pilot {
            spp,
            seconds: 1.0,
            error: (worth / f64::from(spp)).sqrt(),
            uncertainty: 0.0,
        }
    }

    #[test]
    fn runs_are_told_apart_and_put_together() {
        // Runs of 16 are worth 8, of 32 6, of 64 5: 64 samples (8 + 6)/2, 256 (7 + 3 · 5)/4.
        let looks = [look(32, 8.0), look(64, 7.0), look(128, 6.0), look(256, 5.5)];
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-9 * b, "{a} {b}");
        let worth = Worth::new(&looks, Sampler::Sobol);
        for look in looks {
            let spp = f64::from(look.spp);
            near(worth.square(spp), look.error * look.error);
            near(worth.samples(worth.square(spp)), spp);
        }
        near(worth.of_64, 5.0);
        // A pilot that met its first fireflies late promises no more than it has seen in the end.
        let late = [look(32, 0.1), look(64, 0.1), look(128, 6.0), look(256, 6.0)];
        let worth = Worth::new(&late, Sampler::Sobol);
        let square = |look: &Pilot| look.error * look.error;
        assert!(worth.square(256.0) >= 0.99 * square(&late[3]), "{worth:?}");
        assert!(worth.square(32.0) > 10.0 * square(&late[0]), "{worth:?}");
        near(Worth::new(&looks[..2], Sampler::Sobol).of_64, 4.5);
        near(
            Worth::new(&looks, Sampler::Independent).square(100.0),
            0.055,
        );
    }
}
