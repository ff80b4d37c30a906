//! What rays meet: nothing is missed, nothing is met twice, nothing slips through a corner.

use super::draw::{Draw, circle, polygon, segment, world};
use glam::{DVec2, Vec2};
use halfdisk::flatland::{FlatHit, FlatWorld, Shape};
use std::f32::consts::TAU;

/// All places where a ray meets a shape, by another way than the library's: a linear system for
/// the segment, the foot of the perpendicular for the circle. Also how narrow the decision was.
fn truth(shape: &Shape, o: DVec2, d: DVec2) -> (Vec<f64>, f64) {
    match shape {
        Shape::Segment(s) => {
            // o + t d = a + u (b - a), by Cramer's rule.
            let [a, b] = s.ends().map(Vec2::as_dvec2);
            let (e, f) = (b - a, a - o);
            let determinant = e.x * d.y - d.x * e.y;
            let t = (e.x * f.y - f.x * e.y) / determinant;
            let u = (d.x * f.y - f.x * d.y) / determinant;
            let margin = u.abs().min((1.0 - u).abs()).min(t.abs());
            let met = (0.0..=1.0).contains(&u) && t > 0.0;
            (if met { vec![t] } else { vec![] }, margin)
        }
        Shape::Circle(c) => {
            let (center, radius) = (c.center.as_dvec2(), f64::from(c.radius));
            let foot = d.dot(center - o) / d.length_squared();
            let off = (o + d * foot).distance(center);
            let half = (radius * radius - off * off).max(0.0).sqrt() / d.length();
            let met = [foot - half, foot + half].into_iter().filter(|t| *t > 0.0);
            let margin = (1.0 - off / radius).abs();
            (if off <= radius { met.collect() } else { vec![] }, margin)
        }
        Shape::Ellipse(_) => unreachable!("none is drawn here"),
    }
}

#[test]
fn the_first_hit_is_the_nearest_of_all() {
    let (mut hits, mut misses, mut worst_t, mut worst_p) = (0, 0, 0.0_f64, 0.0_f64);
    for i in 0..200 {
        let mut draw = Draw::new(50, i);
        let scale = libm::pow(10.0, f64::from(draw.between(-3.0, 4.0))) as f32;
        let shapes: Vec<String> = (0..16)
            .map(|k| {
                let at = draw.square(scale);
                if k % 4 == 0 {
                    circle(at, scale * draw.between(0.01, 0.2))
                } else {
                    segment(
                        at,
                        at + draw.direction() * (scale * draw.between(0.05, 1.0)),
                    )
                }
            })
            .collect();
        let world = world(&shapes);
        for _ in 0..2000 {
            let (origin, direction) = (draw.square(scale), draw.direction());
            let (o, d) = (origin.as_dvec2(), direction.as_dvec2());
            let all = world.parts().iter().map(|p| truth(&p.shape, o, d));
            let mut nearest: Option<(f64, usize)> = None;
            let mut narrow = false;
            for (object, (met, margin)) in all.enumerate() {
                narrow |= margin < 1e-9;
                for t in met {
                    nearest = nearest.filter(|n| n.0 <= t).or(Some((t, object)));
                }
            }
            if narrow {
                continue;
            }
            match (world.first_hit(origin, direction), nearest) {
                (None, None) => misses += 1,
                (Some(hit), Some((t, object))) => {
                    hits += 1;
                    assert_eq!(hit.object, object);
                    worst_t = worst_t.max((f64::from(hit.t) / t - 1.0).abs());
                    let off = hit.surface.p.as_dvec2() - (o + d * t);
                    let bound = hit.surface.error.as_dvec2() + f64::from(scale) * 1e-9;
                    worst_p = worst_p.max((off.abs() / bound).max_element());
                }
                (ours, truth) => panic!("{ours:?} is not {truth:?}"),
            }
        }
    }
    println!("{hits} hits, {misses} misses; distance off by {worst_t:.1e}, point by {worst_p:.2}");
    assert!(hits > 200_000 && misses > 100_000);
    assert!(worst_t < 6.0e-8 && worst_p < 1.0);
}

/// True where a ray that has just left `hit` meets the same shape as if it had not. A circle is
/// met by a ray that goes inside, on its way out.
fn meets_again(world: &FlatWorld, hit: &FlatHit, origin: Vec2, direction: Vec2) -> bool {
    match (world.first_hit(origin, direction), world.parts()[0].shape) {
        (None, _) => false,
        (Some(_), Shape::Segment(_)) => true,
        (Some(next), Shape::Circle(_) | Shape::Ellipse(_)) => {
            hit.surface.n.dot(direction) >= 0.0 || next.surface.n.dot(direction) <= 0.0
        }
    }
}

#[test]
fn rays_that_leave_do_not_come_back() {
    let (mut again, mut plain, mut rays) = (0, 0, 0);
    for i in 0..4000 {
        let mut draw = Draw::new(51, i);
        let scale = libm::pow(10.0, f64::from(draw.between(-3.0, 4.0))) as f32;
        // Every second shape is up to a thousand times its size away from the origin.
        let far = if i % 4 < 2 { 1000.0 } else { 1.0 };
        let at = draw.square(scale * far);
        let size = scale * draw.between(0.5, 2.0);
        let world = world(&[if i % 2 == 0 {
            circle(at, size)
        } else {
            segment(at, at + draw.direction() * size)
        }]);
        for _ in 0..50 {
            let eye = at + draw.direction() * (size * draw.between(2.0, 30.0));
            let target = at + draw.square(size * 0.7);
            let Some(hit) = world.first_hit(eye, (target - eye).normalize()) else {
                continue;
            };
            for side in [hit.surface.n, -hit.surface.n] {
                let out = draw.leaving(side);
                rays += 1;
                again += usize::from(meets_again(&world, &hit, hit.surface.leave(out), out));
                let point = eye + (target - eye).normalize() * hit.t;
                plain += usize::from(meets_again(&world, &hit, point, out));
            }
        }
    }
    println!("{again} of {rays} rays meet their wall again; from plain hit points {plain}");
    assert!(rays > 100_000 && plain > rays / 10);
    assert_eq!(again, 0);
}

#[test]
fn nothing_slips_through_the_corners_of_a_room() {
    let mut rays = 0;
    for i in 0..300 {
        let mut draw = Draw::new(52, i);
        let scale = libm::pow(10.0, f64::from(draw.between(-3.0, 4.0))) as f32;
        let middle = draw.square(scale * 10.0);
        let sides = 3 + i % 30;
        let corners: Vec<Vec2> = (0..sides)
            .map(|k| {
                let (sin, cos) = halfdisk::numeric::sin_cos(TAU * k as f32 / sides as f32);
                middle + Vec2::new(cos, sin) * (scale * draw.between(0.8, 1.0))
            })
            .collect();
        let room = world(&[polygon(&corners)]);
        for _ in 0..30 {
            let from = middle + draw.square(scale * 0.1);
            for corner in &corners {
                rays += 1;
                let hit = room.first_hit(from, *corner - from).expect("a closed room");
                assert!((hit.t - 1.0).abs() < 1e-2, "{}", hit.t);
                assert!(hit.surface.n.dot(*corner - from) < 0.0, "faces inwards");
            }
        }
    }
    println!("{rays} rays at the corners of 300 rooms, none escapes");
}

#[test]
fn surfaces_see_each_other_unless_something_is_between() {
    let (mut seen, mut hidden) = (0, 0);
    for i in 0..2000 {
        let mut draw = Draw::new(53, i);
        let scale = libm::pow(10.0, f64::from(draw.between(-3.0, 4.0))) as f32;
        let floor = [Vec2::new(-1.0, 0.0), Vec2::X].map(|v| v * scale);
        let (center, radius) = (Vec2::Y * scale * 1.5, scale * 0.3);
        let shelf = [Vec2::new(-0.1, 0.6), Vec2::new(0.4, 0.6)].map(|v| v * scale);
        let open = world(&[segment(floor[0], floor[1]), circle(center, radius)]);
        let shut = world(&[
            segment(floor[0], floor[1]),
            circle(center, radius),
            segment(shelf[0], shelf[1]),
        ]);
        let [Shape::Segment(ground), Shape::Circle(ball)] =
            [open.parts()[0].shape, open.parts()[1].shape]
        else {
            panic!("a segment and a circle");
        };
        for _ in 0..50 {
            let p = ground.surface_at(draw.one());
            let q = ball.surface_towards(draw.direction().as_dvec2().normalize());
            let way = q.p.as_dvec2() - p.p.as_dvec2();
            let cos = q.n.as_dvec2().dot(-way) / way.length();
            if cos.abs() < 1e-6 {
                continue;
            }
            assert_eq!(open.sees(&p, &q), cos > 0.0);
            assert_eq!(open.sees(&q, &p), cos > 0.0);
            assert!(cos < 0.0 || open.sees_point(&p, q.leave(q.n)));
            // Where the way crosses the height of the shelf.
            let x = f64::from(p.p.x) + way.x * f64::from(shelf[0].y) / way.y;
            let [left, right] = shelf.map(|end| f64::from(end.x));
            if (x - left).abs().min((x - right).abs()) < 1e-6 * f64::from(scale) {
                continue;
            }
            let behind = (left..right).contains(&x);
            assert_eq!(shut.sees(&p, &q), cos > 0.0 && !behind);
            seen += usize::from(shut.sees(&p, &q));
            hidden += usize::from(cos > 0.0 && behind);
        }
    }
    println!("{seen} pairs see each other, {hidden} have a shelf between them");
    assert!(seen > 10_000 && hidden > 10_000);
}

#[test]
fn rays_that_are_not_rays_meet_nothing() {
    let room = halfdisk::flatland::load("room").unwrap();
    let inside = Vec2::splat(0.5);
    let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
    assert_eq!(room.first_hit(inside, Vec2::ZERO), None);
    for x in bad {
        for v in [Vec2::new(x, 1.0), Vec2::new(0.0, x), Vec2::splat(x)] {
            assert_eq!(room.first_hit(inside, v), None);
            assert_eq!(room.first_hit(v, Vec2::Y), None);
        }
    }
}
