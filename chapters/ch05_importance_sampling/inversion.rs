//! Inversion and Malley's method, drawn in the flat world.

use glam::DVec2;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::{ChartError, Curve, CurveChart, HALF, StrokeKind, Style};
use halfdisk::lab::figures::sketch::Sketch;
use std::f64::consts::{FRAC_PI_2, PI};

/// Numbers that are inverted, evenly from 0 to 1.
const NUMBERS: u32 = 12;

/// Both drawings.
pub fn drawings(desk: &mut Desk) -> Result<(), DeskError> {
    desk.figure(
        "inversion.svg",
        "Inversion. Twelve evenly spaced numbers u go across to the curve and down to their angles. Where \
         the curve is steep, in the middle, the angles lie close together.",
        inversion()?,
    )?;
    desk.figure(
        "malley.svg",
        "Malley's method. Evenly spaced points of the ground are lifted to the half circle. The directions \
         to them are the twelve of the chart.",
        malley()?,
    )
}

fn numbers() -> impl Iterator<Item = f64> {
    (0..NUMBERS).map(|i| (f64::from(i) + 0.5) / f64::from(NUMBERS))
}

/// The distribution function of the cosine in the flat world, and its inverse read off.
fn inversion() -> Result<String, ChartError> {
    let curve = (0..=90).map(|i| {
        let angle = -FRAC_PI_2 + PI * f64::from(i) / 90.0;
        (angle.to_degrees(), 0.5 * (1.0 + libm::sin(angle)))
    });
    let curve = Curve::new("P(θ) = (1 + sin θ) / 2", Style::Line, curve).coloured(0);
    let read = numbers().map(|u| {
        let angle = libm::asin(2.0 * u - 1.0).to_degrees();
        Curve::new("", Style::Dashed, [(-90.0, u), (angle, u), (angle, 0.0)]).coloured(1)
    });
    CurveChart {
        title: "From u to an angle".to_owned(),
        x_label: "angle θ from the normal, degrees".to_owned(),
        y_label: "u".to_owned(),
        curves: [curve].into_iter().chain(read).collect(),
        ..CurveChart::default()
    }
    .to_svg_at(HALF)
}

/// Even points of the ground, lifted.
fn malley() -> Result<String, ChartError> {
    let mut sketch = Sketch::new("From the ground to an angle", [-1.15, -0.35], [1.15, 1.3]);
    let o = DVec2::ZERO;
    sketch.arc(StrokeKind::HalfDisk, o, 1.0, 0.0, PI);
    sketch.line(
        StrokeKind::Wall,
        DVec2::new(-1.1, 0.0),
        DVec2::new(1.1, 0.0),
    );
    for u in numbers() {
        let x = 2.0 * u - 1.0;
        let (foot, top) = (DVec2::new(x, 0.0), DVec2::new(x, (1.0 - x * x).sqrt()));
        sketch.line(StrokeKind::Axis, foot, top);
        sketch.line(StrokeKind::ToSurface, o, top);
        sketch.dot(foot);
        sketch.dot(top);
    }
    sketch.arrow(StrokeKind::Normal, o, DVec2::new(0.0, 1.18));
    sketch.word(DVec2::new(0.0, 1.25), "n");
    sketch.word(DVec2::new(0.0, -0.2), "x = 2u − 1 = sin θ");
    sketch.to_svg_at(HALF)
}
