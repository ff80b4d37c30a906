//! Where a picture needs samples: maps of the box, and four scenes.

use crate::prices::digits;
use halfdisk::integrators::Path;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::{Axis, Curve, HALF, HeatMap, Style};
use halfdisk::lab::figures::required_chart;
use halfdisk::render::accuracy::Accuracy;
use halfdisk::render::{Options, Rendered, render};
use halfdisk::scene::gallery;
use halfdisk::stats::quantile;

/// The relative error that pixels should have.
const TARGET: f64 = 0.02;

/// The scenes whose needs are compared.
const SCENES: [&str; 4] = ["cornell", "spheres", "gloss", "caustic"];

/// A square picture of a scene, by independent samples.
fn picture(desk: &Desk, name: &str, side: u32, spp: u32) -> Result<Rendered, DeskError> {
    let scene = gallery::load(name)?.sized([side; 2]);
    let options = Options {
        spp,
        seed: desk.options.seed,
        ..Options::default()
    };
    let path = Path::new(scene.suggested.max_depth);
    let rendered = render(&scene, &path, &options, &desk.bar(name));
    match rendered.interrupted {
        true => Err(DeskError::Interrupted),
        false => Ok(rendered),
    }
}

/// The variance of one sample and the samples that are needed, pixel by pixel; the rays.
pub fn box_of_noise(desk: &mut Desk) -> Result<u64, DeskError> {
    let found = picture(desk, "cornell", desk.choose(64, 32), desk.choose(48, 16))?;
    let accuracy = Accuracy::of(&found.film);
    let map = |title: &str, label: &str, values: Vec<f64>| HeatMap {
        title: title.to_owned(),
        label: label.to_owned(),
        width: found.film.width(),
        values,
        axis: Axis::Log,
    };
    let variance = map("The variance of one path", "variance", accuracy.variances());
    let caption = "The variance of one path in each pixel, in squared radiance, on a logarithmic scale. Look for the \
                   brightest line: it is the edge of the lamp.";
    desk.figure("variance.svg", caption, variance.to_svg_at(HALF)?)?;
    let required = map(
        "Paths for an error of 2 %",
        "paths",
        accuracy.required(TARGET),
    );
    let caption = "The paths that each pixel needs for an error of 2 %: its variance over the squared error that is \
                   wanted. The map is the left one, relative to the brightness around each pixel.";
    desk.figure("required.svg", caption, required.to_svg_at(HALF)?)?;
    Ok(found.rays.total())
}

/// How many paths pixels need for 2 % in four scenes; the rays.
pub fn four_scenes(desk: &mut Desk) -> Result<u64, DeskError> {
    let mut needs = Vec::new();
    let mut rays = 0;
    for name in SCENES {
        let found = picture(desk, name, desk.choose(40, 24), desk.choose(48, 16))?;
        rays += found.rays.total();
        let required = Accuracy::of(&found.film).required(TARGET);
        let share = |test: fn(f64) -> bool| {
            let count = required.iter().filter(|n| test(**n)).count();
            100.0 * count as f64 / required.len() as f64
        };
        let shares = [
            ("less", "fewer than 100", share(|n| n < 100.0)),
            (
                "within",
                "100 to 1000",
                share(|n| (100.0..=1000.0).contains(&n)),
            ),
            ("more", "more than 1000", share(|n| n > 1000.0)),
        ];
        for (key, words, share) in shares {
            let says = format!("{name}: pixels that need {words} paths, %");
            desk.value(&format!("{key}_{name}"), &says, digits(share));
        }
        let says = format!("{name}: paths that half of the pixels need at most");
        let median = digits(quantile(required.clone(), 0.5));
        desk.value(&format!("median_{name}"), &says, median);
        needs.push((name, required));
    }
    let mut chart = required_chart("Paths for an error of 2 % in four scenes", TARGET, &needs);
    // Four lines of 95 % would hide what is told here; and pixels of even colour, which one path
    // serves, would hide all others.
    chart.curves.retain(|curve| curve.style != Style::Dashed);
    for curve in &mut chart.curves {
        curve.points.retain(|point| point.x > 1.5);
    }
    let top = chart
        .curves
        .iter()
        .flat_map(|c| &c.points)
        .map(|p| p.y)
        .fold(0.0, f64::max);
    for (name, n) in [("the slides' 100 to 1000", 100.0), ("", 1000.0)] {
        chart
            .curves
            .push(Curve::new(name, Style::Dashed, [(n, 0.0), (n, top)]).coloured(6));
    }
    let caption = "How many paths the pixels of four scenes need for an error of 2 %: the share of the pixels in bins of \
                   half a doubling, without those that need a single path. Look how much of each scene lies between the \
                   dashed lines, the range that the slides give, and how far its tail reaches to the right.";
    desk.figure("histogram.svg", caption, chart.to_svg()?)?;
    Ok(rays)
}
