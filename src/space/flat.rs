//! The flat world.

use super::{Dimension, Space};
use crate::numeric;
use crate::sampling::flat_frame::FlatFrame;
use crate::sampling::half_disk;
use crate::sampling::stream::Numbers;
use glam::Vec2;
use std::f32::consts::PI;

/// Two dimensions: surfaces are curves, and a point sees a half disk of directions.
#[derive(Clone, Copy, Debug)]
pub struct Flat;

// ANCHOR: space
impl Space for Flat {
    type Vector = Vec2;
    type Frame = FlatFrame;
    type Uniforms = f32;

    const DIMENSION: Dimension = Dimension::Flat;
    const HEMISPHERE: f32 = PI;
    const LAMBERT: f32 = 0.5;
    const FALL_OFF: i32 = 1;
    // ANCHOR_END: space

    fn frame(n: Vec2) -> FlatFrame {
        FlatFrame::new(n)
    }

    fn to_local(frame: &FlatFrame, w: Vec2) -> Vec2 {
        frame.to_local(w)
    }

    fn to_world(frame: &FlatFrame, w: Vec2) -> Vec2 {
        frame.to_world(w)
    }

    fn uniforms(numbers: &mut Numbers) -> f32 {
        numbers.one()
    }

    fn stratified(index: u32, count: u32, u: f32) -> f32 {
        half_disk::stratified(index, count, u)
    }

    fn sample_uniform(u: f32) -> Vec2 {
        half_disk::sample_uniform(u)
    }

    fn pdf_uniform(w: Vec2) -> f32 {
        half_disk::pdf_uniform(w)
    }

    fn sample_cosine(u: f32) -> Vec2 {
        half_disk::sample_cosine(u)
    }

    fn pdf_cosine(w: Vec2) -> f32 {
        half_disk::pdf_cosine(w)
    }

    fn cos(w: Vec2) -> f32 {
        w.y
    }

    fn dot(a: Vec2, b: Vec2) -> f32 {
        a.dot(b)
    }

    fn coordinates(p: Vec2) -> [f64; 3] {
        p.extend(0.0).as_dvec3().to_array()
    }

    fn disc(radius: f64) -> f64 {
        2.0 * radius
    }

    fn from_plane(v: Vec2) -> Vec2 {
        v
    }

    fn to_plane(v: Vec2) -> Vec2 {
        v
    }

    fn tilted(angle: f32) -> Vec2 {
        let (sin, cos) = numeric::sin_cos(angle);
        Vec2::new(sin, cos)
    }

    fn offset(p: Vec2, error: Vec2, n: Vec2, direction: Vec2) -> Vec2 {
        let [p, error, n, direction] = [p, error, n, direction].map(|v| v.extend(0.0));
        numeric::offset_origin(p, error, n, direction).truncate()
    }
}
