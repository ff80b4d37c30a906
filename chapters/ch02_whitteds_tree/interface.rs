//! What glass does at one point of its surface, and how a ray leaves a surface.

use glam::DVec2;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::{ChartError, Curve, CurveChart, HALF, StrokeKind, Style};
use halfdisk::lab::figures::sketch::{Sketch, toward};
use halfdisk::materials::fresnel;
use std::f64::consts::FRAC_PI_2;

/// Index of refraction of glass.
const GLASS: f64 = 1.5;

/// Snell's law, Fresnel's formulas, and shadow acne.
pub fn drawings(desk: &mut Desk) -> Result<(), DeskError> {
    desk.figure(
        "snell.svg",
        "Snell's law at glass of index 1.5: light that arrives at 50° from the normal goes on at 30.7°, and a \
         part of it is mirrored at 50°.",
        snell()?,
    )?;
    desk.figure(
        "fresnel.svg",
        "How much is mirrored. From air 4 % head-on, and hardly more until 50°; from inside the glass, all of it beyond \
         the critical angle of 41.8° (total internal reflection).",
        reflectance()?,
    )?;
    let (svg, below) = acne()?;
    desk.value(
        "acne_points",
        "points of the surface in the drawing",
        f64::from(POINTS),
    );
    desk.value(
        "acne_below",
        "  of which rounding puts below it",
        f64::from(below),
    );
    desk.figure(
        "acne.svg",
        "Shadow acne. The computed points of a surface lie on a grid of numbers, drawn coarsely here. Those \
         above the true surface see the lamp; those below it are shadowed by their own surface.",
        svg,
    )
}

/// One ray that becomes two.
fn snell() -> Result<String, ChartError> {
    let mut sketch = Sketch::new("Snell's law", [-1.35, -1.2], [1.35, 1.2]);
    let incident = 50_f64.to_radians();
    let refracted = libm::asin(libm::sin(incident) / GLASS);
    let o = DVec2::ZERO;
    sketch.line(
        StrokeKind::Wall,
        DVec2::new(-1.3, 0.0),
        DVec2::new(1.3, 0.0),
    );
    sketch.line(
        StrokeKind::Axis,
        DVec2::new(0.0, -1.15),
        DVec2::new(0.0, 1.15),
    );
    sketch.arrow(StrokeKind::Camera, toward(FRAC_PI_2 + incident) * 1.2, o);
    sketch.arrow(StrokeKind::Reflected, o, toward(FRAC_PI_2 - incident) * 1.2);
    sketch.arrow(
        StrokeKind::Transmitted,
        o,
        toward(refracted - FRAC_PI_2) * 1.15,
    );
    let kind = StrokeKind::Outline;
    sketch.arc(kind, o, 0.5, FRAC_PI_2, incident);
    sketch.arc(kind, o, 0.5, FRAC_PI_2 - incident, incident);
    sketch.arc(kind, o, 0.5, -FRAC_PI_2, refracted);
    for (angle, radius, word) in [
        (FRAC_PI_2 + 0.5 * incident, 0.66, "θᵢ"),
        (FRAC_PI_2 - 0.5 * incident, 0.66, "θᵢ"),
        (0.5 * refracted - FRAC_PI_2, 0.68, "θₜ"),
    ] {
        sketch.word(toward(angle) * radius, word);
    }
    sketch.word(DVec2::new(-0.85, 0.1), "air, index 1");
    sketch.word(DVec2::new(-0.8, -0.14), "glass, index n");
    sketch.to_svg_at(HALF)
}

/// The share that is mirrored, from both sides.
fn reflectance() -> Result<String, ChartError> {
    let curve = |name: &str, eta: f64| {
        let points = (0..=180).map(|i| {
            let angle = f64::from(i) / 180.0 * FRAC_PI_2;
            (
                angle.to_degrees(),
                fresnel::dielectric(libm::cos(angle), eta),
            )
        });
        Curve::new(name, Style::Line, points)
    };
    CurveChart {
        title: "Fresnel's formulas".to_owned(),
        x_label: "angle from the normal, degrees".to_owned(),
        y_label: "share that is mirrored".to_owned(),
        curves: vec![curve("from air", GLASS), curve("from glass", 1.0 / GLASS)],
        ..CurveChart::default()
    }
    .to_svg_at(HALF)
}

/// Points of the surface that are drawn.
const POINTS: u32 = 25;

/// Points of a slanted surface, rounded to a grid, and what they see of a lamp; how many of them lie below
/// the surface.
fn acne() -> Result<(String, u32), ChartError> {
    let mut sketch = Sketch::new("A surface that shadows itself", [-0.15, -0.1], [4.3, 1.85]);
    let (slope, cell) = (0.21, 0.1);
    let surface = |x: f64| DVec2::new(x, 0.13 + slope * x);
    let lamp = DVec2::new(2.1, 1.7);
    sketch.line(StrokeKind::Wall, surface(-0.1), surface(4.25));
    sketch.lamp(lamp);
    sketch.label(lamp, "lamp");
    let mut below = 0;
    for i in 0..POINTS {
        let exact = surface(0.05 + 4.1 * f64::from(i) / f64::from(POINTS - 1));
        let p = (exact / cell).round() * cell;
        if p.y < surface(p.x).y {
            below += 1;
            // Up to the surface, where the shadow ray ends.
            let towards = lamp - p;
            let depth = surface(p.x).y - p.y;
            let t = depth / (towards.y - slope * towards.x);
            sketch.line(StrokeKind::Useful, p, p + towards * t);
        } else {
            sketch.line(StrokeKind::Shadow, p, lamp);
        }
        sketch.dot(p);
    }
    Ok((sketch.to_svg()?, below))
}
