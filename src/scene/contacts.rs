//! Surfaces within rounding of each other, one of which shines.
//!
//! A lamp may lie in the plane of a ceiling, or two lamps in one place. Which of them a ray meets
//! first would be decided by the last bit of a distance or by the order of the file, and a shadow
//! ray, which ends just before its lamp, would not notice. Here one rule decides for both:
//!
//! * what is in front by more than the rounding of the lamp's own points is in front;
//! * otherwise the lamp that shines towards the ray is met, and of several the first in the file.
//!
//! Scenes without such places pay one branch for each ray.

use super::Object;
use super::interaction::Hit;
use crate::geometry::{Aabb, Intersection, PreparedRay, Ray, Shape, Surface};
use glam::{DVec3, Vec3};

/// Surfaces so near to a lamp, as a share of the scene's diameter, are looked at closely: far more
/// than roundings of distances and the length that a shadow ray leaves out.
pub(super) const NEAR: f64 = 1.0 / (1 << 18) as f64;
/// The least cosine between the normals of surfaces that lie within each other's rounding in more
/// than a strip.
const PARALLEL: f64 = 0.999;
/// Polygons overlap where they do so by more than this share of their size: neighbours in a mesh,
/// which share an edge, do not.
const OVERLAP: f64 = 1e-5;

/// Lamps and what lies within rounding of them.
#[derive(Clone, Debug)]
pub(super) struct Contacts {
    /// For each shape its place among `all`; [`NONE`] for nearly all of them.
    places: Vec<u32>,
    all: Vec<Contested>,
    /// For each light its first shape.
    first_of_light: Vec<Option<u32>>,
}

const NONE: u32 = u32::MAX;

/// A shape that lies within rounding of others.
#[derive(Clone, Debug)]
struct Contested {
    shape: Placed,
    /// The number of the shape.
    id: u32,
    /// Places of the others; one of the two is a lamp.
    others: Vec<u32>,
}

/// A shape of an object, with its way while the shutter is open.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    pub(super) shape: Shape,
    pub(super) span: Vec3,
    pub(super) object: u32,
}

impl Placed {
    fn at(&self, time: f32) -> Shape {
        if self.span == Vec3::ZERO {
            self.shape
        } else {
            self.shape.moved(self.span * time)
        }
    }

    fn bounds(&self) -> Aabb {
        self.at(0.0).bounds().union(self.at(1.0).bounds())
    }
}

/// A shape as a ray crosses it.
struct Crossed {
    place: u32,
    intersection: Intersection,
    surface: Surface,
    /// Where, in `f64`.
    p: DVec3,
    shape: Shape,
}

impl Contacts {
    /// The contacts among shapes, each with its number; `None` where there are none.
    ///
    /// * `lights`: how many lights there are.
    pub(super) fn new(shapes: &[Placed], objects: &[Object], lights: usize) -> Option<Self> {
        let shines = |shape: &Placed| objects[shape.object as usize].light.is_some();
        let bounds: Vec<Aabb> = shapes.iter().map(Placed::bounds).collect();
        let around = bounds.iter().copied().reduce(Aabb::union)?;
        let diameter = (around.max.as_dvec3() - around.min.as_dvec3()).length();
        let near = diameter * NEAR;
        let mut contacts = Contacts {
            places: vec![NONE; shapes.len()],
            all: Vec::new(),
            first_of_light: vec![None; lights],
        };
        sweep(
            &bounds,
            near,
            |i| shines(&shapes[i]),
            |a, b| {
                if touch(&shapes[a], &shapes[b], near) {
                    contacts.add(shapes, a, b);
                }
            },
        );
        for (id, shape) in shapes.iter().enumerate() {
            if let Some(light) = objects[shape.object as usize].light {
                contacts.first_of_light[light as usize].get_or_insert(id as u32);
            }
        }
        (!contacts.all.is_empty()).then_some(contacts)
    }

    fn add(&mut self, shapes: &[Placed], a: usize, b: usize) {
        let [place_a, place_b] = [a, b].map(|id| {
            if self.places[id] == NONE {
                self.places[id] = self.all.len() as u32;
                self.all.push(Contested {
                    shape: shapes[id],
                    id: id as u32,
                    others: Vec::new(),
                });
            }
            self.places[id]
        });
        self.all[place_a as usize].others.push(place_b);
        self.all[place_b as usize].others.push(place_a);
    }

    /// What a ray meets where `hit` is what it seems to meet first.
    #[inline(never)]
    pub(super) fn met(&self, ray: &Ray, hit: Hit, objects: &[Object]) -> Hit {
        let place = self.places.get(hit.shape as usize).copied().unwrap_or(NONE);
        if place == NONE {
            return hit;
        }
        let endless = Ray::new(ray.origin, ray.direction).at_time(ray.time);
        let prepared = PreparedRay::from(&endless);
        let here = &self.all[place as usize];
        let places = std::iter::once(&place).chain(&here.others);
        let crossed = places.filter_map(|place| self.intersect(*place, &endless, &prepared));
        let mut crossed: Vec<Crossed> = crossed.collect();
        crossed.sort_by_key(|c| self.rank(c.place));
        let lamp = crossed.iter().find(|c| {
            self.shines_towards(c, ray, objects)
                && self.light_is_first(c, &endless, &prepared, objects)
        });
        let first = match lamp {
            Some(lamp) => lamp,
            None if !shines(&objects[hit.object as usize], &hit, ray) => return hit,
            // A lamp that something hides.
            None => {
                let along =
                    |c: &&Crossed| (c.p - ray.origin.as_dvec3()).dot(ray.direction.as_dvec3());
                let nearest = crossed.iter().min_by(|a, b| along(a).total_cmp(&along(b)));
                match nearest {
                    Some(nearest) => nearest,
                    None => return hit,
                }
            }
        };
        let contested = &self.all[first.place as usize];
        Hit {
            intersection: first.intersection,
            surface: first.surface,
            object: contested.shape.object,
            shape: contested.id,
        }
    }

    /// True where a shadow ray to a surface of a light, which nothing clearly before it stops, also
    /// meets that surface before all that is within rounding of it.
    #[inline(never)]
    pub(super) fn is_met(
        &self,
        light: usize,
        part: u32,
        shadow_ray: &Ray,
        objects: &[Object],
    ) -> bool {
        let Some(first) = self.first_of_light[light] else {
            return true;
        };
        let place = self.places[(first + part) as usize];
        if place == NONE {
            return true;
        }
        let endless = Ray::new(shadow_ray.origin, shadow_ray.direction).at_time(shadow_ray.time);
        let prepared = PreparedRay::from(&endless);
        match self.intersect(place, &endless, &prepared) {
            Some(lamp) => self.light_is_first(&lamp, &endless, &prepared, objects),
            // Past the rim by a rounding, where there is nothing to compare.
            None => true,
        }
    }

    fn light_is_first(
        &self,
        lamp: &Crossed,
        ray: &Ray,
        prepared: &PreparedRay,
        objects: &[Object],
    ) -> bool {
        let n = lamp.surface.n;
        let towards_origin = -f64::from(n.dot(ray.direction)).signum();
        let rounding = f64::from(n.abs().dot(lamp.surface.error));
        let others = &self.all[lamp.place as usize].others;
        others.iter().all(|&other| {
            let Some(other) = self.intersect(other, ray, prepared) else {
                return true;
            };
            let before = lamp.shape.height(other.p) * towards_origin;
            let wins = before.abs() <= rounding
                && self.rank(other.place) < self.rank(lamp.place)
                && self.shines_towards(&other, ray, objects);
            before <= rounding && !wins
        })
    }

    /// The place in the file.
    fn rank(&self, place: u32) -> (u32, u32) {
        let contested = &self.all[place as usize];
        (contested.shape.object, contested.id)
    }

    fn shines_towards(&self, crossed: &Crossed, ray: &Ray, objects: &[Object]) -> bool {
        let object = &objects[self.all[crossed.place as usize].shape.object as usize];
        object.light.is_some() && object.shines_from(crossed.surface.n, -ray.direction)
    }

    fn intersect(&self, place: u32, ray: &Ray, prepared: &PreparedRay) -> Option<Crossed> {
        let shape = self.all[place as usize].shape.at(ray.time);
        let intersection = shape.intersect(prepared, f32::MAX)?;
        let surface = shape.surface(ray, intersection);
        // The distance is rounded to `f32`; one step along the ray puts the point on the surface.
        let d = ray.direction.as_dvec3();
        let p = ray.origin.as_dvec3() + d * f64::from(intersection.t);
        let step = shape.height(p) / surface.n.as_dvec3().dot(d);
        Some(Crossed {
            place,
            intersection,
            surface,
            p: if step.is_finite() { p - d * step } else { p },
            shape,
        })
    }
}

/// True where a hit is of a light, on a side that shines.
fn shines(object: &Object, hit: &Hit, ray: &Ray) -> bool {
    object.light.is_some() && object.shines_from(hit.surface.n, -ray.direction)
}

/// Calls `meet` with all pairs, at least one of them a lamp, whose boxes are not farther apart than
/// `near` along any axis.
fn sweep(
    bounds: &[Aabb],
    near: f64,
    is_light: impl Fn(usize) -> bool,
    mut meet: impl FnMut(usize, usize),
) {
    let low = |i: usize, axis: usize| f64::from(bounds[i].min[axis]) - near;
    let high = |i: usize, axis: usize| f64::from(bounds[i].max[axis]);
    let overlap = |a: usize, b: usize| {
        (0..3).all(|axis| low(a, axis) <= high(b, axis) && low(b, axis) <= high(a, axis))
    };
    let mut order: Vec<usize> = (0..bounds.len())
        .filter(|&i| bounds[i].is_finite())
        .collect();
    order.sort_by(|&a, &b| low(a, 0).total_cmp(&low(b, 0)));
    let (mut lamps, mut others): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
    for i in order {
        lamps.retain(|&lamp| high(lamp, 0) >= low(i, 0));
        lamps
            .iter()
            .filter(|&&l| overlap(l, i))
            .for_each(|&l| meet(l, i));
        if is_light(i) {
            others.retain(|&other| high(other, 0) >= low(i, 0));
            others
                .iter()
                .filter(|&&o| overlap(o, i))
                .for_each(|&o| meet(i, o));
            lamps.push(i);
        } else {
            others.push(i);
        }
    }
}

/// True where two shapes may lie within rounding of each other in more than a line.
fn touch(a: &Placed, b: &Placed, near: f64) -> bool {
    let apart = a.span != b.span;
    match (&a.shape, &b.shape) {
        (Shape::Sphere(s), Shape::Sphere(t)) => {
            let between = (s.center.as_dvec3() - t.center.as_dvec3()).length();
            let radii = f64::from(s.radius) - f64::from(t.radius);
            radii.abs() <= near && (apart || between <= near)
        }
        (Shape::Sphere(_), _) | (_, Shape::Sphere(_)) => false,
        _ => {
            let (p, q) = (corners(&a.shape), corners(&b.shape));
            let (m, n) = (normal(&p), normal(&q));
            m.dot(n).abs() >= PARALLEL
                && (apart
                    || (level(&p, &b.shape, near) || level(&q, &a.shape, near)) && {
                        let axes = [
                            m.any_orthonormal_vector(),
                            m.cross(m.any_orthonormal_vector()),
                        ];
                        overlap(&flat(&p, axes), &flat(&q, axes))
                    })
        }
    }
}

/// True where some corner is near the plane of a shape, or corners are on both sides.
fn level(corners: &[DVec3], shape: &Shape, near: f64) -> bool {
    let heights = corners.iter().map(|corner| shape.height(*corner));
    let low = heights.clone().fold(f64::INFINITY, f64::min);
    let high = heights.fold(f64::NEG_INFINITY, f64::max);
    low <= near && high >= -near
}

fn corners(shape: &Shape) -> Vec<DVec3> {
    shape.corners().into_iter().map(Vec3::as_dvec3).collect()
}

fn normal(polygon: &[DVec3]) -> DVec3 {
    match *polygon {
        [a, b, c, ..] => (b - a).cross(c - a).normalize_or_zero(),
        _ => DVec3::ZERO,
    }
}

fn flat(polygon: &[DVec3], axes: [DVec3; 2]) -> Vec<[f64; 2]> {
    polygon
        .iter()
        .map(|p| axes.map(|axis| axis.dot(*p)))
        .collect()
}

/// True where two convex polygons overlap in an area: no edge of either has them on different sides.
fn overlap(p: &[[f64; 2]], q: &[[f64; 2]]) -> bool {
    let edges = |polygon: &[[f64; 2]]| {
        let next = polygon.iter().cycle().skip(1);
        let edge = |(a, b): (&[f64; 2], &[f64; 2])| [b[1] - a[1], a[0] - b[0]];
        polygon.iter().zip(next).map(edge).collect::<Vec<_>>()
    };
    let range = |polygon: &[[f64; 2]], axis: [f64; 2]| {
        let along = polygon.iter().map(|p| p[0] * axis[0] + p[1] * axis[1]);
        let low = along.clone().fold(f64::INFINITY, f64::min);
        (low, along.fold(f64::NEG_INFINITY, f64::max))
    };
    edges(p).into_iter().chain(edges(q)).all(|axis| {
        let ((low_p, high_p), (low_q, high_q)) = (range(p, axis), range(q, axis));
        let common = high_p.min(high_q) - low_p.max(low_q);
        common > OVERLAP * (high_p - low_p).min(high_q - low_q)
    })
}
