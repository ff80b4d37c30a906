//! The world with three dimensions.

use super::{Dimension, Space};
use crate::numeric;
use crate::sampling::frame::Frame;
use crate::sampling::hemisphere;
use crate::sampling::stream::Numbers;
use glam::{Vec2, Vec3};
use std::f32::consts::{FRAC_1_PI, TAU};

/// Three dimensions: a point of a surface sees a hemisphere of directions.
#[derive(Clone, Copy, Debug)]
pub struct Solid;

// ANCHOR: space
impl Space for Solid {
    type Vector = Vec3;
    type Frame = Frame;
    type Uniforms = [f32; 2];

    const DIMENSION: Dimension = Dimension::Solid;
    const HEMISPHERE: f32 = TAU;
    const LAMBERT: f32 = FRAC_1_PI;
    const FALL_OFF: i32 = 2;
    // ANCHOR_END: space

    fn frame(n: Vec3) -> Frame {
        Frame::new(n)
    }

    fn to_local(frame: &Frame, w: Vec3) -> Vec3 {
        frame.to_local(w)
    }

    fn to_world(frame: &Frame, w: Vec3) -> Vec3 {
        frame.to_world(w)
    }

    fn uniforms(numbers: &mut Numbers) -> [f32; 2] {
        numbers.two()
    }

    fn stratified(index: u32, count: u32, u: [f32; 2]) -> [f32; 2] {
        hemisphere::stratified(index, count, u)
    }

    fn sample_uniform(u: [f32; 2]) -> Vec3 {
        hemisphere::sample_uniform(u)
    }

    fn pdf_uniform(w: Vec3) -> f32 {
        hemisphere::pdf_uniform(w)
    }

    fn sample_cosine(u: [f32; 2]) -> Vec3 {
        hemisphere::sample_cosine(u)
    }

    fn pdf_cosine(w: Vec3) -> f32 {
        hemisphere::pdf_cosine(w)
    }

    fn cos(w: Vec3) -> f32 {
        w.z
    }

    fn dot(a: Vec3, b: Vec3) -> f32 {
        a.dot(b)
    }

    fn coordinates(p: Vec3) -> [f64; 3] {
        p.as_dvec3().to_array()
    }

    fn disc(radius: f64) -> f64 {
        std::f64::consts::PI * radius * radius
    }

    fn from_plane(v: Vec2) -> Vec3 {
        v.extend(0.0)
    }

    fn to_plane(v: Vec3) -> Vec2 {
        v.truncate()
    }

    fn tilted(angle: f32) -> Vec3 {
        let (sin, cos) = numeric::sin_cos(angle);
        Vec3::new(sin, 0.0, cos)
    }

    fn offset(p: Vec3, error: Vec3, n: Vec3, direction: Vec3) -> Vec3 {
        numeric::offset_origin(p, error, n, direction)
    }
}
