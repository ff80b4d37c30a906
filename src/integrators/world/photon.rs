//! What paths need of a world that start at its lights.

use super::super::Gain;
use super::{FlatTracer, World};
use crate::color::Rgb;
use crate::flatland::FlatHit;
use crate::photons::Photon;
use crate::sampling::stream::Stream;
use crate::scene::{Interaction, Tracer};
use crate::space::{Flat, Ray, Solid, Space};
use glam::{Vec2, Vec3};

/// A ray along which a light emits.
#[derive(Clone, Copy, Debug)]
pub struct Emitted<S: Space> {
    /// The ray.
    pub ray: Ray<S>,
    /// Its power, in W.
    pub power: Rgb,
    /// True where the light has no extent.
    pub is_delta: bool,
}

/// A world in which paths may start at the lights and leave photons.
pub trait PhotonWorld<S: Space>: World<S> {
    /// Draws a light by its power, and a ray along which it emits at the moment `time`, in `[0, 1]`. The mean of its
    /// power is that of all lights. `None` where nothing shines.
    fn emit(&self, time: f32, stream: &Stream) -> Option<Emitted<S>>;

    /// The closest hit of a ray on a path from a light.
    fn land(&mut self, ray: &Ray<S>) -> Option<Self::Point>;

    /// What a walk from a light has gained where it goes on from a point along `ray`.
    fn gain(&self, gain: Gain, at: &Self::Point, ray: &Ray<S>) -> Gain;

    /// The photon that a path leaves at a point: `power` in W that came along so many segments.
    fn photon(&self, at: &Self::Point, power: Rgb, segments: u32) -> Photon<S>;

    /// A point and its unit normal.
    fn place(&self, at: &Self::Point) -> (S::Vector, S::Vector);

    /// The BSDF at a point from the unit direction `wi` to where the point is seen from, without its perfectly
    /// specular part; per steradian (flat: per radian).
    fn f(&self, at: &Self::Point, wi: S::Vector) -> Rgb;
}

impl<'a> PhotonWorld<Solid> for Tracer<'a> {
    fn emit(&self, time: f32, stream: &Stream) -> Option<Emitted<Solid>> {
        let start = self.sample_emission_at(stream, time)?;
        Some(Emitted {
            ray: start.ray,
            power: start.power(),
            is_delta: start.is_delta,
        })
    }

    fn land(&mut self, ray: &Ray<Solid>) -> Option<Interaction<'a>> {
        self.secondary_ray(ray)
    }

    fn gain(&self, gain: Gain, at: &Interaction<'a>, ray: &Ray<Solid>) -> Gain {
        match &at.bsdf {
            Some(bsdf) => gain.through(bsdf, at.wo, at.frame.to_local(ray.direction)),
            None => gain,
        }
    }

    fn photon(&self, at: &Interaction<'a>, power: Rgb, segments: u32) -> Photon<Solid> {
        Photon {
            p: at.surface.p,
            n: at.surface.n,
            wi: at.back,
            power,
            segments,
        }
    }

    fn place(&self, at: &Interaction<'a>) -> (Vec3, Vec3) {
        (at.surface.p, at.surface.n)
    }

    fn f(&self, at: &Interaction<'a>, wi: Vec3) -> Rgb {
        match &at.bsdf {
            Some(bsdf) => bsdf.f(at.wo, at.frame.to_local(wi)),
            None => Rgb::BLACK,
        }
    }
}

impl PhotonWorld<Flat> for FlatTracer<'_> {
    /// Lamps in glass are as points are: their power is what it is.
    fn emit(&self, _: f32, stream: &Stream) -> Option<Emitted<Flat>> {
        let (ray, power) = self.world.sample_emission(stream)?;
        Some(Emitted {
            ray,
            power,
            is_delta: true,
        })
    }

    fn land(&mut self, ray: &Ray<Flat>) -> Option<FlatHit> {
        self.intersect(ray, 0)
    }

    fn gain(&self, gain: Gain, _: &FlatHit, _: &Ray<Flat>) -> Gain {
        gain
    }

    fn photon(&self, at: &FlatHit, power: Rgb, segments: u32) -> Photon<Flat> {
        Photon {
            p: at.surface.p,
            n: at.surface.n,
            wi: at.wo,
            power,
            segments,
        }
    }

    fn place(&self, at: &FlatHit) -> (Vec2, Vec2) {
        (at.surface.p, at.surface.n)
    }

    /// A wall scatters to the side that the light comes from; its normal is on the side that is seen.
    fn f(&self, at: &FlatHit, wi: Vec2) -> Rgb {
        match at.surface.n.dot(wi) > 0.0 {
            true => at.albedo * Flat::LAMBERT,
            false => Rgb::BLACK,
        }
    }
}
