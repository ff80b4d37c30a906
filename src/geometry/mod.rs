//! Rays, shapes and the hierarchy that finds the first hit.
//!
//! A shape answers three questions: where does a ray intersect you ([`Shape::intersect`]), what is the
//! surface like there ([`Shape::surface`]), and what box holds you ([`Shape::bounds`]). Points on
//! a surface carry a bound on their rounding error, so that rays can leave them safely.

mod aabb;
mod bvh;
mod instance;
pub mod lanes;
mod mesh;
mod moving;
mod polygon;
mod quad;
mod ray;
mod sphere;
mod surface;
mod transformed;
mod triangle;

pub use aabb::Aabb;
pub use bvh::{Bvh, ClosestHit, brute_force};
pub use instance::{Instance, InstancedShape, SharedMesh};
pub use mesh::{DEFAULT_UVS, Mesh};
pub use moving::Moving;
pub use polygon::{Polygons, Triangulation};
pub use quad::Quad;
pub use ray::{PreparedRay, Ray};
pub use sphere::Sphere;
pub use surface::Surface;
pub use transformed::Transformed;
pub use triangle::Triangle;

use glam::{DVec3, Vec3};

/// Where a ray crosses a shape: how far along, and where on the shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intersection {
    /// Distance along the ray in units of its direction's length.
    pub t: f32,
    /// Barycentric weight of a triangle's second corner, or the quad's coordinate along its `u`.
    pub u: f32,
    /// Barycentric weight of a triangle's third corner, or the quad's coordinate along its `v`.
    pub v: f32,
    /// The number of a triangle in a mesh that is one of the tree's shapes; 0 for all others.
    pub part: u32,
}

impl Intersection {
    /// An intersection with a shape of one part.
    pub fn new(t: f32, u: f32, v: f32) -> Self {
        Intersection { t, u, v, part: 0 }
    }
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
    pub fn intersect(&self, ray: &PreparedRay, t_max: f32) -> Option<Intersection> {
        match self {
            Shape::Sphere(s) => s.intersect(ray, t_max),
            Shape::Quad(q) => q.intersect(ray, t_max),
            Shape::Triangle(t) => t.intersect(ray, t_max),
        }
    }

    /// The surface at a crossing of this shape with this ray.
    pub fn surface(&self, ray: &Ray, intersection: Intersection) -> Surface {
        let surface = match self {
            Shape::Sphere(s) => s.surface(ray, intersection),
            Shape::Quad(q) => q.surface(intersection),
            Shape::Triangle(t) => t.surface(intersection),
        };
        Surface {
            time: ray.time,
            ..surface
        }
    }

    /// How far a point is from the shape's plane or sphere, in scene units; positive on the front
    /// side.
    pub fn height(&self, p: DVec3) -> f64 {
        match self {
            Shape::Sphere(s) => s.height(p),
            Shape::Quad(q) => q.plane().height(p),
            Shape::Triangle(t) => t.plane().height(p),
        }
    }

    /// The shape moved by a vector, each of its points rounded once.
    #[must_use]
    pub fn moved(&self, by: Vec3) -> Shape {
        match self {
            Shape::Sphere(s) => Shape::Sphere(Sphere {
                center: s.center + by,
                ..*s
            }),
            Shape::Quad(q) => Shape::Quad(q.moved(by)),
            Shape::Triangle(t) => Shape::Triangle(t.moved(by)),
        }
    }

    /// The corners of a shape with straight edges, in their order around it; none of others.
    pub fn corners(&self) -> Vec<Vec3> {
        match self {
            Shape::Sphere(_) => Vec::new(),
            Shape::Quad(q) => q.corners().to_vec(),
            Shape::Triangle(t) => vec![t.a, t.b, t.c],
        }
    }

    /// True where it lies in a plane, so that no part of it lights another.
    pub fn is_flat(&self) -> bool {
        match self {
            Shape::Sphere(_) => false,
            Shape::Quad(_) | Shape::Triangle(_) => true,
        }
    }

    /// Its shortest edge, or its diameter, in scene units.
    pub fn width(&self) -> f32 {
        match self {
            Shape::Sphere(s) => 2.0 * s.radius,
            Shape::Quad(_) | Shape::Triangle(_) => {
                let corners = self.corners();
                let next = corners.iter().cycle().skip(1);
                let edges = corners.iter().zip(next).map(|(a, b)| a.distance(*b));
                edges.fold(f32::INFINITY, f32::min)
            }
        }
    }

    /// Numbers that no other shape has, from whichever corner it was told: its kind, and where it is.
    pub fn key(&self) -> Vec<u32> {
        let (kind, points) = match self {
            Shape::Sphere(s) => {
                let inward = f32::from(u8::from(s.inward));
                (0, vec![s.center, Vec3::new(s.radius, inward, 0.0)])
            }
            Shape::Quad(_) | Shape::Triangle(_) => {
                let mut corners = self.corners();
                let first = (0..corners.len()).min_by(|&i, &j| {
                    let [p, q] = [i, j].map(|at| corners[at].to_array().map(|x| x + 0.0));
                    p.partial_cmp(&q).unwrap_or(std::cmp::Ordering::Equal)
                });
                corners.rotate_left(first.unwrap_or(0));
                (corners.len() as u32, corners)
            }
        };
        // Zeros of both signs are one place.
        let bits = |p: &Vec3| p.to_array().map(|x| (x + 0.0).to_bits());
        let place = points.iter().flat_map(bits);
        std::iter::once(kind).chain(place).collect()
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

/// What a [`Bvh`] can hold: a shape, or one that moves.
pub trait Primitive: Clone + Send + Sync {
    /// A box that holds it at all times.
    fn bounds(&self) -> Aabb;

    /// The first crossing with `0 < t <= t_max`; never nearer than the box.
    fn intersect(&self, ray: &PreparedRay, t_max: f32) -> Option<Intersection>;

    /// The same for a ray known to enter the box at `entry`.
    #[inline(always)]
    fn intersect_from(&self, ray: &PreparedRay, t_max: f32, _entry: f32) -> Option<Intersection> {
        self.intersect(ray, t_max)
    }

    /// The surface at an intersection with this ray.
    fn surface(&self, ray: &Ray, intersection: Intersection) -> Surface;

    /// The triangle it is at all times; of these the tree looks at eight at once.
    fn still_triangle(&self) -> Option<Triangle> {
        None
    }
}

impl Primitive for Shape {
    fn bounds(&self) -> Aabb {
        Shape::bounds(self)
    }

    fn intersect(&self, ray: &PreparedRay, t_max: f32) -> Option<Intersection> {
        Shape::intersect(self, ray, t_max)
    }

    fn surface(&self, ray: &Ray, intersection: Intersection) -> Surface {
        Shape::surface(self, ray, intersection)
    }

    #[inline(always)]
    fn intersect_from(&self, ray: &PreparedRay, t_max: f32, entry: f32) -> Option<Intersection> {
        match self {
            Shape::Sphere(s) => s.intersect(ray, t_max),
            Shape::Quad(q) => q.intersect_from(ray, t_max, entry),
            Shape::Triangle(t) => t.intersect(ray, t_max),
        }
    }

    fn still_triangle(&self) -> Option<Triangle> {
        match self {
            Shape::Triangle(triangle) => Some(*triangle),
            _ => None,
        }
    }
}
