//! The angles and lengths of one shadow ray.

use glam::DVec2;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::StrokeKind;
use halfdisk::lab::figures::sketch::{Sketch, toward};
use std::f64::consts::{FRAC_PI_2, PI};

/// A surface, a piece of a lamp, and what lies between them.
pub fn drawing(desk: &mut Desk) -> Result<(), DeskError> {
    let mut sketch = Sketch::new(
        "From a piece of the lamp to an angle",
        [-1.6, -0.35],
        [3.6, 2.35],
    );
    let x = DVec2::ZERO;
    sketch.line(
        StrokeKind::Wall,
        DVec2::new(-1.5, 0.0),
        DVec2::new(3.5, 0.0),
    );
    let slant = 0.75;
    let towards = toward(FRAC_PI_2 - slant);
    let r = 2.4;
    let lamp = towards * r;
    // The lamp's normal, and how far it turns away from the surface.
    let askew = 0.6;
    let back = FRAC_PI_2 - slant + PI;
    let n_lamp = toward(back - askew);
    let half = n_lamp.perp() * 0.34;
    sketch.line(StrokeKind::Lamp, lamp - half, lamp + half);
    sketch.line(StrokeKind::Axis, x, lamp - half);
    sketch.line(StrokeKind::Axis, x, lamp + half);
    sketch.arrow(StrokeKind::Reflected, x, lamp);
    sketch.arrow(StrokeKind::Normal, x, DVec2::new(0.0, 1.5));
    sketch.arrow(StrokeKind::Normal, lamp, lamp + n_lamp * 0.9);
    let outline = StrokeKind::Outline;
    sketch.arc(outline, x, 0.8, FRAC_PI_2 - slant, slant);
    sketch.arc(outline, lamp, 0.45, back - askew, askew);
    // The angle that the piece covers, on the unit circle around the surface point.
    let ends = [lamp - half, lamp + half].map(|end| libm::atan2(end.y, end.x));
    let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
    sketch.arc(StrokeKind::Useful, x, 1.1, low, high - low);
    for (at, word) in [
        (DVec2::new(0.0, 1.65), "n"),
        (lamp + n_lamp * 1.03, "n′"),
        (toward(FRAC_PI_2 - 0.42 * slant) * 0.97, "θ"),
        (lamp + toward(back - 0.5 * askew) * 0.62, "θ′"),
        (toward(low - 0.1) * 1.2, "dω"),
        (towards * 1.75 - towards.perp() * 0.14, "r"),
        (lamp + towards * 0.22, "dA"),
        (DVec2::new(0.0, -0.17), "x"),
    ] {
        sketch.word(at, word);
    }
    sketch.dot(x);
    desk.figure(
        "geometry.svg",
        "A piece dA of the lamp, seen from x. It covers the angle dω, which shrinks with the distance r, and \
         with the angle θ′ by which the lamp turns away.",
        sketch.to_svg()?,
    )
}
