//! What paths need of a world that start at its lights.

use super::super::from_light;
use super::{FlatTracer, Step, World};
use crate::color::Rgb;
use crate::flatland::FlatHit;
use crate::photons::Photon;
use crate::sampling::stream::Stream;
use crate::scene::{Interaction, Tracer};
use crate::space::{Flat, Ray, Solid, Space};
use glam::{Vec2, Vec3};

/// A world in which paths may start at the lights and leave photons.
pub trait PhotonWorld<S: Space>: World<S> {
    /// Draws a light by its power, and a ray along which it emits at the moment `time`, in `[0, 1]`; the power
    /// of the ray in W, the mean of which is that of all lights. `None` where nothing shines.
    fn emit(&self, time: f32, stream: &Stream) -> Option<(Ray<S>, Rgb)>;

    /// The closest hit of a ray on a path from a light.
    fn land(&mut self, ray: &Ray<S>) -> Option<Self::Point>;

    /// Samples the BSDF for light that goes on from a surface: [`World::sample_bsdf`], its weight that of power.
    fn scatter(&self, at: &Self::Point, vertex: u64, stream: &Stream) -> Option<Step<S>>;

    /// The photon that a path leaves at a point: `power` in W that came along so many segments.
    fn photon(&self, at: &Self::Point, power: Rgb, segments: u32) -> Photon<S>;

    /// A point and its unit normal.
    fn place(&self, at: &Self::Point) -> (S::Vector, S::Vector);

    /// The BSDF at a point from the unit direction `wi` to where the point is seen from, without its perfectly
    /// specular part; per steradian (flat: per radian).
    fn f(&self, at: &Self::Point, wi: S::Vector) -> Rgb;
}

impl<'a> PhotonWorld<Solid> for Tracer<'a> {
    fn emit(&self, time: f32, stream: &Stream) -> Option<(Ray<Solid>, Rgb)> {
        let start = self.sample_emission_at(stream, time)?;
        Some((start.ray, start.power()))
    }

    fn land(&mut self, ray: &Ray<Solid>) -> Option<Interaction<'a>> {
        self.secondary_ray(ray)
    }

    fn scatter(&self, at: &Interaction<'a>, vertex: u64, stream: &Stream) -> Option<Step<Solid>> {
        from_light::scatter(self, at, vertex, stream)
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
    fn emit(&self, _: f32, stream: &Stream) -> Option<(Ray<Flat>, Rgb)> {
        self.world.sample_emission(stream)
    }

    fn land(&mut self, ray: &Ray<Flat>) -> Option<FlatHit> {
        self.intersect(ray, 0)
    }

    fn scatter(&self, at: &FlatHit, vertex: u64, stream: &Stream) -> Option<Step<Flat>> {
        self.sample_bsdf(at, vertex, stream)
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
