//! Chapter 07: a path through the flat room, vertex by vertex.

use crate::within;
use halfdisk::color::Rgb;
use halfdisk::flatland::{self, FlatHit, FlatWorld, exact};
use halfdisk::glam::Vec2;
use halfdisk::integrators::Kajiya;
use halfdisk::integrators::world::{Diffuse, FlatTracer, Lights, Step, World};
use halfdisk::sampling::half_disk;
use halfdisk::sampling::stream::Stream;
use halfdisk::space::{Flat, Ray, Space};
use halfdisk::stats::Estimate;
use std::cell::RefCell;

/// The segment that was traced last, counted from 1.
pub const SEGMENT: [f64; 2] = [1.0, 6.0];
/// Longest path behind the mean, in segments: what is cut off is below `2^-24` of the light.
const MAX_DEPTH: u32 = 24;
/// Paths behind the mean.
const PATHS: u32 = 1000;
/// Points of a lobe.
pub const LOBE: u32 = 33;

/// The path as far as a segment: what it brings, what all of it will bring; mean, standard error and exact value of
/// many paths. Then for each segment so far `x` and `y` of its two ends, the radiance that it brings, and the share of
/// that which reaches the eye. Last, around the end of the last one, [`LOBE`] points at the distance of the density
/// with which the next direction is drawn.
pub fn run(segment: f64, seed: u32) -> Vec<f64> {
    // The room comes with the library, so it can be read.
    flatland::load("room").map_or_else(|_| Vec::new(), |room| through(&room, segment, seed))
}

fn through(room: &FlatWorld, segment: f64, seed: u32) -> Vec<f64> {
    let segments = within(segment, SEGMENT) as u32;
    let stream = |i| Stream::new(seed.into(), i, 0);
    let all = walk(room, MAX_DEPTH, &stream(0)).0;
    let (li, noted) = walk(room, segments, &stream(0));
    let mean: Estimate = (0..PATHS)
        .map(|i| walk(room, MAX_DEPTH, &stream(i)).0)
        .collect();
    let mut numbers = vec![li, all, mean.mean(), mean.std_error(), exact::ROOM_FLOOR];
    for vertex in &noted {
        let [from, to] = vertex.ends.map(Vec2::as_dvec2);
        numbers.extend([from.x, from.y, to.x, to.y]);
        numbers.extend([vertex.emitted, vertex.beta]);
    }
    if let Some(last) = noted.last() {
        numbers.extend((0..LOBE).flat_map(|k| lobe(last, k).as_dvec2().to_array()));
    }
    numbers
}

/// What a path of at most so many segments brings from the middle of the floor, and its vertices.
fn walk(room: &FlatWorld, max_depth: u32, stream: &Stream) -> (f64, Vec<Vertex>) {
    let mut noted = Noted {
        world: FlatTracer::sampling(room, Lights::Points),
        path: Vec::new(),
        weights: RefCell::default(),
    };
    let eye = Vec2::new(0.15, 0.75);
    let ray = Ray::new(eye, (Vec2::new(0.5, 0.0) - eye).normalize());
    let li = Kajiya { max_depth }.walk(&mut noted, &ray, stream);
    (li.r.into(), noted.path)
}

/// A segment of a path and the surface that it ends on.
struct Vertex {
    ends: [Vec2; 2],
    n: Vec2,
    emitted: f64,
    /// The product of the weights before it.
    beta: f64,
}

/// Point number `k` of the lobe over a vertex, from the vertex.
fn lobe(vertex: &Vertex, k: u32) -> Vec2 {
    let w = half_disk::sample_uniform(k as f32 / LOBE as f32);
    Flat::to_world(&Flat::frame(vertex.n), w) * half_disk::pdf_cosine(w)
}

/// A flat world that notes the segments of a path.
struct Noted<'a> {
    world: FlatTracer<'a>,
    path: Vec<Vertex>,
    weights: RefCell<Vec<f64>>,
}

impl World<Flat> for Noted<'_> {
    type Point = FlatHit;

    fn intersect(&mut self, ray: &Ray<Flat>, segment: u32) -> Option<FlatHit> {
        let hit = self.world.intersect(ray, segment);
        self.path.extend(hit.as_ref().map(|at| Vertex {
            ends: [ray.origin, at.surface.p],
            n: at.surface.n,
            emitted: self.world.emitted(ray, hit.as_ref()).r.into(),
            beta: self.weights.borrow().iter().product(),
        }));
        hit
    }

    fn emitted(&self, ray: &Ray<Flat>, hit: Option<&FlatHit>) -> Rgb {
        self.world.emitted(ray, hit)
    }

    fn diffuse(&self, at: &FlatHit) -> Diffuse<Flat> {
        self.world.diffuse(at)
    }

    fn sample_bsdf(&self, at: &FlatHit, vertex: u64, stream: &Stream) -> Option<Step<Flat>> {
        let step = self.world.sample_bsdf(at, vertex, stream)?;
        self.weights.borrow_mut().push(step.weight.r.into());
        Some(step)
    }
}
