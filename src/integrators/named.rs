//! The integrators one can ask for by name.

use super::{Combine, Integrator, Kajiya, NextEvent, Path, Roulette, Survival, WhichRay, Whitted};
use crate::color::Rgb;
use crate::geometry::Ray;
use crate::materials::Choice;
use crate::sampling::mis::Heuristic;
use crate::sampling::stream::Stream;
use crate::scene::Tracer;

/// The name of an integrator that estimates radiance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Named {
    /// [`Whitted`].
    Whitted,
    /// [`Kajiya`].
    Kajiya,
    /// [`WhichRay`], whose choice follows the mean of the shares.
    WhichRay,
    /// [`Roulette`], which survives by its throughput.
    Roulette,
    /// [`NextEvent`].
    NextEvent,
    /// [`Combine`] by the power heuristic.
    Combine,
    /// [`Path`].
    Path,
}

/// An integrator with its settings.
#[derive(Clone, Copy, Debug)]
pub enum Chosen {
    /// See [`Named::Whitted`].
    Whitted(Whitted),
    /// See [`Named::Kajiya`].
    Kajiya(Kajiya),
    /// See [`Named::WhichRay`].
    WhichRay(WhichRay),
    /// See [`Named::Roulette`].
    Roulette(Roulette),
    /// See [`Named::NextEvent`].
    NextEvent(NextEvent),
    /// See [`Named::Combine`].
    Combine(Combine),
    /// See [`Named::Path`].
    Path(Path),
}

impl Named {
    /// All of them, in the order of the ladder.
    pub const ALL: [Named; 7] = [
        Named::Whitted,
        Named::Kajiya,
        Named::WhichRay,
        Named::Roulette,
        Named::NextEvent,
        Named::Combine,
        Named::Path,
    ];

    /// How it is written.
    pub fn name(self) -> &'static str {
        match self {
            Named::Whitted => "whitted",
            Named::Kajiya => "kajiya",
            Named::WhichRay => "which-ray",
            Named::Roulette => "roulette",
            Named::NextEvent => "next-event",
            Named::Combine => "combine",
            Named::Path => "path",
        }
    }

    /// The integrator whose paths have at most `max_depth` segments. The tree of `whitted` ends at
    /// [`Whitted::MAX_DEPTH`] at the latest, and `roulette` by chance alone.
    pub fn with(self, max_depth: u32) -> Chosen {
        match self {
            Named::Whitted => Chosen::Whitted(Whitted {
                max_depth: max_depth.min(Whitted::MAX_DEPTH),
            }),
            Named::Kajiya => Chosen::Kajiya(Kajiya { max_depth }),
            Named::WhichRay => Chosen::WhichRay(WhichRay {
                max_depth,
                choice: Choice::ByMean,
            }),
            Named::Roulette => Chosen::Roulette(Roulette {
                survival: Survival::Throughput(0.05),
            }),
            Named::NextEvent => Chosen::NextEvent(NextEvent { max_depth }),
            Named::Combine => Chosen::Combine(Combine {
                max_depth,
                heuristic: Heuristic::Power,
            }),
            Named::Path => Chosen::Path(Path::new(max_depth)),
        }
    }
}

impl Integrator for Chosen {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        match self {
            Chosen::Whitted(i) => i.li(tracer, ray, stream),
            Chosen::Kajiya(i) => i.li(tracer, ray, stream),
            Chosen::WhichRay(i) => i.li(tracer, ray, stream),
            Chosen::Roulette(i) => i.li(tracer, ray, stream),
            Chosen::NextEvent(i) => i.li(tracer, ray, stream),
            Chosen::Combine(i) => i.li(tracer, ray, stream),
            Chosen::Path(i) => i.li(tracer, ray, stream),
        }
    }
}
