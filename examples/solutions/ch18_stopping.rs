//! Chapter 18, exercise 2: a rule that stops when the error looks small is biased.
//!
//! Each pixel adds samples until its own estimated error is small enough. Where light comes in rare
//! bright samples, a pixel that has not met one yet looks dark and sure of it, and stops.

#![allow(clippy::print_stdout)]

use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::stats::Estimate;

/// A sample of mean 1: 10 with the probability 1/10, else 0.
const CHANCE: f32 = 0.1;
/// The standard error at which a pixel has enough.
const ENOUGH: f64 = 0.25;
/// The fewest samples of a pixel, and the most.
const FEWEST: u32 = 8;
const MOST: u32 = 4096;

fn sample(pixel: u32, number: u32, seed: u64) -> f64 {
    let u = Stream::new(seed, pixel, number)
        .at(0, Purpose::Integrand)
        .one();
    if u < CHANCE {
        1.0 / f64::from(CHANCE)
    } else {
        0.0
    }
}

/// A pixel that stops when it looks good.
fn adaptive(pixel: u32) -> Estimate {
    let mut estimate = Estimate::new();
    for number in 0..MOST {
        estimate.add(sample(pixel, number, 1));
        if number + 1 >= FEWEST && estimate.std_error() <= ENOUGH {
            break;
        }
    }
    estimate
}

/// A pixel that takes as many samples as a pilot of its own random numbers says, and forgets the pilot.
fn two_stages(pixel: u32) -> Estimate {
    let pilot: Estimate = (0..64).map(|n| sample(pixel, n, 2)).collect();
    let needed = (pilot.variance() / (ENOUGH * ENOUGH)).ceil() as u32;
    (0..needed.clamp(FEWEST, MOST))
        .map(|n| sample(pixel, n, 3))
        .collect()
}

/// Means of many pixels by one rule, and the samples they took.
fn measure(rule: fn(u32) -> Estimate, pixels: u32) -> (Estimate, f64) {
    let found: Vec<Estimate> = (0..pixels).map(rule).collect();
    let samples: u64 = found.iter().map(Estimate::count).sum();
    (
        found.iter().map(Estimate::mean).collect(),
        samples as f64 / f64::from(pixels),
    )
}

fn main() {
    let pixels = 100_000;
    for (name, rule) in [
        ("stops when it looks good", adaptive as fn(u32) -> Estimate),
        ("as many as a pilot says", two_stages),
    ] {
        let (mean, samples) = measure(rule, pixels);
        println!(
            "{name:26} mean {:.4} ± {:.4} for 1, {samples:.0} samples a pixel",
            mean.mean(),
            mean.std_error()
        );
    }
    let none = (0..FEWEST).fold(1.0, |p, _| p * (1.0 - f64::from(CHANCE)));
    println!(
        "pixels that meet no light in {FEWEST} samples and stop: {:.1} %",
        100.0 * none
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stopping_when_it_looks_good_loses_light_and_a_pilot_does_not() {
        let (adaptive, _) = measure(adaptive, 20_000);
        let (pilot, _) = measure(two_stages, 20_000);
        assert!(pilot.z(1.0).abs() < 4.0, "{}", pilot.z(1.0));
        assert!(adaptive.z(1.0) < -20.0, "{}", adaptive.z(1.0));
        // Dark pixels alone lose 0.9^8 of the light.
        assert!(adaptive.mean() < 1.0 - 0.4, "{}", adaptive.mean());
    }
}
