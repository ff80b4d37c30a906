//! Integrals by chance: S0.09 to S0.13 and S0.19.

use crate::checks::{accept, reject};
use halfdisk::lab::estimators::{hit_or_miss, many_dimensions};
use halfdisk::lab::experiment::convergence::{Convergence, Design, converge, csv};
use halfdisk::lab::experiment::named;
use halfdisk::stats::slope::Line;
use halfdisk::stats::{Estimate, z_test::two_sided};
use std::f64::consts::PI;

fn run(name: &str, design: &Design) -> Convergence {
    let run = converge(&named::find(name).expect(name), design);
    println!("{name}: {}", run.slope_text());
    run
}

fn slope(name: &str) -> f64 {
    let fit = run(name, &Design::default()).fit.expect(name);
    fit.line.slope
}

#[test]
fn s0_11_darts_and_heights_have_the_variances_they_should() {
    const N: u32 = 8_000_000;
    let (darts, heights) = (hit_or_miss::darts(N, 1), hit_or_miss::sample_mean(N, 2));
    accept("darts", &darts, PI, PI);
    accept("heights", &heights, PI, PI);
    let sigma = darts.variance().sqrt();
    let ratio = darts.variance() / heights.variance();
    println!("sigma {sigma:.5}, ratio {ratio:.4}");
    assert!((sigma / 1.642_183 - 1.0).abs() < 0.01);
    assert!((heights.variance().sqrt() / 0.892_783 - 1.0).abs() < 0.01);
    assert!((ratio - 3.3834).abs() < 0.05);
    reject("a disc of radius 0.99", &darts, 0.9801 * PI);
    reject("a disc of radius 0.99", &heights, 0.9801 * PI);
}

#[test]
fn s0_11_slopes_of_darts_heights_steps_and_grids() {
    for name in ["darts", "sample-mean", "step"] {
        let slope = slope(name);
        assert!((slope + 0.5).abs() < 0.02, "{name}: {slope}");
    }
    let jittered = slope("jittered-darts");
    assert!((jittered + 0.75).abs() < 0.03, "jittered: {jittered}");
    // The same check refuses darts in cells as plain darts, and the other way round.
    assert!((jittered + 0.5).abs() > 0.02);
    // Midpoints: the slope of the circle's end is vertical, which costs the grid half a power.
    let points: Vec<(f64, f64)> = (6..18)
        .map(|k| 1_u32 << k)
        .map(|n| (f64::from(n), (hit_or_miss::midpoints(n) - PI).abs()))
        .collect();
    let line = Line::through(&points).expect("points");
    println!("midpoints: slope {:.3}", line.slope);
    assert!((line.slope + 1.5).abs() < 0.02);
}

#[test]
fn s0_12_the_grid_loses_to_chance_from_four_dimensions_on() {
    for d in 1..=8_u32 {
        let points: Vec<(f64, f64)> = [16, 32, 64]
            .map(|steps| {
                let n = libm::pow(f64::from(steps), f64::from(d));
                (n, (many_dimensions::grid(d, steps) - 1.0).abs())
            })
            .to_vec();
        let grid = Line::through(&points).expect("points").slope;
        let chance = slope(
            [
                "product-1",
                "product-2",
                "product-3",
                "product-4",
                "product-5",
                "product-6",
                "product-7",
                "product-8",
            ][d as usize - 1],
        );
        println!("d = {d}: grid {grid:.4}, chance {chance:.4}");
        assert!(
            (grid + 2.0 / f64::from(d)).abs() < 0.05,
            "grid, d = {d}: {grid}"
        );
        assert!((chance + 0.5).abs() < 0.02, "chance, d = {d}: {chance}");
    }
    // 4096 points are a whole grid in 1, 2, 3, 4 and 6 dimensions.
    for (d, steps) in [(1, 4096), (2, 64), (3, 16), (4, 8), (6, 4)] {
        let grid = (many_dimensions::grid(d, steps) - 1.0).abs();
        let chance = many_dimensions::deviation(d) / 64.0;
        println!("d = {d}: grid {grid:.2e}, chance {chance:.2e}");
        assert_eq!(grid < chance, d <= 3, "d = {d}");
    }
}

#[test]
fn s0_12_the_grid_of_products_is_the_grid() {
    let steps = 7;
    let mut sum = 0.0;
    for i in 0..steps * steps * steps {
        sum += [i % steps, i / steps % steps, i / steps / steps]
            .map(|k| 0.5 * PI * libm::sin(PI * (f64::from(k) + 0.5) / f64::from(steps)))
            .iter()
            .product::<f64>();
    }
    let grid = many_dimensions::grid(3, steps as u32);
    assert!((sum / f64::from(steps * steps * steps) - grid).abs() < 1e-12);
}

#[test]
fn s0_12_products_by_chance_are_one_in_every_dimension() {
    for (d, n) in [(1, 200_000), (4, 600_000), (8, 3_000_000)] {
        let product = many_dimensions::monte_carlo(d, n, 3);
        accept(&format!("d = {d}"), &product, 1.0, 1.0);
        reject("without its last constant", &product, 2.0 / PI);
        let sigma = product.variance().sqrt();
        assert!(
            (sigma / many_dimensions::deviation(d) - 1.0).abs() < 0.05,
            "{sigma}"
        );
    }
}

#[test]
fn s0_19_the_band_holds_the_truth_as_often_as_it_says() {
    let runs = 4000_u64;
    let covered = (0..runs)
        .filter(|&seed| hit_or_miss::darts(400, seed).interval(2.0).contains(PI))
        .count();
    let share = covered as f64 / runs as f64;
    let normal = 1.0 - two_sided(2.0);
    println!("covered {share:.4}, normal law {normal:.4}");
    assert!((share - 0.95).abs() < 0.015);
    // A band of one standard error is refused.
    let narrow = (0..runs)
        .filter(|&seed| hit_or_miss::darts(400, seed).interval(1.0).contains(PI))
        .count();
    assert!((narrow as f64 / runs as f64 - 0.95).abs() > 0.015);
}

#[test]
fn s1_13_twice_the_samples_is_worse_two_times_of_five() {
    let pairs = 20_000_u64;
    let error = |n, seed| (hit_or_miss::sample_mean(n, seed).mean() - PI).abs();
    let worse = (0..pairs)
        .filter(|&i| error(400, 2 * i) > error(200, 2 * i + 1))
        .count();
    let exact = 2.0 / PI * libm::atan(std::f64::consts::FRAC_1_SQRT_2);
    let share = Estimate::from_hits(worse as u64, pairs);
    println!(
        "worse {:.4} ± {:.4}, exact {exact:.4}",
        share.mean(),
        share.std_error()
    );
    assert!((share.mean() - exact).abs() < 0.03 && (exact - 0.392).abs() < 1e-3);
    reject("a coin", &share, 0.5);
}

#[test]
fn threads_change_no_bit() {
    let estimator = || named::find("half-disk-lamp").expect("known");
    let design = Design {
        replicates: 16,
        doublings: 6,
        ..Design::default()
    };
    let on = |threads| {
        rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("threads")
            .install(|| converge(&estimator(), &design))
    };
    let (one, four) = (on(1), on(4));
    assert_eq!(one, four);
    assert_eq!(csv(&[one]).lines().count(), 7);
}
