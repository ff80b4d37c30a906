//! Exercise 3: the gather integral in seven steps.
//!
//! How much light does a diffuse surface of the flat world reflect? Gather it from `p.samples` directions:
//!
//! 1. draw a direction of the half disk: `half_disk::sample_uniform(p.random())`;
//! 2. turn it into the world's axes: `FlatFrame::new(p.normal).to_world(w)`;
//! 3. look along it: `p.cast_ray(wi)` is the radiance that arrives;
//! 4. multiply by the cosine with the normal;
//! 5. add up, and divide by the density where you add;
//! 6. divide by the number of directions;
//! 7. multiply by the surface's BRDF, made of `p.albedo`.
//!
//! Under a white sky the right answer is the albedo. The grader asks five surfaces, because some mistakes hide: from a
//! level surface, from a white one, or behind sixteen directions.

use halfdisk::lab::doctor::Patient;
use halfdisk::lab::exercises::{self, gather};
use halfdisk::sampling::{flat_frame::FlatFrame, half_disk};
use halfdisk::space::Flat;
use std::process::ExitCode;
use std::sync::Arc;

/// One estimate of the radiance that the surface reflects.
pub fn reflected(p: &mut Patient<Flat>) -> f32 {
    // BEGIN SOLUTION
    let frame = FlatFrame::new(p.normal);
    let mut sum = 0.0;
    for _ in 0..p.samples {
        let w = half_disk::sample_uniform(p.random());
        let li = p.cast_ray(frame.to_world(w));
        sum += li * w.y / half_disk::pdf_uniform(w);
    }
    0.5 * p.albedo * sum / p.samples as f32
    // END SOLUTION
}

/// What is graded.
pub fn answer() -> gather::Gather {
    Arc::new(reflected)
}

fn main() -> ExitCode {
    exercises::main(&gather::exam(), &answer())
}
