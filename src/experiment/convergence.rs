//! How fast does an estimator's error fall? Many runs at many sizes, and a line.
//!
//! Every run has random numbers of its own, also from one size to the next: points of one run
//! that goes on are correlated, and intervals drawn from them too narrow.

use crate::render::Progress;
use crate::stats::Estimate;
use crate::stats::slope::{self, Fit, Insufficient};
use rayon::prelude::*;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;

/// An estimator with a name and a known truth.
#[derive(Clone, Copy, Debug)]
pub struct Estimator {
    /// Its name.
    pub name: &'static str,
    /// What it does, in a sentence.
    pub about: &'static str,
    /// What it should give.
    pub truth: f64,
    /// Rays, or evaluations of an integrand, for each sample.
    pub rays_per_sample: u32,
    /// The sizes it can be run at.
    pub sizes: Sizes,
    /// The estimate after `n` samples, a pure function of `n` and the seed.
    pub run: fn(n: u32, seed: u64) -> f64,
}

/// Which numbers of samples an estimator can be run with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Sizes {
    /// Powers of two.
    Doublings,
    /// Powers of four: square grids.
    Squares,
}

/// How much to run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Design {
    /// Independent runs at each size.
    pub replicates: u32,
    /// Sizes in all.
    pub doublings: u32,
    /// The smallest size.
    pub first: u32,
    /// Seed of all random numbers.
    pub seed: u64,
}

impl Default for Design {
    /// 256 runs at 11 sizes: three standard errors of the slope are 0.018.
    fn default() -> Self {
        Design {
            replicates: 256,
            doublings: 11,
            first: 16,
            seed: 1,
        }
    }
}

/// What the runs of one size gave.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Size {
    /// Samples of each run.
    pub samples: u32,
    /// Rays of each run.
    pub rays: u64,
    /// Mean of estimate minus truth.
    pub bias: f64,
    /// Standard error of the bias.
    pub bias_error: f64,
    /// Root mean squared distance from the truth.
    pub rmse: f64,
    /// Standard error of that.
    pub rmse_error: f64,
    /// Variance of the estimates; `None` of one run alone, which has no scatter.
    pub variance: Option<f64>,
}

/// An estimator's error against its samples.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Convergence {
    /// Name of the estimator.
    pub name: String,
    /// What it should give.
    pub truth: f64,
    /// Independent runs at each size.
    pub replicates: u32,
    /// The sizes, the smallest first.
    pub sizes: Vec<Size>,
    /// The slope of error against samples, or why it cannot be stated.
    pub fit: Result<Fit, Insufficient>,
}

impl Sizes {
    fn list(self, design: &Design) -> Vec<u32> {
        let step = match self {
            Sizes::Doublings => 1,
            Sizes::Squares => 2,
        };
        // As far as the doublings of the design reach, and never beyond 2^31.
        (0..design.doublings)
            .step_by(step)
            .map_while(|k| design.first.checked_mul(1_u32.checked_shl(k)?))
            .collect()
    }
}

/// Runs an estimator as designed, on all threads; their number changes no bit.
pub fn converge(estimator: &Estimator, design: &Design) -> Convergence {
    let sizes = estimator.sizes.list(design);
    let errors = (0..design.replicates)
        .into_par_iter()
        .map(|r| replicate(estimator, design, &sizes, r))
        .collect();
    gathered(estimator, design, &sizes, errors)
}

/// How often it is asked whether to stop.
const OFTEN: Duration = Duration::from_millis(50);

/// The same, telling how many runs at all sizes are done. Once asked to stop, it gives what a design of
/// the first replicates gives, as many as are finished without a gap; nothing where there are none.
///
/// The runs are left to the threads of the pool: one may take minutes, and nobody waits for it after
/// the wish to stop. So this is not to be called on a thread of the pool.
pub fn converge_watched(
    estimator: &Estimator,
    design: &Design,
    progress: &impl Progress,
) -> Option<Convergence> {
    let sizes = estimator.sizes.list(design);
    let (sender, finished) = mpsc::channel();
    let next = AtomicU32::new(0);
    let count = design.replicates;
    let one = {
        let (estimator, design, sizes) = (*estimator, *design, sizes.clone());
        move |r| replicate(&estimator, &design, &sizes, r)
    };
    // Handed out in the order of their numbers, so that there are few gaps.
    rayon::spawn_broadcast(move |_| {
        loop {
            let r = next.fetch_add(1, Ordering::Relaxed);
            // Nobody listens any more after the wish to stop.
            if r >= count || sender.send((r, one(r))).is_err() {
                return;
            }
        }
    });
    let mut errors = BTreeMap::new();
    while !progress.stop() {
        match finished.recv_timeout(OFTEN) {
            Ok((r, row)) => {
                errors.insert(r, row);
                progress.tell(errors.len() as u64, u64::from(design.replicates));
            }
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => break,
        }
    }
    let errors: Vec<_> = (0..).map_while(|r| errors.remove(&r)).collect();
    let design = Design {
        replicates: errors.len() as u32,
        ..*design
    };
    (!errors.is_empty()).then(|| gathered(estimator, &design, &sizes, errors))
}

/// The errors of one replicate at each size, every run under a seed that no other has.
fn replicate(estimator: &Estimator, design: &Design, sizes: &[u32], r: u32) -> Vec<f64> {
    let run = |(k, &n): (usize, &u32)| {
        let seed = seed_of(design.seed, r, k as u32);
        (estimator.run)(n, seed) - estimator.truth
    };
    sizes.iter().enumerate().map(run).collect()
}

/// What `errors[r][k]` of all replicates and sizes amount to.
fn gathered(
    estimator: &Estimator,
    design: &Design,
    sizes: &[u32],
    errors: Vec<Vec<f64>>,
) -> Convergence {
    let squares: Vec<Vec<f64>> = errors
        .iter()
        .map(|row| row.iter().map(|e| e * e).collect())
        .collect();
    let samples: Vec<f64> = sizes.iter().copied().map(f64::from).collect();
    Convergence {
        name: estimator.name.to_owned(),
        truth: estimator.truth,
        replicates: design.replicates,
        sizes: sizes
            .iter()
            .enumerate()
            .map(|(k, &n)| {
                size(
                    n,
                    estimator.rays_per_sample,
                    errors.iter().map(|row| row[k]),
                )
            })
            .collect(),
        fit: slope::fit(&samples, &squares),
    }
}

fn size(samples: u32, rays_per_sample: u32, errors: impl Iterator<Item = f64> + Clone) -> Size {
    let bias: Estimate = errors.clone().collect();
    let square: Estimate = errors.map(|e| e * e).collect();
    let rmse = square.mean().sqrt();
    // The square root's error to first order: d√m = dm / 2√m.
    let rmse_error = if rmse == 0.0 && square.count() > 1 {
        0.0
    } else {
        square.std_error() / (2.0 * rmse)
    };
    Size {
        samples,
        rays: u64::from(samples) * u64::from(rays_per_sample),
        bias: bias.mean(),
        bias_error: bias.std_error(),
        rmse,
        rmse_error,
        variance: (bias.count() > 1).then(|| bias.variance()),
    }
}

/// The seed of one run: distinct for distinct runs of a design.
fn seed_of(seed: u64, replicate: u32, size: u32) -> u64 {
    let run = u64::from(size) << 32 | u64::from(replicate);
    // An odd factor is a bijection; neighbouring seeds of a design stay far apart.
    seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(run)
}

impl Convergence {
    /// The fitted line, also where it is too uncertain to be called sufficient.
    pub fn line(&self) -> Option<&Fit> {
        match &self.fit {
            Ok(fit) | Err(Insufficient::Wide(fit)) => Some(fit),
            Err(_) => None,
        }
    }

    /// One line for each size, with a header. A variance that is not known is left empty.
    pub fn to_csv(&self) -> String {
        let mut csv = String::from("name,samples,rays,bias,bias_error,rmse,rmse_error,variance\n");
        for s in &self.sizes {
            let _ = writeln!(
                csv,
                "{},{},{},{:e},{:e},{:e},{:e},{}",
                self.name,
                s.samples,
                s.rays,
                s.bias,
                s.bias_error,
                s.rmse,
                s.rmse_error,
                s.variance.map_or_else(String::new, |v| format!("{v:e}"))
            );
        }
        csv
    }

    /// The whole, for machines.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string_pretty(self)
    }

    /// The slope and its 95 % interval in a few words, or why there is none.
    pub fn slope_text(&self) -> String {
        match &self.fit {
            Ok(fit) => fit.to_string(),
            Err(why) => format!("insufficient: {why}"),
        }
    }
}
