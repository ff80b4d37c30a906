//! What a gather needs of a world, in either dimension.

use crate::color::Rgb;
use crate::sampling::stream::Stream;
use crate::space::{Ray, Space};
use std::fmt::Debug;
use std::ops::{Add, Mul};

/// Light as an estimator sees it: one channel or three.
pub trait Light:
    Copy + Debug + PartialEq + Add<Output = Self> + Mul<Output = Self> + Mul<f32, Output = Self>
{
    /// No light.
    const BLACK: Self;
    /// The channels, for sums in `f64`; grey light has its value in each.
    fn channels(self) -> [f64; 3];
    /// Light from its channels.
    fn from_channels(channels: [f64; 3]) -> Self;
}

impl Light for f32 {
    const BLACK: f32 = 0.0;

    fn channels(self) -> [f64; 3] {
        [f64::from(self); 3]
    }

    fn from_channels(channels: [f64; 3]) -> f32 {
        channels[0] as f32
    }
}

impl Light for Rgb {
    const BLACK: Rgb = Rgb::BLACK;

    fn channels(self) -> [f64; 3] {
        Rgb::channels(self).map(f64::from)
    }

    fn from_channels(channels: [f64; 3]) -> Rgb {
        Rgb::from(channels.map(|x| x as f32))
    }
}

/// A point of a diffuse surface, as a ray finds it.
#[derive(Clone, Copy, Debug)]
pub struct Hit<S: Space, L> {
    /// Where it is.
    pub p: S::Vector,
    /// Bound on the rounding error of `p`, coordinate by coordinate.
    pub error: S::Vector,
    /// Unit normal, on the side the ray came from.
    pub n: S::Vector,
    /// The share of light reflected.
    pub albedo: L,
    /// Radiance it emits towards the ray by itself.
    pub emission: L,
    /// True where [`World::direct`] aims at this emitter. A ray that finds it by chance must not
    /// count its light again.
    pub aimed: bool,
}

impl<S: Space, L> Hit<S, L> {
    /// A ray that leaves the surface in `direction`.
    pub fn spawn(&self, direction: S::Vector) -> Ray<S> {
        Ray {
            origin: S::offset(self.p, self.error, self.n, direction),
            direction,
        }
    }
}

/// A world of diffuse surfaces, lamps and a surrounding.
pub trait World<S: Space> {
    /// What light is here.
    type Light: Light;

    /// What a ray meets first.
    fn first_hit(&mut self, ray: &Ray<S>) -> Option<Hit<S, Self::Light>>;

    /// Radiance from beyond everything, along the unit `direction` of a ray that met nothing.
    fn environment(&self, direction: S::Vector) -> Self::Light;

    /// An estimate of `∫ L cos θ dω` over the lamps one can aim at, by shadow rays, for the node
    /// `node` of a ray tree. None here, unless a world has such lamps.
    fn direct(&mut self, _at: &Hit<S, Self::Light>, _stream: &Stream, _node: u64) -> Self::Light {
        Self::Light::BLACK
    }
}

/// A world that counts the rays it is asked for; shadow rays are its own affair.
#[derive(Clone, Copy, Debug)]
pub struct Counted<W> {
    /// The world.
    pub world: W,
    /// Rays so far.
    pub rays: u64,
}

impl<S: Space, W: World<S>> World<S> for Counted<W> {
    type Light = W::Light;

    fn first_hit(&mut self, ray: &Ray<S>) -> Option<Hit<S, W::Light>> {
        self.rays += 1;
        self.world.first_hit(ray)
    }

    fn environment(&self, direction: S::Vector) -> W::Light {
        self.world.environment(direction)
    }

    fn direct(&mut self, at: &Hit<S, W::Light>, stream: &Stream, node: u64) -> W::Light {
        self.world.direct(at, stream, node)
    }
}
