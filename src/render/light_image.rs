//! The light that paths from the lights bring to all pixels at once.

use super::Options;
use crate::color::Rgb;
use crate::integrators::LightPaths;
use crate::sampling::stream::Stream;
use crate::scene::{RayCounts, Scene, Tracer};
use rayon::prelude::*;

/// Paths that one thread traces before another asks for more.
const CHUNK: usize = 1 << 12;

/// Random numbers of paths from the lights are none of those from the eye.
const FROM_LIGHTS: u64 = 0x6c69_6768_7470_6174;

/// A sample of every pixel, row by row, in W/(m² sr), and the rays that it took: as many paths as there are
/// pixels, whose light is summed in their order whatever the threads. `None` where it was stopped.
///
/// Samples of other numbers are independent of it, so that their scatter tells the error of a pixel.
pub(super) fn light_image(
    scene: &Scene,
    paths: &dyn LightPaths,
    options: &Options,
    sample: u32,
    stop: &(dyn Fn() -> bool + Sync),
) -> Option<(Vec<Rgb>, RayCounts)> {
    let [width, height] = scene.size;
    let count = width as usize * height as usize;
    let starts: Vec<usize> = (0..count).step_by(CHUNK).collect();
    let chunk = |start: usize| {
        let mut tracer = Tracer::new(scene);
        let mut splats: Vec<(usize, Rgb)> = Vec::new();
        for path in start..count.min(start + CHUNK) {
            if stop() {
                return None;
            }
            let seed = options.seed ^ FROM_LIGHTS;
            let stream = Stream::with(options.sampler, seed, path as u32, sample);
            let stream = stream.fixing(options.fixed);
            paths.trace(&mut tracer, &stream, &mut |[s, t], light| {
                let column = (s * width as f32).min(width as f32 - 1.0) as usize;
                let row = (t * height as f32).min(height as f32 - 1.0) as usize;
                splats.push((row * width as usize + column, light));
            });
        }
        Some((splats, tracer.counts()))
    };
    let chunks: Option<Vec<_>> = starts.into_par_iter().map(chunk).collect();
    let mut sums = vec![[0.0_f64; 3]; count];
    let mut rays = RayCounts::default();
    for (splats, counts) in chunks? {
        rays += counts;
        for (pixel, light) in splats {
            let channels = sums[pixel].iter_mut().zip(light.channels());
            channels.for_each(|(sum, x)| *sum += f64::from(x));
        }
    }
    let image = sums.into_iter().map(|sum| Rgb::from(sum.map(|x| x as f32)));
    Some((image.collect(), rays))
}
