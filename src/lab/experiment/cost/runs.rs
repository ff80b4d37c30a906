//! The pictures: every method at every size, many times, in turns.

use super::bias::Sums;
use super::method::{self, BASE, Method};
use super::plan::{Design, plan};
use super::reference::Reference;
use crate::lab::experiment::study::{Study, in_order, order, seed_of};
use crate::render::accuracy::top_share;
use crate::render::{Progress, Rendered, Shard};
use crate::scene::{RayCounts, Scene};
use crate::stats::Estimate;
use std::sync::Mutex;

/// What a picture cost, and how wrong it is: the mean of up to eight of a size.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Run {
    /// Mean squared relative error, without bias.
    pub square: f64,
    /// The share of it in the worst thousandth of the pixels.
    pub top_share: f64,
    /// Seconds of the pixel loop.
    pub seconds: f64,
    /// Rays.
    pub rays: RayCounts,
    /// Samples that were no number.
    pub non_finite: u64,
}

/// All pictures of a method.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub struct Runs {
    /// The method.
    pub method: Method,
    /// Its pictures, by samples per pixel.
    pub study: Study<Run>,
    /// What the pictures of the largest size add up to.
    pub(super) sums: Sums,
}

/// Everything that was measured.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub struct Measured {
    /// The truth for methods that end their paths with the scene's longest.
    pub reference: Reference,
    /// The truth for paths of any length, where a method needs it.
    pub endless: Option<Reference>,
    /// The methods.
    pub methods: Vec<Runs>,
    /// Replicates of every method that were finished.
    pub replicates: u32,
    /// True where it was stopped before the last.
    pub interrupted: bool,
}

impl Measured {
    /// What all shares of the replicates gave together, in the order of their numbers; `None` where there are none, or
    /// where they differ in their methods, sizes or reference.
    ///
    /// Errors, rays and seconds are those of one run, replicate by replicate. Sums over pictures, which tell the bias, are
    /// added share by share, and may differ from one run's in the last bits.
    pub fn joined(shares: Vec<Measured>) -> Option<Measured> {
        let first = shares.first()?;
        let (mut joined, mut studies) = (first.clone(), vec![Vec::new(); first.methods.len()]);
        let halves = |of: &Option<Reference>| of.as_ref().map(|r| r.halves.clone());
        for (i, share) in shares.into_iter().enumerate() {
            let same =
                |(a, b): (&Runs, &Runs)| a.method == b.method && a.study.sizes == b.study.sizes;
            let fits = share.reference.halves == joined.reference.halves
                && halves(&share.endless) == halves(&joined.endless)
                && share.methods.len() == joined.methods.len()
                && share.methods.iter().zip(&joined.methods).all(same);
            if !fits {
                return None;
            }
            for ((runs, own), study) in share
                .methods
                .into_iter()
                .zip(&mut joined.methods)
                .zip(&mut studies)
            {
                if i > 0 {
                    own.sums.join(&runs.sums);
                }
                study.push(runs.study.runs);
            }
        }
        for (runs, study) in joined.methods.iter_mut().zip(studies) {
            runs.study.runs = in_order(study);
        }
        joined.replicates = joined.methods.first()?.study.runs.len() as u32;
        Some(joined)
    }

    /// The truth for this method.
    pub fn truth(&self, method: &Method) -> &Reference {
        match &self.endless {
            Some(endless) if method.is_endless() => endless,
            _ => &self.reference,
        }
    }
}

/// The most pictures of a size in a replicate.
const MOST_REPEATS: u32 = 8;

/// Why nothing was measured.
#[derive(Debug, thiserror::Error)]
pub enum Nothing {
    /// Asked to stop before the first replicate was finished.
    #[error("stopped before anything was measured")]
    Stopped,
    /// Threads could not be started.
    #[error("the threads cannot be started: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
}

/// Measures what `methods` pay for which error in `scene`.
///
/// Within a replicate methods take turns at each size, and from one to the next their order is
/// reversed and shifted, so that what else a machine does is shared fairly. All pictures have random
/// numbers of their own. Asked to stop, it keeps the replicates that are complete.
pub fn measure(
    scene: &Scene,
    methods: &[Method],
    design: &Design,
    progress: &impl Progress,
) -> Result<Measured, Nothing> {
    let all = Shard { index: 1, count: 1 };
    measure_share(scene, methods, design, all, progress)
}

/// The same for every n-th replicate, of `n` shares of all: what [`Measured::joined`] puts together. The reference is
/// made for each share. Shares agree on sizes where the budget is one of rays.
pub fn measure_share(
    scene: &Scene,
    methods: &[Method],
    design: &Design,
    share: Shard,
    progress: &impl Progress,
) -> Result<Measured, Nothing> {
    let replicates = (share.index - 1..design.replicates).step_by(share.count as usize);
    let timed = rayon::ThreadPoolBuilder::new()
        .num_threads(design.threads.unwrap_or_else(rayon::current_num_threads))
        .build()?;
    let mut watch = Watch::new(progress);
    let pixels = scene.size[0] as usize * scene.size[1] as usize;
    let none = |method: &Method| {
        Some(Runs {
            method: *method,
            study: Study {
                sizes: plan(scene, method, design, &watch)?,
                runs: Vec::new(),
            },
            sums: Sums::none(pixels),
        })
    };
    let runs = timed.install(|| methods.iter().map(none).collect::<Option<Vec<Runs>>>());
    let runs = runs.ok_or(Nothing::Stopped)?;
    let is_endless = methods.iter().any(Method::is_endless);
    let own = Design {
        replicates: replicates.len() as u32,
        ..*design
    };
    watch.total = total(&runs, &own, is_endless, watch.threads);
    let of = |endless| truth(scene, endless, &runs, design, &watch);
    let mut measured = Measured {
        reference: of(false)?,
        endless: is_endless.then(|| of(true)).transpose()?,
        methods: runs,
        replicates: 0,
        interrupted: false,
    };
    let none = replicates.len() == 0;
    for r in replicates {
        let Some(row) = timed.install(|| replicate(scene, &measured, design, r, &watch)) else {
            measured.interrupted = true;
            break;
        };
        for (runs, own) in measured.methods.iter_mut().zip(row) {
            runs.add(own);
        }
        measured.replicates += 1;
    }
    match measured.replicates {
        0 if !none => Err(Nothing::Stopped),
        _ => Ok(measured),
    }
}

/// One picture of a replicate: its numbers, and for the largest size its pixels.
type Pictures = Vec<(Run, Option<(Vec<[f64; 3]>, Vec<f64>)>)>;

/// Every method at every size, once; `None` where it was asked to stop.
fn replicate(
    scene: &Scene,
    measured: &Measured,
    design: &Design,
    r: u32,
    watch: &Watch<impl Progress>,
) -> Option<Vec<Pictures>> {
    let count = measured.methods.len();
    let mut rows: Vec<Pictures> = vec![Vec::new(); count];
    for k in 0..design.sizes as usize {
        for m in order(r, count) {
            let runs = &measured.methods[m];
            let Some(&samples) = runs.study.sizes.get(k) else {
                continue;
            };
            let largest = runs.largest();
            let repeats = repeats(samples, largest);
            let (method, mut own) = (&runs.method, Vec::new());
            let mut pixels = None;
            for repeat in 0..repeats {
                let seed = seed_of(design.seed, r, place([k, m, repeat as usize]));
                let rendered = method.render(scene, samples, seed, watch).ok()?;
                if rendered.interrupted {
                    return None;
                }
                let squares = measured.truth(method).squares(&rendered.film);
                own.push(run_of(&rendered, &squares));
                if samples == largest {
                    pixels = Some((rendered.film.picture().values, squares));
                }
            }
            rows[m].push((mean_of(&own), pixels));
            watch.paid(f64::from(repeats * samples) / f64::from(largest));
        }
    }
    Some(rows)
}

/// Pictures of a size in each replicate: of few samples one picture tells little, and costs little.
fn repeats(spp: u32, largest: u32) -> u32 {
    (largest / spp).clamp(1, MOST_REPEATS)
}

/// The mean of several pictures of a size.
fn mean_of(runs: &[Run]) -> Run {
    let n = runs.len().max(1) as f64;
    let mean = |of: fn(&Run) -> f64| runs.iter().map(of).sum::<f64>() / n;
    let count = |of: fn(&Run) -> u64| runs.iter().map(of).sum::<u64>() / runs.len().max(1) as u64;
    Run {
        square: mean(|run| run.square),
        top_share: mean(|run| run.top_share),
        seconds: mean(|run| run.seconds),
        rays: RayCounts {
            camera: count(|run| run.rays.camera),
            secondary: count(|run| run.rays.secondary),
            shadow: count(|run| run.rays.shadow),
        },
        non_finite: runs.iter().map(|run| run.non_finite).sum(),
    }
}

fn run_of(rendered: &Rendered, squares: &[f64]) -> Run {
    Run {
        square: squares.iter().copied().collect::<Estimate>().mean(),
        top_share: top_share(squares.to_vec()),
        seconds: rendered.time.as_secs_f64(),
        rays: rendered.rays,
        non_finite: rendered.non_finite,
    }
}

impl Runs {
    /// Samples per pixel of the largest size.
    pub fn largest(&self) -> u32 {
        self.study.sizes.last().copied().unwrap_or(1)
    }

    fn add(&mut self, pictures: Pictures) {
        let (row, pixels): (Vec<Run>, Vec<_>) = pictures.into_iter().unzip();
        self.study.runs.push(row);
        for (values, squares) in pixels.into_iter().flatten() {
            self.sums.add(&values, &squares);
        }
    }
}

/// Both halves of a reference.
fn truth(
    scene: &Scene,
    endless: bool,
    runs: &[Runs],
    design: &Design,
    watch: &Watch<impl Progress>,
) -> Result<Reference, Nothing> {
    let base = runs.iter().find(|r| r.method.name == BASE).or(runs.first());
    let largest = base.map_or(1, Runs::largest);
    let spp = largest.saturating_mul(design.reference).min(1 << 20);
    let half = |number: usize| {
        let seed = seed_of(
            design.seed,
            u32::MAX,
            place([usize::from(endless), number, 0]),
        );
        let rendered = method::reference(scene, endless, spp, seed, watch);
        watch.paid(f64::from(design.reference) / watch.threads);
        (!rendered.interrupted)
            .then_some(rendered.film)
            .ok_or(Nothing::Stopped)
    };
    Ok(Reference::new(&half(0)?, &half(1)?, spp))
}

/// A picture's size, method and repeat as one number: at most 256 of each.
fn place(place: [usize; 3]) -> u64 {
    place.iter().fold(0, |all, &part| all << 8 | part as u64)
}

/// What everything costs, in times of a method's largest picture.
fn total(runs: &[Runs], design: &Design, endless: bool, threads: f64) -> f64 {
    let sum = |runs: &Runs| {
        let paid = |&n: &u32| f64::from(n * repeats(n, runs.largest())) / f64::from(runs.largest());
        runs.study.sizes.iter().map(paid).sum::<f64>()
    };
    let halves = 2.0 * (1.0 + f64::from(u8::from(endless)));
    let pictures: f64 = runs.iter().map(sum).sum();
    halves * f64::from(design.reference) / threads + f64::from(design.replicates) * pictures
}

/// Tells how much of everything is paid, in thousandths of a method's largest picture.
struct Watch<'a, P> {
    progress: &'a P,
    threads: f64,
    total: f64,
    paid: Mutex<f64>,
}

impl<'a, P: Progress> Watch<'a, P> {
    /// A watch that does not yet know how much there is to pay.
    fn new(progress: &'a P) -> Self {
        Watch {
            progress,
            threads: rayon::current_num_threads() as f64,
            total: 0.0,
            paid: Mutex::new(0.0),
        }
    }

    fn paid(&self, part: f64) {
        let Ok(mut paid) = self.paid.lock() else {
            return;
        };
        *paid += part;
        self.progress
            .tell((1000.0 * *paid) as u64, (1000.0 * self.total) as u64);
    }
}

/// A picture of many asks whether to stop, and tells nothing of itself.
impl<P: Progress> Progress for Watch<'_, P> {
    fn tell(&self, _: u64, _: u64) {}
    fn stop(&self) -> bool {
        self.progress.stop()
    }
}
