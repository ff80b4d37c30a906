//! A shape in motion.

use super::{Aabb, Intersection, PreparedRay, Primitive, Ray, Shape, Surface};
use glam::Vec3;

/// A shape that moves along a straight line while the shutter is open.
///
/// At `time`, in `[0, 1]`, it is [`Shape::moved`] by `motion * time`, a shape like any other: the
/// answers at that time are those of the still shape in that place, bit for bit. Source: Cook,
/// Porter, Carpenter, Distributed Ray Tracing (SIGGRAPH 1984).
#[derive(Clone, Copy, Debug)]
pub struct Moving {
    shape: Shape,
    motion: Vec3,
}

impl Moving {
    /// The shape that stands as given at time 0, and displaced by `motion` at time 1; `None` where
    /// one of the two does not fit into finite numbers.
    pub fn new(shape: Shape, motion: Vec3) -> Option<Self> {
        let moving = Moving { shape, motion };
        let ends = [shape, shape.moved(motion)];
        let finite = motion.is_finite() && ends.iter().all(|s| s.bounds().is_finite());
        finite.then_some(moving)
    }

    /// The shape where it is at `time`, in `[0, 1]`.
    pub fn at(&self, time: f32) -> Shape {
        debug_assert!((0.0..=1.0).contains(&time), "{time}");
        self.shape.moved(self.motion * time)
    }

    /// The surface at an intersection with this ray.
    ///
    /// A moved sphere or triangle is exactly one again. The four corners of a quad are rounded
    /// anew, which bends it: its error grows by that.
    pub fn surface(&self, ray: &Ray, intersection: Intersection) -> Surface {
        let there = self.at(ray.time);
        let mut surface = there.surface(ray, intersection);
        if let (Shape::Quad(before), Shape::Quad(moved)) = (&self.shape, &there)
            && self.motion * ray.time != Vec3::ZERO
        {
            surface.error += before.bend(moved);
        }
        surface
    }

    /// The box of all places.
    ///
    /// Sums and products rounded to the nearest grow with what is added and multiplied, so each
    /// coordinate at any time is between those at the ends, without a rounding to spare.
    pub fn bounds(&self) -> Aabb {
        self.at(0.0).bounds().union(self.at(1.0).bounds())
    }
}

impl Primitive for Moving {
    fn surface(&self, ray: &Ray, intersection: Intersection) -> Surface {
        Moving::surface(self, ray, intersection)
    }

    fn bounds(&self) -> Aabb {
        Moving::bounds(self)
    }

    #[inline]
    fn intersect(&self, ray: &PreparedRay, t_max: f32) -> Option<Intersection> {
        self.at(ray.time).intersect(ray, t_max)
    }
}
