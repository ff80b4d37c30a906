//! The law in a drawing: two methods on logarithmic axes, and the price between them.

use glam::DVec2;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::StrokeKind;
use halfdisk::lab::figures::sketch::Sketch;

/// Draws it.
pub fn drawing(desk: &mut Desk) -> Result<(), DeskError> {
    let mut sketch = Sketch::new("The law, and a price", [-0.5, -0.45], [6.6, 3.2]);
    let at = DVec2::new;
    let axis = StrokeKind::Outline;
    sketch.arrow(axis, at(0.0, 0.0), at(6.4, 0.0));
    sketch.arrow(axis, at(0.0, 0.0), at(0.0, 3.1));
    sketch.word(at(5.3, -0.25), "rays, logarithmic");
    sketch.word(at(0.75, 3.0), "error, logarithmic");
    // Error falls by one unit for two units of rays.
    let law = |height: f64, from: f64, to: f64| [from, to].map(|x| at(x, height - 0.5 * x));
    let [from, to] = law(2.7, 0.2, 5.2);
    sketch.line(StrokeKind::Reflected, from, to);
    sketch.word(at(5.7, 0.14), "A");
    let [from, to] = law(3.9, 2.0, 6.2);
    sketch.line(StrokeKind::Transmitted, from, to);
    sketch.word(at(6.35, 0.85), "B");
    let same = 1.75;
    let ends = [2.7, 3.9].map(|height| at(2.0 * (height - same), same));
    sketch.arrow(StrokeKind::Normal, ends[0], ends[1]);
    sketch.word(at(3.1, 1.93), "the price of B");
    let corner = [at(3.0, 1.2), at(4.4, 1.2), at(4.4, 0.5)];
    sketch.line(StrokeKind::Axis, corner[0], corner[1]);
    sketch.line(StrokeKind::Axis, corner[1], corner[2]);
    sketch.word(at(3.75, 1.36), "4 times the rays");
    sketch.word(at(5.05, 0.85), "half the error");
    let caption = "Independent samples make a line of slope -1/2 on logarithmic axes: four times the rays, half the error. Two \
                   methods make two parallel lines. The distance between them along the axis of rays is the price: it is \
                   the same at every error.";
    desk.figure("law.svg", caption, sketch.to_svg()?)
}
