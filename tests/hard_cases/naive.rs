//! The plain forms of `halfdisk::lab::naive`, asked in the types of the hard cases.

use glam::Vec3;
use halfdisk::geometry::{Aabb, Ray, Sphere, Triangle};
use halfdisk::lab::naive;

/// The first root beyond `t_min` of the school formula.
pub fn sphere_after(ray: &Ray, s: &Sphere, t_min: f32) -> Option<f32> {
    naive::sphere_after(ray.origin, ray.direction, s.center, s.radius, t_min)
}

pub fn triangle(ray: &Ray, t: &Triangle) -> Option<f32> {
    naive::triangle(ray.origin, ray.direction, [t.a, t.b, t.c])
}

pub fn slab(ray: &Ray, b: &Aabb) -> bool {
    naive::slab(ray.origin, ray.direction, b.min, b.max)
}

/// The hit point as the end of the ray, left without any offset.
pub fn leave(ray: &Ray, t: f32, direction: Vec3) -> Ray {
    Ray::new(naive::hit_point(ray.origin, ray.direction, t), direction)
}

/// The hit point as the end of the ray, left with an offset of a fixed length along the normal.
pub fn leave_by(ray: &Ray, t: f32, n: Vec3, distance: f32, direction: Vec3) -> Ray {
    let end = naive::hit_point(ray.origin, ray.direction, t);
    Ray::new(naive::offset_by(distance, end, n, direction), direction)
}
