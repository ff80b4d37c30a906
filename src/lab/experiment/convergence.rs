//! How fast does an estimator's error fall? A [`Study`] of many runs at many sizes, and a line.

use super::study::{Study, seed_of};
use crate::render::{Progress, Shard};
use crate::sampling::stream::{Numbers, Purpose, Stream};
use crate::stats::slope::{Fit, Insufficient};
use crate::stats::{Estimate, Measurement};
use rayon::prelude::*;
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;
use std::fmt::{self, Display, Formatter, Write as _};
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;

/// An estimator with a name and a known truth.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Estimator<F = fn(u32, u64) -> f64> {
    /// Its name.
    pub name: &'static str,
    /// What it does, in a sentence.
    pub about: &'static str,
    /// What it should give.
    pub truth: f64,
    /// Rays, or evaluations of an integrand, for each sample.
    #[serde(skip)]
    pub rays_per_sample: u32,
    /// The sizes it can be run at.
    pub sizes: Sizes,
    /// The estimate after `n` samples, a pure function of `n` and the seed.
    #[serde(skip)]
    pub run: F,
}

impl Estimator {
    /// An estimator of your own: its estimate after `n` samples, by random numbers that no other run has. It
    /// may be run on several threads at once.
    pub fn new(
        name: &'static str,
        truth: f64,
        estimate: impl Fn(&mut Numbers, u32) -> f64 + Clone,
    ) -> Estimator<impl Fn(u32, u64) -> f64 + Clone> {
        Estimator {
            name,
            about: "",
            truth,
            rays_per_sample: 1,
            sizes: Sizes::Doublings,
            run: move |n, seed| {
                let stream = Stream::new(seed, 0, 0);
                estimate(&mut stream.at(0, Purpose::Integrand), n)
            },
        }
    }
}

/// Its line in a list.
impl<F> Display for Estimator<F> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        writeln!(f, "{:<27} {}", self.name, self.about)
    }
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
    #[serde(skip)]
    pub replicates: u32,
    /// The sizes, the smallest first.
    pub sizes: Vec<Size>,
    /// The slope of error against samples, or why it cannot be stated.
    #[serde(flatten, serialize_with = "say")]
    pub fit: Result<Fit, Insufficient>,
}

/// A slope as a fit, or the words why there is none, and in any case a sentence.
fn say<S: Serializer>(fit: &Result<Fit, Insufficient>, serializer: S) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct Said {
        fit: Option<Fit>,
        insufficient: Option<String>,
        says: String,
    }
    Said {
        fit: fit.ok(),
        insufficient: fit.err().map(|why| why.to_string()),
        says: slope_text(fit),
    }
    .serialize(serializer)
}

fn slope_text(fit: &Result<Fit, Insufficient>) -> String {
    match fit {
        Ok(fit) => fit.to_string(),
        Err(why) => format!("insufficient: {why}"),
    }
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
pub fn converge(
    estimator: &Estimator<impl Fn(u32, u64) -> f64 + Sync>,
    design: &Design,
) -> Convergence {
    let sizes = estimator.sizes.list(design);
    let runs = (0..design.replicates).into_par_iter();
    let runs = runs
        .map(|r| replicate(estimator, design, &sizes, r))
        .collect();
    gathered(estimator, Study { sizes, runs })
}

/// How often it is asked whether to stop.
const OFTEN: Duration = Duration::from_millis(50);

/// The same, telling how many runs at all sizes are done. Once asked to stop, it gives what a design of
/// the first replicates gives, as many as are finished without a gap; nothing where there are none.
///
/// The runs are left to the threads of the pool: one may take minutes, and nobody waits for it after
/// the wish to stop. Only who calls from a thread of the pool does them there, for it may have no other:
/// it has none on the web.
pub fn converge_watched(
    estimator: &Estimator<impl Fn(u32, u64) -> f64 + Clone + Send + Sync + 'static>,
    design: &Design,
    progress: &impl Progress,
) -> Option<Convergence> {
    let all = Shard { index: 1, count: 1 };
    of_errors(estimator, design, errors(estimator, design, all, progress))
}

/// The errors of every n-th replicate at each size, of `n` shares of all: what [`of_errors`] makes a convergence of, when
/// those of all shares stand in their order. Once asked to stop, it gives the first ones, as many as are finished
/// without a gap.
pub fn errors(
    estimator: &Estimator<impl Fn(u32, u64) -> f64 + Clone + Send + Sync + 'static>,
    design: &Design,
    share: Shard,
    progress: &impl Progress,
) -> Vec<Vec<f64>> {
    let (sender, finished) = mpsc::channel();
    let next = AtomicU32::new(0);
    let Shard { index, count: n } = share;
    let count = (index - 1..design.replicates).step_by(n as usize).len() as u32;
    let one = {
        let (estimator, design) = (estimator.clone(), *design);
        let sizes = estimator.sizes.list(&design);
        move |k| replicate(&estimator, &design, &sizes, index - 1 + k * n)
    };
    let tell = |done| progress.tell(done, u64::from(count));
    // On the web it is this question that starts the pool, whose only thread is then the one that asks.
    if rayon::current_num_threads() > 0 && rayon::current_thread_index().is_some() {
        let wanted = (0..count).take_while(|_| !progress.stop());
        let runs = wanted.map(one).zip(1..).inspect(|(_, done)| tell(*done));
        return runs.map(|(row, _)| row).collect();
    }
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
                tell(errors.len() as u64);
            }
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => break,
        }
    }
    (0..).map_while(|r| errors.remove(&r)).collect()
}

/// What the errors of replicates amount to; `None` where there are none, or where one lacks a size.
pub fn of_errors<F>(
    estimator: &Estimator<F>,
    design: &Design,
    runs: Vec<Vec<f64>>,
) -> Option<Convergence> {
    let sizes = estimator.sizes.list(design);
    let whole = runs.iter().all(|row| row.len() == sizes.len());
    (whole && !runs.is_empty()).then(|| gathered(estimator, Study { sizes, runs }))
}

/// The errors of one replicate at each size, every run under a seed that no other has.
fn replicate(
    estimator: &Estimator<impl Fn(u32, u64) -> f64>,
    design: &Design,
    sizes: &[u32],
    r: u32,
) -> Vec<f64> {
    let run = |(k, &n): (usize, &u32)| {
        let seed = seed_of(design.seed, r, k as u64);
        (estimator.run)(n, seed) - estimator.truth
    };
    sizes.iter().enumerate().map(run).collect()
}

/// What the errors of all replicates and sizes amount to.
fn gathered<F>(estimator: &Estimator<F>, errors: Study<f64>) -> Convergence {
    let square = |e: &f64| e * e;
    let size = |(k, &samples): (usize, &u32)| {
        let bias: Estimate = errors.at(k, |e| *e);
        let Measurement { value, error } = errors.at(k, square).root();
        Size {
            samples,
            rays: u64::from(samples) * u64::from(estimator.rays_per_sample),
            bias: bias.mean(),
            bias_error: bias.std_error(),
            rmse: value,
            rmse_error: error,
            variance: (bias.count() > 1).then(|| bias.variance()),
        }
    };
    Convergence {
        name: estimator.name.to_owned(),
        truth: estimator.truth,
        replicates: errors.runs.len() as u32,
        sizes: errors.sizes.iter().enumerate().map(size).collect(),
        fit: errors.fit(|n, _| f64::from(n), square),
    }
}

impl Convergence {
    /// The fitted line, also where it is too uncertain to be called sufficient.
    pub fn line(&self) -> Option<&Fit> {
        match &self.fit {
            Ok(fit) | Err(Insufficient::Wide(fit)) => Some(fit),
            Err(_) => None,
        }
    }

    /// The slope and its 95 % interval in a few words, or why there is none.
    pub fn slope_text(&self) -> String {
        slope_text(&self.fit)
    }
}

/// A table of the sizes, and the slope.
impl Display for Convergence {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        // One run alone knows neither its error nor its variance.
        let unknown = || "unknown".to_owned();
        writeln!(f, "{}, exact {}", self.name, self.truth)?;
        writeln!(f, "{:>10}   error ± its error         variance", "N")?;
        for s in &self.sizes {
            let own = Some(s.rmse_error).filter(|own| own.is_finite());
            let own = own.map_or_else(unknown, |own| format!("{own:.1e}"));
            let variance = s.variance.map_or_else(unknown, |v| format!("{v:.3e}"));
            let (n, rmse) = (s.samples, s.rmse);
            writeln!(f, "{n:>10}   {rmse:.3e} ± {own:<10}   {variance}")?;
        }
        writeln!(f, "{}\n", self.slope_text())
    }
}

/// One line for each estimator and size, with a header. A variance that is not known is left empty.
pub fn csv(all: &[Convergence]) -> String {
    let mut csv = String::from("name,samples,rays,bias,bias_error,rmse,rmse_error,variance\n");
    for (run, s) in all
        .iter()
        .flat_map(|run| run.sizes.iter().map(move |s| (run, s)))
    {
        let variance = s.variance.map_or_else(String::new, |v| format!("{v:e}"));
        let _ = writeln!(
            csv,
            "{},{},{},{:e},{:e},{:e},{:e},{variance}",
            run.name, s.samples, s.rays, s.bias, s.bias_error, s.rmse, s.rmse_error,
        );
    }
    csv
}
