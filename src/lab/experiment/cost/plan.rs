//! How many samples each method takes, so that all pay about the same.

use super::method::Method;
use crate::render::Progress;
use crate::scene::Scene;

/// What the largest picture of each method may cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Budget {
    /// So many rays: the same samples on every machine.
    Rays(u64),
    /// So many seconds, by a pilot that tells the speed of this machine.
    Seconds(f64),
}

/// How much to run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Design {
    /// Independent pictures at each size.
    pub replicates: u32,
    /// Sizes, each with four times the samples of the one before.
    pub sizes: u32,
    /// What the largest picture of each method may cost.
    pub budget: Budget,
    /// How many times the samples of the base method's largest picture each half of the reference
    /// has.
    pub reference: u32,
    /// Threads that timed pictures are made on; `None` for those of the current pool.
    pub threads: Option<usize>,
    /// Seed of all random numbers.
    pub seed: u64,
}

impl Default for Design {
    /// Ten pictures of up to 0.6 seconds at four sizes.
    fn default() -> Self {
        Design {
            replicates: 10,
            sizes: 4,
            budget: Budget::Seconds(0.6),
            reference: 16,
            threads: Some(1),
            seed: 1,
        }
    }
}

impl Design {
    /// A design whose run takes about so many seconds, strips of pictures included.
    #[must_use]
    pub fn within(self, seconds: f64, methods: &[Method]) -> Design {
        let references = 2.0 * (1.0 + f64::from(u8::from(methods.iter().any(Method::is_endless))));
        let pictures = methods.len() as f64 * (SIZES * f64::from(self.replicates) + STRIPS);
        let threads = rayon::current_num_threads() as f64;
        let all = references * f64::from(self.reference) / threads + pictures;
        Design {
            budget: Budget::Seconds(seconds / all),
            ..self
        }
    }
}

/// What all sizes cost together, with up to eight pictures of the small ones, in times of the largest.
const SIZES: f64 = 2.6;
/// What a method's pictures in the strips cost, in times of its largest picture.
const STRIPS: f64 = 4.0;

/// More samples than this are never taken: Sobol' points repeat.
const MOST: u32 = 1 << 16;
/// A pilot shorter than this, in seconds, tells nothing about time.
const SHORTEST: f64 = 0.03;

/// The samples per pixel of a method at each size, the smallest first; `None` where it was asked to stop.
pub(super) fn plan(
    scene: &Scene,
    method: &Method,
    design: &Design,
    progress: &impl Progress,
) -> Option<Vec<u32>> {
    // A first picture warms up what a first picture warms up.
    let mut spp = 1;
    let cost = loop {
        let pilot = method.render(scene, spp, !design.seed, progress).ok()?;
        if pilot.interrupted {
            return None;
        }
        let seconds = pilot.time.as_secs_f64();
        match design.budget {
            Budget::Rays(most) => {
                let each = pilot.rays.total().max(1) as f64 / f64::from(spp);
                break most as f64 / each;
            }
            Budget::Seconds(most) if spp > 1 && (seconds > SHORTEST || spp >= MOST) => {
                break most * f64::from(spp) / seconds;
            }
            Budget::Seconds(_) => spp *= 2,
        }
    };
    Some(sizes(cost, design.sizes))
}

/// Powers of two, for which even points lie most evenly: the largest that can be afforded, and
/// quarters of it down to one.
fn sizes(affordable: f64, count: u32) -> Vec<u32> {
    let power = libm::log2(affordable.max(1.0)) as u32;
    let largest = MOST.min(1 << power.min(16));
    let mut sizes: Vec<u32> = (0..count)
        .map(|k| largest >> (2 * k).min(31))
        .take_while(|&spp| spp > 0)
        .collect();
    sizes.reverse();
    sizes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_powers_of_two_up_to_what_can_be_paid() {
        assert_eq!(sizes(70.0, 4), [1, 4, 16, 64]);
        assert_eq!(sizes(128.0, 3), [8, 32, 128]);
        assert_eq!(sizes(0.2, 4), [1]);
        assert_eq!(sizes(20.0, 4), [1, 4, 16]);
        assert_eq!(sizes(1e12, 2), [1 << 14, 1 << 16]);
    }
}
