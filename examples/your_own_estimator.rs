//! An estimator of your own, and the doctor who names its mistake.
//!
//! `cargo run --release --example your_own_estimator`

#![allow(clippy::print_stdout)]

use halfdisk::lab::doctor::{Patient, examine};
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

fn main() {
    println!("wrong: {}", examine(wrong).explain());
    println!("mended: {}", examine(mended).explain());
}

#[test]
fn the_doctor_names_the_mistake_and_lets_the_mended_one_go() {
    let diagnosis = examine(wrong);
    assert!(!diagnosis.healthy());
    assert_eq!(diagnosis.matches()[0].variant.name, "density forgotten");
    assert!(examine(mended).healthy());
}
