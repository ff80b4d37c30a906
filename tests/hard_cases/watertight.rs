//! Closed surfaces keep every ray in, and boxes miss no ray that meets what they hold.

use super::draw::Draw;
use super::naive;
use glam::{DVec3, Vec3};
use halfdisk::geometry::{Aabb, Bvh, Mesh, PreparedRay, Quad, Ray, Shape, Triangle};
use std::f64::consts::{PI, TAU};

/// The unit sphere in rows and columns of triangles, with one vertex at each pole.
fn ball(rows: u32, columns: u32) -> Mesh {
    let mut mesh = Mesh::default();
    mesh.vertices.push(DVec3::Z);
    for row in 1..rows {
        for column in 0..columns {
            let (sin, cos) = libm::sincos(PI * f64::from(row) / f64::from(rows));
            let (y, x) = libm::sincos(TAU * f64::from(column) / f64::from(columns));
            mesh.vertices.push(DVec3::new(sin * x, sin * y, cos));
        }
    }
    mesh.vertices.push(-DVec3::Z);
    let south = mesh.vertices.len() as u32 - 1;
    let vertex = |row: u32, column: u32| match row {
        0 => 0,
        row if row == rows => south,
        row => 1 + (row - 1) * columns + column % columns,
    };
    for row in 0..rows {
        for column in 0..columns {
            let [a, b] = [vertex(row, column), vertex(row, column + 1)];
            let [c, d] = [vertex(row + 1, column), vertex(row + 1, column + 1)];
            if row > 0 {
                mesh.triangles.push([a, d, b]);
            }
            if row + 1 < rows {
                mesh.triangles.push([a, c, d]);
            }
        }
    }
    mesh
}

#[test]
fn a05_watertight_meshes_keep_rays_in() {
    for (rows, columns) in [(10, 20), (40, 80)] {
        for place in [0.0, 1e5] {
            let center = Vec3::new(1.0, 0.3, -0.7) * place;
            let mesh = ball(rows, columns);
            let triangles = mesh.to_triangles(|v| (v + center.as_dvec3()).as_vec3());
            let triangles: Vec<Triangle> = triangles.into_iter().map(|(_, t)| t).collect();
            let shapes: Vec<Shape> = triangles.iter().copied().map(Shape::Triangle).collect();
            let bvh = Bvh::new(&shapes);
            let (mut ours, mut plain) = ([0; 3], [0; 3]);
            for i in 0..20_000 {
                let mut draw = Draw::new(50, i);
                let origin = center + draw.cube(0.3);
                let t = &triangles[draw.below(triangles.len())];
                let aims = [
                    origin + draw.direction(),
                    t.a,
                    t.b + (t.c - t.b) * draw.one(),
                ];
                for (kind, aim) in aims.into_iter().enumerate() {
                    // Not normalised: the ray passes as close to its aim as f32 can say.
                    let ray = Ray::new(origin, aim - origin);
                    ours[kind] += usize::from(bvh.first_hit(&ray).is_none());
                    if i < 1000 {
                        let hit = triangles
                            .iter()
                            .any(|t| naive::triangle(&ray, t) > Some(0.0));
                        plain[kind] += usize::from(!hit);
                    }
                }
            }
            println!(
                "{rows} x {columns} at {place:e}, {} triangles: escapes (anywhere, vertices, edges) \
                 ours {ours:?} of 20000, plain {plain:?} of 1000",
                triangles.len()
            );
            assert_eq!(ours, [0; 3]);
            assert!(place > 0.0 || plain[1] + plain[2] > 20);
        }
    }
}

#[test]
fn a05_watertight_rooms_of_six_quads_keep_rays_in() {
    let mut rays = 0;
    for i in 0..3000 {
        let mut draw = Draw::new(51, i);
        let place = [0.0, 1.0, 1e3, 1e5][i as usize % 4];
        let n = draw.direction().as_dvec3().normalize();
        let (u, v) = n.any_orthonormal_pair();
        let [u, v, w] = [u * 1.0, v * 1.3, n * 0.8];
        let o = draw.cube(1.0).as_dvec3() + DVec3::new(1.0, -0.6, 0.3) * place;
        let walls = [
            (o, u, v),
            (o, v, w),
            (o, w, u),
            (o + w, u, v),
            (o + u, v, w),
            (o + v, w, u),
        ];
        let shapes = walls.map(|(o, u, v)| Shape::Quad(Quad::new(o, u, v).unwrap()));
        let bvh = Bvh::new(&shapes);
        for _ in 0..100 {
            let mut inside = || 0.2 + 0.6 * f64::from(draw.one());
            let origin = (o + u * inside() + v * inside() + w * inside()).as_vec3();
            let at = f64::from(draw.one());
            // A corner with two coordinates of 0 or 1, and anything or the same for the third.
            let [p, q, r] = [(); 3].map(|_| f64::from(u8::from(draw.one() < 0.5)));
            let edge = (o + u * p + v * q + w * at).as_vec3();
            let corner = (o + u * p + v * q + w * r).as_vec3();
            for aim in [edge, corner] {
                rays += 1;
                assert!(bvh.occluded(&Ray::new(origin, aim - origin)), "room {i}");
            }
        }
    }
    println!("{rays} rays into edges and corners of rooms: 0 escapes");
}

/// All rays along an axis whose other coordinates are each on a face of the unit box or between
/// two, with zeros of both signs.
fn axis_rays(on: [f32; 3]) -> impl Iterator<Item = Ray> {
    (0..3 * 2 * 9 * 4).map(move |i| {
        let (axis, forward) = (i % 3, i / 3 % 2 == 0);
        let (first, second, signs) = (i / 6 % 3, i / 18 % 3, i / 54);
        let zero = |negative| if negative { -0.0 } else { 0.0 };
        let (mut origin, mut direction) = (Vec3::ZERO, Vec3::ZERO);
        origin[axis] = if forward { -1.0 } else { 2.0 };
        direction[axis] = if forward { 1.0 } else { -1.0 };
        for (k, place, negative) in [(1, first, signs % 2 == 0), (2, second, signs > 1)] {
            origin[(axis + k) % 3] = on[place];
            direction[(axis + k) % 3] = zero(negative);
        }
        Ray::new(origin, direction)
    })
}

fn enters(b: &Aabb, ray: &Ray) -> bool {
    b.entry(&PreparedRay::from(ray), f32::MAX).is_some()
}

#[test]
fn a08_rays_in_the_faces_of_a_box_are_inside_and_one_ulp_beyond_outside() {
    let unit = Aabb {
        min: Vec3::ZERO,
        max: Vec3::ONE,
    };
    let plain = axis_rays([0.0, 0.5, 1.0]).filter(|ray| !naive::slab(ray, &unit));
    println!(
        "rays in faces and edges: min and max lose {}",
        plain.count()
    );
    assert!(axis_rays([0.0, 0.5, 1.0]).all(|ray| enters(&unit, &ray)));
    assert!(axis_rays([0.0, 0.5, 1.0]).any(|ray| !naive::slab(&ray, &unit)));
    let beyond = [0.0_f32.next_down(), 1.0_f32.next_up(), -1.0];
    assert!(!axis_rays(beyond).any(|ray| enters(&unit, &ray)));
    // Backwards, nothing is met.
    let behind = |ray: Ray| Ray::new(ray.origin, -ray.direction);
    assert!(!axis_rays([0.0, 0.5, 1.0]).any(|ray| enters(&unit, &behind(ray))));
}

#[test]
fn a08_flat_boxes_and_corners_are_met() {
    let mut plain = 0;
    for place in [0.0, 1e3, 1e6] {
        for i in 0..100_000 {
            let mut draw = Draw::new(80, i);
            let min = draw.cube(1.0) + place;
            let mut max = min + Vec3::new(draw.one(), draw.one(), draw.one());
            let flat = i as usize % 4;
            if flat < 3 {
                max[flat] = min[flat];
            }
            let b = Aabb { min, max };
            let corner = Vec3::from_array([0, 1, 2].map(|k| {
                if i >> (2 + k) & 1 == 0 {
                    min[k]
                } else {
                    max[k]
                }
            }));
            let origin = draw.cube(5.0) + place;
            let ray = Ray::new(origin, corner - origin);
            if ray.is_valid() {
                assert!(enters(&b, &ray), "{place} {i}");
                plain += usize::from(!naive::slab(&ray, &b));
            }
        }
    }
    println!("3 x 10^5 rays into corners: ours lose none, min and max {plain}");
    assert!(plain > 1000);
}

#[test]
fn a08_no_triangle_is_crossed_outside_its_box() {
    let (mut crossed, mut latest) = (0, 0.0_f32);
    for i in 0..1_000_000 {
        let mut draw = Draw::new(81, i);
        let size = draw.power(-3.0, 3.0);
        let [a, b, mut c] = [(); 3].map(|_| draw.cube(size));
        if i % 2 == 0 {
            // A sliver: the third corner almost between the other two.
            c = a + (b - a) * draw.one() + (c - a) * draw.power(-8.0, 0.0);
        }
        let triangle = Triangle { a, b, c };
        let [u, v] = match i % 3 {
            0 => draw.inside(),
            1 => [draw.one(), 0.0],
            _ => [0.0, 0.0],
        };
        let mut origin = draw.cube(10.0);
        let mut direction = a + (b - a) * u + (c - a) * v - origin;
        if i % 5 == 0 {
            // Along an axis.
            let axis = draw.below(3);
            let (height, step) = (origin[axis], direction[axis]);
            origin += direction;
            origin[axis] = height;
            direction = Vec3::ZERO;
            direction[axis] = step;
        }
        let ray = PreparedRay::from(&Ray::new(origin, direction));
        if let Some(x) = triangle.intersect(&ray, f32::MAX) {
            crossed += 1;
            let entry = triangle.bounds().entry(&ray, f32::MAX);
            assert!(entry.is_some(), "{i}: {triangle:?}");
            latest = latest.max(entry.unwrap() / x.t);
        }
    }
    println!("{crossed} crossings, all in boxes; latest entry / t {latest}");
    assert!(crossed > 500_000);
}
