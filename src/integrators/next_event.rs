//! Path tracing with next-event estimation: the walk of `kajiya`, which asks every lamp on its way.
//!
//! Simulates the paths `L(S|G|D)*E` of lamps with extent and of the background, like `kajiya` and
//! with the same expected value. Of point and directional lights it has the paths
//! `L(D|G)(S|G|D)*E`: their light through glass or by a mirror onto a diffuse surface is on no path
//! it can find.
//!
//! Differs from `kajiya`: at each hit that is not perfectly specular a shadow ray goes to every
//! lamp. Their light is then in the sum, and must not count again where the walk meets a lamp by
//! chance, except straight from the eye or after a mirror or glass, where no shadow ray could ask
//! for it. An image around the scene is a lamp like any other; a background of one colour is none:
//! it counts wherever the walk leaves the scene.
//!
//! Less noise where lamps are small or far. Rectangles, triangles and spheres are drawn uniformly in
//! solid angle; other parallelograms and meshes uniformly in area, so that close to a large one
//! there is more noise, and where it meets a wall in an edge the variance is infinite. Gloss counts
//! as diffuse: the smoother it is, the fewer of the points drawn on a lamp lie in its lobe, and the
//! larger is the noise.
//!
//! Source: Kajiya, The Rendering Equation (SIGGRAPH 1986); Shirley, Wang, Zimmerman, Monte Carlo
//! Techniques for Direct Lighting Calculations (TOG 15(1), 1996).

use super::world::{World, next_event};
use super::{Entry, Finds};
use crate::color::Rgb;
use crate::sampling::stream::Stream;
use crate::space::{Ray, Space};

/// The random walk with shadow rays.
#[derive(Clone, Copy, Debug)]
pub struct NextEvent {
    /// Longest path in segments: the camera ray is the first, the shadow ray, or the ray that hits
    /// a lamp or leaves the scene, the last.
    pub max_depth: u32,
}

impl NextEvent {
    /// Its row of the table.
    pub const ENTRY: Entry = Entry::of_light(
        [
            "next-event",
            "the walk, and a shadow ray to each lamp",
            "The walk of kajiya with a shadow ray to each lamp at diffuse surfaces: the same light with less \
             noise; of point and directional lights LD(S|D)*E",
        ],
        Finds::BY_AIMING,
        |settings| {
            Box::new(NextEvent {
                max_depth: settings.max_depth,
            })
        },
    );
}

impl NextEvent {
    // ANCHOR: next_event
    /// One estimate of the radiance along a ray from the eye.
    pub fn walk<S: Space>(&self, world: &mut impl World<S>, ray: &Ray<S>, stream: &Stream) -> Rgb {
        let mut li = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        let mut ray = *ray;
        // The surface that asked for the light along the ray. Nobody did along one from the eye.
        let mut asked = None;
        for depth in 1..=self.max_depth {
            let hit = world.intersect(&ray, depth);

            // The light that comes along the path by itself, unless it was asked for.
            let was_sampled = |from| world.pdf_light(&from, &ray, hit.as_ref()) > 0.0;
            if !asked.is_some_and(was_sampled) {
                li += beta * world.emitted(&ray, hit.as_ref());
            }
            let Some(here) = hit else { break };
            if depth == self.max_depth {
                break;
            }

            // The light of all lamps that is scattered once, here.
            let vertex = u64::from(depth);
            li += beta * next_event(world, &here, vertex, stream);

            // Choose where to look next.
            let Some(step) = world.sample_bsdf(&here, vertex, stream) else {
                break;
            };
            asked = step.pdf.map(|_| here);
            beta *= step.weight;
            ray = step.ray;
        }
        li
    }
    // ANCHOR_END: next_event
}
