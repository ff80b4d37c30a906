//! Chapter 3: Hit or miss.
//!
//! Question: how can random numbers answer a question that has nothing random in it?
//! New here: `estimators::hit_or_miss`, `estimators::many_dimensions`, `experiment::convergence`.

mod checks;
mod figures;
mod finale;

use checks::{BATCHES, checked, coverage, relative, slope, spread};
use halfdisk::lab::chapter::{Chapter, Desk, DeskError};
use halfdisk::lab::estimators::hit_or_miss;
use halfdisk::lab::experiment::convergence::{Design, converge};
use halfdisk::lab::experiment::named;
use halfdisk::lab::ledger::Ledger;
use halfdisk::stats::Estimate;
use halfdisk::stats::z_test::Largest;
use rayon::prelude::*;
use std::f64::consts::{FRAC_1_SQRT_2, PI};
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch03",
    title: "Hit or miss",
    question: "How can random numbers answer a question that has nothing random in it, and how far \
               off are they?",
};

/// Samples of each run that is asked whether its band holds the truth.
const RUN: u32 = 400;
/// Points to spend in any number of dimensions.
const POINTS: u32 = 4096;

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    let seed = desk.options.seed;
    // Every run of every experiment has a seed of its own.
    let first = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let own = |part: u64, run: u64| first.wrapping_add(part << 48 | run);
    let mut compared = Largest::default();

    // What one dart, and one height, is worth.
    let batch = desk.choose(1 << 18, 1 << 14);
    let darts = spread(|i| hit_or_miss::darts(batch, own(1, i)));
    let heights = spread(|i| hit_or_miss::sample_mean(batch, own(2, i)));
    for (name, [mean, variance], exact) in [
        ("darts", &darts, PI * (4.0 - PI)),
        ("mean", &heights, 32.0 / 3.0 - PI * PI),
    ] {
        let (value, error) = (mean.mean(), mean.std_error());
        let (key, says) = (format!("pi_{name}"), format!("pi, by {name}"));
        compared.add(checked(desk, &key, &says, [value, error, PI]));
        let sigma = variance.mean().sqrt();
        let found = [sigma, variance.std_error() / (2.0 * sigma), exact.sqrt()];
        let says = "  standard deviation of one sample";
        compared.add(checked(desk, &format!("sigma_{name}"), says, found));
    }
    let [dart, height] = [darts[1], heights[1]];
    let ratio = dart.mean() / height.mean();
    let error = ratio * relative(&[dart, height]);
    let exact = PI * (4.0 - PI) / (32.0 / 3.0 - PI * PI);
    let says = "darts for the error of one height";
    compared.add(checked(desk, "variance_ratio", says, [ratio, error, exact]));
    figures::darts(desk)?;
    figures::running(desk)?;

    // ANCHOR: coverage
    // How often does the band of two standard errors hold the truth?
    let runs = desk.choose(40_000, 4_000);
    let held = (0..runs).into_par_iter().filter(|&i| {
        let run = hit_or_miss::darts(RUN, own(3, i));
        run.interval(2.0).contains(PI)
    });
    let share = Estimate::from_hits(held.count() as u64, runs);
    // ANCHOR_END: coverage
    let says = "share of bands of two standard errors that hold pi";
    let found = [share.mean(), share.std_error(), coverage(RUN)];
    compared.add(checked(desk, "coverage", says, found));

    // The rate: error against samples, over independent repetitions.
    let design = Design {
        replicates: 256,
        doublings: desk.choose(10, 9),
        first: 64,
        seed,
    };
    let rates = [
        ("darts", -0.5),
        ("sample-mean", -0.5),
        ("jittered-darts", -0.75),
        ("step", -0.5),
    ];
    let mut curves = Vec::new();
    for (name, exact) in rates {
        let Some(estimator) = named::find(name) else {
            continue;
        };
        let run = converge(&estimator, &design);
        let z = slope(desk, &run, exact);
        // The power -3/4 is that of many darts: at few of them it is no closed form.
        if exact == -0.5 {
            compared.add(z);
        }
        curves.push(run);
    }
    figures::chart(desk, &curves)?;

    // ANCHOR: worse
    // Two independent runs, one of twice as many samples: how often is it further off?
    let pairs = desk.choose(40_000, 10_000);
    let error = |n, seed| (hit_or_miss::sample_mean(n, seed).mean() - PI).abs();
    let worse = (0..pairs)
        .into_par_iter()
        .filter(|&i| error(400, own(4, i)) > error(200, own(5, i)));
    let share = Estimate::from_hits(worse.count() as u64, pairs);
    // ANCHOR_END: worse
    let exact = 2.0 / PI * libm::atan(FRAC_1_SQRT_2);
    let says = "share of pairs in which twice the samples are further off";
    let found = [share.mean(), share.std_error(), exact];
    compared.add(checked(desk, "worse", says, found));

    // The same number of points in 1 to 8 dimensions, on a grid and by chance.
    let replicates = desk.choose(128, 64);
    let (by_dimension, spent) = figures::dimensions(desk, POINTS, replicates)?;
    let last = finale::work(desk)?;
    let samples = curves.iter().flat_map(|run| &run.sizes);
    let rate: u64 = samples.map(|s| s.rays).sum::<u64>() * u64::from(design.replicates);
    let variance = dart.mean();
    Ok(Ledger {
        rays: 2 * BATCHES * u64::from(batch)
            + runs * u64::from(RUN)
            + rate
            + pairs * 600
            + spent
            + last,
        variance: Some(variance),
        compared: Some(compared.with(by_dimension).into()),
        efficiency: Some(1.0 / variance),
        ..Ledger::of(
            "Any integral, with an error bar of its own; one more digit takes a hundred times the \
             samples.",
        )
    })
}
