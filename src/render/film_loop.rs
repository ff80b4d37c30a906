//! Passes over tiles over threads.

use super::{BadSample, Film, Pixel};
use crate::geometry::Ray;
use crate::integrators::Integrator;
use crate::sampling::stream::{Purpose, Sampler, Stream};
use crate::scene::{RayCounts, Scene, Tracer};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// How to render.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Samples per pixel.
    pub spp: u32,
    /// The picture's seed.
    pub seed: u64,
    /// How the samples of a pixel lie to each other.
    pub sampler: Sampler,
    /// Integrals that are left out: their purposes' numbers are all 1/2 (see [`Stream::fixing`]).
    pub fixed: &'static [Purpose],
    /// Side of the square tiles that threads take in turn, in pixels; changes no bit.
    pub tile: u32,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            spp: 16,
            seed: 0,
            sampler: Sampler::Independent,
            fixed: &[],
            tile: 16,
        }
    }
}

/// What is told while a render runs, and how it is stopped.
pub trait Progress: Sync {
    /// `done` of `total` samples of all pixels are finished.
    fn tell(&self, done: u64, total: u64);
    /// True to stop soon and keep what is there.
    fn stop(&self) -> bool;
}

/// Nobody watches and nobody stops.
impl Progress for () {
    fn tell(&self, _: u64, _: u64) {}
    fn stop(&self) -> bool {
        false
    }
}

/// A finished or interrupted render.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The picture.
    pub film: Film,
    /// Rays traced.
    pub rays: RayCounts,
    /// Time spent in the pixel loop.
    pub time: Duration,
    /// Samples that came out as NaN or infinity. They are in no mean, and never painted over.
    pub non_finite: u64,
    /// The first of them in row order.
    pub first_bad: Option<BadSample>,
    /// True where it was stopped before its last sample.
    pub interrupted: bool,
}

/// Renders a scene on the threads of the current rayon pool.
///
/// Samples are taken in passes of 1, 1, 2, 4, 8 … over the whole picture, so that an interrupted
/// render is a picture everywhere.
pub fn render(
    scene: &Scene,
    integrator: &impl Integrator,
    options: &Options,
    progress: &impl Progress,
) -> Rendered {
    let start = Instant::now();
    let mut tiles = tiles(scene.size, options.tile.max(1));
    let total = u64::from(scene.size[0]) * u64::from(scene.size[1]) * u64::from(options.spp);
    let done = AtomicU64::new(0);
    let interrupted = AtomicBool::new(false);

    for pass in passes(options.spp) {
        tiles.par_iter_mut().for_each(|tile| {
            if progress.stop() {
                interrupted.store(true, Ordering::Relaxed);
                return;
            }
            tile.sample(scene, integrator, options, pass.clone());
            let samples = tile.pixels.len() as u64 * u64::from(pass.end - pass.start);
            let before = done.fetch_add(samples, Ordering::Relaxed);
            progress.tell(before + samples, total);
        });
    }
    develop(scene.size, tiles, start.elapsed(), interrupted.into_inner())
}

/// The ranges of sample numbers of each pass, each as long as all before it, up to 64.
fn passes(spp: u32) -> impl Iterator<Item = Range<u32>> {
    let mut start = 0;
    std::iter::from_fn(move || {
        let length = start.clamp(1, 64).min(spp - start);
        let pass = start..start + length;
        start = pass.end;
        (length > 0).then_some(pass)
    })
}

/// A rectangle of pixels and what its samples added up to.
struct Tile {
    x: Range<u32>,
    y: Range<u32>,
    /// Row by row.
    pixels: Vec<Pixel>,
    rays: RayCounts,
    non_finite: u64,
    first_bad: Option<BadSample>,
}

fn tiles([width, height]: [u32; 2], side: u32) -> Vec<Tile> {
    let starts = |end: u32| (0..end).step_by(side as usize);
    starts(height)
        .flat_map(|y| starts(width).map(move |x| (x, y)))
        .map(|(x, y)| {
            let x = x..width.min(x.saturating_add(side));
            let y = y..height.min(y.saturating_add(side));
            let count = x.len() * y.len();
            Tile {
                x,
                y,
                pixels: vec![Pixel::default(); count],
                rays: RayCounts::default(),
                non_finite: 0,
                first_bad: None,
            }
        })
        .collect()
}

impl Tile {
    fn sample(
        &mut self,
        scene: &Scene,
        integrator: &impl Integrator,
        options: &Options,
        pass: Range<u32>,
    ) {
        let mut tracer = Tracer::new(scene);
        let columns = self.x.clone();
        let places = self
            .y
            .clone()
            .flat_map(|y| columns.clone().map(move |x| (x, y)));
        for ((x, y), pixel) in places.zip(&mut self.pixels) {
            for sample in pass.clone() {
                let (ray, stream) = camera_sample(&mut tracer, options, [x, y], sample);
                let li = integrator.li(&mut tracer, &ray, &stream);
                if li.is_finite() {
                    pixel.add(li);
                } else {
                    self.non_finite += 1;
                    let bad = BadSample { x, y, sample };
                    let key = |b: BadSample| (b.y, b.x, b.sample);
                    if self.first_bad.is_none_or(|first| key(bad) < key(first)) {
                        self.first_bad = Some(bad);
                    }
                }
            }
        }
        self.rays += tracer.counts();
    }
}

/// The camera ray of sample `sample` of the pixel in column `x` and row `y`, and its random numbers.
/// The tracer looks at the scene when the ray does.
pub fn camera_sample(
    tracer: &mut Tracer,
    options: &Options,
    [x, y]: [u32; 2],
    sample: u32,
) -> (Ray, Stream) {
    let scene = tracer.scene();
    let [width, height] = scene.size;
    let stream =
        Stream::with(options.sampler, options.seed, y * width + x, sample).fixing(options.fixed);
    let [u, v] = stream.at(0, Purpose::Pixel).two();
    let s = (x as f32 + u) / width as f32;
    let t = (y as f32 + v) / height as f32;
    if scene.moves() {
        tracer.at_time(stream.at(0, Purpose::Time).one());
    }
    (scene.camera.sample_ray(s, t, &stream), stream)
}

/// Puts the tiles together.
fn develop(
    [width, height]: [u32; 2],
    tiles: Vec<Tile>,
    time: Duration,
    interrupted: bool,
) -> Rendered {
    let mut pixels = vec![Pixel::default(); width as usize * height as usize];
    let mut rays = RayCounts::default();
    let mut non_finite = 0;
    let mut bad = Vec::new();
    for tile in tiles {
        let columns = tile.x.len();
        for (row, y) in tile.pixels.chunks(columns).zip(tile.y.clone()) {
            let start = y as usize * width as usize + tile.x.start as usize;
            pixels[start..start + columns].copy_from_slice(row);
        }
        rays += tile.rays;
        non_finite += tile.non_finite;
        bad.extend(tile.first_bad);
    }
    Rendered {
        film: Film::new(width, pixels),
        rays,
        time,
        non_finite,
        first_bad: bad.into_iter().min_by_key(|b| (b.y, b.x, b.sample)),
        interrupted,
    }
}
