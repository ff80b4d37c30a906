//! The numbers of the book's live figures against closed forms, and as WebAssembly.

mod web;

use crate::checks::CRITICAL;
use halfdisk::stats::z_test::FOUR;
use halfdisk_figures::{darts, half_disk, inversion, lamp, path, roulette, window};
use std::f64::consts::{FRAC_PI_2, PI};

/// The mean of what a figure reads with many seeds, and its standard error, from those of each.
fn over_seeds(seeds: u32, read: impl Fn(u32) -> [f64; 2]) -> [f64; 2] {
    let all: Vec<[f64; 2]> = (1..=seeds).map(read).collect();
    let n = f64::from(seeds);
    let mean = all.iter().map(|[mean, _]| mean).sum::<f64>() / n;
    let squares: f64 = all.iter().map(|[_, error]| error * error).sum();
    [mean, squares.sqrt() / n]
}

/// Accepts a mean, and only where it would have noticed a bias of this share of the truth.
#[track_caller]
fn reads(name: &str, [mean, error]: [f64; 2], truth: f64, share: f64) {
    let z = (mean - truth) / error;
    println!("{name}: {mean:.6} ± {error:.1e}, exact {truth:.6}, z {z:+.2}");
    assert!(z.abs() < CRITICAL, "{name}: {mean} ± {error}, not {truth}");
    assert!(
        FOUR * error < share * truth,
        "{name}: would notice nothing below {}",
        FOUR * error / truth
    );
}

#[track_caller]
fn near(x: f64, y: f64, tolerance: f64) {
    assert!((x - y).abs() <= tolerance, "{x} is not {y}");
}

#[test]
fn a_half_disk_reads_the_albedo_and_its_transpose_the_squared_cosine() {
    for tilt in [0.0, 30.0, 60.0_f64, 90.0] {
        let cos = libm::cos(tilt.to_radians());
        let part = |k: usize| {
            let numbers = move |seed| half_disk::run(tilt, seed);
            over_seeds(16, move |seed| [numbers(seed)[k], numbers(seed)[k + 1]])
        };
        reads("columns", part(0), 1.0, 0.02);
        if tilt < 90.0 {
            reads("rows", part(3), cos * cos, 0.05);
        }
        let numbers = half_disk::run(tilt, 1);
        near(numbers[2], 1.0, 1e-12);
        near(numbers[5], cos * cos, 1e-6);
        near(numbers[6], 2.0 * tilt.to_radians() / PI, 1.0 / 48.0);
        let n = [libm::sin(tilt.to_radians()), cos];
        let heights: Vec<f64> = numbers[7..]
            .chunks(2)
            .map(|w| w[0] * n[0] + w[1] * n[1])
            .collect();
        assert_eq!(heights.len(), 2 * half_disk::RAYS as usize);
        let (right, wrong) = heights.split_at(half_disk::RAYS as usize);
        assert!(right.iter().all(|&h| h >= 0.0), "no ray below the surface");
        let below = wrong.iter().filter(|h| **h < 0.0).count();
        assert_eq!(below as f64 / f64::from(half_disk::RAYS), numbers[6]);
    }
}

#[test]
fn a_number_goes_to_the_angle_whose_distribution_function_it_is() {
    for k in 0..=200 {
        let u = f64::from(k) / 200.0;
        let numbers = inversion::law(u);
        for (at, u) in numbers
            .chunks(3)
            .zip([u, u - inversion::ASIDE, u + inversion::ASIDE])
        {
            // Uniforms are multiples of 2^-24, the first and the last half a step from the ends.
            let u = u.clamp(0.0, 1.0);
            let step = 1e-6;
            near(0.5 * (1.0 + libm::sin(at[0])), u, step);
            near(at[1], 0.5 * libm::cos(at[0]), 1e-6);
            near(at[2], u, step);
        }
    }
    let even = PI * 0.1 - FRAC_PI_2;
    assert!(inversion::law(0.1)[0] - even > 0.3, "angles are not even");
}

#[test]
fn a_path_brings_the_share_of_each_emission_and_on_average_the_truth() {
    let mean = over_seeds(49, |seed| {
        let numbers = path::run(6.0, seed);
        [numbers[2], numbers[3]]
    });
    let truth = path::run(1.0, 1)[4];
    near(truth, halfdisk::flatland::exact::ROOM_FLOOR, 0.0);
    reads("the floor of the room", mean, truth, 0.02);
    for seed in 1..50 {
        let whole = path::run(6.0, seed);
        for segments in 1..=6 {
            let numbers = path::run(segments as f64, seed);
            let (ends, lobe) = numbers[5..].split_at(6 * segments);
            assert_eq!(ends, &whole[5..5 + 6 * segments], "a path's beginning");
            assert_eq!(numbers[1], whole[1]);
            let mut so_far = 0.0;
            for (i, vertex) in ends.chunks(6).enumerate() {
                near(vertex[5], 0.5_f64.powi(i as i32), 0.0);
                // The ceiling shines, and nothing else does.
                near(vertex[4], f64::from(u8::from(vertex[3] > 0.999_999)), 0.0);
                so_far += vertex[4] * vertex[5];
                if let Some(next) = ends.get(6 * (i + 1)..) {
                    let joint = |k: usize| next.get(k).map_or(0.0, |x| x - vertex[2 + k]);
                    assert!(joint(0).hypot(joint(1)) < 1e-5, "a chain");
                }
            }
            near(numbers[0], so_far, 1e-6);
            assert!(numbers[0] <= numbers[1]);
            // At the distance cos θ / 2 the lobe is a circle, half as wide as the longest ray is long.
            assert_eq!(lobe.len(), 2 * path::LOBE as usize);
            let last = &ends[6 * segments - 6..];
            let n = [[0.0, 1.0], [0.0, -1.0], [1.0, 0.0], [-1.0, 0.0]][[
                last[3],
                1.0 - last[3],
                last[2],
                1.0 - last[2],
            ]
            .map(|x| x < 1e-5)
            .iter()
            .position(|x| *x)
            .unwrap()];
            for p in lobe.chunks(2) {
                near((p[0] - 0.25 * n[0]).hypot(p[1] - 0.25 * n[1]), 0.25, 1e-6);
            }
        }
    }
}

#[test]
fn a_lamp_has_the_variances_of_its_three_ways() {
    for angle in [0.01, 0.1, 0.5, 1.0, 1.5] {
        let (sin, cos) = libm::sincos(angle);
        let law = lamp::law(angle);
        let [mean, chance, aiming, both, power, bound, oracle] = law[..] else {
            panic!("{law:?}");
        };
        near(mean, sin, 1e-15);
        near(chance, sin * (1.0 - sin), 1e-7);
        near(aiming, 0.5 * angle * (angle + sin * cos) - sin * sin, 1e-9);
        near(bound, chance.min(aiming) + 0.5 * sin * sin, 1e-15);
        near(oracle, 0.5 * chance.min(aiming), 1e-15);
        assert!((oracle..=bound).contains(&both));
        for (i, variance) in [chance, aiming, both, power].into_iter().enumerate() {
            let read = |seed| {
                let numbers = lamp::run(angle, seed);
                [numbers[3 * i], numbers[3 * i + 1]]
            };
            let [found, _] = over_seeds(50, read);
            // The samples' own error says nothing where no sample finds the lamp: the law's does.
            let error = (variance / (50.0 * 400.0)).sqrt();
            reads("a lamp", [found, error], sin, 0.5);
        }
        let numbers = lamp::run(angle, 1);
        let (_, aimed) = numbers[12..].split_at(lamp::RAYS as usize);
        assert_eq!(aimed.len(), lamp::RAYS as usize);
        assert!(aimed.iter().all(|theta| theta.abs() <= angle));
    }
}

#[test]
fn roulette_has_its_variance_and_its_wall() {
    for (survival, known) in [(0.9, 6.15), (0.8, 20.0), (0.65, 560.0)] {
        let law = roulette::law(survival);
        near(law[0], 5.0, 1e-12);
        near(law[1] / known, 1.0, 2e-3);
        near(law[2], 1.0 / (1.0 - survival), 1e-9);
        near(law[3], 0.64, 1e-12);
        assert_eq!(law[4] == 1.0, survival > 0.75, "a fourth moment");
        near(law[6], law[1] * law[2] / 25.0, 1e-9);
    }
    assert_eq!(roulette::law(0.64)[1], f64::INFINITY);
    // (1 + ρ)/(1 - ρ)/(1 - ρ²/q) less 4, for ρ and q of one half, times two segments, over 4.
    near(
        roulette::law(0.5)[5],
        (3.0 / (1.0 - 0.5) - 4.0) * 2.0 / 4.0,
        1e-9,
    );
    assert_eq!(roulette::law(0.5)[1], f64::INFINITY);
    for (survival, share) in [(0.9, 0.01), (0.8, 0.02)] {
        let read = |seed| {
            let numbers = roulette::run(survival, seed);
            [numbers[0], numbers[1]]
        };
        reads("roulette", over_seeds(40, read), 5.0, share);
        let runs: Vec<f64> = (1..=40)
            .flat_map(|seed| roulette::run(survival, seed).split_off(2))
            .collect();
        assert_eq!(runs.len(), 40 * roulette::RUNS as usize);
        let variance: halfdisk::stats::Estimate = runs.into_iter().collect();
        let claimed = [variance.mean(), variance.std_error()];
        reads("its variance", claimed, roulette::law(survival)[1], 0.15);
    }
}

#[test]
fn a_window_has_its_bias_and_its_variance() {
    for radius in [1.0 / 16.0, 0.25, 1.0] {
        let (mean, variance) = (window::law(radius)[0], window::law(radius)[1]);
        let share = libm::atan(radius) / PI;
        near(mean, libm::atan(radius) / radius, 1e-12);
        let one = share * (1.0 - share) * (PI / radius).powi(2);
        near(variance * f64::from(window::WALKS) / one, 1.0, 1e-12);
        let part = |k: usize| {
            over_seeds(40, move |seed| {
                let numbers = window::run(radius, seed);
                [numbers[k], numbers[k + 1]]
            })
        };
        reads("a window", part(0), mean, 0.1);
        let squared = (mean - 1.0).powi(2) + variance;
        reads("its squared error", part(2), squared, 0.5);
        // About half of the walks go down.
        let landed = window::run(radius, 1).len() - 4;
        assert_eq!(landed, window::SHOWN as usize);
    }
    // No walk lands in a window that nobody can see.
    assert!(
        window::run(0.0, 1)[1].is_finite(),
        "the least radius is 1/64"
    );
}

#[test]
fn darts_estimate_pi_and_lie_where_they_score() {
    let read = |seed| {
        let numbers = darts::run(100_000.0, seed);
        [numbers[0], numbers[1]]
    };
    reads("pi", over_seeds(20, read), PI, 0.005);
    let board = darts::board(300.0, 7);
    assert_eq!(board.len(), 900);
    let mut sum = 0.0;
    for dart in board.chunks(3) {
        let hit = dart[0].hypot(dart[1]) <= 1.0;
        near(dart[2], 4.0 * f64::from(u8::from(hit)), 0.0);
        sum += dart[2];
    }
    near(darts::run(300.0, 7)[0], sum / 300.0, 1e-12);
    assert_eq!(darts::board(1e9, 1).len(), 3 * darts::SHOWN as usize);
}
