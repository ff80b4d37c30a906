//! What an effect costs in time, and what it changes in the picture: side by side, with and
//! without it.

use super::language::Wanted;
use crate::integrators::{FilteredPath, Path};
use crate::render::accuracy::Scale;
use crate::render::{self, Options, Picture, Progress, Rendered};
use crate::sampling::stream::Sampler;
use crate::scene::Scene;
use crate::stats::{Estimate, Measurement, jackknife, slope::student_95};
use serde::Serialize;
use std::fmt::{self, Display, Formatter};

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
                render::render(
                    &self.scene,
                    &FilteredPath { path, paths },
                    options,
                    progress,
                )
            }
        }
    }
}

/// What was measured.
#[derive(Clone, Debug, Serialize)]
pub struct Difference {
    /// The time with over the time without.
    #[serde(rename = "time_ratio")]
    pub time: Times,
    /// Rays with, over rays without.
    #[serde(rename = "rays_ratio")]
    pub rays: f64,
    /// Rays of all renders together.
    #[serde(skip)]
    pub traced: u64,
    /// The share of the light, in the mean of the picture, that is there with and not without.
    pub share: Measurement,
    /// The squared relative error (see [`accuracy`](crate::render::accuracy)) of the pictures without
    /// against those with: of what differs, not of the noise. Its own error is the jackknife's over rounds.
    pub rel_mse: Measurement,
}

/// A ratio of times, and the ends of its 95 % interval.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Times {
    /// The ratio.
    pub value: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
}

impl Times {
    /// From the logarithm of the ratio in each of several rounds.
    fn of(log: &Estimate) -> Times {
        let half = student_95(log.count() as usize - 1) * log.std_error();
        let [value, low, high] = [log.mean(), log.mean() - half, log.mean() + half].map(libm::exp);
        Times { value, low, high }
    }
}

impl Display for Times {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "{:.2} [{:.2}, {:.2}]", self.value, self.low, self.high)
    }
}

/// The pictures of a round: with, and without.
type Pair = [Picture; 2];
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
    let mut pictures: Vec<Pair> = Vec::new();
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
        pictures.push([a.film.picture(), b.film.picture()]);
    }
    let [share, rel_mse] = changed(&pictures);
    Some(Difference {
        time: Times::of(&log_time),
        rays: rays[0] as f64 / (rays[1] as f64).max(1.0),
        traced: rays.iter().sum(),
        share,
        rel_mse,
    })
}

/// The share of the light and the squared relative error of what differs, each with its standard error.
fn changed(pictures: &[Pair]) -> [Measurement; 2] {
    let means: Vec<[f64; 2]> = pictures
        .iter()
        .map(|pair| pair.each_ref().map(|picture| picture.mean().0))
        .collect();
    let light: Estimate = means.iter().map(|m| m[0]).collect();
    let lost: Estimate = means.iter().map(|m| m[0] - m[1]).collect();
    let share = ratio(lost.mean(), light.mean());
    // Of a ratio, to first order: both its parts come from the same rounds.
    let off: Estimate = means.iter().map(|m| m[0] - m[1] - share * m[0]).collect();
    let all: Vec<&Pair> = pictures.iter().collect();
    let left_out = |i: usize| {
        let others = pictures.iter().enumerate().filter(|(j, _)| *j != i);
        rel_mse(&others.map(|(_, pair)| pair).collect::<Vec<_>>())
    };
    let others: Vec<f64> = (0..pictures.len()).map(left_out).collect();
    [
        (share, ratio(off.std_error(), light.mean())).into(),
        (rel_mse(&all), jackknife(&others)).into(),
    ]
}

/// The mean over pixels of the mean product of the differences of two rounds, relative to the
/// brightness around in the mean of the pictures with.
fn rel_mse(rounds: &[&Pair]) -> f64 {
    let n = rounds.len() as f64;
    let Some([first, _]) = rounds.first() else {
        return 0.0;
    };
    let mean = |p: usize| {
        let sum = |c: usize| {
            rounds
                .iter()
                .map(|[with, _]| with.values[p][c])
                .sum::<f64>()
        };
        [0, 1, 2].map(|c| sum(c) / n)
    };
    let pixels = 0..first.values.len();
    let scale = Scale::of(&Picture {
        size: first.size,
        values: pixels.clone().map(mean).collect(),
        errors: None,
    });
    let channel = |p: usize, c: usize| {
        let (mut sum, mut squares) = (0.0, 0.0);
        for [with, without] in rounds.iter().copied() {
            let d = with.values[p][c] - without.values[p][c];
            sum += d;
            squares += d * d;
        }
        (sum * sum - squares) / (n * (n - 1.0))
    };
    let pixel = |p| scale.relative(p, (channel(p, 0) + channel(p, 1) + channel(p, 2)) / 3.0);
    pixels.map(pixel).collect::<Estimate>().mean()
}

fn ratio(a: f64, b: f64) -> f64 {
    if b == 0.0 { 0.0 } else { a / b }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::stream::{Purpose, Stream};

    /// Rounds of pictures of 16 x 16 pixels: 1 with, 0.75 without, each with noise of its own and some
    /// that both share, as of the same random numbers.
    fn rounds(run: u32, count: u32) -> Vec<Pair> {
        let round = |round: u32| {
            let mut u = Stream::new(7, run, round).at(0, Purpose::Pixel);
            let mut noise = |size: f64| size * (f64::from(u.one()) - 0.5);
            let mut pair: [Vec<[f64; 3]>; 2] = Default::default();
            for _ in 0..256 {
                let both = noise(0.5);
                pair[0].push([1.0 + both + noise(0.3); 3]);
                pair[1].push([0.75 + both + noise(0.3); 3]);
            }
            pair.map(|values| Picture {
                size: [16, 16],
                values,
                errors: None,
            })
        };
        (0..count).map(round).collect()
    }

    /// The scatter of 400 measurements is the error they state: the ratio of variances is known within 7 %
    /// (one standard error, of a normal law), so that the test, at four of them, sees a stated error
    /// that is 15 % off. Errors too small by the root of the 6 rounds are off by 145 %.
    #[test]
    fn the_errors_of_what_an_effect_changes_are_the_scatter_of_repeated_measurements() {
        let mut values = [Estimate::new(); 2];
        let mut squares = [Estimate::new(); 2];
        for run in 0..400 {
            for (k, m) in changed(&rounds(run, 6)).into_iter().enumerate() {
                values[k].add(m.value);
                squares[k].add(m.error * m.error);
            }
        }
        for (k, truth) in [0.25, 0.0625].into_iter().enumerate() {
            // The brightness around is the larger of two means, and so a little too large by their noise.
            let mean = values[k].mean();
            assert!((mean / truth - 1.0).abs() < 0.02, "{k}: {mean}");
            let ratio = values[k].variance() / squares[k].mean();
            assert!((ratio - 1.0).abs() < 0.29, "{k}: {ratio}");
        }
    }

    #[test]
    fn the_squared_error_is_relative_to_the_brightness_around_and_the_noise_counts_for_nothing() {
        let grey = |x: f64| Picture {
            size: [2, 1],
            values: vec![[x; 3], [2.0; 3]],
            errors: None,
        };
        // The same noise in all rounds is none: 1 of 1.5, which is the mean of both pixels.
        let pairs = vec![[grey(1.0), grey(0.0)]; 3];
        let [share, rel_mse] = changed(&pairs);
        assert!((share.value - 1.0 / 3.0).abs() < 1e-12 && share.error < 1e-12);
        assert!(
            (rel_mse.value - 1.0 / 2.25 / 2.0).abs() < 1e-12,
            "{rel_mse:?}"
        );
        assert!(rel_mse.error < 1e-12);
    }
}
