//! Chapter 4, exercise 2: five broken estimators, named by what the furnace reads.
//!
//! Each gathers the light of a white sky over a surface of the flat world, and each is wrong in one
//! way. The doctor asks it about several surfaces and compares the readings with those of the
//! classic mistakes. The answers stand below `main`: find them first.

#![allow(clippy::print_stdout)]

use halfdisk::lab::doctor::{Patient, examine};
use halfdisk::sampling::{flat_frame::FlatFrame, half_disk};
use halfdisk::space::Flat;
use std::f32::consts::PI;

type Broken = fn(&mut Patient<Flat>) -> f32;

/// Estimator A.
fn a(p: &mut Patient<Flat>) -> f32 {
    let mut sum = 0.0;
    for _ in 0..p.samples {
        let w = half_disk::sample_uniform(p.random());
        sum += p.cast_ray(FlatFrame::new(p.normal).to_world(w)) * w.y;
    }
    p.albedo * sum / p.samples as f32
}

/// Estimator B.
fn b(p: &mut Patient<Flat>) -> f32 {
    let mut sum = 0.0;
    for _ in 0..p.samples {
        let w = half_disk::sample_uniform(p.random());
        sum += p.cast_ray(FlatFrame::new(p.normal).to_world(w)) * w.x;
    }
    p.albedo * 0.5 * PI * sum / p.samples as f32
}

/// Estimator C.
fn c(p: &mut Patient<Flat>) -> f32 {
    let mut sum = 0.0;
    for _ in 0..=p.samples {
        let w = half_disk::sample_uniform(p.random());
        sum += p.cast_ray(FlatFrame::new(p.normal).to_world(w)) * w.y;
    }
    p.albedo * 0.5 * PI * sum / p.samples as f32
}

/// Estimator D.
fn d(p: &mut Patient<Flat>) -> f32 {
    let mut sum = 0.0;
    for _ in 0..p.samples {
        let w = half_disk::sample_cosine(p.random());
        sum += p.cast_ray(FlatFrame::new(p.normal).to_world(w)) * w.y;
    }
    p.albedo * sum / p.samples as f32
}

/// Estimator E.
fn e(p: &mut Patient<Flat>) -> f32 {
    let mut sum = 0.0;
    for _ in 0..p.samples {
        let w = half_disk::sample_uniform(p.random());
        sum += p.cast_ray(FlatFrame::new(p.normal).to_world(w)) * w.y;
    }
    p.albedo * 0.5 * sum / p.samples as f32
}

fn main() {
    for (name, estimator, _) in BROKEN {
        let diagnosis = examine(estimator);
        let reading = diagnosis.readings[0];
        println!(
            "{name} reads {:.4} ± {:.4}: {}",
            reading.value,
            reading.error,
            diagnosis.explain()
        );
    }
}

/// The estimators, and what is wrong with each.
const BROKEN: [(&str, Broken, &str); 5] = [
    ("A", a, "formula as printed"),
    ("B", b, "cosine of the sampled angle"),
    ("C", c, "one term too many"),
    ("D", d, "cosine twice"),
    ("E", e, "density forgotten"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_doctor_names_each_slip() {
        for (name, estimator, slip) in BROKEN {
            let diagnosis = examine(estimator);
            assert!(!diagnosis.healthy(), "{name}");
            assert_eq!(diagnosis.matches()[0].variant.name, slip, "{name}");
        }
    }
}
