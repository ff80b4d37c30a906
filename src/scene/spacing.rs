//! Shapes too small for the numbers that say where they are, or so large that these are far apart.

use crate::geometry::{Aabb, Quad, Shape, Sphere, Triangle};
use glam::{DVec3, Vec3};

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

/// A shape that rounding moves by less than this share of its distance from the camera is in its
/// place: some two-hundredth of a pixel where a thousand pixels show 45 degrees.
const IN_PLACE: f64 = 1.0 / (1 << 18) as f64;

/// Shapes that rounding moves towards the camera or away from it: they are huge beside their distance,
/// such as a wall that is part of a sphere.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Misplaced {
    /// How many.
    pub shapes: usize,
    /// The largest distance by which one is moved, in scene units.
    pub by: f64,
}

impl Misplaced {
    /// Looks at a sphere, whose middle was `center` before rounding, counted from the camera.
    pub fn sphere(&mut self, center: DVec3, radius: f64, rounded: &Sphere) {
        let distance = center.length() - radius;
        let now = rounded.center.as_dvec3().length() - f64::from(rounded.radius);
        self.count(now - distance, distance.abs());
    }

    /// Looks at a quad of which this was a corner before rounding, and these the edges.
    pub fn quad(&mut self, [corner, u, v]: [DVec3; 3], rounded: &Quad) {
        let corners = [corner, corner + u, corner + u + v, corner + v];
        self.flat(&corners, &rounded.corners());
    }

    /// Looks at a triangle, whose corners were these before rounding; one that is left out, because
    /// it has no area or is too far away, is nowhere.
    pub fn triangle(&mut self, corners: &[DVec3; 3], t: &Triangle) {
        if t.is_proper() {
            self.flat(corners, &[t.a, t.b, t.c]);
        }
    }

    fn flat(&mut self, corners: &[DVec3], rounded: &[Vec3]) {
        let [a, b, .., d] = corners else {
            return;
        };
        let normal = (b - a).cross(d - a).normalize_or_zero();
        let moved = corners
            .iter()
            .zip(rounded)
            .map(|(p, q)| normal.dot(q.as_dvec3() - p).abs());
        let moved = moved.fold(0.0, f64::max);
        // Of both distances that it has at least, that of its plane and that of the box around it.
        let bounds = Aabb::of(rounded.iter().copied());
        let outside = Vec3::ZERO.clamp(bounds.min, bounds.max);
        self.count(moved, normal.dot(*a).abs().max(outside.as_dvec3().length()));
    }

    fn count(&mut self, moved: f64, distance: f64) {
        let moved = moved.abs();
        if moved > IN_PLACE * distance {
            self.shapes += 1;
            self.by = self.by.max(moved);
        }
    }
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
        if shape.width() < STEPS * step {
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
