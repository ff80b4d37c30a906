//! The plain versions of what the library does with care. The hard cases show where they fail.

use glam::Vec3;
use halfdisk::geometry::{Aabb, Ray, Sphere, Triangle};

/// The school formula in `f32`; both roots in order.
pub fn sphere(ray: &Ray, sphere: &Sphere) -> Option<(f32, f32)> {
    let from_center = ray.origin - sphere.center;
    let a = ray.direction.length_squared();
    let b = 2.0 * from_center.dot(ray.direction);
    let c = from_center.length_squared() - sphere.radius * sphere.radius;
    let discriminant = b * b - 4.0 * a * c;
    (discriminant >= 0.0).then(|| {
        let root = discriminant.sqrt();
        ((-b - root) / (2.0 * a), (-b + root) / (2.0 * a))
    })
}

/// The first root beyond `t_min`.
pub fn sphere_after(ray: &Ray, shape: &Sphere, t_min: f32) -> Option<f32> {
    let (near, far) = sphere(ray, shape)?;
    [near, far].into_iter().find(|t| *t > t_min)
}

/// Source: Möller, Trumbore, Fast, Minimum Storage Ray-Triangle Intersection (JGT 2(1), 1997).
pub fn triangle(ray: &Ray, triangle: &Triangle) -> Option<f32> {
    let (e1, e2) = (triangle.b - triangle.a, triangle.c - triangle.a);
    let p = ray.direction.cross(e2);
    let determinant = e1.dot(p);
    if determinant == 0.0 {
        return None;
    }
    let from_a = ray.origin - triangle.a;
    let u = from_a.dot(p) / determinant;
    let q = from_a.cross(e1);
    let v = ray.direction.dot(q) / determinant;
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0).then(|| e2.dot(q) / determinant)
}

/// The slab test with `min` and `max`, which drop a NaN and keep the other number.
pub fn slab(ray: &Ray, b: &Aabb) -> bool {
    let inverse = ray.direction.recip();
    let (mut t0, mut t1) = (0.0_f32, f32::INFINITY);
    for axis in 0..3 {
        let x = (b.min[axis] - ray.origin[axis]) * inverse[axis];
        let y = (b.max[axis] - ray.origin[axis]) * inverse[axis];
        t0 = t0.max(x.min(y));
        t1 = t1.min(x.max(y));
    }
    t0 <= t1
}

/// The hit point as the end of the ray, left without any offset.
pub fn leave(ray: &Ray, t: f32, direction: Vec3) -> Ray {
    Ray::new(ray.at(t), direction)
}

/// The hit point as the end of the ray, left with an offset of a fixed length along the normal.
pub fn leave_by(ray: &Ray, t: f32, n: Vec3, distance: f32, direction: Vec3) -> Ray {
    let side = if direction.dot(n) < 0.0 { -1.0 } else { 1.0 };
    Ray::new(ray.at(t) + n * side * distance, direction)
}
