//! How fast noise and blur fall when each pass has smaller discs.

use super::landing::flat_world;
use super::scene;
use super::window::LAMP;
use glam::{Vec2, Vec3};
use halfdisk::integrators::Photons;
use halfdisk::integrators::world::{FlatTracer, PhotonWorld};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, HALF, Style};
use halfdisk::photons::{Kernel, PhotonMap, radius};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::Tracer;
use halfdisk::space::{Flat, Solid, Space};
use halfdisk::stats::Estimate;
use halfdisk::stats::slope::fit;
use rayon::prelude::*;

/// The same lamp in space: the floor below it gets 1 W/m².
const SOLID: &str = "name = 'lamp'\nfilm.size = [8, 8]\n\
    camera = { from = [0, 2, 0], to = [0, 0, 0], up = [0, 0, 1], fov = 40 }\n\
    materials.half.lambert.albedo = 0.5\n[[objects]]\nmaterial = 'half'\n\
    quad = { corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }\n\
    [[lights]]\npoint = { position = [0, 1, 0], intensity = 1 }\n";

/// The radius of the first pass.
const FIRST: f64 = 0.5;

// ANCHOR: progressive
/// The light at a place after 1, 2, 3 … passes: each has photons and a disc of its own.
fn progressive<S: Space, W: PhotonWorld<S>>(
    world: &mut W,
    [p, n]: [S::Vector; 2],
    alpha: f64,
    [passes, walks]: [u32; 2],
    seed: u64,
) -> Vec<f64> {
    let by = Photons::in_space::<S>(2);
    let mut sum = 0.0;
    let mut disc = 1.0;
    let mut means = Vec::new();
    for pass in 0..passes {
        if pass > 0 {
            disc *= (f64::from(pass) + alpha) / (f64::from(pass) + 1.0);
        }
        let radius = (FIRST * libm::pow(disc, 1.0 / f64::from(S::FALL_OFF))) as f32;
        let mut photons = Vec::new();
        for walk in 0..walks {
            let stream = Stream::new(seed, walk, pass);
            by.trace(world, 0.0, &stream, &mut |photon| photons.push(photon));
        }
        let map = PhotonMap::new(photons, walks, radius, Kernel::Constant);
        sum += f64::from(map.estimate(p, n, radius, |photon| photon.power).g);
        means.push(sum / f64::from(pass + 1));
    }
    means
}
// ANCHOR_END: progressive

pub fn work(desk: &mut Desk) -> Result<(), DeskError> {
    desk.say("\npasses with smaller and smaller discs");
    let (flat, solid) = (flat_world("lamp.toml", LAMP)?, scene("lamp.toml", SOLID)?);
    let foot = Vec3::ZERO - solid.origin().as_vec3();
    let on_line = |alpha: f64, passes: u32, seed: u64| {
        let mut world = FlatTracer::new(&flat);
        let at = [Vec2::ZERO, Vec2::Y];
        progressive::<Flat, _>(&mut world, at, alpha, [passes, 16], seed)
    };
    let on_surface = |alpha: f64, passes: u32, seed: u64| {
        let mut world = Tracer::new(&solid);
        progressive::<Solid, _>(&mut world, [foot, Vec3::Y], alpha, [passes, 64], seed)
    };
    world(desk, "flat", radius::fastest::<Flat>(), -0.4, &on_line)?;
    world(
        desk,
        "solid",
        radius::fastest::<Solid>(),
        -1.0 / 3.0,
        &on_surface,
    )
}

/// A run of passes by alpha, number and seed.
type Run<'a> = &'a (dyn Fn(f64, u32, u64) -> Vec<f64> + Sync);

fn world(desk: &mut Desk, name: &str, fastest: f64, slope: f64, run: Run) -> Result<(), DeskError> {
    let last = 9;
    let replicates = 48;
    let sizes: Vec<u32> = (3..=last).map(|k| 1 << k).collect();
    let mut curves = Vec::new();
    let around = if name == "flat" { "windows" } else { "discs" };
    for (kind, says, alpha) in [
        ("fastest", "shrinking", fastest),
        ("fixed", "of one size", 1.0),
    ] {
        let seeds = (0..replicates).into_par_iter();
        let squares: Vec<Vec<f64>> = seeds
            .map(|r| {
                let means = run(
                    alpha,
                    1 << last,
                    desk.options.seed.wrapping_mul(1000).wrapping_add(r),
                );
                sizes
                    .iter()
                    .map(|&n| (means[n as usize - 1] - 1.0).powi(2))
                    .collect()
            })
            .collect();
        let points = (0..sizes.len()).map(|k| {
            let all: Estimate = squares.iter().map(|s: &Vec<f64>| s[k]).collect();
            let root = all.root();
            (f64::from(sizes[k]), root.value, root.error)
        });
        let points: Vec<(f64, f64, f64)> = points.collect();
        if let ("fastest", Some(&(n, error, _))) = (kind, points.last()) {
            // The law, through the last point.
            let law = [f64::from(sizes[0]), n].map(|x| (x, error * libm::pow(x / n, slope)));
            let name = format!("slope {slope:.3}");
            curves.push(Curve::new(name, Style::Dashed, law).coloured(2));
        }
        let place = usize::from(kind == "fixed");
        let label = format!("{around} {says}");
        curves.push(Curve::measured(label, Style::MarksAndLine, points).coloured(place));
        // Early passes are not yet what the law is of.
        let late = 2;
        let costs = vec![sizes[late..].iter().map(|&n| f64::from(n)).collect(); squares.len()];
        let late: Vec<Vec<f64>> = squares.iter().map(|s| s[late..].to_vec()).collect();
        let fitted = fit(&costs, &late).map_err(|e| DeskError::Missing(e.to_string()))?;
        let says = format!("slope of the error against passes, {name}, discs {says}");
        let number = Number {
            error: Some(fitted.std_error),
            ..Number::new(&says, fitted.line.slope)
        };
        let number = if kind == "fastest" {
            number.exact(slope)
        } else {
            number
        };
        desk.number(&format!("slope_{kind}_{name}"), number);
    }
    let chart = CurveChart {
        title: format!("Passes of photons on {around}"),
        x_label: "passes".to_owned(),
        y_label: "relative error".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves,
    };
    let caption = format!(
        "Error below a lamp against the number of passes. With {around} of one size it levels out at their blur. With \
         {around} that shrink (α = {fastest:.3}) it goes on falling along its law. Bars: one standard error."
    );
    desk.figure(
        &format!("rates_{name}.svg"),
        &caption,
        chart.to_svg_at(HALF)?,
    )
}
