//! How noise and blur fall.

use super::mirrored::{MIRRORED, ONCE, exact};
use super::{fixed, rendered, scene};
use crate::checks::CRITICAL;
use glam::Vec2;
use halfdisk::integrators::Photons;
use halfdisk::photons::radius;
use halfdisk::sampling::stream::{Numbers, Purpose, Stream};
use halfdisk::space::{Dimension, Flat, Solid, Space};
use halfdisk::stats::Estimate;
use halfdisk::stats::slope::fit;
use rayon::prelude::*;

#[test]
fn the_error_falls_as_it_should() {
    let scene = scene(MIRRORED).sized([2, 2]);
    let truth = exact(&scene, 2, 0.0);
    let slope = |alpha: f64| {
        let sizes: Vec<u32> = (4..=9).map(|k| 1 << k).collect();
        let squared = |replicate: u64, size: &u32| {
            let photons = Photons {
                alpha,
                ..fixed(ONCE, 1.6, 32)
            };
            let seed = replicate << 32 | u64::from(*size);
            let film = rendered(&scene, &photons, *size, seed).film;
            let pixels = film.pixels().iter().map(|p| p.mean().unwrap()[0]);
            let squares = pixels.zip(&truth).map(|(x, truth)| (x - truth).powi(2));
            squares.sum::<f64>()
        };
        let replicates: Vec<u64> = (0..100).collect();
        let squares = replicates.into_par_iter();
        let squares = squares.map(|r| sizes.iter().map(|size| squared(r, size)).collect());
        let squares: Vec<Vec<f64>> = squares.collect();
        let costs = vec![sizes.iter().map(|&n| f64::from(n)).collect(); squares.len()];
        fit(&costs, &squares).unwrap()
    };
    let (shrinking, staying) = (slope(radius::fastest::<Solid>()), slope(1.0));
    println!("shrinking {shrinking}, staying {staying}");
    let off = shrinking.line.slope + 1.0 / 3.0;
    assert!(off.abs() < 0.05, "{shrinking}");
    assert!(shrinking.half_width < 0.04, "{shrinking}");
    assert!(staying.line.slope > -0.25, "{staying}");
}

/// A lamp at height 1 over a surface: where one of its photons lands.
fn lands<S: Space>(numbers: &mut Numbers) -> S::Vector {
    match S::DIMENSION {
        Dimension::Flat => {
            let angle = std::f64::consts::PI * (f64::from(numbers.one()) - 0.5);
            S::from_plane(Vec2::new(libm::tan(angle) as f32, 0.0))
        }
        Dimension::Solid => {
            let cos = 1.0 - f64::from(numbers.one());
            let aside = (1.0 - cos * cos).sqrt() / cos;
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(numbers.one()));
            S::from_plane(Vec2::new((aside * cos) as f32, (aside * sin) as f32))
        }
    }
}

/// The share of its photons within a radius of the point below it, over the measure of that disc.
fn below<S: Space>(radius: f64) -> f64 {
    let share = match S::DIMENSION {
        Dimension::Flat => libm::atan(radius) * std::f64::consts::FRAC_2_PI,
        Dimension::Solid => 1.0 - 1.0 / (1.0 + radius * radius).sqrt(),
    };
    share / S::disc(radius)
}

const FIRST: f64 = 0.5;

/// The density below the lamp after 1, 2, 3 … passes of a few photons each.
fn progressive<S: Space>(alpha: f64, passes: u32, replicate: u32) -> Vec<f64> {
    let photons = [64, 16][usize::from(S::FALL_OFF == 1)];
    let mut sum = 0.0;
    let mut disc = 1.0;
    let one = |pass: u32| {
        if pass > 0 {
            disc *= (f64::from(pass) + alpha) / (f64::from(pass) + 1.0);
        }
        let radius = FIRST * libm::pow(disc, 1.0 / f64::from(S::FALL_OFF));
        let mut numbers = Stream::new(21, replicate, pass).at(0, Purpose::Emission);
        let within = (0..photons).filter(|_| {
            let p = lands::<S>(&mut numbers);
            f64::from(S::dot(p, p)) < radius * radius
        });
        sum += within.count() as f64 / (f64::from(photons) * S::disc(radius));
        sum / f64::from(pass + 1)
    };
    (0..passes).map(one).collect()
}

#[test]
fn s0_08_noise_and_blur_fall_together_in_both_worlds() {
    fn check<S: Space>(slope: f64) {
        const PASSES: u32 = 1 << 11;
        let sizes: Vec<u32> = (5..=11).map(|k| 1 << k).collect();
        let runs = |alpha: f64| -> Vec<Vec<f64>> {
            let replicates = (0..600_u32).into_par_iter();
            replicates
                .map(|replicate| {
                    let means = progressive::<S>(alpha, PASSES, replicate);
                    sizes.iter().map(|&n| means[n as usize - 1]).collect()
                })
                .collect()
        };
        let truth = below::<S>(1e-6);
        let fitted = |runs: &[Vec<f64>]| {
            let square = |mean: &f64| (mean - truth).powi(2);
            let squares: Vec<Vec<f64>> = runs
                .iter()
                .map(|run| run.iter().map(square).collect())
                .collect();
            let costs = vec![sizes.iter().map(|&n| f64::from(n)).collect(); runs.len()];
            fit(&costs, &squares).unwrap()
        };
        // The blur that is predicted, from the radii alone.
        let blur = |alpha: f64| {
            let read = |k| below::<S>(FIRST * radius::shrunk::<S>(alpha, k)) - truth;
            (0..PASSES).map(read).sum::<f64>() / f64::from(PASSES)
        };
        for (alpha, name) in [(radius::fastest::<S>(), "shrinking"), (1.0, "staying")] {
            let all = runs(alpha);
            let fitted = fitted(&all);
            let last: Estimate = all.iter().map(|run| run[6] - truth).collect();
            let predicted = blur(alpha);
            println!(
                "{:?}, {name}: {fitted}; {:.5} off for {predicted:.5}",
                S::DIMENSION,
                last.mean()
            );
            assert!(last.z(predicted).abs() < CRITICAL, "{}", last.z(predicted));
            if alpha < 1.0 {
                assert!((fitted.line.slope - slope).abs() < 0.04, "{fitted}");
                assert!(fitted.half_width < 0.02, "{fitted}");
            } else {
                // It levels out at its blur.
                let square = |mean: &f64| (mean - truth).powi(2);
                let rms: Estimate = all.iter().map(|run| square(&run[6])).collect();
                let level = rms.mean().sqrt() / predicted.abs();
                assert!((0.98..1.15).contains(&level), "{level}");
                assert!(fitted.line.slope > -0.25, "{fitted}");
            }
        }
    }
    check::<Flat>(-0.4);
    check::<Solid>(-1.0 / 3.0);
}
