//! The figures of this chapter: the two directions drawn in the flat world, the pictures, the
//! chart.

use crate::prices::{Measured, Prices};
use crate::two_ways::Traced;
use halfdisk::integrators::Combine;
use halfdisk::lab::chapter::{Desk, DeskError, Finale};
use halfdisk::lab::drawing::{
    Axis, Bounds, ChartError, Curve, CurveChart, Dot, HALF, Label, RayDrawing, Stroke, StrokeKind,
    Style,
};
use halfdisk::numeric::sin_cos;
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::{Scene, gallery};
use std::f32::consts::{PI, TAU};

const LAMP: [f32; 2] = [-0.6, 0.9];
const WALL: f32 = -2.0;
const EYE: f32 = 2.0;
const HALF_SLIT: f32 = 0.2;
const VIEW: [f32; 2] = [2.4, 1.5];

/// Both directions, drawn.
pub fn drawings(desk: &mut Desk) -> Result<(), DeskError> {
    let seed = desk.options.seed;
    desk.figure(
        "from_light.svg",
        "Three hundred rays leave the lamp and bounce once at the wall. Those that enter the slit \
         are drawn bold.",
        from_light(seed)?,
    )?;
    desk.figure(
        "from_eye.svg",
        "Twenty-four rays from the eye: each meets the wall, and a line leads from there to the lamp. \
         None is lost.",
        from_eye()?,
    )
}

/// Both pictures.
pub fn pictures(
    desk: &mut Desk,
    scene: &Scene,
    [light, eye]: &[Traced; 2],
) -> Result<(), DeskError> {
    let caption = "From the light: few of its rays find the eye, so the picture is noise.";
    desk.picture("light.png", caption, &light.film, scene)?;
    let caption = "From the eye, with as many rays: every one of them counts.";
    desk.picture("image.png", caption, &eye.film, scene)
}

/// A larger scene by rays from the eye that see lights and what lights shine on; the rays it took.
pub fn finale(desk: &mut Desk) -> Result<u64, DeskError> {
    let finale = Finale {
        file: "courtyard.png",
        title: "A courtyard by rays from the eye: each meets a surface, and looks from there to the sun, and at random for the sky. \
                Look at the shadows: they are blue, for only the sky lights them; and at the balls of mirror and glass, \
                which are black where a further ray would have to go on.",
        spp: 32,
        stops: 0.2,
    };
    let scene = gallery::load("courtyard")?.sized([512, 256]);
    // Direct light alone: a ray to the sun, and one in a random direction for the sky.
    let direct = Combine {
        max_depth: 2,
        heuristic: Heuristic::Power,
    };
    Ok(desk.finale(&scene, &direct, &finale)?.rays.total())
}

/// The error of both ways against the number of rays.
pub fn chart(desk: &mut Desk, prices: &Prices) -> Result<(), DeskError> {
    let curve = |name: &str, measured: &[Measured]| {
        let points = measured.iter();
        let points = points.map(|m| (m.rays as f64, m.error.mean(), m.error.std_error()));
        Curve::measured(name, Style::MarksAndLine, points)
    };
    let chart = CurveChart {
        title: "The same floor both ways".to_owned(),
        x_label: "rays traced".to_owned(),
        y_label: "RMS error of a pixel, W/(m² sr)".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves: vec![
            curve("from the light", &prices.light),
            curve("from the eye", &prices.eye),
        ],
    };
    let caption = "The error of the pixels of the floor (bars: one standard error). Both lines have the slope \
                   -1/2; the distance between them, along the axis of rays, is the price.";
    desk.figure("chart.svg", caption, chart.to_svg()?)
}

/// Rays from the lamp, straight or by the wall, until they leave the view or enter the slit.
fn from_light(seed: u64) -> Result<String, ChartError> {
    let mut strokes = frame();
    for i in 0..300 {
        let mut u = Stream::new(seed, i, 0).at(0, Purpose::Emission);
        let (sin, cos) = sin_cos(TAU * u.one());
        let mut kind = StrokeKind::Lost;
        let mut legs = Vec::new();
        let (end, at_wall) = leg(LAMP, [cos, sin], &mut kind);
        legs.push((LAMP, end));
        if at_wall {
            // The wall scatters every way alike, for the drawing's sake.
            let (sin, cos) = sin_cos(PI * (u.one() - 0.5));
            let (last, _) = leg(end, [cos, sin], &mut kind);
            legs.push((end, last));
        }
        strokes.extend(
            legs.into_iter()
                .map(|(a, b)| Stroke::new(kind, wide(a), wide(b))),
        );
    }
    drawing("From the light", strokes).to_svg_at(HALF)
}

/// Rays from the eye through the slit to the wall, and on to the lamp.
fn from_eye() -> Result<String, ChartError> {
    let eye = [EYE, 0.0];
    let mut strokes = frame();
    for i in 0..24 {
        let at_wall = [WALL, -1.1 + 2.2 * i as f32 / 23.0];
        strokes.push(Stroke::arrow(StrokeKind::Camera, wide(eye), wide(at_wall)));
        strokes.push(Stroke::new(StrokeKind::Shadow, wide(at_wall), wide(LAMP)));
    }
    drawing("From the eye", strokes).to_svg_at(HALF)
}

/// Follows a ray to the wall, into the slit, or out of the view; true where it met the wall.
fn leg(from: [f32; 2], d: [f32; 2], kind: &mut StrokeKind) -> ([f32; 2], bool) {
    let to = |t: f32| [from[0] + t * d[0], from[1] + t * d[1]];
    let out = (VIEW[1] * d[1].signum() - from[1]) / d[1];
    let across = if d[0] > 0.0 { EYE } else { WALL };
    let t = (across - from[0]) / d[0];
    if t > out {
        return (to(out), false);
    }
    let end = to(t);
    if across == EYE && end[1].abs() < HALF_SLIT {
        *kind = StrokeKind::Useful;
    }
    (end, across == WALL)
}

fn frame() -> Vec<Stroke> {
    let wall = |x, y0, y1| Stroke::new(StrokeKind::Wall, wide([x, y0]), wide([x, y1]));
    vec![
        wall(WALL, -VIEW[1], VIEW[1]),
        wall(EYE, -VIEW[1], -HALF_SLIT),
        wall(EYE, HALF_SLIT, VIEW[1]),
    ]
}

fn drawing(title: &str, strokes: Vec<Stroke>) -> RayDrawing {
    let label = |x: f32, y: f32, text: &str| Label {
        at: wide([x, y]),
        text: text.to_owned(),
    };
    RayDrawing {
        title: title.to_owned(),
        view: Bounds {
            min: wide([-VIEW[0], -VIEW[1]]),
            max: wide(VIEW),
        },
        strokes,
        dots: vec![Dot { at: wide(LAMP) }],
        labels: vec![label(LAMP[0], LAMP[1], "lamp"), label(EYE, 0.0, "eye")],
        ..RayDrawing::default()
    }
}

fn wide([x, y]: [f32; 2]) -> [f64; 2] {
    [f64::from(x), f64::from(y)]
}
