//! The figures of this chapter: half disks with their rays, and the two estimators' errors.

use glam::{DVec2, Vec2};
use halfdisk::flatland::{frame, load};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::experiment::convergence::Convergence;
use halfdisk::lab::figures::convergence_chart;
use halfdisk::lab::figures::flat::{self, Turn};
use halfdisk::lab::mistakes::{self, Exam};
use halfdisk::sampling::half_disk;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::space::Dimension;
use std::f32::consts::FRAC_PI_6;

/// The lamp of the world `lamp`, seen from its probe.
pub const LAMP: [DVec2; 2] = [DVec2::new(-0.5, 1.0), DVec2::new(0.5, 1.0)];

/// The half disk over a point, and half disks over twelve normals.
pub fn drawings(desk: &mut Desk) -> Result<(), DeskError> {
    let yard = load("yard")?;
    if let Some(probe) = yard.probe {
        let matrix = frame(probe.surface.n);
        let directions: Vec<Vec2> = local(desk.options.seed, 120).map(|w| matrix * w).collect();
        let mut drawing = flat::half_disk(&yard, &probe.surface, &directions);
        drawing.title = "What P sees".to_owned();
        let caption = "A flat yard in the evening. Rays leave the point P in random directions of \
                       its half disk, coloured by what they meet.";
        desk.figure("fan.svg", caption, drawing.to_svg()?)?;
    }
    let turns = [
        Turn {
            name: "tangent and normal as columns",
            matrix: frame,
        },
        Turn {
            name: "tangent and normal as rows: the transpose",
            matrix: |n| frame(n).transpose(),
        },
    ];
    // One in each of 48 equal parts, so that the shares below the surface show.
    let part = |i: u32| half_disk::sample_uniform((i as f32 + 0.5) / 48.0);
    let directions: Vec<Vec2> = (0..48).map(part).collect();
    let drawing = flat::tilted("Turning the half disk to its normal", &turns, &directions);
    let caption = "The right matrix keeps every ray above the surface, for every normal. The \
                   transpose turns the other way, and loses rays below it.";
    desk.figure("matrices.svg", caption, drawing.to_svg()?)
}

/// Uniform directions of the half disk over an upright normal.
fn local(seed: u64, count: u32) -> impl Iterator<Item = Vec2> {
    (0..count).map(move |i| {
        let u = Stream::new(seed, i, 0).at(0, Purpose::Direction).one();
        half_disk::sample_uniform(u)
    })
}

/// What each slip reads under a white sky.
pub fn readings(desk: &mut Desk, gathers: u32) {
    let upright = Exam::default();
    let tilted = Exam {
        tilt: FRAC_PI_6,
        ..upright
    };
    let mut variants = vec![mistakes::right(Dimension::Flat)];
    variants.extend(mistakes::all(Dimension::Flat));
    for (number, name, exam) in [
        ("reading_correct", "right", upright),
        ("reading_printed", "formula as printed", upright),
        ("reading_over_pi", "printed formula over pi", upright),
        ("reading_cosine", "cosine of the sampled angle", upright),
        ("reading_one_more", "one term too many", upright),
        (
            "reading_transposed",
            "matrix transposed, cosine clamped",
            tilted,
        ),
    ] {
        if let Some(variant) = variants.iter().find(|v| v.name == name) {
            let read = variant.measure(&exam, gathers, desk.options.seed);
            let says = format!("white sky, {:.0}° of tilt: {name}", exam.tilt.to_degrees());
            desk.estimate(number, &says, &read, Some(variant.reading(&exam)));
        }
    }
}

/// The errors of the right and the literal estimator: slopes as numbers, and the chart.
pub fn convergence(desk: &mut Desk, runs: &[Convergence]) -> Result<(), DeskError> {
    for (run, (name, exact)) in runs.iter().zip([("correct", -0.5), ("literal", 0.0)]) {
        if let Some(fit) = run.line() {
            let says = format!("slope of the error: {}", run.name);
            let number = Number::new(&says, fit.line.slope).exact(exact);
            let error = Some(fit.std_error);
            desk.number(&format!("slope_{name}"), Number { error, ..number });
        }
    }
    let chart = convergence_chart("A white sky: more rays help only the right estimator", runs);
    let caption = "The right estimator's error falls with the root of the rays. The formula as \
                   printed stays where its bias is.";
    desk.figure("chart.svg", caption, chart.to_svg()?)
}
