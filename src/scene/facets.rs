//! The shapes of a scene one by one, for those who look at surfaces and not along rays.

use super::{Mapping, Object, Scene};
use crate::color::Rgb;
use crate::geometry::Shape;
use crate::materials::Bsdf;
use glam::Vec3;

/// A shape that stands still, with the object it belongs to.
#[derive(Clone, Copy, Debug)]
pub struct Facet<'a> {
    /// Its number: [`Interaction::shape`](super::Interaction::shape) of a ray that hits it.
    pub number: u32,
    /// Where it is, relative to the camera.
    pub shape: Shape,
    /// What all points of its object have in common.
    pub object: &'a Object,
}

impl Scene {
    /// The shapes that stand still, in the order of their numbers, which is that of the file. Instances
    /// of a mesh that several objects share are not among them, nor is what moves.
    pub fn facets(&self) -> Vec<Facet<'_>> {
        let mut facets: Vec<Facet> = self
            .bvh
            .shapes()
            .map(|(number, shape)| Facet {
                number,
                shape,
                object: &self.objects[self.object_of_shape[number as usize] as usize],
            })
            .collect();
        facets.sort_by_key(|facet| facet.number);
        facets
    }

    /// True where some shapes are stored once for several objects, or are one's own.
    pub fn has_instances(&self) -> bool {
        self.report.instances > 0
    }
}

impl Facet<'_> {
    /// The share of light that it scatters ideally diffusely at a place, on either side; black where
    /// it does so not at all.
    ///
    /// * `place`: the coordinates on a quad or triangle, as in
    ///   [`Intersection`](crate::geometry::Intersection).
    pub fn diffuse_albedo(&self, place: [f32; 2]) -> Rgb {
        let Some(material) = &self.object.material else {
            return Rgb::BLACK;
        };
        match material.bsdf(|| self.uv(place)) {
            Bsdf::Lambert(lambert) => lambert.albedo,
            Bsdf::Mixture(mixture) => mixture.kd,
            _ => Rgb::BLACK,
        }
    }

    /// True where it scatters light ideally diffusely anywhere.
    pub fn scatters_diffusely(&self) -> bool {
        let material = self.object.material.as_ref();
        match material.map(|material| material.brightest()) {
            Some(Bsdf::Lambert(lambert)) => !lambert.albedo.is_black(),
            Some(Bsdf::Mixture(mixture)) => !mixture.kd.is_black(),
            _ => false,
        }
    }

    /// The radiance that it emits at a place, on the sides that shine.
    pub fn emission(&self, place: [f32; 2]) -> Rgb {
        self.object.emission.at(|| self.uv(place))
    }

    fn uv(&self, place: [f32; 2]) -> glam::Vec2 {
        let mapping = &self.object.mapping;
        let part = match mapping {
            Mapping::Flat { first, .. } => self.number - first,
            Mapping::Sphere { .. } => 0,
        };
        mapping.at(part, place, Vec3::Z)
    }
}
