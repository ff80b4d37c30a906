//! The pixel loop itself: a rectangle of pixels, and the samples of a pass over it.

use super::recorder::Recorder;
use super::shots::Shots;
use super::watch::Watch;
use super::{BadSample, Options, Pixel, shard};
use crate::color::Rgb;
use crate::geometry::Ray;
use crate::integrators::{PathInLanes, PixelSample, Prepared};
use crate::sampling::stream::{Sampler, Stream, even_run};
use crate::scene::{RayCounts, Scene, Tracer};
use std::ops::Range;

/// A rectangle of pixels and what its samples added up to.
#[derive(Clone, Debug)]
pub(super) struct Tile<Notes> {
    pub(super) x: Range<u32>,
    pub(super) y: Range<u32>,
    /// Row by row.
    pub(super) pixels: Vec<Pixel>,
    /// Those of further pictures, all of a pixel together.
    pub(super) further: Vec<Pixel>,
    pub(super) notes: Notes,
    pub(super) rays: RayCounts,
    pub(super) watch: Watch,
    pub(super) lights_met: u64,
    /// Of the last pass: its samples' means over the channels, added up.
    pub(super) sum: f64,
}

/// The tiles of an image, or those of its shard, whose samples are in `further` more pictures, too.
pub(super) fn tiles<Notes: Default>(
    size: [u32; 2],
    options: &Options,
    further: usize,
) -> Vec<Tile<Notes>> {
    let tile = |[x, y]: [Range<u32>; 2]| {
        let count = x.len() * y.len();
        Tile {
            x,
            y,
            pixels: vec![Pixel::default(); count],
            further: vec![Pixel::default(); count * further],
            notes: Notes::default(),
            rays: RayCounts::default(),
            watch: Watch::default(),
            lights_met: 0,
            sum: 0.0,
        }
    };
    match options.shard {
        None => shard::tiles(size, options.tile.max(1)).map(tile).collect(),
        Some(shard) => shard.tiles(size).map(tile).collect(),
    }
}

impl<Notes> Tile<Notes> {
    /// The light of the samples of a pass, in their order, taken many at a time; fewer where it was stopped.
    fn light<'s>(
        &self,
        lanes: &PathInLanes<'s>,
        options: &Options,
        pass: &Range<u32>,
        tracer: &mut Tracer<'s>,
        stop: &(dyn Fn() -> bool + Sync),
    ) -> Vec<Rgb> {
        let width = tracer.scene().size[0];
        let places = self
            .y
            .clone()
            .flat_map(|y| self.x.clone().map(move |x| [x, y]));
        let mut samples = places.zip(&self.pixels).flat_map(|(pixel, before)| {
            let numbers = pass.start.max(before.taken)..pass.end;
            numbers.map(move |sample| (pixel, sample))
        });
        let mut next = || {
            let ([x, y], sample) = samples.next().filter(|_| !stop())?;
            let stream = Stream::with(options.sampler, options.seed, y * width + x, sample);
            Some(PixelSample {
                pixel: [x, y],
                stream,
            })
        };
        let mut light = Vec::new();
        lanes.take(tracer, options.sampler, &mut next, &mut light);
        light
    }

    /// Takes the samples of a pass, in lanes or one by one, by or with what was prepared for it in the whole picture; false
    /// where it was stopped before its last pixel. It asks before each sample: a pass over a tile may have thousands, and a
    /// sample take a millisecond.
    pub(super) fn sample<R: Recorder<Notes = Notes> + ?Sized>(
        &mut self,
        shots: &Shots<R>,
        pass: Range<u32>,
        prepared: &Prepared,
        stop: &(dyn Fn() -> bool + Sync),
    ) -> bool {
        let (scene, recorder, options) = (shots.scene, shots.recorder, shots.options);
        let lanes = shots.lanes.filter(|_| prepared.eye.is_none());
        let mut tracer = Tracer::new(scene);
        let run = even_run(pass.start);
        let ends_run = options.sampler == Sampler::Sobol && pass.end == run.end;
        let pictures = recorder.pictures();
        let mut parts = vec![Rgb::BLACK; pictures];
        let mut in_lanes = lanes.map(|lanes| {
            self.light(lanes, options, &pass, &mut tracer, stop)
                .into_iter()
        });
        let mut further = self.further.as_mut_slice();
        let mut whole = true;
        self.sum = 0.0;
        'pixels: for (y, row) in self.y.clone().zip(self.pixels.chunks_mut(self.x.len())) {
            for (x, pixel) in self.x.clone().zip(row) {
                let (own, rest) = further.split_at_mut(pictures);
                further = rest;
                // What a picture had that is taken further is not taken again.
                for sample in pass.start.max(pixel.taken)..pass.end {
                    let notes = &mut self.notes;
                    let li = match &mut in_lanes {
                        Some(light) => light.next(),
                        None => (!stop()).then(|| {
                            let (ray, stream) = camera_sample(scene, options, [x, y], sample);
                            match &prepared.eye {
                                Some(eye) => eye.li(&mut tracer, &ray, &stream),
                                None => {
                                    recorder.record(&mut tracer, &ray, &stream, &mut parts, notes)
                                }
                            }
                        }),
                    };
                    let Some(mut li) = li else {
                        whole = false;
                        break 'pixels;
                    };
                    if let Some(light) = &prepared.light {
                        let number = y * scene.size[0] + x;
                        let light = light[number as usize];
                        li += light;
                        recorder.arrive(light, prepared.splats.of(number), &mut parts, notes);
                    }
                    pixel.taken = sample + 1;
                    own.iter_mut().for_each(|p| p.taken = pixel.taken);
                    if self.watch.admits(li, BadSample { x, y, sample }) {
                        pixel.add(li);
                        self.sum += f64::from(li.mean());
                        own.iter_mut().zip(&parts).for_each(|(p, li)| p.add(*li));
                    }
                }
                if ends_run {
                    let doubles = run.end == 2 * run.start;
                    pixel.end_run(doubles);
                    own.iter_mut().for_each(|pixel| pixel.end_run(doubles));
                }
            }
        }
        self.rays += tracer.counts();
        self.lights_met |= tracer.lights_met();
        whole
    }
}

/// The camera ray of sample `sample` of the pixel in column `x` and row `y`, and its random numbers.
pub fn camera_sample(
    scene: &Scene,
    options: &Options,
    [x, y]: [u32; 2],
    sample: u32,
) -> (Ray, Stream) {
    let pixel = y * scene.size[0] + x;
    let stream = Stream::with(options.sampler, options.seed, pixel, sample).fixing(options.fixed);
    (scene.camera_ray([x, y], &stream), stream)
}
