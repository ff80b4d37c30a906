//! What an effect costs in time, and what it changes in the picture: side by side, with and
//! without it.

use super::language::Wanted;
use crate::integrators::{Path, Restricted};
use crate::render::{self, Options, Progress, Rendered};
use crate::sampling::stream::Sampler;
use crate::scene::Scene;
use crate::stats::{Estimate, slope::student_95};

/// A scene, and which of its paths count.
#[derive(Clone, Debug)]
pub struct Setup {
    /// The scene.
    pub scene: Scene,
    /// `None` for all.
    pub wanted: Option<Wanted>,
}

impl Setup {
    /// A render by [`Path`] with the suggested longest path.
    pub fn render(&self, options: &Options, progress: &impl Progress) -> Rendered {
        let path = Path::new(self.scene.suggested.max_depth);
        match &self.wanted {
            None => render::render(&self.scene, &path, options, progress),
            Some(Wanted { eye_first, .. }) => {
                let paths = eye_first;
                render::render(&self.scene, &Restricted { path, paths }, options, progress)
            }
        }
    }
}

/// What was measured.
#[derive(Clone, Debug)]
pub struct Difference {
    /// Logarithm of the time with over the time without, one value for each round.
    pub log_time: Estimate,
    /// Rays with, over rays without.
    pub rays: f64,
    /// Rays of all renders together.
    pub traced: u64,
    /// The share of the light, in the mean of the picture, that is there with and not without.
    pub share: f64,
    /// Its standard error.
    pub share_error: f64,
    /// Mean over pixels and channels of the squared difference, over the squared value plus 0.01.
    pub rel_mse: f64,
    /// Its standard error, by the jackknife over rounds.
    pub rel_mse_error: f64,
}

impl Difference {
    /// The time with over the time without, and the ends of its 95 % interval.
    pub fn time(&self) -> [f64; 3] {
        let log = &self.log_time;
        let half = student_95(log.count() as usize - 1) * log.std_error();
        [log.mean(), log.mean() - half, log.mean() + half].map(libm::exp)
    }
}

/// What leaving out saves and loses; see [`difference_watched`].
pub fn difference(with: &Setup, without: &Setup, spp: u32, rounds: u32) -> Difference {
    match difference_watched(with, without, spp, rounds, &()) {
        Some(difference) => difference,
        None => unreachable!("nobody asked it to stop"),
    }
}

/// Renders `with` and `without` in turn, `rounds` times with seeds of their own; the two of a round
/// share theirs, so that what differs is the effect.
///
/// The noise of a round is independent of the others': the squared difference is estimated by
/// products of the differences of two rounds, in which noise averages out.
///
/// `None` where it was asked to stop before the last round was finished.
///
/// # Panics
///
/// With fewer than three rounds, or pictures of different sizes.
pub fn difference_watched(
    with: &Setup,
    without: &Setup,
    spp: u32,
    rounds: u32,
    progress: &impl Progress,
) -> Option<Difference> {
    assert!(rounds >= 3 && with.scene.size == without.scene.size);
    let mut log_time = Estimate::new();
    let mut rays = [0; 2];
    let mut pictures: Vec<[Vec<f64>; 2]> = Vec::new();
    for round in 0..rounds {
        let options = Options {
            spp,
            seed: u64::from(round) + 1,
            sampler: Sampler::Sobol,
            ..Options::default()
        };
        let run = |setup: &Setup| setup.render(&options, progress);
        // Who goes first takes turns.
        let (a, b) = if round % 2 == 0 {
            let a = run(with);
            (a, run(without))
        } else {
            let b = run(without);
            (run(with), b)
        };
        if a.interrupted || b.interrupted {
            return None;
        }
        log_time.add(libm::log(a.time.as_secs_f64() / b.time.as_secs_f64()));
        rays[0] += a.rays.total();
        rays[1] += b.rays.total();
        let values = |r: &Rendered| r.film.picture().values.into_flattened();
        pictures.push([values(&a), values(&b)]);
    }
    let means: Vec<[f64; 2]> = pictures
        .iter()
        .map(|pair| {
            pair.each_ref()
                .map(|p| p.iter().sum::<f64>() / p.len() as f64)
        })
        .collect();
    let light: Estimate = means.iter().map(|m| m[0]).collect();
    let lost: Estimate = means.iter().map(|m| m[0] - m[1]).collect();
    let all: Vec<&[Vec<f64>; 2]> = pictures.iter().collect();
    let left_out = |i: usize| {
        let others = pictures.iter().enumerate().filter(|(j, _)| *j != i);
        rel_mse(&others.map(|(_, pair)| pair).collect::<Vec<_>>())
    };
    let jackknife: Estimate = (0..pictures.len()).map(left_out).collect();
    let n = f64::from(rounds);
    Some(Difference {
        log_time,
        rays: rays[0] as f64 / (rays[1] as f64).max(1.0),
        traced: rays.iter().sum(),
        share: ratio(lost.mean(), light.mean()),
        share_error: ratio(lost.std_error(), light.mean()),
        rel_mse: rel_mse(&all),
        rel_mse_error: ((n - 1.0) * (n - 1.0) / n * jackknife.variance()).sqrt(),
    })
}

/// The mean product of the differences of two rounds, relative to the squared mean of the first
/// pictures.
fn rel_mse(rounds: &[&[Vec<f64>; 2]]) -> f64 {
    let n = rounds.len() as f64;
    let pixels = rounds.first().map_or(0, |pair| pair[0].len());
    let one = |p: usize| {
        let (mut sum, mut squares, mut value) = (0.0, 0.0, 0.0);
        for [a, b] in rounds.iter().copied() {
            let d = a[p] - b[p];
            sum += d;
            squares += d * d;
            value += a[p] / n;
        }
        (sum * sum - squares) / (n * (n - 1.0)) / (value * value + 0.01)
    };
    (0..pixels).map(one).sum::<f64>() / pixels.max(1) as f64
}

fn ratio(a: f64, b: f64) -> f64 {
    if b == 0.0 { 0.0 } else { a / b }
}
