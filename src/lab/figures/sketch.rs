//! A drawing of an idea: few strokes, and words beside them instead of a legend.

use crate::lab::drawing::{
    Arc, Bounds, ChartError, Circle, Dot, Label, RayDrawing, Stroke, StrokeKind,
};
use glam::DVec2;

/// A drawing that is made stroke by stroke, in units of the plane.
#[derive(Clone, Debug)]
pub struct Sketch(RayDrawing);

/// The unit vector at an angle, in radians, counter-clockwise from the right.
pub fn toward(angle: f64) -> DVec2 {
    let (sin, cos) = libm::sincos(angle);
    DVec2::new(cos, sin)
}

impl Sketch {
    /// An empty sheet: its headline, its lower left and its upper right corner.
    pub fn new(title: &str, min: [f64; 2], max: [f64; 2]) -> Self {
        Self(RayDrawing {
            title: title.to_owned(),
            view: Bounds { min, max },
            bare: true,
            ..RayDrawing::default()
        })
    }

    /// A line.
    pub fn line(&mut self, kind: StrokeKind, from: DVec2, to: DVec2) {
        let stroke = Stroke::new(kind, from.to_array(), to.to_array());
        self.0.strokes.push(stroke);
    }

    /// A line with an arrow head at its end.
    pub fn arrow(&mut self, kind: StrokeKind, from: DVec2, to: DVec2) {
        let stroke = Stroke::arrow(kind, from.to_array(), to.to_array());
        self.0.strokes.push(stroke);
    }

    /// A curve through places.
    pub fn curve(&mut self, kind: StrokeKind, places: impl IntoIterator<Item = DVec2>) {
        let places: Vec<DVec2> = places.into_iter().collect();
        places.windows(2).for_each(|w| self.line(kind, w[0], w[1]));
    }

    /// A piece of a circle, from an angle on, by so many radians counter-clockwise.
    pub fn arc(&mut self, kind: StrokeKind, center: DVec2, radius: f64, start: f64, turn: f64) {
        self.0.arcs.push(Arc {
            center: center.to_array(),
            radius,
            start,
            turn,
            kind,
        });
    }

    /// A circle.
    pub fn circle(&mut self, kind: StrokeKind, center: DVec2, radius: f64) {
        self.0.circles.push(Circle {
            center: center.to_array(),
            radius,
            kind,
        });
    }

    /// A dot.
    pub fn dot(&mut self, at: DVec2) {
        self.0.dots.push(Dot { at: at.to_array() });
    }

    /// A lamp that is a point.
    pub fn lamp(&mut self, at: DVec2) {
        self.0.lamps.push(Dot { at: at.to_array() });
    }

    /// A word, its middle at a place.
    pub fn word(&mut self, at: DVec2, text: &str) {
        self.0.captions.push(Label::new(at.to_array(), text));
    }

    /// A word above and to the right of a place.
    pub fn label(&mut self, at: DVec2, text: &str) {
        self.0.labels.push(Label::new(at.to_array(), text));
    }

    /// As SVG text, as wide as a page.
    pub fn to_svg(&self) -> Result<String, ChartError> {
        self.0.to_svg()
    }

    /// As SVG text, of a width in pixels.
    pub fn to_svg_at(&self, width: u32) -> Result<String, ChartError> {
        self.0.to_svg_at(width)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_that_is_sketched_is_drawn_and_named_by_words_alone() {
        let mut sketch = Sketch::new("an idea", [-1.0, -1.0], [1.0, 1.0]);
        let (o, kind) = (DVec2::ZERO, StrokeKind::Normal);
        sketch.line(kind, o, toward(0.0));
        sketch.arrow(kind, o, toward(1.0));
        sketch.curve(kind, (0..4).map(|i| toward(f64::from(i))));
        sketch.arc(kind, o, 0.5, 0.0, 1.0);
        sketch.circle(kind, o, 0.25);
        sketch.dot(o);
        sketch.lamp(o);
        sketch.word(o, "middle");
        sketch.label(o, "beside");
        let svg = sketch.to_svg().unwrap();
        assert_eq!(svg.matches("<polyline").count(), 2 + 3);
        assert_eq!(svg.matches("<circle").count(), 3);
        for part in ["A", "middle", "beside", "an idea", "marker-end"] {
            assert!(svg.contains(part), "{part}");
        }
        assert!(!svg.contains(">normal<"), "no legend");
    }
}
