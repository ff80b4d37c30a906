//! Pictures of the scene's geometry instead of its light: the first thing to look at when a
//! picture is wrong.

use super::{Entry, Integrator};
use crate::color::Rgb;
use crate::geometry::Ray;
use crate::sampling::stream::Stream;
use crate::scene::Tracer;

/// The normal at the first hit: `0.5 + 0.5 n` in the channels, black where there is nothing.
///
/// Normals are those of the shape's front, so a wall that faces away shows at once.
#[derive(Clone, Copy, Debug)]
pub struct Normals;

impl Normals {
    /// Its row of the table.
    pub const ENTRY: Entry = Entry::of_geometry(
        [
            "normals",
            "the normal at the first hit",
            "Debugging view: the normal at the first hit, as colour",
        ],
        Some(1.0),
        |_| Box::new(Normals),
    );
}

impl Integrator for Normals {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, _: &Stream) -> Rgb {
        match tracer.camera_ray(ray) {
            Some(hit) => Rgb::from((hit.surface.n * 0.5 + 0.5).to_array()),
            None => Rgb::BLACK,
        }
    }
}

/// The share of light that the first hit sends back; black for surfaces that only emit.
#[derive(Clone, Copy, Debug)]
pub struct Albedo;

impl Albedo {
    /// Its row of the table.
    pub const ENTRY: Entry = Entry::of_geometry(
        [
            "albedo",
            "the share of light the first hit sends back",
            "Debugging view: the share of light the first hit sends back",
        ],
        Some(1.0),
        |_| Box::new(Albedo),
    );
}

impl Integrator for Albedo {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, _: &Stream) -> Rgb {
        tracer
            .camera_ray(ray)
            .and_then(|hit| hit.bsdf)
            .map_or(Rgb::BLACK, |bsdf| bsdf.albedo())
    }
}

/// The distance to the first hit in scene units; 0 where there is nothing.
#[derive(Clone, Copy, Debug)]
pub struct Depth;

impl Depth {
    /// Its row of the table.
    pub const ENTRY: Entry = Entry::of_geometry(
        [
            "depth",
            "the distance to the first hit",
            "Debugging view: the distance to the first hit (white is the farthest)",
        ],
        None,
        |_| Box::new(Depth),
    );
}

impl Integrator for Depth {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, _: &Stream) -> Rgb {
        tracer
            .camera_ray(ray)
            .map_or(Rgb::BLACK, |hit| Rgb::grey(hit.t))
    }
}
