//! The hierarchy answers as the plain loop over all shapes does, whatever it is built from.

use super::draw::Draw;
use glam::{DVec3, Vec3};
use halfdisk::geometry::{Bvh, Intersection, Quad, Ray, Shape, Sphere, Triangle, brute_force};

/// Casts the rays through tree and loop, demands the same shape at the same bits, counts the hits.
pub fn compare(name: &str, shapes: &[Shape], rays: impl IntoIterator<Item = Ray>) -> usize {
    compare_with(name, shapes, shapes, rays)
}

/// The same with a tree that may have been built of other shapes.
pub fn compare_with(
    name: &str,
    built_of: &[Shape],
    shapes: &[Shape],
    rays: impl IntoIterator<Item = Ray>,
) -> usize {
    let bvh = Bvh::new(built_of);
    let mut hits = 0;
    for ray in rays {
        let tree = bvh.first_hit(&ray).map(|f| (f.id, f.intersection));
        let all = brute_force(shapes, &ray).map(|(intersection, id)| (id, intersection));
        let bits = |x: Option<(u32, Intersection)>| x.map(|(id, x)| (id, x.t.to_bits()));
        assert_eq!(bits(tree), bits(all), "{name}: {ray:?}");
        assert_eq!(bvh.occluded(&ray), all.is_some(), "{name}: {ray:?}");
        hits += usize::from(all.is_some());
    }
    hits
}

fn triangle(a: Vec3, b: Vec3, c: Vec3) -> Shape {
    Shape::Triangle(Triangle { a, b, c })
}

/// Rays from a cube of half width `half`, each second one along an axis with zeros of both signs.
fn rays(seed: u64, count: u32, half: f32) -> impl Iterator<Item = Ray> {
    (0..count).map(move |i| {
        let mut draw = Draw::new(seed, i);
        let origin = draw.cube(half);
        let mut direction = Draw::towards(origin, draw.cube(half * 0.5)).direction;
        if i % 2 == 0 {
            let axis = draw.below(3);
            for k in [1, 2].map(|k| (axis + k) % 3) {
                direction[k] = if draw.one() < 0.5 { 0.0 } else { -0.0 };
            }
        }
        Ray::new(origin, direction)
    })
}

fn random_mix(seed: u64, count: usize, half: f32, size: f32) -> Vec<Shape> {
    let mut draw = Draw::new(seed, 0);
    (0..count)
        .map(|kind| {
            let center = draw.cube(half);
            draw.shape(kind, center, size)
        })
        .collect()
}

#[test]
fn a09_no_shape_and_one_and_two_and_three() {
    for count in 0..4 {
        let shapes = random_mix(90, count, 1.0, 1.0);
        let hits = compare("few", &shapes, rays(90, 10_000, 3.0));
        println!("{count} shapes: {hits} of 10^4 rays hit");
        assert_eq!(hits == 0, count == 0);
    }
}

#[test]
fn a09_random_mixed_shapes() {
    for (seed, size) in [(91, 0.05), (92, 0.5), (93, 10.0)] {
        let shapes = random_mix(seed, 1000, 3.0, size);
        let hits = compare("mixed", &shapes, rays(seed, 10_000, 6.0));
        println!("1000 shapes of size {size}: {hits} of 10^4 rays hit");
        assert!(hits > 100);
    }
}

#[test]
fn a09_shapes_that_cannot_be_told_apart() {
    let same = vec![triangle(Vec3::X, Vec3::Y, Vec3::Z); 10_000];
    let hits = compare("same", &same, rays(94, 1000, 3.0));
    let mut draw = Draw::new(95, 0);
    let nested: Vec<Shape> = (0..10_000)
        .map(|_| {
            let radius = draw.power(-3.0, 1.0);
            Shape::Sphere(Sphere::new(Vec3::ONE, radius))
        })
        .collect();
    let nested_hits = compare("nested", &nested, rays(95, 1000, 20.0));
    println!("of 1000 rays {hits} hit 10^4 equal triangles, {nested_hits} hit nested spheres");
    assert!(hits > 20 && nested_hits > 20);
}

#[test]
fn a09_a_hundred_thousand_in_a_row() {
    let row: Vec<Shape> = (0..100_000)
        .map(|i| Vec3::X * i as f32)
        .map(|o| {
            triangle(
                o,
                o + Vec3::new(0.9, 0.0, 0.0),
                o + Vec3::new(0.0, 0.9, 0.4),
            )
        })
        .collect();
    let aimed = (0..200).map(|i| {
        let mut draw = Draw::new(96, i);
        let origin = Vec3::new(draw.between(0.0, 1e5), 3.0, draw.between(-2.0, 2.0));
        Ray::new(
            origin,
            Vec3::new(draw.between(-9.0, 9.0), -3.0, 0.2) - Vec3::Z * origin.z,
        )
    });
    let hits = compare("row", &row, aimed);
    println!("10^5 triangles in a row: {hits} of 200 rays hit");
    assert!(hits > 20);
}

#[test]
fn a09_one_huge_triangle_among_small_ones() {
    let mut shapes = random_mix(97, 1000, 3.0, 0.3);
    let far = 1e15;
    shapes.push(triangle(
        Vec3::new(-far, -4.0, -far),
        Vec3::new(far, -4.0, -far),
        Vec3::new(0.0, -4.0, far),
    ));
    let down = rays(97, 10_000, 6.0).map(|ray| match ray.origin.y {
        y if y > -4.0 => Ray::new(ray.origin, ray.direction - Vec3::Y * 0.5),
        _ => ray,
    });
    let hits = compare("huge", &shapes, down);
    println!("a triangle 10^15 wide: {hits} of 10^4 rays hit");
    assert!(hits > 5000);
}

#[test]
fn a09_exponential_spacing_does_not_exhaust_the_stack() {
    let mut shapes = Vec::new();
    for k in -120..120 {
        let step = libm::exp2(f64::from(k)) as f32;
        for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
            let o = axis * step;
            shapes.push(triangle(
                o,
                o + Vec3::splat(step * 0.3),
                o - axis * (step * 0.2),
            ));
        }
    }
    // Many at every place, so that no plane divides the last of them.
    let many: Vec<Shape> = shapes.iter().flat_map(|s| [*s; 20]).collect();
    let aimed = (0..2000).map(|i| {
        let mut draw = Draw::new(98, i);
        let scale = draw.power(-30.0, 30.0);
        Ray::new(draw.cube(1.0) * scale, draw.direction())
    });
    let hits = compare("exponential", &many, aimed.chain(rays(98, 2000, 1.0)));
    println!(
        "{} triangles at exponential places: {hits} of 4000 rays hit",
        many.len()
    );
    assert!(hits > 10);
}

/// A scene of shapes whose numbers are random bits, and rays through it, half of them aimed.
pub fn garbage(scene: u32, rays: u32) -> usize {
    let mut draw = Draw::new(99, scene);
    let mut word = move || (draw.below(1 << 16) << 16 | draw.below(1 << 16)) as u32;
    // The distance of two coordinates should be a number where they are.
    let mut number = move || match f32::from_bits(word()) {
        x if x.is_finite() && x.abs() > 0.5 * f32::MAX => 0.5 * x,
        x => x,
    };
    let mut point = || Vec3::from_array(std::array::from_fn(|_| number()));
    let count = 1 + scene as usize % 255;
    let shapes: Vec<Shape> = (0..count)
        .map(|i| {
            let [a, b, c] = std::array::from_fn(|_| point());
            match (scene as usize + i) % 8 {
                0 => Shape::Sphere(Sphere::new(a, b.x.abs())),
                1 => Quad::new(a.as_dvec3(), b.as_dvec3(), c.as_dvec3())
                    .map_or(triangle(a, b, c), Shape::Quad),
                _ => triangle(a, b, c),
            }
        })
        .collect();
    let aimed = (0..rays as usize).map(|i| {
        let origin = point();
        let bounds = shapes[i / 3 % count].bounds();
        let share = i as f32 / rays as f32;
        let target = bounds.min * share + bounds.max * (1.0 - share);
        match (i % 3, shapes[i / 3 % count]) {
            (0, Shape::Triangle(t)) => Draw::towards(origin, t.a * 0.25 + t.b * 0.25 + t.c * 0.5),
            (1, Shape::Triangle(t)) => {
                Draw::towards(Vec3::splat(1.0), t.a * 0.3 + t.b * 0.3 + t.c * 0.4)
            }
            (2, _) => Ray::new(origin, point()),
            _ => Draw::towards(origin, target),
        }
    });
    let aimed: Vec<Ray> = aimed.collect();
    compare("garbage", &shapes, aimed)
}

#[test]
fn a09_garbage_as_vertices() {
    let hits: usize = (1000..1200).map(|scene| garbage(scene, 100)).sum();
    println!("200 scenes of random bits: {hits} of 20000 rays hit");
    assert!(hits > 1000);
}

#[test]
fn a12_of_equal_shapes_the_lowest_id_is_hit_whatever_the_order() {
    let single = random_mix(120, 100, 2.0, 1.0);
    let mut doubled: Vec<(usize, Shape)> = [0, 1, 2]
        .into_iter()
        .flat_map(|_| single.iter().copied().enumerate())
        .collect();
    let mut draw = Draw::new(121, 0);
    for _ in 0..20 {
        for i in (1..doubled.len()).rev() {
            doubled.swap(i, draw.below(i + 1));
        }
        let shapes: Vec<Shape> = doubled.iter().map(|(_, shape)| *shape).collect();
        let (one, three) = (Bvh::new(&single), Bvh::new(&shapes));
        for ray in rays(122, 2000, 5.0) {
            let [a, b] = [one.first_hit(&ray), three.first_hit(&ray)];
            assert_eq!(a.map(|f| f.intersection), b.map(|f| f.intersection));
            if let (Some(a), Some(b)) = (a, b) {
                let twins = |i: &usize| doubled[*i].0 == a.id as usize;
                assert_eq!((0..doubled.len()).find(twins), Some(b.id as usize));
            }
        }
    }
    println!("20 orders x 2000 rays: always the lowest id");
}

#[test]
fn a12_two_walls_in_one_place_are_one_wall() {
    let wall = Quad::new(
        DVec3::new(-0.7, 0.1, 0.3),
        DVec3::X * 2.0,
        DVec3::new(0.3, 1.0, 0.5),
    );
    let wall = Shape::Quad(wall.unwrap());
    let crowd = random_mix(123, 500, 3.0, 0.2);
    let mut shapes = vec![wall];
    shapes.extend(&crowd);
    shapes.push(wall);
    let bvh = Bvh::new(&shapes);
    let last = shapes.len() as u32 - 1;
    let seconds =
        rays(123, 20_000, 5.0).filter(|ray| bvh.first_hit(ray).is_some_and(|f| f.id == last));
    assert_eq!(seconds.count(), 0);
}
