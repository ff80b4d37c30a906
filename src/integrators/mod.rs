//! The stages of the algorithm, side by side: each a complete answer to "how much light comes
//! along this ray?".
//!
//! | integrator | simulates | by |
//! |---|---|---|
//! | [`Whitted`] | `LD?S*E` | a tree of specular rays, a shadow ray to each lamp |
//! | [`Kajiya`] | `L(S\|D)*E`, lamps with extent and the background | one random walk |
//! | [`NextEvent`] | the same; of lights without extent `LD(S\|D)*E` | the walk, and shadow rays |
//!
//! No integrator is a flag of another one. They share the floors below, never each other's lines.

mod kajiya;
mod next_event;
mod tree;
mod views;
mod whitted;

pub use kajiya::Kajiya;
pub use next_event::NextEvent;
pub use tree::{Met, RayKind, RecordedRay, TreeCount, TreeRay, TreeRecord, Watch};
pub use views::{Albedo, Depth, Normals};
pub use whitted::{Whitted, direct_light};

use crate::color::Rgb;
use crate::geometry::Ray;
use crate::sampling::stream::Stream;
use crate::scene::Tracer;

/// An estimate of the light along a camera ray.
pub trait Integrator: Sync {
    /// One sample of the radiance that arrives along `ray`, in W/(m² sr).
    ///
    /// A pure function of its arguments: all randomness comes from `stream`, all rays go through
    /// `tracer`.
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb;
}
