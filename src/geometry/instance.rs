//! A shape that stands in many places and is stored once.

use super::{Aabb, Bvh, Intersection, PreparedRay, Primitive, Ray, Shape, Surface, Triangle};
use crate::numeric::gamma;
use glam::{DMat3, DVec3, Vec3};
use std::fmt::Debug;
use std::sync::Arc;

/// The largest product of the largest factors by which a transformation and its inverse stretch: with
/// more, the roundings of one space would be too large in the other.
const WORST_CONDITION: f64 = 1e4;

/// A shape in coordinates of its own, to be placed by [`Instance`]s: a mesh, or one's own.
///
/// Distances along a ray count in units of its direction's length, which may be any.
pub trait InstancedShape: Debug + Send + Sync {
    /// A box that holds it.
    fn bounds(&self) -> Aabb;

    /// The first intersection with `0 < t <= ray.t_max`, whose `u`, `v` and `part` are the shape's own
    /// matter; textures find the first two.
    fn intersect(&self, ray: &Ray) -> Option<Intersection>;

    /// The surface there. The point lies on the shape up to its `error`, which must be sure along the
    /// normal, or rays that leave it meet it again.
    fn surface(&self, ray: &Ray, intersection: Intersection) -> Surface;
}

/// Triangles in coordinates of their own.
#[derive(Clone, Debug)]
pub struct SharedMesh {
    triangles: Vec<Triangle>,
    bvh: Bvh,
}

impl SharedMesh {
    /// The mesh of proper triangles.
    pub fn new(triangles: Vec<Triangle>) -> Self {
        let shapes: Vec<Shape> = triangles.iter().copied().map(Shape::Triangle).collect();
        SharedMesh {
            bvh: Bvh::new(&shapes),
            triangles,
        }
    }

    /// Its triangles.
    pub fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }
}

impl InstancedShape for SharedMesh {
    fn bounds(&self) -> Aabb {
        let all = self.triangles.iter().map(Triangle::bounds);
        all.fold(Aabb::EMPTY, Aabb::union)
    }

    fn intersect(&self, ray: &Ray) -> Option<Intersection> {
        let found = self.bvh.first_hit(ray)?;
        Some(Intersection {
            part: found.id,
            ..found.intersection
        })
    }

    fn surface(&self, _: &Ray, intersection: Intersection) -> Surface {
        self.triangles[intersection.part as usize].surface(intersection)
    }
}

/// A shape in a place: rays are brought to it, by the inverse of the transformation that puts it there.
///
/// Distances along a ray are the same in both spaces, for its direction is transformed with it and keeps
/// the length that it gets. Source: Pharr, Jakob, Humphreys, Physically Based Rendering (4th ed. 2023),
/// section 7.1.2, "Object instancing"; the bound on the error of a point is that of its own space,
/// transformed, and the roundings of the way there and back.
#[derive(Clone, Debug)]
pub struct Instance {
    shape: Arc<dyn InstancedShape>,
    to_world: DMat3,
    shift: DVec3,
    to_shape: DMat3,
    bounds: Aabb,
}

impl Instance {
    /// The shape with `linear` applied to each point, and then shifted; `None` where the two spaces are so
    /// different that roundings do not carry over, or the shape does not fit into finite numbers.
    pub fn new(shape: Arc<dyn InstancedShape>, linear: DMat3, shift: DVec3) -> Option<Self> {
        let inverse = linear.inverse();
        let size = |m: DMat3| {
            m.to_cols_array()
                .iter()
                .fold(0.0, |a: f64, x| a.max(x.abs()))
        };
        let condition = size(linear) * size(inverse);
        // A NaN of a singular matrix is not below either.
        let well = condition <= WORST_CONDITION;
        let Aabb { min, max } = shape.bounds();
        let mut instance = Instance {
            shape,
            to_world: linear,
            shift,
            to_shape: inverse,
            bounds: Aabb::EMPTY,
        };
        let corners = (0..8).map(|i| {
            let side = |axis: usize| {
                if i >> axis & 1 == 0 {
                    min[axis]
                } else {
                    max[axis]
                }
            };
            let corner = Vec3::new(side(0), side(1), side(2));
            let p = instance.point(corner);
            let error = instance.error(corner, corner.abs() * gamma(6), p);
            Aabb {
                min: p - error,
                max: p + error,
            }
        });
        instance.bounds = corners.fold(Aabb::EMPTY, Aabb::union);
        (well && instance.bounds.is_finite()).then_some(instance)
    }

    /// A triangle of the shape's own space in the world, each corner rounded once. Where the transformation
    /// mirrors, second and third corner change places, so that fronts stay fronts.
    pub fn placed(&self, t: &Triangle) -> Triangle {
        let (b, c) = if self.mirrors() {
            (t.c, t.b)
        } else {
            (t.b, t.c)
        };
        Triangle {
            a: self.point(t.a),
            b: self.point(b),
            c: self.point(c),
        }
    }

    /// True where the transformation turns right hands into left ones.
    pub fn mirrors(&self) -> bool {
        self.to_world.determinant() < 0.0
    }

    /// The surface at an intersection with this ray.
    pub fn surface(&self, ray: &Ray, intersection: Intersection) -> Surface {
        let there = self.shape.surface(&self.brought(ray), intersection);
        let p = self.point(there.p);
        // Normals go by the inverse transposed, so that their side stays.
        let n = self.to_shape.transpose() * there.n.as_dvec3();
        Surface {
            p,
            error: self.error(there.p, there.error, p),
            n: n.normalize().as_vec3(),
            time: ray.time,
        }
    }

    /// The ray in the shape's own space.
    fn brought(&self, ray: &Ray) -> Ray {
        Ray {
            origin: (self.to_shape * (ray.origin.as_dvec3() - self.shift)).as_vec3(),
            direction: (self.to_shape * ray.direction.as_dvec3()).as_vec3(),
            ..*ray
        }
    }

    fn point(&self, p: Vec3) -> Vec3 {
        (self.to_world * p.as_dvec3() + self.shift).as_vec3()
    }

    /// How far the world's point `p` may be off the surface, which in the mesh's space is that of `there`
    /// with `error`: a ray that leaves `p` is rounded once on its way there, and `p` was on its way back.
    fn error(&self, there: Vec3, error: Vec3, p: Vec3) -> Vec3 {
        let error = error + there.abs() * gamma(2);
        (self.to_world.abs() * error.as_dvec3()).as_vec3() + p.abs() * gamma(2)
    }
}

impl Primitive for Instance {
    fn surface(&self, ray: &Ray, intersection: Intersection) -> Surface {
        Instance::surface(self, ray, intersection)
    }

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn intersect(&self, ray: &PreparedRay, t_max: f32) -> Option<Intersection> {
        let entry = self.bounds.entry(ray, t_max)?;
        let ray = Ray {
            origin: ray.origin,
            direction: ray.direction,
            t_max,
            time: ray.time,
        };
        let met = self.shape.intersect(&self.brought(&ray))?;
        (met.t > 0.0 && met.t <= t_max).then(|| Intersection {
            t: met.t.max(entry),
            ..met
        })
    }
}
