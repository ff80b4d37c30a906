//! What focuses light: balls around the surfaces with perfectly specular parts.

use super::Object;
use super::contacts::Placed;
use super::motion::PlacedInstance;
use crate::geometry::{Primitive, Shape};
use crate::lights::{BoundingSphere, Targets};
use glam::Vec3;
use std::collections::BTreeMap;

/// With more objects than this one ball is around all of them.
const MOST: usize = 8;

/// A ball around each object that mirrors or refracts some light perfectly, wherever it is while the shutter is
/// open: light that passes all of them is not focused.
///
/// * `placed`: all shapes but those of instances.
pub(super) fn targets(
    objects: &[Object],
    placed: &[Placed],
    instances: &[PlacedInstance],
) -> Targets {
    let focuses = |id: u32| {
        let material = objects[id as usize].material.as_ref();
        material.is_some_and(|material| material.brightest().is_specular())
    };
    let mut parts: BTreeMap<u32, Vec<BoundingSphere>> = BTreeMap::new();
    for part in placed.iter().filter(|part| focuses(part.object)) {
        let all = parts.entry(part.object).or_default();
        for by in [Vec3::ZERO, part.span] {
            all.extend(balls(&part.shape.moved(by)));
        }
    }
    for placed in instances.iter().filter(|placed| focuses(placed.object)) {
        let all = parts.entry(placed.object).or_default();
        match &placed.mesh {
            Some(_) => all.extend(placed.triangles().flat_map(|t| balls(&Shape::Triangle(t)))),
            None => all.push(BoundingSphere::of(placed.instance.bounds())),
        }
    }
    let objects: Vec<BoundingSphere> = parts
        .values()
        .filter_map(|parts| BoundingSphere::around(parts))
        .collect();
    Targets::new(match objects.len() > MOST {
        true => BoundingSphere::around(&objects).into_iter().collect(),
        false => objects,
    })
}

/// Balls whose convex hull holds a shape: its corners, or itself.
fn balls(shape: &Shape) -> Vec<BoundingSphere> {
    let point = |center| BoundingSphere {
        center,
        radius: 0.0,
    };
    match shape {
        Shape::Sphere(s) => vec![BoundingSphere {
            center: s.center,
            radius: s.radius,
        }],
        Shape::Quad(_) | Shape::Triangle(_) => shape.corners().into_iter().map(point).collect(),
    }
}
