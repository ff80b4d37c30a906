//! The chart in the README: how the error of one pixel falls with its samples.
//!
//! `cargo run --release --example one_pixel`

#![allow(clippy::print_stdout)]

use halfdisk::integrators::{Integrator, Path};
use halfdisk::lab::experiment::convergence::{Design, Estimator, Sizes, converge};
use halfdisk::lab::figures::convergence_chart;
use halfdisk::output::save;
use halfdisk::sampling::stream::{Sampler, Stream};
use halfdisk::scene::{Tracer, gallery};
use rayon::prelude::*;
use std::error::Error;

/// The pixel, as a place of the picture from its upper left corner: the wall to the left of the door, where the tiles
/// and the basin throw light back.
const PIXEL: [f32; 2] = [0.34, 0.48];
/// Paths that the truth is known from.
const TRUTH: u32 = 1 << 21;

fn main() -> Result<(), Box<dyn Error>> {
    let scene = gallery::load("courtyard")?;
    let path = Path::from_eye(scene.suggested.max_depth);
    let ray = scene.camera.ray(PIXEL[0], PIXEL[1]);
    let sample = |sampler: Sampler, seed: u64, i: u32| {
        let stream = Stream::with(sampler, seed, 0, i);
        f64::from(path.li(&mut Tracer::new(&scene), &ray, &stream).g)
    };
    let truth: f64 = (0..TRUTH)
        .into_par_iter()
        .map(|i| sample(Sampler::Independent, u64::MAX, i))
        .sum::<f64>()
        / f64::from(TRUTH);
    let design = Design {
        replicates: 256,
        doublings: 11,
        first: 1,
        seed: 1,
    };
    let run = |name: &'static str, sampler: Sampler| {
        let estimator = Estimator {
            name,
            about: "",
            truth,
            rays_per_sample: 1,
            sizes: Sizes::Doublings,
            run: |n: u32, seed: u64| {
                (0..n).map(|i| sample(sampler, seed, i)).sum::<f64>() / f64::from(n)
            },
        };
        converge(&estimator, &design)
    };
    let runs = [
        run("independent paths", Sampler::Independent),
        run("even points", Sampler::Sobol),
    ];
    let chart = convergence_chart("One pixel of the courtyard, green", &runs);
    let file = "book/images/one_pixel.svg";
    save(file.as_ref(), chart.to_svg()?.as_bytes())?;
    println!("wrote {file}: the truth is {truth:.5}");
    Ok(())
}
