//! The figures of this chapter: histograms, points, and errors that fall.

use crate::angles::{CELLS, Drawn};
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::{
    Arc, Axis, Bounds, ChartError, Circle, Curve, CurveChart, Dot, HALF, Label, RayDrawing, Stroke,
    StrokeKind, Style,
};
use halfdisk::lab::estimators::directions::Recipe;
use halfdisk::lab::experiment::convergence::Convergence;
use halfdisk::lab::figures::convergence_chart;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::space::{Flat, Solid};
use std::f64::consts::PI;

/// The histograms of both worlds.
pub fn angles(desk: &mut Desk, flat: &[Drawn], solid: &[Drawn]) -> Result<(), DeskError> {
    let caption = "Angles from the normal in the flat world: drawn (dots), and their densities \
                   (lines).";
    let chart = histogram("The half disk", flat);
    desk.figure("angles_flat.svg", caption, chart.to_svg_at(HALF)?)?;
    let caption = "The same on the hemisphere, where few directions lie around the normal. A \
                   uniform polar angle is none of them.";
    let chart = histogram("The hemisphere", solid);
    desk.figure("angles_solid.svg", caption, chart.to_svg_at(HALF)?)
}

/// Both charts of errors.
pub fn slopes(desk: &mut Desk, lamp: &[Convergence], sky: &[Convergence]) -> Result<(), DeskError> {
    let caption = "A strip of light in space: the cosine lowers the line, strata tilt it.";
    let chart = convergence_chart("Under a strip of light", lamp);
    desk.figure("chart.svg", caption, chart.to_svg_at(HALF)?)?;
    let caption = "A white sky, uniform directions: without an edge, strata tilt it further, in \
                   one dimension most.";
    let chart = convergence_chart("Under a white sky", sky);
    desk.figure("smooth.svg", caption, chart.to_svg_at(HALF)?)
}

/// Directions of three recipes, in both worlds.
pub fn points(desk: &mut Desk) -> Result<(), DeskError> {
    let caption = "Sixteen directions of the half disk, and a hundred of the hemisphere seen from \
                   above. From there cosine directions fill the disc evenly, and uniform ones crowd \
                   at its rim.";
    desk.figure("points.svg", caption, scattered(desk.options.seed)?)
}

/// Dots for what was drawn, a line for the density of the law.
fn histogram(title: &str, all: &[Drawn]) -> CurveChart {
    let curves = all.iter().enumerate().flat_map(|(i, drawn)| {
        let total = drawn.cosine.count() as f64 * drawn.width();
        let dots = drawn.counts.iter().enumerate().map(|(cell, &count)| {
            let angle = drawn.place(cell as f64 + 0.5);
            let count = count as f64;
            (angle.to_degrees(), count / total, count.sqrt() / total)
        });
        let line = (0..=4 * CELLS).map(|quarter| {
            // A hair inside the horizon: beyond it there is no density.
            let angle = drawn.place(quarter as f64 / 4.0) * (1.0 - 1e-6);
            (angle.to_degrees(), (drawn.law.density)(angle))
        });
        // The fourth claims the density of the first.
        let own = i < 3;
        let name = |shown: bool| if shown { drawn.law.name } else { "" };
        let dots = Curve::measured(name(!own), Style::Marks, dots).coloured(i);
        let line = own.then(|| Curve::new(name(own), Style::Line, line).coloured(i));
        [Some(dots), line].into_iter().flatten()
    });
    CurveChart {
        title: title.to_owned(),
        x_label: "angle from the normal, degrees".to_owned(),
        y_label: "density, per radian".to_owned(),
        x_axis: Axis::Linear,
        y_axis: Axis::Linear,
        curves: curves.collect(),
    }
}

fn scattered(seed: u64) -> Result<String, ChartError> {
    let columns = [
        (-2.5, "uniform", Recipe::Uniform),
        (0.0, "cosine", Recipe::Cosine),
        (2.5, "stratified cosine", Recipe::StratifiedCosine),
    ];
    let mut drawing = RayDrawing {
        title: "Directions".to_owned(),
        view: Bounds {
            min: [-3.7, -1.15],
            max: [3.7, 2.8],
        },
        ..RayDrawing::default()
    };
    let kind = StrokeKind::HalfDisk;
    for (x, name, recipe) in columns {
        let base = [x, 1.4];
        drawing.arcs.push(Arc {
            center: base,
            radius: 1.0,
            start: 0.0,
            turn: PI,
            kind,
        });
        let ground = Stroke::new(kind, [x - 1.0, base[1]], [x + 1.0, base[1]]);
        drawing.strokes.push(ground);
        let mut numbers = Stream::new(seed, 6, 0).at(0, Purpose::Direction);
        for i in 0..16 {
            let w = recipe.draw::<Flat>(i, 16, &mut numbers).w.as_dvec2();
            let at = [base[0] + w.x, base[1] + w.y];
            let ray = Stroke::new(StrokeKind::ToSky, base, at);
            drawing.strokes.push(ray);
            drawing.dots.push(Dot { at });
        }
        let center = [x, 0.0];
        drawing.circles.push(Circle {
            center,
            radius: 1.0,
            kind,
        });
        for i in 0..100 {
            let w = recipe.draw::<Solid>(i, 100, &mut numbers).w.as_dvec3();
            drawing.dots.push(Dot { at: [x + w.x, w.y] });
        }
        drawing.captions.push(Label {
            at: [x, 2.62],
            text: name.to_owned(),
        });
    }
    drawing.to_svg()
}
