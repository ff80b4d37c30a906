//! Sixteen rays at once against one at a time.

use super::*;
use crate::geometry::{Bvh, Intersection, Ray, Surface, Triangle};
use crate::numeric::lanes::{ALL_LANES, Each, LANES, Row, Row3, levels};
use crate::sampling::stream::{Numbers, Purpose, Stream};
use crate::sampling::warps;
use fearless_simd::{Level, dispatch};
use glam::{DVec3, Vec3};

fn numbers(seed: u64, i: u32) -> Numbers {
    Stream::new(seed, i, 0).at(0, Purpose::Direction)
}

fn point(numbers: &mut Numbers, size: f32) -> Vec3 {
    Vec3::from([(); 3].map(|()| (numbers.one() - 0.5) * size))
}

fn few(shapes: &[Shape]) -> Option<FewShapes> {
    FewShapes::new((0..).zip(shapes.iter().copied()), |_| Note::default())
}

/// A bowl of triangles, and a room with slanted quads and two balls in it, so large.
fn room_with_bowl(size: f32) -> Vec<Shape> {
    let corner = |x: u32, z: u32| {
        let [x, z] = [x, z].map(|i| i as f32 / 6.0 - 0.5);
        Vec3::new(x + 0.2, x * x + z * z - 0.3, z) * size
    };
    let cells = (0..6).flat_map(|x| (0..6).map(move |z| (x, z)));
    let bowl = cells.flat_map(|(x, z)| {
        let [a, b, c, d] =
            [(x, z), (x, z + 1), (x + 1, z + 1), (x + 1, z)].map(|(x, z)| corner(x, z));
        [Triangle { a, b, c }, Triangle { a, b: c, c: d }]
    });
    bowl.map(Shape::Triangle).chain(room(size)).collect()
}

/// A room with slanted quads and two balls in it, so large.
fn room(size: f32) -> Vec<Shape> {
    let quad = |corner: [f64; 3], u: [f64; 3], v: [f64; 3]| {
        let [corner, u, v] = [corner, u, v].map(|x| DVec3::from(x) * f64::from(size));
        Shape::Quad(Quad::new(corner, u, v).expect("a quad"))
    };
    let ball = |at: Vec3, radius: f32, inward| {
        Shape::Sphere(Sphere {
            center: at * size,
            radius: radius * size,
            inward,
        })
    };
    vec![
        quad([-1.0, -1.0, -1.0], [2.0, 0.0, 0.0], [0.0, 0.0, 2.0]),
        quad([-1.0, 1.0, -1.0], [0.0, 0.0, 2.0], [2.0, 0.0, 0.0]),
        quad([-1.0, -1.0, -1.0], [0.0, 2.0, 0.0], [2.0, 0.0, 0.0]),
        quad([-1.0, -1.0, -1.0], [0.0, 0.0, 2.0], [0.0, 2.0, 0.0]),
        quad([1.0, -1.0, -1.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]),
        quad([-0.3, 0.999, -0.3], [0.6, 0.0, 0.0], [0.0, 0.0, 0.6]),
        quad([0.1, -1.0, 0.1], [0.4, 0.0, 0.2], [-0.1, 0.7, 0.0]),
        quad([0.5, -1.0, 0.3], [-0.2, 0.0, 0.4], [-0.1, 0.7, 0.0]),
        // All but parallel to the first of these two.
        quad([0.3, -0.9, -0.3], [0.4, 4e-7, 0.2], [-0.1, 0.7, 3e-7]),
        quad([-0.8, -0.2, 0.0], [1e-3, 0.0, 0.0], [0.0, 0.9, 0.1]),
        ball(Vec3::new(-0.4, -0.7, 0.3), 0.3, false),
        ball(Vec3::new(0.6, 0.4, -0.5), 0.25, true),
    ]
}

/// Rays with the shape that each leaves: from afar, from surfaces, and at edges and corners.
fn rays(shapes: &[Shape], size: f32, i: u32) -> Vec<(Ray, u32)> {
    let mut numbers = numbers(11, i);
    let from_surface = |numbers: &mut Numbers| {
        let id = numbers.one() * shapes.len() as f32;
        let surface = surface_of(&shapes[id as usize], [numbers.one(), numbers.one()]);
        (surface, id as u32)
    };
    let corner = |numbers: &mut Numbers| {
        let quads: Vec<Vec<Vec3>> = shapes
            .iter()
            .map(Shape::corners)
            .filter(|c| !c.is_empty())
            .collect();
        let corners = &quads[(numbers.one() * quads.len() as f32) as usize];
        let at = (numbers.one() * corners.len() as f32) as usize;
        let along = if numbers.one() < 0.5 {
            0.0
        } else {
            numbers.one()
        };
        corners[at].lerp(corners[(at + 1) % corners.len()], along)
    };
    let ray = |kind: u32, numbers: &mut Numbers| match kind {
        0 => {
            let direction = warps::sample_sphere(numbers.two());
            (Ray::new(point(numbers, 2.0 * size), direction), NO_SHAPE)
        }
        1 => {
            let (surface, id) = from_surface(numbers);
            (surface.spawn(warps::sample_sphere(numbers.two())), id)
        }
        2 => {
            let (surface, id) = from_surface(numbers);
            let (target, _) = from_surface(numbers);
            (surface.spawn_to(&target), id)
        }
        _ => {
            let origin = point(numbers, 2.0 * size);
            (
                Ray::new(origin, (corner(numbers) - origin).normalize()),
                NO_SHAPE,
            )
        }
    };
    (0..LANES as u32)
        .map(|lane| ray((i + lane / 4) % 4, &mut numbers))
        .collect()
}

fn surface_of(shape: &Shape, u: [f32; 2]) -> Surface {
    match shape {
        Shape::Quad(quad) => quad.surface_at(u[0], u[1]),
        Shape::Sphere(sphere) => {
            sphere.surface_towards(warps::sample_sphere(u).as_dvec3().normalize())
        }
        Shape::Triangle(triangle) => {
            triangle.surface(Intersection::new(0.0, u[0] * u[1], u[0] * (1.0 - u[1])))
        }
    }
}

/// What became of rays in lanes.
#[derive(Debug, Default, PartialEq)]
struct Count {
    hit: u32,
    missed: u32,
    doubt: u32,
    /// Lanes that ask the tree of the triangles.
    at_triangles: u32,
    /// Lanes in which something else came out than for one ray.
    wrong: u32,
}

/// First hits, or occlusion, of many rays.
fn count(few: &FewShapes, shapes: &[Shape], size: f32, level: Level, rounds: u32) -> [Count; 2] {
    let tree = Bvh::new(shapes);
    let mut counts = [Count::default(), Count::default()];
    for i in 0..rounds {
        let rays = rays(shapes, size, i);
        let (mut origin, mut direction, mut t_max) =
            (Row3::default(), Row3::default(), Row::default());
        let mut from = WordRow::default();
        for (lane, (ray, id)) in rays.iter().enumerate() {
            origin.set_lane(lane, ray.origin);
            direction.set_lane(lane, ray.direction);
            (t_max.0[lane], from.0[lane]) = (ray.reach(), *id);
        }
        let (first, id, numbers, surface, any) = dispatch!(level, s => {
            let rays = Rays {
                origin: origin.get(s),
                direction: direction.get(s),
                t_max: t_max.get(s),
                from: from.get(s),
            };
            let first = few.intersect(s, &rays);
            let any = few.occluded(s, &rays, NO_SHAPE, mask(s, ALL_LANES));
            (
                [first.hit, first.doubt, first.at_triangles].map(bits),
                WordRow::from(first.id),
                [first.t, first.u, first.v].map(Row::from),
                [first.p, first.error, first.n].map(Row3::from),
                [any.hit, any.doubt, any.at_triangles].map(bits),
            )
        });
        for lane in Each(ALL_LANES) {
            let lane_of = |masks: [u32; 3]| masks.map(|mask| mask >> lane & 1 == 1);
            let ray = &rays[lane].0;
            let plain = tree.first_hit(ray);
            let [hit, _, at_triangles] = lane_of(first);
            let is_triangle = |id: u32| matches!(shapes[id as usize], Shape::Triangle(_));
            let same = match &plain {
                None => !hit,
                Some(found) if is_triangle(found.id) => {
                    let alone = tree
                        .first_triangle(ray)
                        .map(|alone| (alone.id, alone.intersection));
                    at_triangles && alone == Some((found.id, found.intersection))
                }
                Some(found) => {
                    let at = found.intersection;
                    let plain = found.surface(ray);
                    hit && id.0[lane] == found.id
                        && numbers.each_ref().map(|row| row.0[lane].to_bits())
                            == [at.t, at.u, at.v].map(f32::to_bits)
                        && surface.each_ref().map(|row| row.lane(lane))
                            == [plain.p, plain.error, plain.n].map(|v| v.to_array())
                }
            };
            counts[0].add(lane_of(first), same);
            let [hit, _, at_triangles] = lane_of(any);
            let blocked = hit || (at_triangles && tree.occluded_by_triangles(ray));
            counts[1].add(lane_of(any), blocked == plain.is_some());
        }
    }
    counts
}

impl Count {
    fn add(&mut self, [hit, doubt, at_triangles]: [bool; 3], same: bool) {
        self.hit += u32::from(hit);
        self.doubt += u32::from(doubt);
        self.at_triangles += u32::from(at_triangles);
        self.missed += u32::from(!hit && !doubt && !at_triangles);
        self.wrong += u32::from(!doubt && !same);
    }
}

#[test]
fn what_is_certain_in_lanes_is_what_one_ray_meets() {
    for size in [1.0, 555.0, 1e-4, 3e7] {
        let shapes = room_with_bowl(size);
        let few = few(&shapes).expect("few shapes");
        let all = levels()
            .into_iter()
            .map(|level| count(&few, &shapes, size, level, 1500));
        let all: Vec<[Count; 2]> = all.collect();
        let [first, any] = &all[0];
        assert_eq!(
            (first.wrong, any.wrong),
            (0, 0),
            "{size}: {first:?} {any:?}"
        );
        // A fifth of the rays are aimed at edges, and an eighth end on a surface.
        assert!(
            first.hit > 10_000 && first.missed > 100 && first.doubt > 1000,
            "{first:?}"
        );
        assert!(any.hit > 10_000 && any.doubt < 10_000, "{any:?}");
        // Most of the rays miss the bowl, or its box, or meet something before.
        let asked = first.at_triangles;
        assert!(asked > 3000 && asked < 14_000, "{first:?}");
        assert!(all.iter().all(|counts| counts == &all[0]), "{all:?}");
    }
}

#[test]
fn few_rays_leave_a_doubt() {
    let shapes = room(1.0);
    let few = few(&shapes).expect("few shapes");
    let mut doubts = 0;
    for i in 0..2000 {
        let mut numbers = numbers(12, i);
        let (mut origin, mut direction, mut from) =
            (Row3::default(), Row3::default(), WordRow::default());
        for lane in 0..LANES {
            let id = (numbers.one() * 8.0) as usize;
            let ray =
                surface_of(&shapes[id], numbers.two()).spawn(warps::sample_sphere(numbers.two()));
            origin.set_lane(lane, ray.origin);
            direction.set_lane(lane, ray.direction);
            from.0[lane] = id as u32;
        }
        doubts += dispatch!(Level::new(), s => {
            let rays = Rays {
                origin: origin.get(s),
                direction: direction.get(s),
                t_max: floats(s, f32::MAX),
                from: from.get(s),
            };
            bits(few.intersect(s, &rays).doubt).count_ones()
        });
    }
    assert!(doubts < 32, "{doubts} of 32000");
}

#[test]
fn without_a_bound_on_roundings_lanes_go_wrong() {
    let shapes = room(555.0);
    let mut few = few(&shapes).expect("few shapes");
    for quad in &mut few.quads {
        quad.be_rash();
    }
    let [first, any] = count(&few, &shapes, 555.0, Level::new(), 1500);
    assert!(first.wrong > 100 && any.wrong > 10, "{first:?} {any:?}");
}

#[test]
fn with_too_small_a_box_triangles_are_missed() {
    let shapes = room_with_bowl(1.0);
    let mut few = few(&shapes).expect("few shapes");
    few.triangles = few.triangles.map(|b| Aabb {
        max: b.max - Vec3::Y * 0.02,
        ..b
    });
    let [first, any] = count(&few, &shapes, 1.0, Level::new(), 1500);
    assert!(first.wrong > 0 && any.wrong > 0, "{first:?} {any:?}");
}

#[test]
fn what_is_not_few_or_is_of_no_common_size_is_for_the_tree() {
    let one = room(1.0);
    let many: Vec<Shape> = one.iter().cycle().take(65).copied().collect();
    assert!(few(&many[..64]).is_some());
    assert!(few(&many).is_none());
    let bowl = room_with_bowl(1.0);
    assert!(bowl.len() > 64 && few(&bowl).is_some());
    assert!(few(&room(1e10)).is_none());
    assert!(few(&room(1e-12)).is_none());
}
