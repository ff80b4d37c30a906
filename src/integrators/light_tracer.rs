//! Light tracing: random walks from the lights, each of whose surfaces is connected to the eye.
//!
//! Simulates the paths `L((D|S|G)*(D|G))?E`: all that end at the eye from a surface that is not perfectly
//! specular, and the lights themselves. A mirror or glass that the eye looks at shows nothing: no line
//! from a surface to the eye lies in the one direction in which it scatters.
//!
//! Differs from all integrators before it: a walk does not know which pixel it will reach. So its light
//! is added where it falls, as many walks for each picture as it has pixels.
//!
//! Least noise where light is focused onto a surface that the eye sees, a caustic; and points and
//! directions, which no walk from the eye can meet, cost it nothing. Most noise on surfaces that few walks
//! reach, however large they look.
//!
//! Source: Arvo, Backward Ray Tracing (SIGGRAPH course notes 1986); Veach, Robust Monte Carlo Methods for
//! Light Transport Simulation (1997), chapter 4: the adjoint of a BSDF is the BSDF with its two directions
//! exchanged.

use super::from_light::{Gain, to_eye};
use super::world::World;
use super::{Arrival, Entry, Finds, Found, Integrator, Pass, Passes, Prepared, Survival};
use crate::color::Rgb;
use crate::geometry::Ray;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{Scene, Tracer};

/// Walks from the lights.
#[derive(Clone, Copy, Debug)]
pub struct LightTracer {
    /// Longest path in segments: the one that leaves the light is the first, that to the eye the last.
    pub max_depth: u32,
}

/// From here on roulette decides whether a walk goes on.
const ROULETTE_FROM: u32 = 3;

impl LightTracer {
    /// Its row of the table.
    pub const ENTRY: Entry = Entry::of_light(
        [
            "light-tracer",
            "walks from the lights, connected to the eye",
            "Random walks from the lights, connected to the eye at each surface that is not a perfect mirror \
             or glass: little noise in caustics, and nothing in mirrors",
        ],
        Finds {
            lamps: TO_THE_EYE,
            image: TO_THE_EYE,
            sky: TO_THE_EYE,
            points: Found {
                paths: Some("L(D|S|G)*(D|G)E"),
                ..TO_THE_EYE
            },
            by_chance: false,
        },
        |settings| {
            Box::new(LightTracer {
                max_depth: settings.max_depth,
            })
        },
    );
}

/// Walks from the lights end at a surface that scatters towards the eye.
const TO_THE_EYE: Found = Found {
    paths: Some("L((D|S|G)*(D|G))?E"),
    because: "no line from a surface to the eye is the one direction of a mirror or glass",
};

impl Integrator for LightTracer {
    /// What the eye sees of the lights themselves.
    fn li(&self, tracer: &mut Tracer, ray: &Ray, _: &Stream) -> Rgb {
        let hit = tracer.intersect(ray, 1);
        tracer.emitted(ray, hit.as_ref())
    }

    fn passes(&self, _: &Scene) -> Option<&dyn Passes> {
        Some(self)
    }
}

impl Passes for LightTracer {
    fn prepare<'a>(&'a self, pass: &Pass<'a>) -> Option<Prepared<'a>> {
        pass.splat(pass.pixels(), |tracer, stream, splat| {
            self.trace(tracer, stream, &mut |film, light| {
                splat(film, light, Arrival::Counts);
            });
        })
    }
}

impl LightTracer {
    // ANCHOR: light_tracer
    /// Traces one path, and calls `splat` with each place of the film that it brings light to: see
    /// [`Pass::splat`].
    pub fn trace(
        &self,
        tracer: &mut Tracer,
        stream: &Stream,
        splat: &mut dyn FnMut([f32; 2], Rgb),
    ) {
        let Some(start) = tracer.sample_emission(stream) else {
            return;
        };
        let mut power = start.power();
        let mut gain = Gain::new(start.is_delta);
        let mut throughput = Rgb::WHITE;
        let mut ray = start.ray;
        for depth in 1..self.max_depth {
            let Some(here) = tracer.secondary_ray(&ray) else {
                break;
            };

            // The light that is scattered from here straight to the eye.
            let vertex = u64::from(depth);
            if let Some((film, received)) = to_eye(tracer, &here, gain, vertex, stream) {
                splat(film, power * received);
            }

            // Choose where to go next: the BSDF as seen by who sends the light.
            let Some(step) = tracer.sample_bsdf(&here, vertex, stream) else {
                break;
            };
            if let Some(bsdf) = &here.bsdf {
                gain = gain.through(bsdf, here.wo, here.frame.to_local(step.ray.direction));
            }
            power *= step.weight;
            throughput *= step.weight;
            ray = step.ray;

            // Does the walk go on?
            if depth >= ROULETTE_FROM {
                let q = Survival::Throughput(0.05).probability(throughput);
                if stream.at(vertex, Purpose::Survival).one() >= q {
                    break;
                }
                power = power / q;
                throughput = throughput / q;
            }
        }
    }
    // ANCHOR_END: light_tracer
}
