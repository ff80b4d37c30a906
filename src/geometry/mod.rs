//! Rays, shapes and the hierarchy that finds the first hit.
//!
//! A shape answers three questions: where does a ray cross you ([`Shape::cross`]), what is the
//! surface like there ([`Shape::surface`]), and what box holds you ([`Shape::bounds`]). Points on
//! a surface carry a bound on their rounding error, so that rays can leave them safely.

mod aabb;
mod bvh;
mod mesh;
mod quad;
mod ray;
mod sphere;
mod surface;
mod triangle;

pub use aabb::Aabb;
pub use bvh::{Bvh, Found, brute_force};
pub use mesh::{Mesh, TriangleCount};
pub use quad::Quad;
pub use ray::{PreparedRay, Ray};
pub use sphere::Sphere;
pub use surface::Surface;
pub use triangle::Triangle;

/// Where a ray crosses a shape: how far along, and where on the shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Distance along the ray in units of its direction's length.
    pub t: f32,
    /// Barycentric weight of a triangle's second corner, or the quad's coordinate along its `u`.
    pub u: f32,
    /// Barycentric weight of a triangle's third corner, or the quad's coordinate along its `v`.
    pub v: f32,
}

/// Everything a ray can hit. To add a shape: a file, a variant, and follow the compiler.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    /// A sphere, hollow or full: light crosses both sides.
    Sphere(Sphere),
    /// A parallelogram.
    Quad(Quad),
    /// A flat triangle.
    Triangle(Triangle),
}

impl Shape {
    /// The first crossing with `0 < t <= t_max`, which is a finite number.
    pub fn cross(&self, ray: &PreparedRay, t_max: f32) -> Option<Crossing> {
        match self {
            Shape::Sphere(s) => s.cross(ray, t_max),
            Shape::Quad(q) => q.cross(ray, t_max),
            Shape::Triangle(t) => t.cross(ray, t_max),
        }
    }

    /// The surface at a crossing of this shape with this ray.
    pub fn surface(&self, ray: &Ray, crossing: Crossing) -> Surface {
        match self {
            Shape::Sphere(s) => s.surface(ray, crossing),
            Shape::Quad(q) => q.surface(crossing),
            Shape::Triangle(t) => t.surface(crossing),
        }
    }

    /// The smallest axis-aligned box that holds the shape.
    pub fn bounds(&self) -> Aabb {
        match self {
            Shape::Sphere(s) => s.bounds(),
            Shape::Quad(q) => q.bounds(),
            Shape::Triangle(t) => t.bounds(),
        }
    }
}
