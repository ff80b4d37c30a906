//! A mixture among surfaces that all glow: what the choice of one ray does to mean, variance and
//! cost, with closed forms.

use glam::Vec3;
use halfdisk::color::Rgb;
use halfdisk::materials::{BsdfSample, Choice, Mixture};
use halfdisk::sampling::stream::{Purpose, Stream};

/// A world in which every ray meets the same mixture, and every surface glows with radiance one, to
/// all sides alike.
#[derive(Clone, Copy, Debug)]
pub struct MixedFurnace {
    /// What everything is made of.
    pub material: Mixture,
    /// How a path chooses its next ray.
    pub choice: Choice,
    /// Longest path in segments.
    pub segments: u32,
}

/// Where a path comes from at each surface: a world that is alike on all sides does not ask.
const WO: Vec3 = Vec3::new(0.6, 0.0, 0.8);

impl MixedFurnace {
    /// The ray that a path chooses at its surface numbered `place`; `None` where it is absorbed.
    pub fn next(&self, place: u64, stream: &Stream) -> Option<BsdfSample> {
        let choice = stream.at(place, Purpose::Branch).one();
        let u = stream.at(place, Purpose::Direction).two();
        self.material.scatter_by(self.choice, WO, choice, u)
    }

    /// One path: the light it finds, and its rays.
    pub fn walk(&self, stream: &Stream) -> (Rgb, u32) {
        let mut li = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        for segment in 1..=self.segments {
            li += beta;
            match self.next(u64::from(segment), stream) {
                Some(next) if segment < self.segments => beta *= next.weight,
                _ => return (li, segment),
            }
        }
        (li, self.segments)
    }

    /// What the walks read in the mean, for each channel: the powers of `k_tot`, added up.
    pub fn radiance(&self) -> [f64; 3] {
        self.material.k_tot().channels().map(|k| {
            let k = f64::from(k);
            (0..self.segments as i32).map(|j| k.powi(j)).sum()
        })
    }

    /// The variance, for each channel, of the weight of one choice, which is `k_tot` in the mean:
    /// the sum of `k²/p` over the parts, less `k_tot²`.
    pub fn weight_variance(&self) -> [f64; 3] {
        let m = &self.material;
        let p = m.probabilities(self.choice);
        let parts = [m.kd, m.ks, m.kt].map(|k| k.channels().map(f64::from));
        [0, 1, 2].map(|channel| {
            let chosen = parts.iter().zip(p).filter(|(_, p)| *p > 0.0);
            let squares: f64 = chosen.map(|(k, p)| k[channel] * k[channel] / p).sum();
            let mean: f64 = parts.iter().map(|k| k[channel]).sum();
            squares - mean * mean
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use halfdisk::stats::Estimate;
    use halfdisk::stats::z_test::z_test;

    fn furnace(choice: Choice) -> MixedFurnace {
        MixedFurnace {
            material: Mixture {
                kd: Rgb::new(0.5, 0.2, 0.1),
                ks: Rgb::new(0.1, 0.4, 0.2),
                kt: Rgb::new(0.1, 0.2, 0.5),
                ior: 1.5,
            },
            choice,
            segments: 6,
        }
    }

    #[test]
    fn every_choice_reads_the_powers_with_the_variance_it_should() {
        for choice in [
            Choice::Equal,
            Choice::ByMean,
            Choice::ByLuminance,
            Choice::Analog,
        ] {
            let furnace = furnace(choice);
            for channel in 0..3 {
                let stream = |i| Stream::new(1, i, 0);
                let of = |li: Rgb| f64::from(li.channels()[channel]);
                let walks = (0..100_000).map(|i| of(furnace.walk(&stream(i)).0));
                let read: Estimate = walks.collect();
                let test = z_test(&read, furnace.radiance()[channel], 4.4);
                assert!(test.passes(), "{choice:?} {channel}: {test}");
                let weights = (0..100_000).map(|i| {
                    let next = furnace.next(1, &stream(i));
                    next.map_or(0.0, |next| of(next.weight))
                });
                let spread = weights.collect::<Estimate>().variance();
                let exact = furnace.weight_variance()[channel];
                assert!((spread - exact).abs() < 0.02 * exact + 1e-9, "{choice:?}");
                // Absorption by chance is no weight, and a weight is no absorption.
                let wrong = furnace.radiance()[channel] * 0.97;
                assert!(!z_test(&read, wrong, 4.4).passes());
            }
        }
    }
}
