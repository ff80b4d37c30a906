//! The price list: what was measured, as statements.

use super::bias::{Bias, Floor};
use super::method::{BASE, Method};
use super::runs::{Measured, Run, Runs};
use super::size::{Size, Verdict};
use super::target::{Reach, reach};
use crate::lab::experiment::study::Study;
use crate::scene::{RayCounts, Scene};
use crate::stats::Measurement;
use crate::stats::price::{Ratio, ratio};
use crate::stats::slope::{Fit, Insufficient};
use serde::Serialize;

/// Relative errors whose price is stated.
pub const TARGETS: [f64; 3] = [0.05, 0.02, 0.01];

/// What accuracy costs in a scene.
#[derive(Clone, Debug, Serialize)]
pub struct PriceList {
    /// Name of the scene.
    pub scene: String,
    /// The size that was measured, in pixels.
    pub size: [u32; 2],
    /// Replicates of each method.
    pub replicates: u32,
    /// True where it was stopped before the last of them.
    pub interrupted: bool,
    /// Samples per pixel of each half of the reference.
    pub reference_spp: u32,
    /// Relative error of the reference itself.
    pub reference_error: f64,
    /// The methods.
    pub methods: Vec<Priced>,
}

/// What a method asks for accuracy.
#[derive(Clone, Debug, Serialize)]
pub struct Priced {
    /// Its name.
    pub name: &'static str,
    /// How it finds light.
    pub about: &'static str,
    /// Rays of one sample.
    pub rays_per_sample: PerSample,
    /// Seconds of one sample of each pixel, on the threads that were timed.
    pub seconds_per_spp: f64,
    /// Error and cost at each size, the smallest first.
    pub sizes: Vec<Size>,
    /// The line of error against rays.
    pub against_rays: Result<Fit, Insufficient>,
    /// The line of error against seconds.
    pub against_seconds: Result<Fit, Insufficient>,
    /// What can be said about its error.
    pub verdict: Verdict,
    /// Why its answer may not be the truth.
    pub may_be_biased: Option<&'static str>,
    /// How far its expectation is from the truth; `None` below two replicates.
    pub bias: Option<Bias>,
    /// Where its error levels out; `None` where it is not known to.
    pub levels_out: Option<Floor>,
    /// What each of [`TARGETS`] costs.
    pub times: Vec<Reach>,
    /// The time it needs for the same error, in times of that of each method in the list, by seconds;
    /// `None` where either is biased, in the scene or by its nature.
    pub ratios: Vec<Option<Ratio>>,
    /// The same by rays.
    pub ray_ratios: Vec<Option<Ratio>>,
    /// Samples that were no number, in all pictures.
    pub non_finite: u64,
}

/// Rays of one sample, by what they were for.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct PerSample {
    /// From the camera: one.
    pub camera: f64,
    /// From surface to surface.
    pub secondary: f64,
    /// To lamps.
    pub shadow: f64,
}

impl PriceList {
    /// What was measured in `scene`, as a price list.
    pub fn new(scene: &Scene, measured: &Measured) -> PriceList {
        let mut methods: Vec<Priced> = measured
            .methods
            .iter()
            .map(|m| priced(m, measured))
            .collect();
        for (i, a) in measured.methods.iter().enumerate() {
            for (j, b) in measured.methods.iter().enumerate() {
                let biased = |k: usize| {
                    let by_nature = measured.methods[k].method.integrator.biased.is_some();
                    by_nature || methods[k].verdict == Verdict::Biased
                };
                let fair = i != j && !biased(i) && !biased(j);
                let by = |cost: fn(&Run) -> f64| {
                    let [a, b] = [a, b].map(|runs| runs.study.largest(square, cost));
                    ratio(&a, &b).filter(|_| fair)
                };
                methods[i].ratios.push(by(seconds));
                methods[i].ray_ratios.push(by(rays));
            }
        }
        PriceList {
            scene: scene.name.clone(),
            size: scene.size,
            replicates: measured.replicates,
            interrupted: measured.interrupted,
            reference_spp: measured.reference.spp,
            reference_error: measured.reference.error(),
            methods,
        }
    }

    /// The method of this name.
    pub fn find(&self, name: &str) -> Option<&Priced> {
        self.methods.iter().find(|m| m.name == name)
    }

    /// How many times the time of `path` a method needs for the same error, and how many times its
    /// rays.
    pub fn against_base(&self, method: &Priced) -> Option<[Ratio; 2]> {
        let base = self.methods.iter().position(|m| m.name == BASE)?;
        let of = |ratios: &[Option<Ratio>]| ratios.get(base).copied().flatten();
        Some([of(&method.ratios)?, of(&method.ray_ratios)?])
    }
}

fn square(run: &Run) -> f64 {
    run.square
}

fn seconds(run: &Run) -> f64 {
    run.seconds
}

fn rays(run: &Run) -> f64 {
    run.rays.total() as f64
}

fn priced(runs: &Runs, measured: &Measured) -> Priced {
    let study = &runs.study;
    let against_rays = study.fit(|_, run| rays(run), square);
    let against_seconds = study.fit(|_, run| seconds(run), square);
    let largest = study.largest(square, seconds);
    let bias = runs.sums.bias(measured.truth(&runs.method));
    let sizes: Vec<Size> = (0..study.sizes.len()).map(|k| size(study, k)).collect();
    let verdict = verdict(&against_rays, bias, &runs.method);
    // The error of the largest pictures, and two of its own errors more.
    let most_off = sizes
        .last()
        .map_or(f64::INFINITY, |s| s.error + 2.0 * s.error_error);
    let mut counts = RayCounts::default();
    let all = || study.runs.iter().flatten();
    all().for_each(|run| counts += run.rays);
    let camera = counts.camera.max(1) as f64;
    Priced {
        name: runs.method.name,
        about: runs.method.about,
        rays_per_sample: PerSample {
            camera: 1.0,
            secondary: counts.secondary as f64 / camera,
            shadow: counts.shadow as f64 / camera,
        },
        seconds_per_spp: sizes.last().map_or(0.0, |s| s.seconds / f64::from(s.spp)),
        times: TARGETS
            .iter()
            .map(|&target| reach(target, &sizes, &largest, verdict, bias))
            .collect(),
        sizes,
        against_rays,
        against_seconds,
        verdict,
        may_be_biased: runs.method.may_be_biased,
        bias,
        levels_out: bias
            .filter(|_| verdict == Verdict::Biased)
            .map(|bias| bias.levels_out().at_most(most_off)),
        ratios: Vec::new(),
        ray_ratios: Vec::new(),
        non_finite: all().map(|run| run.non_finite).sum(),
    }
}

fn size(study: &Study<Run>, k: usize) -> Size {
    let mut sorted: Vec<f64> = study.runs.iter().map(|row| row[k].seconds).collect();
    sorted.sort_by(f64::total_cmp);
    let Measurement { value, error } = study.at(k, square).root();
    let at = |share: f64| sorted[(share * (sorted.len() - 1) as f64).round() as usize];
    Size {
        spp: study.sizes[k],
        rays: study.at(k, rays).mean(),
        seconds: at(0.5),
        mean_seconds: study.at(k, seconds).mean(),
        spread: at(0.75) - at(0.25),
        error: value,
        error_error: error,
        top_share: study.at(k, |run| run.top_share).mean(),
    }
}

/// What a line and a bias allow to say.
///
/// An integrator that is biased in any scene ([`Entry::biased`](crate::integrators::Entry::biased)) is never
/// called sufficient, though its bias may still hide in its noise.
fn verdict(fit: &Result<Fit, Insufficient>, bias: Option<Bias>, method: &Method) -> Verdict {
    if bias.is_some_and(|bias| bias.is_certain()) {
        return Verdict::Biased;
    }
    let independent = method.is_independent();
    match fit {
        _ if method.integrator.biased.is_some() => Verdict::Insufficient,
        Ok(fit) if fit.agrees_with(-0.5) && independent => Verdict::Sufficient,
        Ok(fit) if !independent && fit.line.slope - fit.half_width <= -0.5 => Verdict::Faster,
        _ => Verdict::Insufficient,
    }
}

impl Priced {
    /// The verdict with its numbers, in a few words.
    pub fn says(&self) -> String {
        match (self.verdict, &self.against_rays) {
            (Verdict::Biased, _) => {
                let why = self.may_be_biased.unwrap_or("and no reason is known");
                let floor = self.levels_out.map_or_else(String::new, |f| f.to_string());
                format!("biased: levels out {floor}; {why}")
            }
            (Verdict::Sufficient, Ok(fit)) => format!("{fit}, sufficient"),
            (Verdict::Faster, Ok(fit)) => format!("{fit}, as Sobol' points do"),
            (_, Ok(fit)) if fit.agrees_with(-0.5) => {
                let why = self.may_be_biased.unwrap_or("and no reason is known");
                format!("insufficient: {fit}, but its bias may be hidden by noise: {why}")
            }
            (_, Ok(fit)) => format!("insufficient: {fit} does not hold -1/2"),
            (_, Err(why)) => format!("insufficient: {why}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stats::slope::Line;

    #[test]
    fn a_biased_integrator_is_never_sufficient() {
        let line = Line::through(&[(1.0, 1.0), (4.0, 0.5)]).unwrap();
        let fit = Ok(Fit {
            line,
            std_error: 0.01,
            half_width: 0.02,
        });
        let of = |name: &str| verdict(&fit, None, &Method::find(name).unwrap());
        assert_eq!(of("path"), Verdict::Sufficient);
        for biased in ["photons", "radiosity"] {
            assert_eq!(of(biased), Verdict::Insufficient, "{biased}");
        }
    }
}
