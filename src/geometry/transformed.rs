//! Shapes that are not simply where they are: their place is asked for ray by ray.

use super::{Aabb, Instance, Intersection, Moving, PreparedRay, Primitive, Ray, Surface};

/// A shape under a transformation.
#[derive(Clone, Debug)]
pub enum Transformed {
    /// That changes with time.
    Moving(Moving),
    /// That puts a mesh, or a shape of one's own, in its place.
    Instance(Instance),
}

impl Primitive for Transformed {
    fn bounds(&self) -> Aabb {
        match self {
            Transformed::Moving(shape) => shape.bounds(),
            Transformed::Instance(shape) => shape.bounds(),
        }
    }

    fn intersect(&self, ray: &PreparedRay, t_max: f32) -> Option<Intersection> {
        match self {
            Transformed::Moving(shape) => shape.intersect(ray, t_max),
            Transformed::Instance(shape) => shape.intersect(ray, t_max),
        }
    }

    fn surface(&self, ray: &Ray, intersection: Intersection) -> Surface {
        match self {
            Transformed::Moving(shape) => shape.surface(ray, intersection),
            Transformed::Instance(shape) => shape.surface(ray, intersection),
        }
    }
}
