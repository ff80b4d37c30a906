//! A mesh that stands in many places and is stored once.

use super::{Aabb, Bvh, Crossing, PreparedRay, Primitive, Ray, Shape, Surface, Triangle};
use crate::numeric::gamma;
use glam::{DMat3, DVec3, Vec3};
use std::sync::Arc;

/// The largest product of the largest factors by which a transformation and its inverse stretch: with
/// more, the roundings of one space would be too large in the other.
const WORST_CONDITION: f64 = 1e4;

/// Triangles in coordinates of their own, to be placed by [`Instance`]s.
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

/// A mesh in a place: rays are brought to it, by the inverse of the transformation that puts it there.
///
/// Distances along a ray are the same in both spaces, for its direction is transformed with it and keeps
/// the length that it gets. Source: Pharr, Jakob, Humphreys, Physically Based Rendering (4th ed. 2023),
/// section 7.1.2, "Object instancing"; the bound on the error of a point is that of its own space,
/// transformed, and the roundings of the way there and back.
#[derive(Clone, Debug)]
pub struct Instance {
    mesh: Arc<SharedMesh>,
    to_world: DMat3,
    shift: DVec3,
    to_mesh: DMat3,
    bounds: Aabb,
}

impl Instance {
    /// The mesh with `linear` applied to each point, and then shifted; `None` where the two spaces are so
    /// different that roundings do not carry over, or the mesh does not fit into finite numbers.
    pub fn new(mesh: Arc<SharedMesh>, linear: DMat3, shift: DVec3) -> Option<Self> {
        let inverse = linear.inverse();
        let size = |m: DMat3| {
            m.to_cols_array()
                .iter()
                .fold(0.0, |a: f64, x| a.max(x.abs()))
        };
        let condition = size(linear) * size(inverse);
        // A NaN of a singular matrix is not below either.
        let well = condition <= WORST_CONDITION;
        let mut instance = Instance {
            mesh,
            to_world: linear,
            shift,
            to_mesh: inverse,
            bounds: Aabb::EMPTY,
        };
        let corners = || instance.mesh.triangles.iter().flat_map(|t| [t.a, t.b, t.c]);
        let around = Aabb::of(corners().map(|p| instance.point(p)));
        let error = corners()
            .map(|p| instance.error(p, p.abs() * gamma(6), instance.point(p)))
            .fold(Vec3::ZERO, Vec3::max);
        instance.bounds = Aabb {
            min: around.min - error,
            max: around.max + error,
        };
        (well && instance.bounds.is_finite()).then_some(instance)
    }

    /// The mesh's triangles in world coordinates, each corner rounded once. Where the transformation
    /// mirrors, second and third corner change places, so that fronts stay fronts.
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = Triangle> {
        let mirrors = self.mirrors();
        self.mesh.triangles.iter().map(move |t| {
            let (b, c) = if mirrors { (t.c, t.b) } else { (t.b, t.c) };
            Triangle {
                a: self.point(t.a),
                b: self.point(b),
                c: self.point(c),
            }
        })
    }

    /// True where the transformation turns right hands into left ones.
    pub fn mirrors(&self) -> bool {
        self.to_world.determinant() < 0.0
    }

    /// The surface at an intersection with this ray.
    pub fn surface(&self, ray: &Ray, crossing: Crossing) -> Surface {
        let there = self.mesh.triangles[crossing.part as usize].surface(crossing);
        let p = self.point(there.p);
        // Normals go by the inverse transposed, so that their side stays.
        let n = self.to_mesh.transpose() * there.n.as_dvec3();
        Surface {
            p,
            error: self.error(there.p, there.error, p),
            n: n.normalize().as_vec3(),
            time: ray.time,
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
    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn cross(&self, ray: &PreparedRay, t_max: f32) -> Option<Crossing> {
        let entry = self.bounds.entry(ray, t_max)?;
        let there = Ray {
            origin: (self.to_mesh * (ray.origin.as_dvec3() - self.shift)).as_vec3(),
            direction: (self.to_mesh * ray.direction.as_dvec3()).as_vec3(),
            t_max,
            time: ray.time,
        };
        let found = self.mesh.bvh.first(&there)?;
        Some(Crossing {
            t: found.crossing.t.max(entry),
            part: found.id,
            ..found.crossing
        })
    }
}
