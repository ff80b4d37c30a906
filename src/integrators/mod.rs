//! The stages of the algorithm, side by side: each a complete answer to "how much light comes
//! along this ray?".
//!
//! | integrator | simulates | by |
//! |---|---|---|
//! | [`Whitted`] | `LD?S*E` | a tree of specular rays, a shadow ray to each lamp |
//! | [`Kajiya`] | `L(S\|G\|D)*E`, lamps with extent and the background | one random walk |
//! | [`Roulette`] | the same, without a depth cut | the walk, which ends by chance |
//! | [`NextEvent`] | the same; of lights without extent `L(D\|G)(S\|G\|D)*E` | the walk, and shadow rays |
//! | [`Distributed`] | the same | `next_event`; every integral can be left out |
//! | [`WhichRay`] | the same | shadow rays, and one ray whose kind is chosen |
//! | [`Combine`] | the same | both, weighted |
//! | [`LightTracer`] | `L((D\|S\|G)*(D\|G))?E` | walks from the lights, connected to the eye |
//! | [`Radiosity`] | `LD*(S\|G)*E` | light solved on patches, looked at by one ray more |
//! | [`Photons`] | `L(D\|S\|G)*E`, blurred | walks from the lights, looked at where they land |
//! | [`Path`] | as `combine` | all of it: the one to use |
//!
//! The walks are written against [`world::World`] and run in flatland, too, photons included. No integrator is
//! a flag of another one. They share the floors below, never each other's lines.

mod asked;
mod blur;
mod caustics;
mod combine;
mod distributed;
mod entry;
mod from_light;
mod kajiya;
mod lanes;
mod light_tracer;
mod next_event;
mod observer;
mod pass;
mod path;
mod photons;
mod prepare;
mod radiosity;
mod roulette;
mod tree;
mod views;
mod which_ray;
mod whitted;
pub mod world;

pub use asked::{ENOUGH, RarelyAsked, rarely_asked};
pub use blur::PhotonBlur;
pub use caustics::Caustics;
pub use combine::{Combine, Shares};
pub use distributed::{Distributed, Integral};
pub use entry::{Entry, Finds, Found, Shows};
pub use from_light::Gain;
pub use kajiya::Kajiya;
pub use lanes::{PathInLanes, PixelSample};
pub use light_tracer::LightTracer;
pub use next_event::NextEvent;
pub use observer::{AllLight, FilteredPath, FromEye, PathFilter, PathObserver};
pub use pass::{Arrival, Pass, Passes, Prepared, Splat, Splats};
pub use path::Path;
pub use photons::Photons;
pub use prepare::{Refused, Settings};
pub use radiosity::Radiosity;
pub use roulette::{Roulette, Survival};
pub use tree::{Met, RayKind, RecordedRay, TreeCount, TreeObserver, TreeRay, TreeRecord};
pub use views::{Albedo, Depth, Normals};
pub use which_ray::WhichRay;
pub use whitted::{Whitted, direct_light};

use crate::color::Rgb;
use crate::geometry::Ray;
use crate::radiosity::Report;
use crate::sampling::stream::Stream;
use crate::scene::{Scene, Tracer};
use crate::space::Solid;
use glam::DVec3;

/// Walks from the eye, in the order in which they are built up.
pub const WALKS: [Entry; 7] = [
    Whitted::ENTRY,
    Kajiya::ENTRY,
    WhichRay::ENTRY,
    Roulette::ENTRY,
    NextEvent::ENTRY,
    Combine::ENTRY,
    Path::ENTRY,
];

/// Integrators of light that find it in other ways.
pub const OTHERS: [Entry; 3] = [LightTracer::ENTRY, Photons::ENTRY, Radiosity::ENTRY];

/// All integrators of light that one can ask for by name: [`WALKS`], then [`OTHERS`].
pub const LADDER: [Entry; WALKS.len() + OTHERS.len()] = {
    let mut all = [Path::ENTRY; WALKS.len() + OTHERS.len()];
    let mut i = 0;
    while i < all.len() {
        all[i] = if i < WALKS.len() {
            WALKS[i]
        } else {
            OTHERS[i - WALKS.len()]
        };
        i += 1;
    }
    all
};

/// Pictures of the geometry that one can ask for by name.
pub const VIEWS: [Entry; 3] = [Normals::ENTRY, Albedo::ENTRY, Depth::ENTRY];

/// The integrator of this name.
pub fn find(name: &str) -> Option<Entry> {
    let mut all = LADDER.into_iter().chain(VIEWS);
    all.find(|entry| entry.name == name)
}

/// An estimate of the light along a camera ray.
pub trait Integrator: Sync {
    /// One sample of the radiance that arrives along `ray`, in W/(m² sr).
    ///
    /// A pure function of its arguments: all randomness comes from `stream`, all rays go through
    /// `tracer`.
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb;

    /// The same samples, many at a time; `None` for integrators and scenes that take them one by one.
    fn in_lanes<'s>(&self, _scene: &'s Scene) -> Option<PathInLanes<'s>> {
        None
    }

    /// What is prepared for each sample of all pixels at once; `None` where the pixels of a scene need nothing of
    /// the kind. Where there is something, [`Integrator::li`] alone is a part of the light.
    fn passes(&self, _scene: &Scene) -> Option<&dyn Passes> {
        None
    }

    /// What it found out about the scene while it was made; `None` for those that did not look.
    fn solved(&self) -> Option<&Report> {
        None
    }

    /// Its photons, whose blur is told apart from its noise; `None` for those without.
    fn photons(&self) -> Option<&Photons> {
        None
    }

    /// The same for the same scene in coordinates whose origin is `by` further, as another camera has
    /// them; `None` where it holds no coordinates.
    fn moved(&self, _by: DVec3) -> Option<Box<dyn Integrator>> {
        None
    }
}

impl<I: Integrator + ?Sized> Integrator for Box<I> {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        (**self).li(tracer, ray, stream)
    }

    fn in_lanes<'s>(&self, scene: &'s Scene) -> Option<PathInLanes<'s>> {
        (**self).in_lanes(scene)
    }

    fn passes(&self, scene: &Scene) -> Option<&dyn Passes> {
        (**self).passes(scene)
    }

    fn solved(&self) -> Option<&Report> {
        (**self).solved()
    }

    fn photons(&self) -> Option<&Photons> {
        (**self).photons()
    }

    fn moved(&self, by: DVec3) -> Option<Box<dyn Integrator>> {
        (**self).moved(by)
    }
}

impl Integrator for Kajiya {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        self.walk::<Solid>(tracer, ray, stream)
    }
}

impl Integrator for Roulette {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        self.walk::<Solid>(tracer, ray, stream)
    }
}

impl Integrator for NextEvent {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        self.walk::<Solid>(tracer, ray, stream)
    }
}

impl Integrator for Combine {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let shares = self.walk::<Solid>(tracer, ray, stream);
        shares.by_chance + shares.by_aiming
    }
}
