//! Rays that leave a surface: they neither meet it again nor jump over its neighbour.

use super::draw::Draw;
use super::naive;
use glam::{DVec3, Vec3};
use halfdisk::geometry::{Intersection, PreparedRay, Quad, Ray, Shape, Sphere, Surface, Triangle};

fn cross(shape: &Shape, ray: &Ray) -> Option<Intersection> {
    shape.intersect(&PreparedRay::from(ray), f32::MAX)
}

/// True where a ray that has just left `shape` meets it as if it had not.
///
/// A flat shape is never met again. A sphere is met by a ray that goes inside, on the way out.
fn meets_again(shape: &Shape, ray: &Ray) -> bool {
    match (cross(shape, ray), shape) {
        (None, _) => false,
        (Some(x), Shape::Sphere(s)) => {
            let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
            let at = o + d * f64::from(x.t) - s.center.as_dvec3();
            at.dot(d) <= 0.0
        }
        _ => true,
    }
}

/// How often rays leaving `surface` on both sides meet `shape` again.
fn count(shape: &Shape, surface: &Surface, draw: &mut Draw, rays: usize) -> usize {
    let again = |i: usize| {
        let side = if i.is_multiple_of(2) {
            surface.n
        } else {
            -surface.n
        };
        meets_again(shape, &surface.spawn(draw.leaving(side)))
    };
    (0..rays).map(again).filter(|again| *again).count()
}

#[test]
fn a03_rays_that_leave_a_sphere_do_not_come_back() {
    let (mut ours, mut plain, mut inwards) = (0, 0, 0);
    for i in 0..1000 {
        let mut draw = Draw::new(3, i);
        let radius = draw.power(-4.0, 4.0);
        let place = radius * draw.power(-1.0, 3.0);
        let center = draw.cube(place);
        let sphere = Sphere::new(center, radius);
        let away = radius * draw.between(2.0, 20.0);
        let from = center + draw.direction() * away;
        let ray = Draw::towards(from, center + draw.direction() * (radius * 0.9));
        let Some(x) = cross(&Shape::Sphere(sphere), &ray) else {
            continue;
        };
        let surface = sphere.surface(&ray, x);
        for _ in 0..1000 {
            let out = draw.leaving(surface.n);
            ours += usize::from(cross(&Shape::Sphere(sphere), &surface.spawn(out)).is_some());
            let left = naive::leave(&ray, x.t, out);
            plain += usize::from(naive::sphere_after(&left, &sphere, 0.0).is_some());
            let back = surface.spawn(draw.leaving(-surface.n));
            inwards += usize::from(meets_again(&Shape::Sphere(sphere), &back));
        }
    }
    println!("10^6 rays: ours {ours} out, {inwards} in; plain {plain}");
    assert_eq!((ours, inwards), (0, 0));
    assert!(plain > 100_000);
}

#[test]
fn a04_self_intersection_of_triangles_of_all_proportions() {
    let (mut ours, mut worst, mut triangles) = (0, 0.0_f64, 0);
    for i in 0..1000 {
        let mut draw = Draw::new(4, i);
        let [a, b, c] =
            [(); 3].map(|_| Vec3::from_array([(); 3].map(|_| draw.signed_power(-8.0, 8.0))));
        let triangle = Triangle { a, b, c };
        let n = (b - a).as_dvec3().cross((c - a).as_dvec3());
        if n.length_squared() < 1e-20 {
            continue;
        }
        triangles += 1;
        for _ in 0..1000 {
            let [u, v] = draw.inside();
            let surface = triangle.surface(Intersection::new(1.0, u, v));
            worst = worst.max(off_plane(&triangle, &surface));
            ours += count(&Shape::Triangle(triangle), &surface, &mut draw, 1);
        }
    }
    println!("{triangles} triangles x 1000 rays: {ours} again; worst error / bound {worst:.3}");
    assert_eq!(ours, 0);
}

fn off_plane(triangle: &Triangle, surface: &Surface) -> f64 {
    let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(Vec3::as_dvec3);
    let n = (b - a).cross(c - a).normalize();
    let bound = n.abs().dot(surface.error.as_dvec3());
    n.dot(surface.p.as_dvec3() - a).abs() / bound
}

#[test]
fn a04_self_intersection_far_from_the_origin_and_from_the_camera() {
    let mut worst_plain = 1.0_f64;
    for place in [0.0, 1e3, 1e4, 1e6] {
        for distance in [10.0, 1000.0] {
            for kind in 0..3 {
                let (mut ours, mut plain, mut fixed, mut rays) = (0, 0, 0, 0);
                for i in 0..1000 {
                    let mut draw = Draw::new(5, i);
                    let center = draw.cube(1.0) + Vec3::new(1.0, -0.7, 0.4) * place;
                    let shape = match kind {
                        0 => Shape::Sphere(Sphere::new(center, 1.0)),
                        _ => draw.shape(kind, center, 1.0),
                    };
                    let (x, ray) = loop {
                        let eye = center + draw.direction() * distance;
                        let ray = Draw::towards(eye, center + draw.cube(1.0));
                        if let Some(x) = cross(&shape, &ray) {
                            break (x, ray);
                        }
                    };
                    let surface = shape.surface(&ray, x);
                    ours += count(&shape, &surface, &mut draw, 1000);
                    rays += 1000;
                    if let Shape::Triangle(triangle) = &shape {
                        let facing = if ray.direction.dot(surface.n) < 0.0 {
                            1.0
                        } else {
                            -1.0
                        };
                        for _ in 0..100 {
                            let out = draw.leaving(surface.n * facing);
                            let again = |left: &Ray| naive::triangle(left, triangle) > Some(0.0);
                            plain += usize::from(again(&naive::leave(&ray, x.t, out)));
                            let left = naive::leave_by(&ray, x.t, surface.n, 1e-3, out);
                            fixed += usize::from(again(&left));
                        }
                    }
                }
                println!("S {place:e} L {distance} {kind}: {ours} of {rays} again");
                assert_eq!(ours, 0, "of {rays} rays at {place}, {distance}, {kind}");
                if kind == 2 {
                    worst_plain = worst_plain.min(plain as f64 / (rays / 10) as f64);
                    assert_eq!(fixed > 10_000, place == 1e6, "fixed offset: {fixed}");
                }
            }
        }
    }
    println!("plain hit points: at least {worst_plain:.3} meet their triangle again");
    assert!(worst_plain > 0.2);
}

/// Two surfaces a gap apart, the second on the front side of the first.
fn neighbours(kind: usize, place: f32, draw: &mut Draw) -> Option<[Shape; 2]> {
    let n = draw.direction();
    let center = draw.direction() * place;
    let gap = f64::from(64.0 * place * f32::EPSILON);
    if kind == 0 {
        let radius = place * 0.1;
        let outer = (f64::from(radius) + gap) as f32;
        return Some([radius, outer].map(|radius| Shape::Sphere(Sphere::new(center, radius))));
    }
    let (u, v) = n.any_orthonormal_pair();
    let [u, v] = [u, v].map(|e| e.as_dvec3() * f64::from(place));
    let corner = center.as_dvec3() - (u + v) * 0.5;
    let corners = [0.0, gap].map(|g| corner + n.as_dvec3() * g);
    let [first, second] = corners.map(|c| Quad::new(c, u, v));
    if kind == 1 {
        return Some([Shape::Quad(first?), Shape::Quad(second?)]);
    }
    Some(corners.map(|c| {
        let [a, b, c] = [c, c + u * 2.0, c + v * 2.0].map(DVec3::as_vec3);
        Shape::Triangle(Triangle { a, b, c })
    }))
}

#[test]
fn a04_self_intersection_offsets_stay_within_a_gap_of_64_ulps() {
    let (mut rays, mut jumped, mut fixed_jumped) = (0, 0, 0);
    for place in [1e-4, 1.0, 1e3, 1e6] {
        for i in 0..3000 {
            let mut draw = Draw::new(6, i);
            let Some([first, second]) = neighbours(i as usize % 3, place, &mut draw) else {
                continue;
            };
            let surface = match &first {
                Shape::Sphere(s) => s.surface_towards(draw.direction().as_dvec3().normalize()),
                Shape::Quad(q) => q.surface_at(draw.between(0.3, 0.7), draw.between(0.3, 0.7)),
                Shape::Triangle(t) => t.surface(Intersection::new(0.0, 0.3, 0.2)),
            };
            for _ in 0..100 {
                let slant = draw.leaving(surface.n);
                let direction = (slant + surface.n * 0.05).normalize();
                rays += 1;
                jumped += usize::from(cross(&second, &surface.spawn(direction)).is_none());
                let start = surface.p - direction * place;
                let fixed = naive::leave_by(
                    &Ray::new(start, direction),
                    place,
                    surface.n,
                    1e-3,
                    direction,
                );
                fixed_jumped += usize::from(place <= 1.0 && cross(&second, &fixed).is_none());
            }
        }
    }
    println!("{jumped} of {rays} rays start beyond the neighbour; a fixed 1e-3: {fixed_jumped}");
    assert_eq!(jumped, 0);
    assert!(fixed_jumped > rays / 3);
}

#[test]
fn a04_self_intersection_scales_by_powers_of_two_bit_for_bit() {
    let mut compared = 0;
    for i in 0..30_000 {
        for k in [-20, -10, 10, 20] {
            let scale = libm::exp2(f64::from(k)) as f32;
            // The same draws twice; only lengths are multiplied.
            let [(one, ray_one), (two, ray_two)] = [1.0, scale].map(|scale| {
                let mut draw = Draw::new(7, i);
                let center = draw.cube(3.0);
                let shape = draw.shape(i as usize, center * scale, scale);
                let origin = draw.cube(10.0);
                let direction = Draw::towards(origin, center + draw.cube(0.2)).direction;
                (shape, Ray::new(origin * scale, direction))
            });
            let [x, y] = [cross(&one, &ray_one), cross(&two, &ray_two)];
            assert_eq!(
                x.map(|x| Intersection {
                    t: x.t * scale,
                    ..x
                }),
                y
            );
            if let (Some(x), Some(y)) = (x, y) {
                let out = Draw::new(8, i).direction();
                let left = one.surface(&ray_one, x).spawn(out).origin;
                assert_eq!(left * scale, two.surface(&ray_two, y).spawn(out).origin);
                compared += 1;
            }
        }
    }
    println!("{compared} crossings and the rays that leave them, all bits equal");
    assert!(compared > 40_000);
}

#[test]
fn a04_self_intersection_of_shadow_rays_with_their_lamp() {
    let (mut ours, mut plain, mut rays) = (0, 0, 0);
    for place in [0.0, 1e3, 1e4] {
        for distance in [10.0, 1e3, 1e5_f32] {
            for i in 0..100_000 {
                let mut draw = Draw::new(9, i);
                let center = draw.cube(1.0) + Vec3::new(1.0, -0.7, 0.4) * place;
                let lamp = draw.shape(i as usize, center, 1.0);
                let target = match &lamp {
                    Shape::Sphere(s) => s.surface_towards(draw.direction().as_dvec3().normalize()),
                    Shape::Quad(q) => q.surface_at(draw.one(), draw.one()),
                    Shape::Triangle(t) => {
                        let [u, v] = draw.inside();
                        t.surface(Intersection::new(0.0, u, v))
                    }
                };
                let out = draw.leaving(target.n);
                let p = target.p + out * distance;
                // Nearer to the lamp's plane, rounding may put the point on either side of it.
                if (p - target.p).normalize().dot(target.n) < 0.01 {
                    continue;
                }
                let lit = Surface {
                    p,
                    error: p.abs() * f32::EPSILON,
                    n: -out,
                    time: 0.0,
                };
                let blocked =
                    |ray: &Ray| lamp.intersect(&PreparedRay::from(ray), ray.t_max).is_some();
                rays += 1;
                ours += usize::from(blocked(&lit.spawn_to(&target)));
                let mut short = Draw::towards(p, target.p);
                short.t_max = (target.p - p).length() * (1.0 - f32::EPSILON);
                plain += usize::from(blocked(&short));
            }
        }
    }
    println!("{rays} shadow rays: {ours} end behind their lamp; plainly shortened {plain}");
    assert_eq!(ours, 0);
    assert!(plain > rays / 100);
}
