//! Rays and shapes.

use glam::{Mat3, Vec3};

// ANCHOR: sphere
/// Where the line `o + t d` meets a sphere: the school formula in `f32`, both roots in order.
///
/// Fails far away: `b² - 4 a c` and `|o - c|² - r²` each are a small difference of large numbers.
pub fn sphere(o: Vec3, d: Vec3, center: Vec3, radius: f32) -> Option<[f32; 2]> {
    let from_center = o - center;
    let a = d.length_squared();
    let b = 2.0 * from_center.dot(d);
    let c = from_center.length_squared() - radius * radius;
    let discriminant = b * b - 4.0 * a * c;
    (discriminant >= 0.0).then(|| {
        let root = discriminant.sqrt();
        [(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)]
    })
}
// ANCHOR_END: sphere

/// The first root of [`sphere`] beyond `t_min`; with a `t_min` that is a length, a shape smaller
/// than it is lost, and one far away still shadows itself.
pub fn sphere_after(o: Vec3, d: Vec3, center: Vec3, radius: f32, t_min: f32) -> Option<f32> {
    let roots = sphere(o, d, center, radius)?;
    roots.into_iter().find(|t| *t > t_min)
}

/// Where the line `o + t d` meets a triangle.
///
/// Fails at edges and vertices of meshes, where each neighbour rounds its own way and both may miss.
/// Source: Möller, Trumbore, Fast, Minimum Storage Ray-Triangle Intersection (JGT 2(1), 1997).
pub fn triangle(o: Vec3, d: Vec3, [a, b, c]: [Vec3; 3]) -> Option<f32> {
    let (e1, e2) = (b - a, c - a);
    let p = d.cross(e2);
    let determinant = e1.dot(p);
    if determinant == 0.0 {
        return None;
    }
    let from_a = o - a;
    let u = from_a.dot(p) / determinant;
    let q = from_a.cross(e1);
    let v = d.dot(q) / determinant;
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0).then(|| e2.dot(q) / determinant)
}

/// True where the ray meets a box: the slab test with `min` and `max`, which drop a NaN and keep the
/// other number.
///
/// Fails for rays in a face of the box, where `0 · ∞` decides, and at corners.
pub fn slab(o: Vec3, d: Vec3, min: Vec3, max: Vec3) -> bool {
    let inverse = d.recip();
    let (mut t0, mut t1) = (0.0_f32, f32::INFINITY);
    for axis in 0..3 {
        let x = (min[axis] - o[axis]) * inverse[axis];
        let y = (max[axis] - o[axis]) * inverse[axis];
        t0 = t0.max(x.min(y));
        t1 = t1.min(x.max(y));
    }
    t0 <= t1
}

/// The hit point as the end of the ray, whose error is that of `t d` however small the shape is.
pub fn hit_point(o: Vec3, d: Vec3, t: f32) -> Vec3 {
    o + d * t
}

/// A hit point moved by a fixed length along the normal, to the side on which `leaving` leaves: too
/// little for large scenes, too much for small ones.
pub fn offset_by(distance: f32, p: Vec3, n: Vec3, leaving: Vec3) -> Vec3 {
    p + n * distance.copysign(leaving.dot(n))
}

/// The same by a share of the largest coordinate, as `2⁻¹⁶` or so: it grows with the distance from
/// the origin, but not with that from the eye, from which the error of [`hit_point`] comes.
pub fn hit_point_off(share: f32, p: Vec3, n: Vec3, leaving: Vec3) -> Vec3 {
    offset_by(share * p.abs().max_element(), p, n, leaving)
}

/// The angle between unit vectors as an arc cosine: NaN where rounding makes a cosine above 1.
pub fn angle(a: Vec3, b: Vec3) -> f32 {
    libm::acosf(a.dot(b))
}

/// A rotation between two, entry by entry: no rotation in between, and none at all half-way to the
/// opposite one.
pub fn matrix_between(a: Mat3, b: Mat3, time: f32) -> Mat3 {
    a * (1.0 - time) + b * time
}
