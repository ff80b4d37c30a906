//! The variance of many paths at a point of the box.

use crate::SEGMENTS;
use halfdisk::integrators::{Integrator, Kajiya, NextEvent, Path};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::estimators::walks;
use halfdisk::lab::experiment::convergence::{Convergence, Design, Estimator, Sizes, converge};
use halfdisk::lab::figures::variance_chart;
use halfdisk::sampling::stream::{Sampler, Stream};
use halfdisk::scene::{Tracer, gallery};
use std::f64::consts::SQRT_2;

/// The variance of the mean of `N` paths, by chance, by aiming and by the path tracer; the rays that the
/// variances of one path took.
pub fn chart(desk: &mut Desk) -> Result<u64, DeskError> {
    let design = Design {
        replicates: 64,
        doublings: desk.choose(8, 6),
        first: 4,
        seed: desk.options.seed,
    };
    let scene = gallery::load("cornell")?;
    // On the floor, in the light of the lamp.
    let ray = scene.camera.ray(0.35, 0.93);
    let max_depth = SEGMENTS;
    let (kajiya, next_event, path) = (
        Kajiya { max_depth },
        NextEvent { max_depth },
        Path::new(max_depth),
    );
    let (even, independent) = (Sampler::Sobol, Sampler::Independent);
    let ways: [(&str, &str, &dyn Integrator, Sampler); 4] = [
        ("chance", "by chance", &kajiya, independent),
        ("aiming", "aiming", &next_event, independent),
        ("path", "path", &path, independent),
        ("even", "path, even points", &path, even),
    ];
    let count = 40_000;
    let mut runs: Vec<(Convergence, Option<f64>)> = Vec::new();
    let mut rays = 0;
    for (key, name, by, sampler) in ways {
        let estimator = Estimator {
            name,
            about: "",
            truth: 0.0,
            rays_per_sample: 1,
            sizes: Sizes::Doublings,
            run: |n: u32, seed: u64| {
                let mut tracer = Tracer::new(&scene);
                // Even points lie evenly among the samples of one pixel.
                let stream = |i| Stream::with(sampler, seed, 0, i);
                let mut path = |i| f64::from(by.li(&mut tracer, &ray, &stream(i)).r);
                (0..n).map(&mut path).sum::<f64>() / f64::from(n)
            },
        };
        let run = converge(&estimator, &design);
        // Each even point alone is a random point: it has the variance of any.
        let of_one = match runs.last() {
            Some((_, known)) if key == "even" => *known,
            _ => {
                let found = walks::many(0.0, count, desk.options.seed, |stream| {
                    let mut tracer = Tracer::new(&scene);
                    let li = by.li(&mut tracer, &ray, stream);
                    (li, tracer.counts().total())
                });
                rays += found.rays;
                let variance = found.estimate.variance();
                let says = format!("point of the floor, {name}: variance of one path");
                desk.value(&format!("floor_variance_{key}"), &says, variance);
                Some(variance)
            }
        };
        runs.push((run, of_one));
    }
    if let [.., (path, _), (even, _)] = &runs[..] {
        gain(desk, path, even);
    }
    let chart = variance_chart("Paths from a point of the floor", &runs);
    let caption = "Independent paths follow σ²/N, whichever way they find the light; dashed, with the σ² of many \
                   single paths. Aiming lowers the line by two to three powers of ten. Here even points gain hardly anything.";
    desk.figure("rate.svg", caption, chart.to_svg()?)?;
    Ok(rays)
}

/// How much lower the variance of 64 even paths is than that of 64 others.
fn gain(desk: &mut Desk, path: &Convergence, even: &Convergence) {
    let of = |run: &Convergence| {
        let size = run.sizes.iter().find(|size| size.samples == 64);
        size.and_then(|size| size.variance)
    };
    if let (Some(path_variance), Some(even_variance)) = (of(path), of(even)) {
        let gain = path_variance / even_variance;
        // Both variances are known to this share, as those of so many normal means are.
        let share = (2.0 / (f64::from(path.replicates) - 1.0)).sqrt();
        let number = Number::new("64 even paths: times less variance", gain);
        let error = Some(gain * share * SQRT_2);
        desk.number("even_gain", Number { error, ..number });
    }
}
