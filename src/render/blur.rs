//! The bias of a picture by photons, which the scatter of its samples does not tell.

use super::accuracy::Scale;
use super::{Film, Options, Progress, render};
use crate::integrators::{PhotonBlur, Photons};
use crate::scene::Scene;
use crate::stats::{Estimate, Measurement, jackknife};

/// How far photons put a picture off in the mean over all noise.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Blur {
    /// Passes that it was estimated from.
    pub passes: u32,
    /// What it adds to the mean of the picture; power that is spread stays, so this is mostly what discs lack
    /// beyond the edges of surfaces.
    pub mean: Measurement,
    /// The squared relative error of pixels by it, as [`super::accuracy`] defines one: of no noise, so an estimate
    /// of it may be below zero.
    pub squared: Measurement,
}

/// Passes for the estimate: an eighth of those of the picture, within these bounds.
const PASSES: [u32; 2] = [4, 16];

/// Seeds of these passes: far from each other, and from that of the picture.
const SEEDS: u64 = 0x626c_7572_0000_0000;

impl Blur {
    /// Estimates the blur of a `film` of `spp` samples per pixel, by [`PhotonBlur`] in passes of their own;
    /// `None` where it was stopped.
    pub fn measure(
        scene: &Scene,
        photons: &Photons,
        film: &Film,
        options: &Options,
        progress: &dyn Progress,
    ) -> Option<Blur> {
        let [least, most] = PASSES;
        let passes = (options.spp / 8).clamp(least, most);
        let by = PhotonBlur::new(photons, scene, options.spp);
        let mut differences = Vec::new();
        let mut means = Estimate::new();
        for pass in 0..u64::from(passes) {
            let options = Options {
                spp: 1,
                seed: options.seed ^ SEEDS.wrapping_add(pass),
                ..*options
            };
            let made = render(scene, &by, &options, progress);
            if made.interrupted {
                return None;
            }
            means.add(made.film.mean().0);
            let pixels = made.film.pixels().iter();
            differences.push(pixels.map(|p| p.mean().unwrap_or_default()).collect());
        }
        Some(Blur {
            passes,
            mean: (means.mean(), means.std_error()).into(),
            squared: squared(&differences, &Scale::of(&film.picture())),
        })
    }

    /// The relative error of pixels by it and its standard error, where it can be told from none.
    pub fn relative(&self) -> Option<Measurement> {
        let Measurement { value, error } = self.squared;
        let known = value > 2.0 * error;
        known.then(|| (value.sqrt(), 0.5 * error / value.sqrt()).into())
    }

    /// What that error is at most, by two standard errors.
    pub fn at_most(&self) -> f64 {
        (self.squared.value.max(0.0) + 2.0 * self.squared.error).sqrt()
    }
}

/// The mean over pixels of the squared mean of differences, from products of those of different passes alone:
/// their noise is independent, so it is in no product's mean. Its error by leaving out passes.
fn squared(passes: &[Vec<[f64; 3]>], scale: &Scale) -> Measurement {
    let pixels = passes.first().map_or(0, Vec::len);
    // Over pixels: of all pairs, and of those without each pass.
    let mut all = Estimate::new();
    let mut without = vec![Estimate::new(); passes.len()];
    let n = passes.len() as f64;
    for i in 0..pixels {
        let (mut pairs, mut left_out) = (0.0, vec![0.0; passes.len()]);
        for channel in 0..3 {
            let values = || passes.iter().map(|pass| pass[i][channel]);
            let sum: f64 = values().sum();
            let squares: f64 = values().map(|x| x * x).sum();
            pairs += (sum * sum - squares) / (3.0 * n * (n - 1.0));
            for (left, x) in left_out.iter_mut().zip(values()) {
                let (sum, squares) = (sum - x, squares - x * x);
                *left += (sum * sum - squares) / (3.0 * (n - 1.0) * (n - 2.0));
            }
        }
        all.add(scale.relative(i, pairs));
        let left_out = without.iter_mut().zip(left_out);
        left_out.for_each(|(all, pairs)| all.add(scale.relative(i, pairs)));
    }
    let left_out: Vec<f64> = without.iter().map(Estimate::mean).collect();
    (all.mean(), jackknife(&left_out)).into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::Picture;
    use crate::sampling::stream::{Purpose, Stream};

    #[test]
    fn noise_alone_is_no_bias() {
        let white = Picture {
            size: [40, 40],
            values: vec![[1.0; 3]; 1600],
            errors: None,
        };
        let scale = Scale::of(&white);
        for bias in [0.0, 0.1] {
            let pass = |k| {
                let mut numbers = Stream::new(7, k, 0).at(0, Purpose::Integrand);
                let mut one = || bias + f64::from(numbers.one()) - 0.5;
                (0..1600).map(|_| [one(), one(), one()]).collect()
            };
            let passes: Vec<_> = (0..8).map(pass).collect();
            let Measurement { value, error } = squared(&passes, &scale);
            let off = value - bias * bias;
            println!("{value:.5} ± {error:.5} for {:.5}", bias * bias);
            assert!(off.abs() < 4.0 * error && error < 0.002);
            // Squares of one pass have the noise in them.
            let plain: Estimate = passes[0].iter().map(|d| d[0] * d[0]).collect();
            assert!(plain.mean() - bias * bias > 20.0 * error);
        }
    }
}
