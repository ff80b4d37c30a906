//! Caustics: light that mirrors and glass focus, traced from its sources.
//!
//! Simulates the paths `LS(D|S|G)*DE`, and of points and directions `LS(D|S|G)*(D|G)E`: light that first meets
//! a mirror or glass and comes to the eye from a surface that is neither. A walk from the eye finds the small
//! bright places where it lands, but hardly ever the way back through the mirror or glass to the lamp; a
//! point or direction it never meets. From the lights the way leads there by itself.
//!
//! Rays from the lights are aimed at what focuses light. Part of [`Path`](super::Path), which leaves these
//! paths out of its walk. A sky of one colour is left to the walk: it is met wherever a ray leaves.
//!
//! Source: Arvo, Backward Ray Tracing (SIGGRAPH course notes 1986); Jensen, Global Illumination Using Photon
//! Maps (Rendering Techniques 1996), for aiming at what focuses light and for a map of caustics alone.

use super::from_light::{Gain, to_eye};
use super::world::World;
use super::{Arrival, Pass, Prepared, Survival};
use crate::color::Rgb;
use crate::materials::Event;
use crate::notation::Letter;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::Tracer;

/// Traces what is focused from the lights.
#[derive(Clone, Copy, Debug)]
pub struct Caustics {
    /// Longest path in segments: the one that leaves the light is the first, that to the eye the last.
    pub max_depth: u32,
}

impl Caustics {
    /// The paths that may be among those it traces.
    pub const PATHS: &str = "LS(D|S|G)*(D|G)E";

    /// The light that `paths` paths bring in a pass; `arrival` says what becomes of that of a path, for its
    /// letters from the light on, without the eye's.
    pub fn prepare(
        &self,
        pass: &Pass,
        paths: u32,
        arrival: impl Fn(&[Letter]) -> Arrival + Sync,
    ) -> Option<Prepared<'static>> {
        pass.splat(paths, |tracer, stream, splat| {
            self.trace(tracer, stream, &mut |film, light, letters| {
                splat(film, light, arrival(letters));
            });
        })
    }

    // ANCHOR: caustics
    /// Traces one path, and calls `splat` with each place of the film that it brings light to, and
    /// with its letters so far.
    pub fn trace(
        &self,
        tracer: &mut Tracer,
        stream: &Stream,
        splat: &mut impl FnMut([f32; 2], Rgb, &[Letter]),
    ) {
        let Some(start) = tracer.sample_focused(stream) else {
            return;
        };
        let mut power = start.power();
        let mut gain = Gain::new(start.is_delta);
        let mut throughput = Rgb::WHITE;
        let mut letters = vec![Letter::Light];
        let mut ray = start.ray;
        for depth in 1..self.max_depth {
            let Some(here) = tracer.secondary_ray(&ray) else {
                break;
            };

            // The light that is scattered from here straight to the eye.
            let vertex = u64::from(depth);
            let event = tracer.smooth_event(&here);
            let shows =
                event == Some(Event::Diffuse) || event == Some(Event::Gloss) && start.is_delta;
            if let Some(event) = event.filter(|_| depth > 1 && shows)
                && let Some((film, received)) = to_eye(tracer, &here, gain, vertex, stream)
            {
                letters.push(event.into());
                splat(film, power * received, &letters);
                letters.pop();
            }

            // Choose where to go next. The first surface has to be a mirror or glass.
            let Some(step) = tracer.sample_bsdf(&here, vertex, stream) else {
                break;
            };
            if depth == 1 && step.event != Event::Specular {
                break;
            }
            letters.push(step.event.into());
            if let Some(bsdf) = &here.bsdf {
                gain = gain.through(bsdf, here.wo, here.frame.to_local(step.ray.direction));
            }
            power *= step.weight;
            throughput *= step.weight;
            ray = step.ray;

            // Does the walk go on? Where light has landed it is worth less.
            if step.pdf.is_some() {
                let q = Survival::Throughput(0.05).probability(throughput);
                if stream.at(vertex, Purpose::Survival).one() >= q {
                    break;
                }
                power = power / q;
                throughput = throughput / q;
            }
        }
    }
    // ANCHOR_END: caustics
}
