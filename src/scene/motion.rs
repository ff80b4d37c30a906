//! Shapes that are not simply where they are: what moves while the shutter is open, and instances.

use super::Object;
use super::contacts::Placed;
use super::field::{Checked, check};
use super::value::Triple;
use crate::geometry::{Bvh, Instance, Moving, Shape, SharedMesh, Transformed, Triangle};
use glam::{DVec3, Vec3};
use std::sync::Arc;

/// How an object moves while the shutter is open.
pub(super) struct Way {
    /// Where it is when the shutter opens, from where it stands at time 0.
    pub start: DVec3,
    /// From there to where it is when the shutter closes; zero for what stands still.
    pub span: Vec3,
}

impl Way {
    /// The way of an object that moves by `motion` in each unit of time.
    pub(super) fn new([open, close]: [f64; 2], motion: Triple) -> Checked<Self> {
        let motion = motion.get()?;
        let start = motion * open;
        let span = (motion * (close - open)).as_vec3();
        let near = start.as_vec3().is_finite() && span.is_finite();
        check(near, TOO_FAR).map(|()| Way { start, span })
    }

    /// A complaint where one of the shapes leaves the numbers on this way.
    pub(super) fn check(&self, shapes: &[Shape]) -> Checked<()> {
        let stays = |shape: &Shape| Moving::new(*shape, self.span).is_some();
        check(self.span == Vec3::ZERO || shapes.iter().all(stays), TOO_FAR)
    }
}

const TOO_FAR: &str = "must keep the object within 3.4e38 of the camera while the shutter is open";

/// A shape that was put in its place by a transformation.
pub(super) struct PlacedInstance {
    pub instance: Instance,
    /// What it is, if it is a mesh.
    pub mesh: Option<Arc<SharedMesh>>,
    pub object: u32,
}

impl PlacedInstance {
    /// Its triangles in the world, if it is a mesh.
    pub(super) fn triangles(&self) -> impl Iterator<Item = Triangle> {
        let all = self.mesh.iter().flat_map(|mesh| mesh.triangles());
        all.map(|t| self.instance.placed(t))
    }

    /// How many shapes it stands for.
    pub(super) fn shapes(&self) -> usize {
        self.mesh.as_ref().map_or(1, |mesh| mesh.triangles().len())
    }
}

/// Shapes in motion, with the lights that move with them, and instances of meshes. Time runs from 0, where
/// the shutter opens, to 1, where it closes.
#[derive(Clone, Debug)]
pub(super) struct TransformedShapes {
    pub bvh: Bvh<Transformed>,
    /// For each shape of the hierarchy the object it belongs to; those in motion come first.
    pub object_of_shape: Vec<u32>,
    /// Those in motion, where they are when the shutter opens.
    pub moving: Vec<Placed>,
    /// For each light its way while the shutter is open.
    pub span_of_light: Vec<Vec3>,
}

impl TransformedShapes {
    /// True where anything moves.
    pub(super) fn moves(&self) -> bool {
        !self.moving.is_empty()
    }

    /// True where there is nothing.
    pub(super) fn is_empty(&self) -> bool {
        self.object_of_shape.is_empty()
    }

    /// Motion of nothing, beside some lights that stand still.
    pub(super) fn of_nothing(lights: usize) -> TransformedShapes {
        TransformedShapes {
            bvh: Bvh::new(&[]),
            object_of_shape: Vec::new(),
            moving: Vec::new(),
            span_of_light: vec![Vec3::ZERO; lights],
        }
    }
}

/// Parts what is transformed from what simply stands: the shapes that do, and of each its object.
///
/// * `all`: shapes, where they are when the shutter opens, and the objects they belong to.
/// * `spans`: the way of each object while the shutter is open.
/// * `instances`: shapes that a transformation puts in their places.
pub(super) fn part(
    all: Vec<(Shape, u32)>,
    objects: &[Object],
    spans: &[Vec3],
    lights: usize,
    instances: &[PlacedInstance],
) -> (Vec<Shape>, Vec<u32>, Option<TransformedShapes>) {
    let stands = |(_, object): &(Shape, u32)| spans[*object as usize] == Vec3::ZERO;
    let (still, moving): (Vec<_>, Vec<_>) = all.into_iter().partition(stands);
    let (shapes, object_of_shape) = still.into_iter().unzip();
    let moving = moving.into_iter().filter_map(|(shape, object)| {
        let span = spans[object as usize];
        let placed = Placed {
            shape,
            span,
            object,
        };
        Moving::new(shape, span).map(|shape| (Transformed::Moving(shape), placed))
    });
    let (mut primitives, moving): (Vec<_>, Vec<Placed>) = moving.unzip();
    let mut owners: Vec<u32> = moving.iter().map(|shape| shape.object).collect();
    for placed in instances {
        primitives.push(Transformed::Instance(placed.instance.clone()));
        owners.push(placed.object);
    }
    let mut span_of_light = vec![Vec3::ZERO; lights];
    for (object, span) in objects.iter().zip(spans) {
        if let Some(light) = object.light {
            span_of_light[light as usize] = *span;
        }
    }
    let transformed = (!primitives.is_empty()).then(|| TransformedShapes {
        bvh: Bvh::new(&primitives),
        object_of_shape: owners,
        moving,
        span_of_light,
    });
    (shapes, object_of_shape, transformed)
}

/// All shapes by their numbers, those that stand still first.
pub(super) fn placed(
    shapes: &[Shape],
    object_of_shape: &[u32],
    transformed: Option<&TransformedShapes>,
) -> Vec<Placed> {
    let still = shapes.iter().zip(object_of_shape);
    let still = still.map(|(&shape, &object)| Placed {
        shape,
        span: Vec3::ZERO,
        object,
    });
    let moving = transformed.map_or(&[][..], |shapes| &shapes.moving);
    still.chain(moving.iter().copied()).collect()
}
