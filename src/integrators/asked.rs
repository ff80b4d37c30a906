//! How often a path asks each light: where that is rare, the picture may lack a light that its own
//! noise cannot tell of.

use super::world::World;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{Scene, Tracer};

/// A light asked fewer times than this in a whole picture may not have been seen at all.
pub const ENOUGH: f64 = 30.0;

/// Camera rays from which the surfaces are found at which lights are asked.
const PROBES: u32 = 256;
/// Probabilities computed at most, so that thousands of lights take no longer than a second.
const MOST_WORK: u64 = 2_000_000;

/// Lights that a picture hardly asks.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct RarelyAsked {
    /// How many there are.
    pub lights: usize,
    /// The index in [`Scene::lights`] of the one asked least.
    pub least: usize,
    /// The expected number of times it is asked.
    pub times: f64,
}

/// The lights that [`Path`](super::Path) is expected to ask fewer than [`ENOUGH`] times in a picture of
/// so many `samples` (pixels times samples per pixel); `None` where it asks each more often.
///
/// Asked are the surfaces that some paths find; it is an estimate, and the same for the same scene.
pub fn rarely_asked(scene: &Scene, max_depth: u32, samples: u64) -> Option<RarelyAsked> {
    let lights = scene.lights.len();
    // Where nothing is rough, no surface asks, and rays find the lights by the only ways there are.
    let nobody_asks = scene.inventory.diffuse + scene.inventory.glossy == 0;
    if lights < 2 || nobody_asks {
        return None;
    }
    let places = u64::from(max_depth.clamp(1, 8)) * lights as u64;
    let probes = (MOST_WORK / places).clamp(1, u64::from(PROBES)) as u32;
    let mut times = vec![0.0; lights];
    for probe in 0..probes {
        let stream = Stream::new(0, probe, 0);
        let mut numbers = stream.at(0, Purpose::Pixel);
        // Rows of the picture in turn, for points that lie evenly.
        let row = (probe as f32 + numbers.one()) / probes as f32;
        let ray = scene.camera.ray(numbers.one(), row);
        let mut tracer = Tracer::new(scene);
        let mut ray = ray;
        for depth in 1..max_depth.min(9) {
            let Some(at) = tracer.intersect(&ray, depth) else {
                break;
            };
            if tracer.smooth_event(&at).is_some() {
                let p = at.surface.p;
                let asked = times.iter_mut().enumerate();
                asked.for_each(|(i, t)| *t += f64::from(scene.light_choice.probability(p, i)));
            }
            let Some(step) = tracer.sample_bsdf(&at, u64::from(depth), &stream) else {
                break;
            };
            ray = step.ray;
        }
    }
    let scale = samples as f64 / f64::from(probes);
    times.iter_mut().for_each(|t| *t *= scale);
    // Rays that leave by chance find a sky of one colour.
    let counts = |i: &usize| scene.lights[*i].shines() && scene.sky_light != Some(*i);
    let rare: Vec<usize> = (0..lights)
        .filter(counts)
        .filter(|&i| times[i] < ENOUGH)
        .collect();
    let least = *rare
        .iter()
        .min_by(|&&a, &&b| times[a].total_cmp(&times[b]))?;
    Some(RarelyAsked {
        lights: rare.len(),
        least,
        times: times[least],
    })
}
