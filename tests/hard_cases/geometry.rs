//! Spheres far, tiny and huge; degenerate triangles; rays that are none.

use super::draw::Draw;
use super::naive;
use glam::{DVec3, Vec3};
use halfdisk::geometry::{
    Bvh, Intersection, Mesh, PreparedRay, Ray, Shape, Sphere, Triangle, brute_force,
};

fn cross(sphere: &Sphere, ray: &Ray) -> Option<f64> {
    let intersection = sphere.intersect(&PreparedRay::from(ray), f32::MAX)?;
    Some(f64::from(intersection.t))
}

/// How close the line of the ray comes to the centre, in radii, and where it first crosses.
///
/// In `f64` and without the differences that cancel: a product of vectors for the distance from
/// the line, a product of sum and difference for the power of the origin.
fn truth(sphere: &Sphere, ray: &Ray) -> (f64, f64) {
    let d = ray.direction.as_dvec3();
    let f = ray.origin.as_dvec3() - sphere.center.as_dvec3();
    let r = f64::from(sphere.radius);
    let closest = f.cross(d).length() / d.length();
    let half = ((r - closest) * (r + closest)).max(0.0).sqrt();
    let power = (f.length() - r) * (f.length() + r);
    let t = power / (-f.dot(d) / d.length() + half) / d.length();
    (closest / r, t)
}

/// A ray from `distance` whose line passes the unit direction's sphere between two radii.
fn ray_past(sphere: &Sphere, distance: f32, radii: [f32; 2], draw: &mut Draw) -> Ray {
    loop {
        let from = sphere.center + draw.direction() * distance;
        let reach = sphere.radius * draw.between(radii[0], radii[1]);
        let ray = Draw::towards(from, sphere.center + draw.direction() * reach);
        let closest = truth(sphere, &ray).0;
        if f64::from(radii[0]) <= closest && closest <= f64::from(radii[1]) {
            return ray;
        }
    }
}

#[test]
fn a01_far_and_tiny_spheres_are_hit_where_they_are_and_missed_where_they_are_not() {
    let (mut misses, mut false_hits, mut worst) = (0, 0, 0.0_f64);
    let (mut plain_misses, mut plain_false_hits) = (0, 0);
    for distance in [1.0, 10.0, 1e3, 1e4, 1e5_f32] {
        for radius in [1e-3, 1.0, 1e3_f32] {
            let mut draw = Draw::new(1, radius.to_bits() ^ distance.to_bits());
            let sphere = Sphere::new(Vec3::ZERO, radius);
            let ratio = distance / radius;
            // In f32 rays no finer aim than a few roundings of the distance exists.
            if ratio > 1.0 {
                for _ in 0..20_000 {
                    let ray = ray_past(&sphere, distance, [0.0, 0.98], &mut draw);
                    let t = truth(&sphere, &ray).1;
                    let ulp = f64::from((distance + radius) * f32::EPSILON);
                    match cross(&sphere, &ray) {
                        Some(ours) => worst = worst.max((ours - t).abs() / ulp),
                        None => misses += 1,
                    }
                    let plain = naive::sphere_after(&ray, &sphere, 0.0);
                    plain_misses += usize::from(plain.is_none());
                }
            }
            if ratio > 2.0 && ratio < 1e6 {
                for _ in 0..20_000 {
                    let ray = ray_past(&sphere, distance, [1.01, 1.2], &mut draw);
                    false_hits += usize::from(cross(&sphere, &ray).is_some());
                    let plain = naive::sphere_after(&ray, &sphere, 0.0);
                    plain_false_hits += usize::from(plain.is_some());
                }
            }
        }
    }
    println!("ours {misses} misses, {false_hits} false hits, |dt| {worst:.3} ulp(D + r)");
    println!("plain {plain_misses} misses, {plain_false_hits} false hits");
    assert_eq!((misses, false_hits), (0, 0));
    assert!(worst <= 1.0);
    assert!(plain_misses > 10_000 && plain_false_hits > 10_000);
}

#[test]
fn a02_the_ground_may_be_a_sphere_as_large_as_a_planet() {
    for radius in [1e3, 1e5, 1e7] {
        let (mut worst, mut plain) = (0.0_f64, 0.0_f64);
        let mut draw = Draw::new(2, 0);
        let sphere = Sphere::new(Vec3::new(0.0, -radius, 0.0), radius);
        for _ in 0..100_000 {
            let origin = Vec3::new(draw.between(-1.0, 1.0), 1.0, draw.between(-1.0, 1.0));
            let down = Vec3::new(draw.between(-0.7, 0.7), -1.0, draw.between(-0.7, 0.7));
            let ray = Ray::new(origin, down.normalize());
            // The power of the origin with the radius taken out of it: x² + y² + z² + 2 r y.
            let (o, d) = (origin.as_dvec3(), ray.direction.as_dvec3());
            let r = f64::from(radius);
            let power = o.length_squared() + 2.0 * r * o.y;
            let h = o.dot(d) + r * d.y;
            let t = power / (-h + (h * h - d.length_squared() * power).sqrt());
            worst = worst.max((cross(&sphere, &ray).unwrap() - t).abs());
            if let Some(t_plain) = naive::sphere_after(&ray, &sphere, 0.0) {
                plain = plain.max((f64::from(t_plain) - t).abs());
            }
        }
        println!("r {radius:e}: |dt| ours {worst:.2e}, plain {plain:.2e}");
        assert!(worst <= 1e-6);
        assert!(plain > 1e-5, "the plain form should fail");
    }
}

#[test]
fn a06_degenerate_triangles_are_left_out_and_the_others_kept_as_they_are() {
    let good = [
        DVec3::new(0.0, 0.0, 1.0),
        DVec3::X,
        DVec3::new(0.0, 3.0, 0.5),
    ];
    let bad = [
        // Collinear, far from the origin, after a case in the tests of the renderer pbrt.
        [
            DVec3::new(-1113.45459, -79.049614, -56.2431908),
            DVec3::new(-1113.45459, -87.0922699, -56.2431908),
            DVec3::new(-1113.45459, -79.2090149, -56.2431908),
        ],
        [
            DVec3::ONE,
            DVec3::ONE + 1e-30,
            DVec3::new(1.0, 1.0 + 2e-30, 1.0),
        ],
        [DVec3::X, DVec3::Y, DVec3::X],
        [DVec3::X, DVec3::NAN, DVec3::Z],
        [DVec3::X, DVec3::Y * 1e39, DVec3::Z],
    ];
    let mut vertices = bad.as_flattened().to_vec();
    vertices.splice(3..3, good);
    let mesh = Mesh {
        vertices,
        triangles: (0..6).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
        ..Mesh::default()
    };
    assert_eq!(mesh.bad_index(), None);
    let kept = mesh.to_triangles(|v| v.as_vec3());
    assert_eq!(kept.len(), 1);
    let (at, Triangle { a, b, c }) = kept[0];
    assert_eq!((at, [a, b, c]), (1, good.map(|v| v.as_vec3())));

    // Even handed to the test itself, the collinear one is not hit; plainly tested, it may be.
    let [a, b, c] = bad[0].map(|v| v.as_vec3());
    let ray = Ray::new(
        Vec3::new(-1_081.479_2, 99.999_954, 87.770_11),
        Vec3::new(-32.107_3, -183.355_87, -144.607_64),
    );
    assert!(brute_force(&[Shape::Triangle(Triangle { a, b, c })], &ray).is_none());
}

#[test]
fn a06_no_collinear_triangle_is_ever_hit() {
    let (mut ours, mut plain) = (0, 0);
    for i in 0..100_000 {
        let mut draw = Draw::new(60, i);
        let (a, step) = (draw.cube(1.0), draw.cube(1.0));
        // Whole multiples of a step on a coarse grid: exactly collinear.
        let [a, step] = [a, step].map(|v| (v * 1024.0).round() / 1024.0);
        let triangle = Triangle {
            a,
            b: a + step * 3.0,
            c: a - step * 2.0,
        };
        assert!(!triangle.is_proper());
        let origin = draw.cube(4.0);
        let ray = Draw::towards(origin, a + step * draw.between(-2.0, 3.0));
        ours += usize::from(brute_force(&[Shape::Triangle(triangle)], &ray).is_some());
        plain += usize::from(naive::triangle(&ray, &triangle).is_some());
    }
    println!("collinear triangles hit: ours {ours}, plain {plain}");
    assert_eq!(ours, 0);
    assert!(plain > 1000);
}

#[test]
fn a06_triangles_of_any_proper_size_have_a_normal_and_are_hit() {
    let mut worst = 0.0_f64;
    for size in [1e-30, 1e-12, 1.0, 1e15, 1e30] {
        for i in 0..1000 {
            let mut draw = Draw::new(61, i);
            let Shape::Triangle(triangle) = draw.shape(2, Vec3::ZERO, size) else {
                unreachable!()
            };
            let [u, v] = draw.inside();
            let at = triangle.surface(Intersection::new(0.0, u, v));
            worst = worst.max((at.n.as_dvec3().length() - 1.0).abs());
            let side = if draw.one() < 0.5 { 1.0 } else { -1.0 };
            let origin = at.p + at.n * (size * side);
            let shapes = [Shape::Triangle(triangle)];
            let ray = Draw::towards(origin, (triangle.a + triangle.b + triangle.c) / 3.0);
            assert!(brute_force(&shapes, &ray).is_some(), "size {size:e}, {i}");
        }
    }
    println!("worst distance from unit length {worst:e}");
    assert!(worst < 1e-6);
}

#[test]
fn a16_rays_that_go_nowhere_hit_nothing() {
    let mut draw = Draw::new(16, 0);
    let shapes: Vec<Shape> = (0..300)
        .map(|kind| draw.shape(kind, Vec3::ZERO, 1.0))
        .collect();
    let bvh = Bvh::new(&shapes);
    let odd = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
    for i in 0..10_000 {
        let mut ray = Ray::new(draw.cube(2.0), draw.direction());
        let value = odd[draw.below(3)];
        match i % 8 {
            axis @ 0..3 => ray.origin[axis] = value,
            axis @ 3..6 => ray.direction[axis - 3] = value,
            6 => ray.direction = Vec3::ZERO,
            _ => ray.t_max = f32::NAN,
        }
        assert!(!ray.is_valid());
        assert!(bvh.first_hit(&ray).is_none() && !bvh.occluded(&ray));
        assert!(brute_force(&shapes, &ray).is_none());
    }
    // A direction may be short beyond reason; what it hits is then no finite distance away.
    let ray = Ray::new(Vec3::Z * 5.0, Vec3::Z * -1e-40);
    assert!(ray.is_valid() && bvh.first_hit(&ray).is_none());
    println!("10^4 invalid rays: no hit");
}
