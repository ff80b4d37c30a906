//! What a ray met, once and for all.

use super::Object;
use crate::color::Rgb;
use crate::geometry::{Intersection, Ray, Surface};
use crate::materials::Bsdf;
use crate::sampling::frame::Frame;
use glam::Vec3;

/// A point of a surface, as the ray sees it that hit it.
#[derive(Clone, Copy, Debug)]
pub struct Interaction<'a> {
    /// Distance along the ray.
    pub t: f32,
    /// The point, its error bound, its normal and the moment.
    pub surface: Surface,
    /// Local axes around the normal.
    pub frame: Frame,
    /// The unit direction from which the ray came, in local coordinates.
    pub wo: Vec3,
    /// The same in world coordinates.
    pub back: Vec3,
    /// The BSDF at the point; `None` where all light is absorbed.
    pub bsdf: Option<Bsdf<'a>>,
    /// Radiance that the point itself emits towards `wo`.
    pub emission: Rgb,
    /// The object it belongs to.
    pub object: &'a Object,
    /// The number of its shape, as [`Scene::facets`](super::Scene::facets) counts; instances of one
    /// mesh share numbers beyond all of these.
    pub shape: u32,
}

/// A hit that nobody has looked at yet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hit {
    /// Where on the ray and on the shape.
    pub(super) intersection: Intersection,
    pub(super) surface: Surface,
    /// The index of the object.
    pub(super) object: u32,
    /// The number of its shape: those that stand still come first.
    pub(super) shape: u32,
}

impl<'a> Interaction<'a> {
    #[inline]
    pub(super) fn new(objects: &'a [Object], ray: &Ray, hit: &Hit) -> Self {
        let object = &objects[hit.object as usize];
        let back = -ray.direction;
        let frame = Frame::new(hit.surface.n);
        let uv = || object.mapping.uv(hit);
        Interaction {
            t: hit.intersection.t,
            surface: hit.surface,
            frame,
            wo: frame.to_local(back),
            back,
            bsdf: object.material.as_ref().map(|m| m.bsdf(uv)),
            emission: if object.shines_from(hit.surface.n, back) {
                object.emission.at(uv)
            } else {
                Rgb::BLACK
            },
            object,
            shape: hit.shape,
        }
    }
}
