//! Shapes too small for the numbers that say where they are.

use crate::geometry::Shape;
use glam::Vec3;

/// A shape this many steps across, from one number to the next, is still much like itself.
const STEPS: f32 = 8.0;

/// What of a scene is too small for where it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coarse {
    /// Shapes whose shortest edge, or diameter, is fewer than eight steps from one `f32` to the next
    /// at their largest coordinate, counted from the camera.
    pub shapes: usize,
    /// The largest of these steps, in scene units.
    pub step: f32,
}

/// Which shapes are so small for where they stand that rounding changes their form; `None` where
/// none is.
pub(super) fn coarse<'a>(shapes: impl Iterator<Item = &'a Shape>) -> Option<Coarse> {
    let mut found = Coarse {
        shapes: 0,
        step: 0.0,
    };
    for shape in shapes {
        let step = step_at(shape);
        if size(shape) < STEPS * step {
            found.shapes += 1;
            found.step = found.step.max(step);
        }
    }
    (found.shapes > 0).then_some(found)
}

/// The distance from the largest coordinate of a shape to the next number.
fn step_at(shape: &Shape) -> f32 {
    let extent = match shape {
        // A sphere stands where its centre does; its radius is a number of its own.
        Shape::Sphere(s) => s.center.abs().max_element(),
        _ => {
            let bounds = shape.bounds();
            bounds.min.abs().max(bounds.max.abs()).max_element()
        }
    };
    extent.next_up() - extent
}

fn size(shape: &Shape) -> f32 {
    let shortest = |corners: &[Vec3]| {
        let next = corners.iter().cycle().skip(1);
        let edges = corners.iter().zip(next).map(|(a, b)| a.distance(*b));
        edges.fold(f32::INFINITY, f32::min)
    };
    match shape {
        Shape::Sphere(s) => 2.0 * s.radius,
        Shape::Quad(q) => shortest(&q.corners()),
        Shape::Triangle(t) => shortest(&[t.a, t.b, t.c]),
    }
}
