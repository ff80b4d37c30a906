//! Solids that a scene file probably does not mean: inside out, or sharing a face with another.

use super::Object;
use crate::geometry::{Aabb, Shape};
use glam::{DVec2, DVec3, Vec3, Vec3Swizzles};
use std::collections::HashMap;

/// The bits of a point; zeros of both signs are one place.
fn place(p: Vec3) -> [u32; 3] {
    p.to_array().map(|x| (x + 0.0).to_bits())
}

/// A set of faces that hang together.
#[derive(Clone, Default)]
struct Piece {
    corners: Vec<Vec3>,
    /// Six times the volume that it encloses, negative where its faces look inwards.
    volume: f64,
    /// For each edge how much more often it runs one way than the other: nowhere, if it is closed.
    balance: HashMap<[u32; 2], i32>,
}

/// True where a closed piece of some faces looks inwards and lies in no other, whose cavity it may
/// be.
pub(super) fn inside_out(shapes: &[Shape]) -> bool {
    let faces: Vec<Vec<Vec3>> = shapes.iter().map(Shape::corners).collect();
    let mut numbers = HashMap::new();
    let mut parent: Vec<usize> = Vec::new();
    let mut ids: Vec<Vec<usize>> = Vec::new();
    for face in &faces {
        let face: Vec<usize> = face
            .iter()
            .map(|p| {
                let next = numbers.len();
                *numbers.entry(place(*p)).or_insert(next)
            })
            .collect();
        parent.extend(parent.len()..numbers.len());
        for pair in face.windows(2) {
            let [a, b] = [pair[0], pair[1]].map(|i| root(&mut parent, i));
            parent[a] = b;
        }
        ids.push(face);
    }
    let mut pieces: HashMap<usize, Piece> = HashMap::new();
    for (face, ids) in faces.iter().zip(&ids) {
        let Some(first) = ids.first() else {
            continue;
        };
        let piece = pieces.entry(root(&mut parent, *first)).or_default();
        piece.corners.extend(face);
        // Counted from a corner of its own: far from the origin nothing cancels.
        let origin = piece.corners[0].as_dvec3();
        let from = |i: usize| face[i].as_dvec3() - origin;
        for i in 1..face.len() - 1 {
            piece.volume += from(0).dot(from(i).cross(from(i + 1)));
        }
        for (i, a) in ids.iter().enumerate() {
            let (a, b) = (*a as u32, ids[(i + 1) % ids.len()] as u32);
            *piece.balance.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
        }
    }
    let closed = pieces
        .values()
        .filter(|p| p.balance.values().all(|b| *b == 0));
    let (inwards, outwards): (Vec<&Piece>, Vec<&Piece>) = closed.partition(|p| p.volume < 0.0);
    let bounds = |piece: &Piece| Aabb::of(piece.corners.iter().copied());
    let around: Vec<Aabb> = outwards.into_iter().map(bounds).collect();
    inwards.into_iter().map(bounds).any(|inner| {
        let holds = |o: &Aabb| o.min.cmple(inner.min).all() && o.max.cmpge(inner.max).all();
        !around.iter().any(holds)
    })
}

/// The piece that a corner belongs to.
fn root(parent: &mut [usize], mut i: usize) -> usize {
    while parent[i] != i {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    i
}

/// A plane face, or a whole sphere, of something that refracts.
struct Face {
    corners: Vec<DVec3>,
    normal: DVec3,
    /// The middle and the radius of a sphere.
    sphere: Option<(DVec3, f64)>,
    bounds: Aabb,
    /// So far apart surfaces are in one place.
    close: f64,
}

/// A surface within so many steps from one number to the next is in the same place.
const STEPS: f64 = 8.0;
/// With more pairs of faces than this between two objects the rest is not looked at.
const MOST_PAIRS: usize = 1 << 21;

impl Face {
    fn new(shape: &Shape) -> Self {
        let corners: Vec<DVec3> = shape.corners().iter().map(|c| c.as_dvec3()).collect();
        let normal = match corners.as_slice() {
            &[a, b, c, ..] => (b - a).cross(c - a).normalize_or_zero(),
            _ => DVec3::ZERO,
        };
        let bounds = shape.bounds();
        let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
        Face {
            corners,
            normal,
            sphere: match shape {
                Shape::Sphere(s) => Some((s.center.as_dvec3(), f64::from(s.radius))),
                _ => None,
            },
            bounds,
            close: STEPS * f64::from(largest.next_up() - largest),
        }
    }

    /// True where both are in one place over some area.
    fn coincides(&self, other: &Face) -> bool {
        let close = self.close.max(other.close);
        match (self.sphere, other.sphere) {
            (Some((c, r)), Some((d, s))) => return c.distance(d) + (r - s).abs() <= close,
            (None, None) => {}
            _ => return false,
        }
        let lies_in = |a: &Face, b: &Face| {
            let distance = |p: &DVec3| b.normal.dot(*p - b.corners[0]).abs();
            a.corners.iter().all(|p| distance(p) <= close)
        };
        (lies_in(self, other) || lies_in(other, self)) && self.overlaps(other, 2.0 * close)
    }

    /// True where no line parts two polygons of one plane: separating axes, with some `room`.
    fn overlaps(&self, other: &Face, room: f64) -> bool {
        let normal = self.normal.abs();
        let flat = |p: &DVec3| -> DVec2 {
            if normal.x >= normal.y && normal.x >= normal.z {
                p.yz()
            } else if normal.y >= normal.z {
                p.xz()
            } else {
                p.xy()
            }
        };
        let [a, b] = [self, other].map(|f| f.corners.iter().map(flat).collect::<Vec<DVec2>>());
        let parts = |line: DVec2| {
            let reach = |all: &[DVec2]| {
                let along = all.iter().map(|p| p.dot(line));
                along.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], x| {
                    [l.min(x), h.max(x)]
                })
            };
            let ([a, b], [c, d]) = (reach(&a), reach(&b));
            b.min(d) - a.max(c) <= room
        };
        let sides = |all: &[DVec2]| {
            let next = all.iter().cycle().skip(1);
            let across = all
                .iter()
                .zip(next)
                .map(|(p, q)| (*q - *p).perp().normalize_or_zero());
            across.collect::<Vec<DVec2>>()
        };
        !sides(&a).into_iter().chain(sides(&b)).any(parts)
    }
}

/// True where the boxes meet, widened by `close`.
fn meet(a: &Aabb, b: &Aabb, close: f64) -> bool {
    let close = Vec3::splat(close as f32);
    (a.min - close).cmple(b.max).all() && (b.min - close).cmple(a.max).all()
}

/// Pairs of objects that refract and have a face, or part of one, in the same place; an object that
/// has two such faces is a pair with itself.
pub(super) fn touching(all: &[(Shape, u32)], objects: &[Object], spans: &[Vec3]) -> Vec<[u32; 2]> {
    let mut solids: Vec<(u32, Vec<Face>)> = Vec::new();
    let mut found = Vec::new();
    let mut rest = all;
    while let Some((_, object)) = rest.first() {
        let count = rest.iter().take_while(|(_, o)| o == object).count();
        let (its, others) = rest.split_at(count);
        rest = others;
        let material = objects[*object as usize].material.as_ref();
        if material.is_some_and(|m| m.brightest().refracts()) {
            if has_twins(its) {
                found.push([*object; 2]);
            }
            let faces = its.iter().map(|(shape, _)| Face::new(shape)).collect();
            solids.push((*object, faces));
        }
    }
    for (i, (a, faces)) in solids.iter().enumerate() {
        for (b, others) in &solids[i + 1..] {
            if spans[*a as usize] == spans[*b as usize] && share_a_face(faces, others) {
                found.push([*a, *b]);
            }
        }
    }
    found
}

/// True where two faces have the same corners.
fn has_twins(shapes: &[(Shape, u32)]) -> bool {
    let mut seen = std::collections::HashSet::new();
    let faces = shapes
        .iter()
        .map(|(shape, _)| shape.corners())
        .filter(|c| !c.is_empty());
    faces.into_iter().any(|face| {
        let mut key: Vec<[u32; 3]> = face.into_iter().map(place).collect();
        key.sort_unstable();
        !seen.insert(key)
    })
}

fn share_a_face(a: &[Face], b: &[Face]) -> bool {
    let whole = |faces: &[Face]| faces.iter().map(|f| f.bounds).reduce(Aabb::union);
    let close = |faces: &[Face]| faces.iter().map(|f| f.close).fold(0.0, f64::max);
    let close = close(a).max(close(b));
    let (Some(box_a), Some(box_b)) = (whole(a), whole(b)) else {
        return false;
    };
    if !meet(&box_a, &box_b, close) {
        return false;
    }
    let near = |faces: &'_ [Face], other: &Aabb| -> Vec<usize> {
        let near = |i: &usize| meet(&faces[*i].bounds, other, close);
        let mut near: Vec<usize> = (0..faces.len()).filter(near).collect();
        near.sort_by(|i, j| faces[*i].bounds.min.x.total_cmp(&faces[*j].bounds.min.x));
        near
    };
    let (near_a, near_b) = (near(a, &box_b), near(b, &box_a));
    let mut looks = 0;
    for i in near_a {
        let face = &a[i];
        let reach = face.bounds.max.x + close as f32;
        for &j in near_b.iter().take_while(|j| b[**j].bounds.min.x <= reach) {
            looks += 1;
            if looks > MOST_PAIRS {
                return false;
            }
            if meet(&face.bounds, &b[j].bounds, close) && face.coincides(&b[j]) {
                return true;
            }
        }
    }
    false
}
