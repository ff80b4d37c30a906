//! What a path needs of a world, in either dimension.
//!
//! A path traces rays, picks up what surfaces emit, samples BSDFs and lights. Written against this
//! trait, it runs in flatland and in space from the same lines; and a world may be wrapped in
//! another one that counts, draws or gets something wrong.

mod flat;
mod guided;
mod photon;
mod scene;

pub use flat::{FlatTracer, Lights};
pub use guided::Guided;
pub use photon::{Emitted, PhotonWorld};

use crate::color::Rgb;
use crate::materials::Event;
use crate::sampling::mis::Heuristic;
use crate::sampling::stream::Stream;
use crate::space::{Ray, Space};

/// A world of surfaces and lights that rays can be traced in.
///
/// `vertex` is the number of a surface in its path, 1 for the one that the eye sees: it tells which of
/// the stream's random numbers are drawn there.
pub trait World<S: Space> {
    /// A point of a surface, as the ray sees it that met it.
    type Point: Clone;

    /// The closest hit of a ray; `segment` is its number in the path, 1 from the eye.
    fn intersect(&mut self, ray: &Ray<S>, segment: u32) -> Option<Self::Point>;

    /// Radiance that arrives along a ray by itself: what the surface that it hit emits towards it, or
    /// what comes from beyond everything.
    fn emitted(&self, ray: &Ray<S>, hit: Option<&Self::Point>) -> Rgb;

    /// The surface of a point, as far as it is diffuse.
    fn diffuse(&self, at: &Self::Point) -> Diffuse<S>;

    /// What happens to light that the BSDF scatters at a point other than in perfectly specular
    /// directions; `None` where there is no such light, and none need be looked for by shadow rays.
    fn smooth_event(&self, _at: &Self::Point) -> Option<Event> {
        Some(Event::Diffuse)
    }

    /// Samples the BSDF: how a path goes on from a surface; `None` where it ends.
    fn sample_bsdf(&self, at: &Self::Point, vertex: u64, stream: &Stream) -> Option<Step<S>>;

    /// How many lights can be sampled.
    fn lights(&self) -> usize {
        0
    }

    /// Samples a light and sends a shadow ray to it; `None` where no light comes of it.
    fn sample_light(
        &mut self,
        _at: &Self::Point,
        _light: usize,
        _vertex: u64,
        _stream: &Stream,
    ) -> Option<DirectLight> {
        None
    }

    /// Density with which [`World::sample_light`] at `from` samples the direction of `ray`, of the
    /// light that the ray hit, or of what is beyond everything; 0 where it is not sampled.
    fn pdf_light(&self, _from: &Self::Point, _ray: &Ray<S>, _hit: Option<&Self::Point>) -> f32 {
        0.0
    }
}

// ANCHOR: next_event
/// Next-event estimation: the light of all lights that a surface scatters back, by one shadow ray to each.
pub fn next_event<S: Space, W: World<S>>(
    world: &mut W,
    at: &W::Point,
    vertex: u64,
    stream: &Stream,
) -> Rgb {
    (0..world.lights())
        .filter_map(|light| world.sample_light(at, light, vertex, stream))
        .map(|direct| direct.scattered())
        .sum()
}
// ANCHOR_END: next_event

/// A point of a diffuse surface.
#[derive(Clone, Copy, Debug)]
pub struct Diffuse<S: Space> {
    /// Where it is.
    pub p: S::Vector,
    /// Bound on the rounding error of `p`, coordinate by coordinate.
    pub error: S::Vector,
    /// Unit normal, on the side that the ray came from.
    pub n: S::Vector,
    /// The moment, in `[0, 1]`.
    pub time: f32,
    /// The share of light reflected; black for what is not diffuse.
    pub albedo: Rgb,
}

impl<S: Space> Diffuse<S> {
    /// A ray that leaves the surface in `direction`.
    pub fn spawn(&self, direction: S::Vector) -> Ray<S> {
        let origin = S::offset(self.p, self.error, self.n, direction);
        Ray::new(origin, direction).at_time(self.time)
    }
}

/// How a path goes on: a sample of the BSDF.
#[derive(Clone, Copy, Debug)]
pub struct Step<S: Space> {
    /// The next ray.
    pub ray: Ray<S>,
    /// `f cos / pdf`, the share of the next ray's radiance that goes on along this one.
    pub weight: Rgb,
    /// The weight that it would have, had the BSDF alone been sampled: where other densities are mixed
    /// in, `weight` also tells how much rarer or more frequent they make such directions.
    pub bsdf_weight: Rgb,
    /// The density of its direction, per radian or steradian; `None` for a perfectly specular one.
    pub pdf: Option<f32>,
    /// What happens to light there.
    pub event: Event,
    /// A random number in `[0, 1)` that was drawn with the others and is left over.
    pub left: f32,
}

/// Light that arrives straight from a light source, and how a surface scatters it.
#[derive(Clone, Copy, Debug)]
pub struct DirectLight {
    /// The BSDF.
    pub f: Rgb,
    /// The cosine of its direction with the normal, without sign.
    pub cos: f32,
    /// Radiance that arrives; of a light without extent, its irradiance.
    pub li: Rgb,
    /// The estimate of the irradiance of a surface that faces the light, `li / pdf`.
    pub irradiance: Rgb,
    /// The density of its direction, per radian or steradian; `None` for a light without extent.
    pub pdf: Option<f32>,
    /// The density with which [`World::sample_bsdf`] samples that direction.
    pub pdf_bsdf: f32,
}

impl DirectLight {
    /// `f li cos / pdf`: the estimate of the light that is scattered back along the ray.
    pub fn scattered(&self) -> Rgb {
        self.f * self.irradiance * self.cos
    }

    /// The same with the weight of multiple importance sampling, where the BSDF is sampled, too.
    pub fn weighted(&self, heuristic: Heuristic) -> Rgb {
        let scattered = self.f * self.cos;
        match self.pdf {
            Some(pdf) => scattered * (self.li * (heuristic.weight(pdf, self.pdf_bsdf) / pdf)),
            None => scattered * self.irradiance,
        }
    }
}
