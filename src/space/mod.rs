//! Two worlds, one source: what an estimator needs to know about its dimension.
//!
//! The documents teach the sampler in the half disk and use it on the hemisphere. Code that is
//! generic over [`Space`] does both from the same lines: `Flat` to be drawn and solved exactly,
//! `Solid` to make pictures.
//!
//! Source: Jarosz, Schönefeld, Kobbelt, Jensen, Theory, Analysis and Applications of 2D Global
//! Illumination (ACM TOG 31(5), 2012), for transport in a flat world.

mod flat;
mod ray;
mod solid;

pub use flat::Flat;
pub use ray::Ray;
pub use solid::Solid;

use crate::sampling::stream::Numbers;
use glam::Vec2;
use std::fmt::Debug;
use std::ops::{Add, Mul, Neg, Sub};

/// A dimension: vectors, directions over a surface, and the constants that differ.
///
/// Local directions have the normal as their last axis. Densities are per unit of
/// [`Space::HEMISPHERE`]: per radian in the flat world, per steradian in space.
pub trait Space: Copy + Debug + Send + Sync + 'static {
    /// A point or direction.
    type Vector: Copy
        + Debug
        + PartialEq
        + Send
        + Sync
        + Neg<Output = Self::Vector>
        + Add<Output = Self::Vector>
        + Sub<Output = Self::Vector>
        + Mul<f32, Output = Self::Vector>;
    /// Local axes over a surface.
    type Frame: Copy + Debug;
    /// The uniforms that make one direction.
    type Uniforms: Copy + Debug;

    /// The same as a value.
    const DIMENSION: Dimension;
    /// Measure of all directions over a surface: π radians, or 2π steradians.
    const HEMISPHERE: f32;
    /// What makes a white diffuse surface reflect all light, `1 / ∫ cos θ dω`: 1/2 per radian in
    /// the flat world, 1/π per steradian in space. A diffuse BRDF is albedo times this.
    const LAMBERT: f32;
    /// The power of the distance with which the light of a small lamp falls off: 1, or 2. It is also the
    /// dimension of a surface.
    const FALL_OFF: i32;

    /// The local axes whose last is the unit normal `n`.
    fn frame(n: Self::Vector) -> Self::Frame;
    /// From world coordinates to local ones.
    fn to_local(frame: &Self::Frame, w: Self::Vector) -> Self::Vector;
    /// From local coordinates to world ones.
    fn to_world(frame: &Self::Frame, w: Self::Vector) -> Self::Vector;

    /// The next uniforms.
    fn uniforms(numbers: &mut Numbers) -> Self::Uniforms;
    /// The `index`-th of `count` stratified uniforms.
    fn stratified(index: u32, count: u32, u: Self::Uniforms) -> Self::Uniforms;
    /// A local direction, uniform over the surface.
    fn sample_uniform(u: Self::Uniforms) -> Self::Vector;
    /// Density of [`Space::sample_uniform`].
    fn pdf_uniform(w: Self::Vector) -> f32;
    /// A local direction, proportional to the cosine with the normal.
    fn sample_cosine(u: Self::Uniforms) -> Self::Vector;
    /// Density of [`Space::sample_cosine`].
    fn pdf_cosine(w: Self::Vector) -> f32;
    /// The cosine of a local unit direction with the normal: its last coordinate.
    fn cos(w: Self::Vector) -> f32;

    /// The dot product.
    fn dot(a: Self::Vector, b: Self::Vector) -> f32;
    /// The coordinates of a point; in the flat world the last one is 0.
    fn coordinates(p: Self::Vector) -> [f64; 3];
    /// Measure of the points of a flat surface less than `radius` away from one of them, a disc: `2 r` in
    /// the flat world, `π r²` in space.
    fn disc(radius: f64) -> f64;
    /// A vector of the plane, `x` to the right and `y` up; in space its `z` is 0.
    fn from_plane(v: Vec2) -> Self::Vector;
    /// The `x` and `y` of a vector.
    fn to_plane(v: Self::Vector) -> Vec2;
    /// The last axis, tilted by `angle` radians towards the first.
    fn tilted(angle: f32) -> Self::Vector;
    /// A point within `error` of a surface, moved off it to the side of `direction`.
    fn offset(
        p: Self::Vector,
        error: Self::Vector,
        n: Self::Vector,
        direction: Self::Vector,
    ) -> Self::Vector;
}

/// A [`Space`] by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Dimension {
    /// Two dimensions.
    Flat,
    /// Three dimensions.
    Solid,
}
