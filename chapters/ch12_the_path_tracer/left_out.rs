//! The path tracer with one of its ingredients left out.
//!
//! The walk is [`Path::walk`] in every case, line by line. What is left out is left out of the world it walks in.

use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::world::{Diffuse, DirectLight, Guided, Step, World};
use halfdisk::integrators::{AllLight, Integrator, Path};
use halfdisk::materials::{Event, kinds};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::Tracer;
use halfdisk::space::{self, Solid, Space};

/// An ingredient of the path tracer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeftOut {
    /// None: the path tracer as it is.
    Nothing,
    /// No shadow rays: lights are found by chance.
    Aiming,
    /// No weights: what can be aimed at counts when it is aimed at, and never by chance.
    Weights,
    /// No roulette: paths go on to the depth cut.
    Roulette,
    /// No choice: each surface asks every light.
    Choice,
}

/// A world in which shadow rays or their weights are missing.
#[derive(Clone, Copy, Debug)]
pub struct Less<W> {
    /// The world as it is.
    pub world: W,
    /// What is missing; [`LeftOut::Aiming`], [`LeftOut::Weights`], or else nothing.
    pub left_out: LeftOut,
}

impl<S: Space, W: World<S>> World<S> for Less<W> {
    type Point = W::Point;

    fn intersect(&mut self, ray: &space::Ray<S>, segment: u32) -> Option<W::Point> {
        self.world.intersect(ray, segment)
    }

    fn emitted(&self, ray: &space::Ray<S>, hit: Option<&W::Point>) -> Rgb {
        self.world.emitted(ray, hit)
    }

    fn diffuse(&self, at: &W::Point) -> Diffuse<S> {
        self.world.diffuse(at)
    }

    fn smooth_event(&self, at: &W::Point) -> Option<Event> {
        self.world.smooth_event(at)
    }

    fn sample_bsdf(&self, at: &W::Point, vertex: u64, stream: &Stream) -> Option<Step<S>> {
        self.world.sample_bsdf(at, vertex, stream)
    }

    // ANCHOR: less
    fn lights(&self) -> usize {
        match self.left_out {
            LeftOut::Aiming => 0,
            _ => self.world.lights(),
        }
    }

    fn sample_light(
        &mut self,
        at: &W::Point,
        light: usize,
        vertex: u64,
        stream: &Stream,
    ) -> Option<DirectLight> {
        let direct = self.world.sample_light(at, light, vertex, stream)?;
        Some(match self.left_out {
            // Nobody else could have found it: its weight is 1.
            LeftOut::Weights => DirectLight {
                pdf_bsdf: 0.0,
                ..direct
            },
            _ => direct,
        })
    }

    fn pdf_light(&self, from: &W::Point, ray: &space::Ray<S>, hit: Option<&W::Point>) -> f32 {
        let pdf = self.world.pdf_light(from, ray, hit);
        match self.left_out {
            LeftOut::Aiming => 0.0,
            // All is left to those who aim: the weight of chance is 0.
            LeftOut::Weights if pdf > 0.0 => f32::INFINITY,
            _ => pdf,
        }
    }
    // ANCHOR_END: less
}

/// The path tracer without one of its ingredients, in scenes without perfect mirrors and glass.
#[derive(Clone, Copy, Debug)]
pub struct PathWithout {
    /// Longest path in segments.
    pub max_depth: u32,
    /// What is missing.
    pub left_out: LeftOut,
}

impl PathWithout {
    /// The walk: only its roulette may be missing.
    pub fn path(&self) -> Path {
        let path = Path::from_eye(self.max_depth);
        match self.left_out {
            LeftOut::Roulette => Path {
                roulette_from: u32::MAX,
                ..path
            },
            _ => path,
        }
    }
}

impl Integrator for PathWithout {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let (path, mut all) = (self.path(), AllLight::default());
        if self.left_out == LeftOut::Choice {
            path.walk::<Solid>(tracer, ray, stream, &mut all);
        } else {
            let mut less = Less {
                world: Guided::<{ kinds::ALL }>::new(tracer, false),
                left_out: self.left_out,
            };
            path.walk(&mut less, ray, stream, &mut all);
        }
        all.li
    }
}
