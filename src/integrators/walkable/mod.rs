//! What a path needs of a world, in either dimension.
//!
//! A walk follows rays, picks up what surfaces emit, scatters, and may aim at lamps. Written
//! against this trait, it runs in flatland and in space from the same lines.

mod flat;
mod solid;

pub use flat::{FlatPoint, FlatWalk};
pub use solid::SolidPoint;

use crate::color::Rgb;
use crate::sampling::stream::Stream;
use crate::space::{Ray, Space};

/// A world one can walk in.
pub trait Walkable<S: Space> {
    /// A point of a surface, as seen along the ray that met it.
    type Point: Copy;

    /// What the ray meets first; `segment` is its number in the path, 1 from the eye.
    fn follow(&mut self, ray: &Ray<S>, segment: u32) -> Option<Self::Point>;

    /// Radiance that arrives along a ray by itself: what the surface it met emits towards it, or
    /// what comes from beyond everything.
    fn arriving(&self, ray: &Ray<S>, met: Option<&Self::Point>) -> Rgb;

    /// Draws how a path goes on from a surface; `None` where it ends.
    fn scatter(&self, at: &Self::Point, place: u64, stream: &Stream) -> Option<Step<S>>;

    /// How many lamps one can aim at.
    fn lamps(&self) -> usize;

    /// Draws a point of a lamp and sends a shadow ray; `None` where no light comes of it.
    fn aim(&mut self, at: &Self::Point, lamp: usize, place: u64, stream: &Stream) -> Option<Aimed>;

    /// The density with which [`Walkable::aim`] from `from` draws the direction of `ray`, at the
    /// lamp that the ray met, or beyond everything; 0 where nobody aims.
    fn pdf_aim(&self, from: &Self::Point, ray: &Ray<S>, met: Option<&Self::Point>) -> f32;
}

/// The light of all lamps that a surface scatters back: one shadow ray to each.
pub fn ask_all<S: Space, W: Walkable<S>>(
    world: &mut W,
    at: &W::Point,
    place: u64,
    stream: &Stream,
) -> Rgb {
    (0..world.lamps())
        .filter_map(|lamp| world.aim(at, lamp, place, stream))
        .map(|aimed| aimed.light)
        .sum()
}

/// How a path goes on.
#[derive(Clone, Copy, Debug)]
pub struct Step<S: Space> {
    /// The next ray.
    pub ray: Ray<S>,
    /// `f cos / pdf`, the share of the next ray's radiance that goes on along this one.
    pub weight: Rgb,
    /// The density of its direction, per radian or steradian; `None` for a perfectly specular one.
    pub pdf: Option<f32>,
}

/// Light that came from a lamp by aiming at it.
#[derive(Clone, Copy, Debug)]
pub struct Aimed {
    /// `f li cos / pdf`: the estimate of the lamp's light that is scattered back along the ray.
    pub light: Rgb,
    /// The density of its direction; `None` for a lamp without extent.
    pub pdf: Option<f32>,
    /// The density with which [`Walkable::scatter`] would have drawn that direction.
    pub pdf_scatter: f32,
}
