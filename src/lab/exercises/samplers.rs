//! What is asked of a sampler and its density, in the half disk and on the hemisphere.

use super::Question;
use crate::sampling::stream::{Purpose, Stream};
use crate::stats::chi_square::{ChiSquare, chi_square};
use glam::{Vec2, Vec3};
use std::f64::consts::{FRAC_PI_6, PI, TAU};

/// A sampler of directions over a surface of the flat world; `y` is the normal.
#[derive(Clone, Copy, Debug)]
pub struct FlatSampler {
    /// Turns a uniform in `[0, 1)` into a unit direction.
    pub sample: fn(f32) -> Vec2,
    /// The density of a unit direction, per radian.
    pub pdf: fn(Vec2) -> f32,
}

/// A sampler of directions over a surface in space; `z` is the normal.
#[derive(Clone, Copy, Debug)]
pub struct SolidSampler {
    /// Turns two uniforms in `[0, 1)` into a unit direction.
    pub sample: fn([f32; 2]) -> Vec3,
    /// The density of a unit direction, per steradian.
    pub pdf: fn(Vec3) -> f32,
}

/// What a right sampler of the flat world reads.
pub(super) struct FlatTruth {
    /// The mean of `y`.
    pub y: f64,
    /// The mean of `x²`.
    pub x2: f64,
    /// The density along the normal.
    pub up: f64,
    /// The density 30 degrees above the surface.
    pub low: f64,
}

/// So far off the unit circle a direction is of another length.
const OFF: f32 = 1e-5;

pub(super) fn is_not_one(length: f32) -> bool {
    length.is_nan() || (length - 1.0).abs() > OFF
}

fn at_angle(theta: f64) -> Vec2 {
    Vec2::new(libm::cos(theta) as f32, libm::sin(theta) as f32)
}

/// The questions to a sampler of the flat world.
pub(super) fn flat(truth: FlatTruth) -> Vec<Question<FlatSampler>> {
    vec![
        Question::never("directions below the surface", |a: &FlatSampler, d| {
            (a.sample)(d.one()).y < -OFF
        }),
        Question::never("directions whose length is not 1", |a: &FlatSampler, d| {
            is_not_one((a.sample)(d.one()).length())
        }),
        Question::mean(
            "the mean of y over your directions",
            truth.y,
            |a: &FlatSampler, d| (a.sample)(d.one()).y.into(),
        ),
        Question::mean(
            "the mean of x over your directions",
            0.0,
            |a: &FlatSampler, d| (a.sample)(d.one()).x.into(),
        ),
        Question::mean(
            "the mean of x² over your directions",
            truth.x2,
            |a: &FlatSampler, d| f64::from((a.sample)(d.one()).x).powi(2),
        ),
        Question::exact(
            "the integral of your density over the half disk",
            1.0,
            |a: &FlatSampler| PI * mean_over(4096, |t| (a.pdf)(at_angle(PI * t)).into()),
        ),
        Question::exact(
            "your density along the normal",
            truth.up,
            |a: &FlatSampler| (a.pdf)(Vec2::Y).into(),
        ),
        Question::exact(
            "your density 30 degrees above the surface",
            truth.low,
            |a: &FlatSampler| (a.pdf)(at_angle(FRAC_PI_6)).into(),
        ),
        Question::exact("your density below the surface", 0.0, |a: &FlatSampler| {
            (a.pdf)(at_angle(-FRAC_PI_6)).into()
        }),
        Question::fit("your directions do not follow your density", fit_flat),
    ]
}

/// The questions to a sampler proportional to the cosine in space.
pub(super) fn cosine_in_space() -> Vec<Question<SolidSampler>> {
    let up = std::f64::consts::FRAC_1_PI;
    vec![
        Question::never("directions below the surface", |a: &SolidSampler, d| {
            (a.sample)(d.two()).z < -OFF
        }),
        Question::never("directions whose length is not 1", |a: &SolidSampler, d| {
            is_not_one((a.sample)(d.two()).length())
        }),
        Question::mean(
            "the mean of z over your directions",
            2.0 / 3.0,
            |a: &SolidSampler, d| (a.sample)(d.two()).z.into(),
        ),
        Question::mean(
            "the mean of x over your directions",
            0.0,
            |a: &SolidSampler, d| (a.sample)(d.two()).x.into(),
        ),
        Question::mean(
            "the mean of y over your directions",
            0.0,
            |a: &SolidSampler, d| (a.sample)(d.two()).y.into(),
        ),
        Question::mean(
            "the mean of x² over your directions",
            0.25,
            |a: &SolidSampler, d| f64::from((a.sample)(d.two()).x).powi(2),
        ),
        Question::exact(
            "the integral of your density over the hemisphere",
            1.0,
            |a: &SolidSampler| TAU * mean_over(4096, |z| (a.pdf)(at_height(z, 1.0)).into()),
        ),
        Question::exact("your density along the normal", up, |a: &SolidSampler| {
            (a.pdf)(Vec3::Z).into()
        }),
        Question::exact(
            "your density 30 degrees above the surface",
            0.5 * up,
            |a: &SolidSampler| (a.pdf)(at_height(0.5, 2.0)).into(),
        ),
        Question::exact("your density below the surface", 0.0, |a: &SolidSampler| {
            (a.pdf)(at_height(-0.5, 2.0)).into()
        }),
        Question::fit("your directions do not follow your density", fit_solid),
    ]
}

/// The direction of height `z` and azimuth `phi`.
pub(super) fn at_height(z: f64, phi: f64) -> Vec3 {
    let r = (1.0 - z * z).max(0.0).sqrt();
    Vec3::new(
        (r * libm::cos(phi)) as f32,
        (r * libm::sin(phi)) as f32,
        z as f32,
    )
}

/// The mean of a function over `[0, 1]`, by the middles of so many steps.
pub(super) fn mean_over(steps: u32, f: impl Fn(f64) -> f64) -> f64 {
    let n = f64::from(steps);
    (0..steps).map(|i| f((f64::from(i) + 0.5) / n)).sum::<f64>() / n
}

/// Samples of a chi-square test, and its cells along each angle.
const SAMPLES: u32 = 1 << 16;
const CELLS: usize = 32;
/// Points of a cell at which the density is asked.
const POINTS: u32 = 32;

fn uniforms(seed: u64, i: u32) -> [f32; 2] {
    Stream::new(seed, i, 0).at(0, Purpose::Direction).two()
}

/// The cell of a number in `[0, 1)`; rounding may put it at an end.
fn cell(share: f64, cells: usize) -> usize {
    ((share * cells as f64) as usize).min(cells - 1)
}

/// Compares counts with what a density expects of each cell. A density that does not integrate to one is found by
/// another question, so it is scaled here.
fn test(counts: &[u64], density: &[f64]) -> ChiSquare {
    let total: f64 = density.iter().map(|x| x.max(0.0)).sum();
    let expected: Vec<f64> = density
        .iter()
        .map(|x| f64::from(SAMPLES) * x.max(0.0) / total)
        .collect();
    match total.is_finite() && total > 0.0 {
        true => chi_square(counts, &expected),
        false => ChiSquare {
            statistic: f64::INFINITY,
            freedom: 0,
            p: 0.0,
        },
    }
}

fn fit_flat(answer: &FlatSampler, seed: u64) -> ChiSquare {
    let mut counts = [0; CELLS];
    for i in 0..SAMPLES {
        let w = (answer.sample)(uniforms(seed, i)[0]).as_dvec2();
        // What rounding puts a little below the end of the half disk belongs to it.
        let y = if w.y.abs() < OFF.into() { 1e-9 } else { w.y };
        let turn = libm::atan2(y, w.x) / TAU;
        counts[cell(turn.rem_euclid(1.0), CELLS)] += 1;
    }
    let density = |k: usize| {
        mean_over(POINTS, |t| {
            let turn = (k as f64 + t) / CELLS as f64;
            (answer.pdf)(at_angle(TAU * turn)).into()
        })
    };
    test(&counts, &(0..CELLS).map(density).collect::<Vec<_>>())
}

fn fit_solid(answer: &SolidSampler, seed: u64) -> ChiSquare {
    const AROUND: usize = 8;
    let mut counts = [0; CELLS * AROUND];
    for i in 0..SAMPLES {
        let w = (answer.sample)(uniforms(seed, i)).as_dvec3();
        let height = cell((0.5 + 0.5 * w.z).max(0.0), CELLS);
        let turn = (libm::atan2(w.y, w.x) / TAU).rem_euclid(1.0);
        counts[height * AROUND + cell(turn, AROUND)] += 1;
    }
    let density = |k: usize| {
        let (height, around) = (k / AROUND, k % AROUND);
        let phi = TAU * (around as f64 + 0.5) / AROUND as f64;
        mean_over(POINTS, |t| {
            let z = 2.0 * (height as f64 + t) / CELLS as f64 - 1.0;
            (answer.pdf)(at_height(z, phi)).into()
        })
    };
    let density: Vec<f64> = (0..CELLS * AROUND).map(density).collect();
    test(&counts, &density)
}
