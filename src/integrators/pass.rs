//! What all pixels of a sample have in common: paths that start at the lights.

use super::Integrator;
use crate::color::Rgb;
use crate::sampling::stream::{Purpose, Sampler, Stream};
use crate::scene::{RayCounts, Scene, Tracer};
use rayon::prelude::*;
use std::ops::Range;

/// Paths that one thread traces before another asks for more.
const CHUNK: u32 = 1 << 8;

/// Paths whose light is held before it is added up.
const BATCH: u32 = 1 << 19;

/// Random numbers of paths from the lights are none of those from the eye.
const FROM_LIGHTS: u64 = 0x6c69_6768_7470_6174;

/// An integrator whose samples are taken in passes: something is prepared for one sample of all pixels
/// at once, before any of them is taken.
pub trait Passes: Sync {
    /// Prepares a pass; `None` where it was stopped.
    ///
    /// A pure function of its arguments: all randomness comes from the streams of [`Pass::trace`].
    fn prepare<'a>(&'a self, pass: &Pass<'a>) -> Option<Prepared<'a>>;

    /// How many paths from the lights a pass of a scene has, where their number changes nothing but noise and cost,
    /// and nobody asked for this one.
    fn light_paths(&self, _scene: &Scene) -> Option<u32> {
        None
    }

    /// The same integrator with so many in each pass, where [`Passes::light_paths`] has an answer.
    fn with_light_paths(&self, _light_paths: u32) -> Option<Box<dyn Integrator + '_>> {
        None
    }
}

/// What a pass adds to the samples of its pixels, or does for them.
#[derive(Default)]
pub struct Prepared<'a> {
    /// The light of each pixel, row by row, in W/(m² sr), that is added to its sample of
    /// [`Integrator::li`]; `None` for none.
    pub light: Option<Vec<Rgb>>,
    /// The same light again, where whoever takes the samples wants to know by which paths it came.
    pub splats: Splats,
    /// Who takes the samples of this pass; `None` for the integrator itself.
    pub eye: Option<Box<dyn Integrator + 'a>>,
    /// The rays that it took.
    pub rays: RayCounts,
}

/// Light that paths from the lights brought to pixels.
#[derive(Clone, Debug, Default)]
pub struct Splats {
    /// Sorted by pixel.
    all: Vec<(u32, Splat)>,
}

/// What one path brought to one pixel.
#[derive(Clone, Copy, Debug)]
pub struct Splat {
    /// The light, as in [`Prepared::light`].
    pub light: Rgb,
    /// What [`Arrival::Kept`] said of its path.
    pub path: u64,
}

impl Splats {
    /// Those of a pixel, by its number row by row, in the order of their paths.
    pub fn of(&self, pixel: u32) -> impl Iterator<Item = Splat> {
        let start = self.all.partition_point(|(other, _)| *other < pixel);
        let rest = self.all[start..].iter();
        rest.take_while(move |(other, _)| *other == pixel)
            .map(|(_, splat)| *splat)
    }
}

/// What becomes of the light of a path that arrives at the eye.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arrival {
    /// It does not count.
    LeftOut,
    /// It counts.
    Counts,
    /// It counts, and is kept in [`Prepared::splats`] with a note of where it came.
    Kept(u64),
}

/// One sample of all pixels of a picture.
#[derive(Clone, Copy)]
pub struct Pass<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The number of the sample, 0 for the first.
    pub sample: u32,
    /// The picture's seed.
    pub seed: u64,
    /// How the samples of a path of one number lie to each other.
    pub sampler: Sampler,
    /// Integrals that are left out.
    pub fixed: &'static [Purpose],
    /// True once the work should end.
    pub stop: &'a (dyn Fn() -> bool + Sync),
}

impl Pass<'_> {
    /// The number of pixels.
    pub fn pixels(&self) -> u32 {
        self.scene.size[0].saturating_mul(self.scene.size[1])
    }

    /// A random moment in `[0, 1)` while the shutter is open, for passes that look at one only.
    pub fn moment(&self) -> f32 {
        match self.scene.moves() {
            true => self.stream(0).at(0, Purpose::Time).one(),
            false => 0.0,
        }
    }

    /// The random numbers of a path.
    fn stream(&self, path: u32) -> Stream {
        let seed = self.seed ^ FROM_LIGHTS;
        Stream::with(self.sampler, seed, path, self.sample).fixing(self.fixed)
    }

    /// Traces the paths of these numbers, each with a stream of its own; `path` is told where to leave what it
    /// finds.
    ///
    /// All of it in the order of the paths, whatever the threads, and the rays that it took; `None` where it
    /// was stopped. Passes of other numbers are independent of it.
    pub fn trace<T: Send>(
        &self,
        paths: Range<u32>,
        path: impl Fn(&mut Tracer, &Stream, &mut dyn FnMut(T)) + Sync,
    ) -> Option<(Vec<T>, RayCounts)> {
        let chunk = |start: u32| {
            let mut tracer = Tracer::new(self.scene);
            let mut found = Vec::new();
            for number in start..paths.end.min(start.saturating_add(CHUNK)) {
                if (self.stop)() {
                    return None;
                }
                path(&mut tracer, &self.stream(number), &mut |one| {
                    found.push(one);
                });
            }
            Some((found, tracer.counts()))
        };
        let starts: Vec<u32> = paths.clone().step_by(CHUNK as usize).collect();
        let chunks: Option<Vec<_>> = starts.into_par_iter().map(chunk).collect();
        let chunks = chunks?;
        let mut all = Vec::with_capacity(chunks.iter().map(|(found, _)| found.len()).sum());
        let mut rays = RayCounts::default();
        for (found, counts) in chunks {
            all.extend(found);
            rays += counts;
        }
        Some((all, rays))
    }

    /// The light that `paths` paths bring to places `(s, t)` in `[0, 1)²` of the film, `s` to the right and `t`
    /// downwards, added up in their order; `None` where it was stopped.
    ///
    /// A path's light is the mean radiance over the film that it stands for, in W/(m² sr), were it the only one.
    pub fn splat(
        &self,
        paths: u32,
        path: impl Fn(&mut Tracer, &Stream, &mut dyn FnMut([f32; 2], Rgb, Arrival)) + Sync,
    ) -> Option<Prepared<'static>> {
        let [width, height] = self.scene.size;
        let place = |[s, t]: [f32; 2]| {
            let column = (s * width as f32).min(width as f32 - 1.0) as u32;
            let row = (t * height as f32).min(height as f32 - 1.0) as u32;
            row * width + column
        };
        // One path for each pixel brings it what all paths together would bring to the film.
        let each = self.pixels() as f32 / paths.max(1) as f32;
        let mut sums = vec![[0.0_f64; 3]; self.pixels() as usize];
        let mut all = Vec::new();
        let mut rays = RayCounts::default();
        for start in (0..paths).step_by(BATCH as usize) {
            let end = paths.min(start.saturating_add(BATCH));
            let (arrived, traced) = self.trace(start..end, |tracer, stream, leave| {
                path(tracer, stream, &mut |film, light, arrival| {
                    if arrival != Arrival::LeftOut {
                        leave((place(film), light * each, arrival));
                    }
                });
            })?;
            rays += traced;
            for (pixel, light, arrival) in arrived {
                let channels = sums[pixel as usize].iter_mut().zip(light.channels());
                channels.for_each(|(sum, x)| *sum += f64::from(x));
                if let Arrival::Kept(path) = arrival {
                    all.push((pixel, Splat { light, path }));
                }
            }
        }
        // Stable: the paths of a pixel keep their order.
        all.sort_by_key(|(pixel, _)| *pixel);
        let light = sums.into_iter().map(|sum| Rgb::from(sum.map(|x| x as f32)));
        Some(Prepared {
            light: Some(light.collect()),
            splats: Splats { all },
            rays,
            ..Prepared::default()
        })
    }
}
