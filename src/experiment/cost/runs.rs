//! The pictures: every method at every size, many times, in turns.

use super::bias::Sums;
use super::method::{self, BASE, Method};
use super::plan::{Design, Planned, plan};
use super::reference::Reference;
use crate::render::accuracy::top_share;
use crate::render::{Progress, Rendered};
use crate::scene::{RayCounts, Scene};
use crate::stats::Estimate;
use std::sync::Mutex;

/// What a picture cost, and how wrong it is: the mean of up to eight of a size.
#[derive(Clone, Copy, Debug, PartialEq)]
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
#[derive(Clone, Debug)]
pub struct Runs {
    /// The method.
    pub method: Method,
    /// Samples per pixel at each size, the smallest first.
    pub spp: Vec<u32>,
    /// `runs[r][k]`: replicate `r` at size `k`.
    pub runs: Vec<Vec<Run>>,
    /// What the pictures of the largest size add up to.
    pub(super) sums: Sums,
}

/// Everything that was measured.
#[derive(Clone, Debug)]
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
    let timed = rayon::ThreadPoolBuilder::new()
        .num_threads(design.threads.unwrap_or_else(rayon::current_num_threads))
        .build()?;
    let quiet = Quiet(progress);
    let planned: Vec<Planned> = timed
        .install(|| {
            methods
                .iter()
                .map(|m| plan(scene, *m, design, &quiet))
                .collect::<Option<_>>()
        })
        .ok_or(Nothing::Stopped)?;
    let watch = Watch::new(progress, &planned, design, rayon::current_num_threads());
    let of = |endless| truth(scene, endless, &planned, design, &watch);
    let reference = of(false)?;
    let endless = match methods.iter().any(Method::is_endless) {
        true => Some(of(true)?),
        false => None,
    };
    let mut measured = Measured {
        methods: planned
            .into_iter()
            .map(|p| Runs::none(p, &reference))
            .collect(),
        reference,
        endless,
        replicates: 0,
        interrupted: false,
    };
    for r in 0..design.replicates {
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
        0 => Err(Nothing::Stopped),
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
            let Runs { method, spp, .. } = &measured.methods[m];
            let Some(&samples) = spp.get(k) else { continue };
            let largest = spp[spp.len() - 1];
            let repeats = repeats(samples, largest);
            let mut runs = Vec::new();
            let mut pixels = None;
            for repeat in 0..repeats {
                let seed = seed_of(design.seed, r, [k, m, repeat as usize]);
                let rendered = method.render(scene, samples, seed, watch);
                if rendered.interrupted {
                    return None;
                }
                let squares = measured.truth(method).squares(&rendered.film);
                runs.push(run_of(&rendered, &squares));
                if samples == largest {
                    pixels = Some((rendered.film.picture().values, squares));
                }
            }
            rows[m].push((mean_of(&runs), pixels));
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

/// Forwards, backwards, and a place further on every second time.
fn order(r: u32, count: usize) -> Vec<usize> {
    let shift = r as usize / 2;
    let mut order: Vec<usize> = (0..count).map(|i| (i + shift) % count).collect();
    if r % 2 == 1 {
        order.reverse();
    }
    order
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
    fn none(planned: Planned, reference: &Reference) -> Runs {
        Runs {
            method: planned.method,
            spp: planned.spp,
            runs: Vec::new(),
            sums: Sums::none(reference.picture.values.len()),
        }
    }

    fn add(&mut self, pictures: Pictures) {
        let mut row = Vec::with_capacity(pictures.len());
        for (run, pixels) in pictures {
            row.push(run);
            if let Some((values, squares)) = pixels {
                self.sums.add(&values, &squares);
            }
        }
        self.runs.push(row);
    }
}

/// Both halves of a reference.
fn truth(
    scene: &Scene,
    endless: bool,
    planned: &[Planned],
    design: &Design,
    watch: &Watch<impl Progress>,
) -> Result<Reference, Nothing> {
    let base = planned
        .iter()
        .find(|p| p.method.name == BASE)
        .or(planned.first());
    let largest = base.and_then(|p| p.spp.last()).copied().unwrap_or(1);
    let spp = largest.saturating_mul(design.reference).min(1 << 20);
    let half = |number: usize| {
        let seed = seed_of(design.seed, u32::MAX, [usize::from(endless), number, 0]);
        let rendered = method::reference(scene, endless, spp, seed, watch);
        watch.paid(f64::from(design.reference) / watch.threads);
        (!rendered.interrupted)
            .then_some(rendered.film)
            .ok_or(Nothing::Stopped)
    };
    Ok(Reference::new(&half(0)?, &half(1)?, spp))
}

/// A seed that no other picture has: at most 256 sizes, methods and repeats.
fn seed_of(seed: u64, replicate: u32, place: [usize; 3]) -> u64 {
    let place = place.iter().fold(0, |all, &part| all << 8 | part as u64);
    // An odd factor is a bijection; neighbouring seeds of a design stay far apart.
    seed.wrapping_mul(0x9e37_79b9_7f4a_7c15)
        .wrapping_add(place << 32 | u64::from(replicate))
}

/// Tells how much of everything is paid, in thousandths of a method's largest picture.
struct Watch<'a, P> {
    progress: &'a P,
    threads: f64,
    total: f64,
    paid: Mutex<f64>,
}

impl<'a, P: Progress> Watch<'a, P> {
    fn new(progress: &'a P, planned: &[Planned], design: &Design, threads: usize) -> Self {
        let sum = |p: &Planned| {
            let largest = p.spp.last().copied().unwrap_or(1);
            let paid = |&n: &u32| f64::from(n * repeats(n, largest)) / f64::from(largest);
            p.spp.iter().map(paid).sum::<f64>()
        };
        let endless = planned.iter().any(|p| p.method.is_endless());
        let halves = 2.0 * (1.0 + f64::from(u8::from(endless)));
        let pictures: f64 = planned.iter().map(sum).sum();
        Watch {
            progress,
            threads: threads as f64,
            total: halves * f64::from(design.reference) / threads as f64
                + f64::from(design.replicates) * pictures,
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

/// The same before there is a plan.
struct Quiet<'a, P>(&'a P);

impl<P: Progress> Progress for Quiet<'_, P> {
    fn tell(&self, _: u64, _: u64) {}
    fn stop(&self) -> bool {
        self.0.stop()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn methods_take_turns() {
        assert_eq!(order(0, 3), [0, 1, 2]);
        assert_eq!(order(1, 3), [2, 1, 0]);
        assert_eq!(order(2, 3), [1, 2, 0]);
        assert_eq!(order(3, 3), [0, 2, 1]);
    }

    #[test]
    fn no_two_pictures_share_a_seed() {
        let mut seen = std::collections::BTreeSet::new();
        for r in (0..20).chain([u32::MAX]) {
            for k in 0..6 {
                for m in 0..9 {
                    for repeat in 0..8 {
                        assert!(seen.insert(seed_of(1, r, [k, m, repeat])));
                    }
                }
            }
        }
    }
}
