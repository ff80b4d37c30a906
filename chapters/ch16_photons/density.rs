//! Counting photons in a window: what is gained and lost with its size, at its edges, and by the nearest.

use super::landing::flat_world;
use super::scene;
use super::window::{LAMP, first_photons, window};
use glam::{Vec2, Vec3};
use halfdisk::integrators::Photons;
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, Style};
use halfdisk::lab::experiment::convergence::{Design, Estimator, Sizes, converge};
use halfdisk::lab::figures::variance_chart;
use halfdisk::photons::edge::share_on_rectangle;
use halfdisk::photons::nearest::{Count, density};
use halfdisk::photons::{Kernel, PhotonMap};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::Tracer;
use halfdisk::space::{Solid, Space};
use halfdisk::stats::Estimate;
use std::f64::consts::PI;

pub fn work(desk: &mut Desk) -> Result<(), DeskError> {
    desk.say("\na window on a line");
    variance(desk)?;
    u_curve(desk)?;
    plate(desk)?;
    for k in [5, 20, 50] {
        let right = nearest::<Solid>(desk, k, Count::LessOne);
        let says = format!("the {k} nearest, counted as one less");
        desk.estimate(&format!("nearest_{k}"), &says, &right, Some(1.0));
        let wrong = nearest::<Solid>(desk, k, Count::All);
        let says = format!("the {k} nearest, all counted: k / (k - 1)");
        let exact = k as f64 / (k as f64 - 1.0);
        desk.estimate(&format!("nearest_all_{k}"), &says, &wrong, Some(exact));
    }
    Ok(())
}

/// The variance of what three windows read, against the number of photons.
fn variance(desk: &mut Desk) -> Result<(), DeskError> {
    let world = flat_world("lamp.toml", LAMP)?;
    let design = Design {
        replicates: desk.choose(80, 64),
        doublings: desk.choose(7, 5),
        first: 128,
        seed: desk.options.seed,
    };
    let mut runs = Vec::new();
    for (key, name, radius) in [
        ("wide", "radius 1", 1.0_f32),
        ("middle", "radius 1/4", 0.25),
        ("narrow", "radius 1/16", 0.0625),
    ] {
        let world = &world;
        let estimator = Estimator {
            name,
            about: "",
            truth: 1.0,
            rays_per_sample: 1,
            sizes: Sizes::Doublings,
            run: move |walks: u32, seed: u64| {
                let photons = first_photons(world, walks, seed, 0);
                let map = PhotonMap::new(photons, walks, radius, Kernel::Constant);
                let read = map.estimate(Vec2::ZERO, Vec2::Y, radius, |photon| photon.power);
                f64::from(read.g)
            },
        };
        let run = converge(&estimator, &design);
        let (mean, one) = window(f64::from(radius), 1);
        if let Some(last) = run.sizes.last() {
            let number = Number {
                error: Some(last.bias_error),
                ..Number::new(&format!("mean of a window of {name}"), 1.0 + last.bias)
            };
            desk.number(&format!("window_mean_{key}"), number.exact(mean));
        }
        // N times the variance is the same at all sizes: all of them tell it. A count's fourth moment says how well.
        let sizes = (run.sizes.iter())
            .filter_map(|size| Some((f64::from(size.samples), size.variance?)))
            .map(|(n, variance)| {
                let share = libm::atan(f64::from(radius)) / PI;
                let one = share * (1.0 - share);
                let excess = (1.0 - 6.0 * one) / (n * one);
                (n * variance, (2.0 + excess) / f64::from(design.replicates))
            });
        let sizes: Vec<(f64, f64)> = sizes.collect();
        let mean_of =
            |part: fn(&(f64, f64)) -> f64| sizes.iter().map(part).sum::<f64>() / sizes.len() as f64;
        let found = mean_of(|size| size.0);
        let own = (mean_of(|size| size.1) / sizes.len() as f64).sqrt();
        let number = Number {
            error: Some(own * found),
            ..Number::new(&format!("variance of one walk, window of {name}"), found)
        };
        desk.number(&format!("window_variance_{key}"), number.exact(one));
        runs.push((run, Some(one)));
    }
    let chart = variance_chart("Three windows below the lamp", &runs);
    let caption = "Variance of what a window reads against the number N of walks. All three follow σ²/N; dashed, σ² by the \
                   formula of the text. The narrower the window, the fewer photons, and the higher the line.";
    desk.figure("rate.svg", caption, chart.to_svg()?)
}

fn u_curve(desk: &mut Desk) -> Result<(), DeskError> {
    let world = flat_world("lamp.toml", LAMP)?;
    let (walks, runs) = (2000, desk.choose(160, 60));
    let radii: Vec<f64> = (-12..=1).map(|k| libm::exp2(0.5 * f64::from(k))).collect();
    let mut squares = vec![Estimate::new(); radii.len()];
    for run in 0..runs {
        let photons = first_photons(&world, walks, desk.options.seed, run);
        for (radius, squares) in radii.iter().zip(&mut squares) {
            let radius = *radius as f32;
            let map = PhotonMap::new(photons.clone(), walks, radius, Kernel::Constant);
            let read = map.estimate(Vec2::ZERO, Vec2::Y, radius, |photon| photon.power);
            squares.add((f64::from(read.g) - 1.0).powi(2));
        }
    }
    let points = |y: &dyn Fn(f64) -> f64| radii.iter().map(|&r| (r, y(r))).collect::<Vec<_>>();
    let bias = |r: f64| (window(r, walks).0 - 1.0).powi(2);
    let variance = |r: f64| window(r, walks).1;
    let measured = radii.iter().zip(&squares);
    let measured = measured.map(|(&r, squares)| (r, squares.mean(), squares.std_error()));
    // Far below the variance it is of no interest.
    let seen = points(&bias).into_iter().filter(|(_, y)| *y > 1e-4);
    let chart = CurveChart {
        title: "The size of a window".to_owned(),
        x_label: "radius of the window, m".to_owned(),
        y_label: "squared error".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves: vec![
            Curve::measured("measured", Style::Marks, measured),
            Curve::new("both", Style::Line, points(&|r| bias(r) + variance(r))),
            Curve::new("bias², by theory", Style::Dashed, seen),
            Curve::new("variance, by theory", Style::Dashed, points(&variance)),
        ],
    };
    let caption = format!(
        "Squared error of the light below the lamp, from {walks} walks. Left of the lowest place the error is noise, because \
         a small window holds few photons. Right of it the error is blur, because a large window reaches beyond the place. \
         Bars: one standard error."
    );
    desk.figure("u_curve.svg", &caption, chart.to_svg()?)?;
    let least = |all: &dyn Fn(usize) -> f64| {
        (0..radii.len())
            .min_by(|&a, &b| all(a).total_cmp(&all(b)))
            .unwrap_or(0)
    };
    let found = least(&|i| squares[i].mean());
    let expected = least(&|i| bias(radii[i]) + variance(radii[i]));
    desk.known(
        "best_radius",
        "radius with the least error",
        radii[found],
        radii[expected],
    );
    let at = |r: f64| {
        radii
            .iter()
            .position(|x| (x / r - 1.0).abs() < 1e-9)
            .unwrap_or(0)
    };
    for (name, radius) in [("small", 1.0 / 64.0), ("large", 1.0)] {
        let says = format!("squared error of a window of radius {radius}");
        let exact = bias(radius) + variance(radius);
        desk.estimate(
            &format!("squared_{name}"),
            &says,
            &squares[at(radius)],
            Some(exact),
        );
    }
    Ok(())
}

/// A plate under light of irradiance 1 that comes straight down.
const PLATE: &str = "name = 'plate'\nfilm.size = [8, 8]\n\
    camera = { from = [5, 9, 5], to = [5, 0, 5], up = [0, 0, 1], fov = 40 }\n\
    materials.half.lambert.albedo = 0.5\n[[objects]]\nmaterial = 'half'\n\
    quad = { corner = [0, 0, 10], u = [10, 0, 0], v = [0, 0, -10] }\n\
    [[lights]]\ndirectional = { direction = [0, -1, 0], irradiance = 1 }\n";

fn plate(desk: &mut Desk) -> Result<(), DeskError> {
    let plate = scene("plate.toml", PLATE)?;
    let by = Photons::new(2);
    let mut tracer = Tracer::new(&plate);
    let (walks, radius) = (20_000, 1.0);
    let mut reads = [Estimate::new(), Estimate::new(), Estimate::new()];
    let places = [[5.0, 5.0], [0.0, 5.0], [0.0, 0.0]];
    for run in 0..desk.choose(16, 8) {
        let mut photons = Vec::new();
        for walk in 0..walks {
            let stream = Stream::new(desk.options.seed, walk, 100 + run);
            by.trace(&mut tracer, 0.0, &stream, &mut |photon| {
                photons.push(photon)
            });
        }
        let map = PhotonMap::new(photons, walks, radius, Kernel::Constant);
        for (read, [x, z]) in reads.iter_mut().zip(places) {
            // Coordinates count from the camera.
            let p = Vec3::new(x, 0.0, z) - plate.origin().as_vec3();
            let light = map.estimate(p, Vec3::Y, radius, |photon| photon.power);
            read.add(f64::from(light.g));
        }
    }
    for (i, (name, what, exact)) in [
        ("middle", "in the middle of a plate", 1.0),
        ("edge", "at its edge", 0.5),
        ("corner", "in its corner", 0.25),
    ]
    .into_iter()
    .enumerate()
    {
        let says = format!("light read {what}, of 1");
        desk.estimate(&format!("plate_{name}"), &says, &reads[i], Some(exact));
        let part = share_on_rectangle(places[i].map(f64::from), [10.0; 2], f64::from(radius));
        let says = format!("the same {what}, over the part of the disc on the plate");
        desk.known(&format!("cured_{name}"), &says, reads[i].mean() / part, 1.0);
    }
    Ok(())
}

/// The density of evenly spread points, by the k nearest of a place.
fn nearest<S: Space>(desk: &Desk, k: usize, count: Count) -> Estimate {
    let points = 400;
    let one = |run| {
        let mut numbers = Stream::new(desk.options.seed, run, k as u32).at(0, Purpose::Integrand);
        let mut along = || 2.0 * f64::from(numbers.one()) - 1.0;
        let mut squares: Vec<f64> = (0..points)
            .map(|_| (0..S::FALL_OFF).map(|_| along().powi(2)).sum())
            .collect();
        let all = f64::from(1 << S::FALL_OFF);
        density::<S>(&mut squares, k, count).map_or(0.0, |d| d * all / f64::from(points))
    };
    (0..desk.choose(8_000, 4000)).map(one).collect()
}
