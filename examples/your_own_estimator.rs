//! An estimator of your own: how fast its error falls, and the doctor who names its mistake.
//!
//! `cargo run --release --example your_own_estimator`

#![allow(clippy::print_stdout)]

use halfdisk::lab::doctor::{Patient, examine};
use halfdisk::lab::experiment::convergence::{Convergence, Design, Estimator, converge};
use halfdisk::sampling::half_disk;
use halfdisk::space::{Flat, Space};

/// What the surface reflects: directions uniform over the half disk, but a density is missing.
fn wrong(p: &mut Patient<Flat>) -> f32 {
    let frame = Flat::frame(p.normal);
    let mut sum = 0.0;
    for _ in 0..p.samples {
        let w = half_disk::sample_uniform(p.random());
        sum += p.cast_ray(Flat::to_world(&frame, w)) * w.y;
    }
    Flat::LAMBERT * p.albedo * sum / p.samples as f32
}

/// The same, divided by the density.
fn mended(p: &mut Patient<Flat>) -> f32 {
    let frame = Flat::frame(p.normal);
    let mut sum = 0.0;
    for _ in 0..p.samples {
        let w = half_disk::sample_uniform(p.random());
        sum += p.cast_ray(Flat::to_world(&frame, w)) * w.y / half_disk::pdf_uniform(w);
    }
    Flat::LAMBERT * p.albedo * sum / p.samples as f32
}

// ANCHOR: converge
/// The convergence of a closure: the mean of `x^power`, with each sample and its mirror image.
fn mirrored(power: i32) -> Convergence {
    let truth = 1.0 / f64::from(power + 1);
    let estimator = Estimator::new("mirrored", truth, |random, n| {
        let pair = |x: f64| 0.5 * (x.powi(power) + (1.0 - x).powi(power));
        (0..n).map(|_| pair(random.fine())).sum::<f64>() / f64::from(n)
    });
    converge(&estimator, &Design::default())
}
// ANCHOR_END: converge

fn main() {
    print!("{}", mirrored(2));
    println!("wrong: {}", examine(wrong).explain());
    println!("mended: {}", examine(mended).explain());
}

#[test]
fn a_closure_converges_as_its_variance_says() {
    let run = mirrored(2);
    // Of x^2 - x + 1/2, as against 4/45 for x^2 by itself.
    let variance = 1.0 / 180.0;
    let slope = run.fit.expect("256 runs at 11 sizes").line.slope;
    // The slope is known to 0.006, a mean square of 256 runs to 9 %.
    assert!((slope + 0.5).abs() < 0.026, "{slope}");
    for size in &run.sizes {
        let expected = variance / f64::from(size.samples);
        let ratio = size.rmse * size.rmse / expected;
        assert!(
            (ratio - 1.0).abs() < 0.4,
            "{} samples: {ratio}",
            size.samples
        );
    }
}

#[test]
fn the_doctor_names_the_mistake_and_lets_the_mended_one_go() {
    let diagnosis = examine(wrong);
    assert!(!diagnosis.healthy());
    assert_eq!(diagnosis.matches()[0].variant.name, "density forgotten");
    assert!(examine(mended).healthy());
}
