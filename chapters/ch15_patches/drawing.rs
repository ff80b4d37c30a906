//! Two patches, and how much one sees of the other.

use glam::DVec2;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::StrokeKind;
use halfdisk::lab::figures::sketch::{Sketch, toward};
use std::f64::consts::FRAC_PI_2;

/// A floor and a wall cut into patches, a point of one, and the view that another one takes up.
pub fn patches(desk: &mut Desk) -> Result<(), DeskError> {
    let mut sketch = Sketch::new("The form factor of two patches", [-0.5, -0.55], [5.3, 2.75]);
    let at = DVec2::new;
    let (floor, wall) = (StrokeKind::Wall, StrokeKind::Wall);
    sketch.line(floor, at(0.0, 0.0), at(4.0, 0.0));
    sketch.line(wall, at(4.0, 0.0), at(4.0, 2.4));
    // Where the patches end.
    for k in 0..=5 {
        let x = 0.8 * f64::from(k);
        sketch.line(StrokeKind::Outline, at(x, -0.07), at(x, 0.07));
    }
    for k in 0..=3 {
        let y = 0.8 * f64::from(k);
        sketch.line(StrokeKind::Outline, at(3.93, y), at(4.07, y));
    }
    let (x, ends) = (at(1.2, 0.0), [at(4.0, 0.8), at(4.0, 1.6)]);
    sketch.line(StrokeKind::Lamp, at(0.8, -0.04), at(1.6, -0.04));
    let beside = at(0.04, 0.0);
    sketch.line(StrokeKind::Lamp, ends[0] + beside, ends[1] + beside);
    ends.into_iter()
        .for_each(|end| sketch.line(StrokeKind::Axis, x, end));
    let middle = 0.5 * (ends[0] + ends[1]);
    sketch.arrow(StrokeKind::Reflected, x, middle);
    sketch.arrow(StrokeKind::Normal, x, x + at(0.0, 1.3));
    sketch.arrow(StrokeKind::Normal, middle, middle - at(1.0, 0.0));
    let angle = |p: DVec2| libm::atan2(p.y, p.x);
    let [low, high] = ends.map(|end| angle(end - x));
    sketch.arc(StrokeKind::Useful, x, 1.5, low, high - low);
    let up = angle(middle - x);
    sketch.arc(StrokeKind::Outline, x, 0.7, up, FRAC_PI_2 - up);
    sketch.arc(StrokeKind::Outline, middle, 0.7, std::f64::consts::PI, up);
    for (place, word) in [
        (at(1.2, -0.27), "patch i"),
        (at(4.55, 1.2), "patch j"),
        (x + at(-0.14, 0.13), "x"),
        (x + at(0.0, 1.45), "n"),
        (middle - at(1.0, -0.16), "n′"),
        (x + toward(0.5 * (up + FRAC_PI_2)) * 0.87, "θ"),
        (middle - toward(0.5 * up) * 0.88, "θ′"),
        (x + toward(up) * 1.95 + at(-0.05, 0.16), "r"),
        (x + toward(0.5 * (low + up)) * 1.68, "dω"),
    ] {
        sketch.word(place, word);
    }
    sketch.dot(x);
    desk.figure(
        "patches.svg",
        "Patch j takes up a part of what x sees, here between the two thin lines. The form factor is that part, with the \
         weight cos θ/π of each direction, as a mean over all points x of patch i.",
        sketch.to_svg()?,
    )
}
