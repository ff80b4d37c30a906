//! Shapes in motion: nothing leaves its box, and at each time all is as if it stood still there.

use super::draw::Draw;
use glam::Vec3;
use halfdisk::geometry::{Aabb, Primitive};
use halfdisk::geometry::{Bvh, Moving, PreparedRay, Shape, Sphere, Surface, brute_force};

/// A shape and a motion of comparable size, at any place.
fn draw_moving(draw: &mut Draw, kind: usize) -> Moving {
    let place = draw.power(-1.0, 4.0);
    let center = draw.cube(place);
    let shape = draw.shape(kind, center, 1.0);
    let far = draw.power(-2.0, 4.0);
    Moving::new(shape, draw.cube(far)).expect("finite")
}

/// True where the box holds the other, corners included.
fn holds(all: &Aabb, one: &Aabb) -> bool {
    all.union(*one) == *all
}

#[test]
fn a09_the_box_of_a_moving_shape_holds_it_at_all_times() {
    let mut outside_the_ends = 0;
    for i in 0..100_000 {
        let mut draw = Draw::new(130, i);
        let moving = match i {
            0..50_000 => draw_moving(&mut draw, 0),
            _ => draw_moving(&mut draw, i as usize),
        };
        let time = draw.one();
        let there = moving.at(time).bounds();
        assert!(holds(&moving.bounds(), &there), "{moving:?} at {time}");
        outside_the_ends += usize::from(!holds(&moving.at(0.0).bounds(), &there));
    }
    println!("10^5 places in their boxes; {outside_the_ends} not in that of time 0");
    assert!(outside_the_ends > 50_000);
}

#[test]
fn a09_a_tree_of_moving_shapes_answers_as_the_loop_does_at_every_time() {
    let (mut hits, mut at_another_time) = (0, 0);
    for scene in 0..20 {
        let mut draw = Draw::new(131, scene);
        let shapes: Vec<Moving> = (0..300)
            .map(|kind| {
                let center = draw.cube(3.0);
                let shape = draw.shape(kind, center, 0.5);
                Moving::new(shape, draw.cube(2.0)).expect("finite")
            })
            .collect();
        let bvh = Bvh::new(&shapes);
        for i in 0..1000 {
            let time = [0.0, 1.0, draw.one()][i % 3];
            let ray = Draw::towards(draw.cube(6.0), draw.cube(3.0)).at_time(time);
            let bits = |t: f32, id: u32| (t.to_bits(), id);
            let tree = bvh.first_hit(&ray).map(|f| bits(f.intersection.t, f.id));
            let still: Vec<Shape> = shapes.iter().map(|s| s.at(time)).collect();
            let all = brute_force(&still, &ray).map(|(x, id)| bits(x.t, id));
            assert_eq!(tree, all, "{ray:?} at {time}");
            assert_eq!(bvh.occluded(&ray), all.is_some());
            let frozen = brute_force(&shapes, &ray.at_time(0.5)).map(|(x, id)| bits(x.t, id));
            hits += usize::from(tree.is_some());
            at_another_time += usize::from(frozen != all);
        }
    }
    println!("20 000 rays: {hits} hits, {at_another_time} not the same at time 1/2");
    assert!(hits > 3000 && at_another_time > 3000);
}

#[test]
fn a09_a_motion_of_zero_changes_no_bit() {
    let mut compared = 0;
    for i in 0..30_000 {
        let mut draw = Draw::new(132, i);
        let center = draw.cube(3.0);
        let shape = draw.shape(i as usize, center, 1.0);
        let moving = Moving::new(shape, Vec3::ZERO).expect("finite");
        let time = draw.one();
        let ray = Draw::towards(draw.cube(10.0), center + draw.cube(0.2)).at_time(time);
        let prepared = PreparedRay::from(&ray);
        assert_eq!(moving.bounds(), shape.bounds());
        let intersection = shape.intersect(&prepared, f32::MAX);
        assert_eq!(moving.intersect(&prepared, f32::MAX), intersection);
        if let Some(x) = intersection {
            let [a, b] = [shape.surface(&ray, x), moving.surface(&ray, x)];
            assert_eq!((a.p, a.error, a.n), (b.p, b.error, b.n));
            compared += 1;
        }
    }
    println!("{compared} surfaces alike");
    assert!(compared > 15_000);
}

#[test]
fn a04_self_intersection_of_moving_shapes() {
    let (mut ours, mut as_if_still, mut other_time, mut rays) = (0, 0, 0, 0);
    for i in 0..60_000 {
        let mut draw = Draw::new(133, i);
        // From far away to a place near the origin, where the corners' old roundings are large.
        let far = draw.power(0.0, 5.0);
        let start = draw.direction() * far;
        let shape = draw.shape(i as usize, start, 1.0);
        let back = draw.cube(1.0) - start;
        let Some(moving) = Moving::new(shape, back) else {
            continue;
        };
        let time = if i % 2 == 0 { 1.0 } else { draw.one() };
        let there = moving.at(time);
        let middle = there.bounds().center();
        let ray = Draw::towards(middle + draw.direction() * 10.0, middle + draw.cube(0.3));
        let ray = ray.at_time(time);
        let prepared = PreparedRay::from(&ray);
        let Some(x) = moving.intersect(&prepared, f32::MAX) else {
            continue;
        };
        let surface = moving.surface(&ray, x);
        let plain = there.surface(&ray, x);
        for k in 0..20 {
            let side = if k % 2 == 0 { surface.n } else { -surface.n };
            let out = draw.leaving(side);
            let meets = |s: &Surface, time: f32| {
                let ray = s.spawn(out).at_time(time);
                let again = moving.intersect(&PreparedRay::from(&ray), f32::MAX);
                again.is_some_and(|x| match moving.at(time) {
                    // From inside, the ray meets the sphere on its way out.
                    Shape::Sphere(s) => (ray.at(x.t) - s.center).dot(out) <= 0.0,
                    _ => true,
                })
            };
            rays += 1;
            ours += usize::from(meets(&surface, time));
            as_if_still += usize::from(meets(&plain, time));
            other_time += usize::from(meets(&surface, time * 0.5));
        }
    }
    println!("{rays} rays: {ours} again; quads taken as flat {as_if_still}; later {other_time}");
    assert_eq!(ours, 0);
    assert!(rays > 200_000 && as_if_still > 0 && other_time > 1000);
}

#[test]
fn a09_motions_out_of_the_numbers_are_refused() {
    let ball = |radius| Shape::Sphere(Sphere::new(Vec3::ONE, radius));
    assert!(Moving::new(ball(1.0), Vec3::splat(1e30)).is_some());
    for motion in [f32::NAN, f32::INFINITY, f32::MAX] {
        assert!(
            Moving::new(ball(1e38), Vec3::X * motion).is_none(),
            "{motion}"
        );
    }
    assert!(Moving::new(ball(f32::NAN), Vec3::X).is_none());
}
