//! Path tracing as a pure random walk: one ray in, one ray out, until a light happens to be hit.
//!
//! Simulates the paths `L(S|G|D)*E` of lamps with extent and of the background, one colour or an
//! image: all there are, up to the depth cut. Point and directional lights have no extent, so no
//! walk ever meets them; a scene lit by nothing else is black.
//!
//! Differs from `whitted`: where that follows every branch of a tree and asks every lamp, this
//! chooses one direction, diffuse ones too, and asks nobody. A path costs as many rays as it has
//! segments; small lamps are found rarely, and the picture is as noisy as they are small.
//!
//! Source: Kajiya, The Rendering Equation (SIGGRAPH 1986), without his rays to the lights: those
//! are the next stage, `next_event`.

use super::world::World;
use super::{Entry, Finds};
use crate::color::Rgb;
use crate::sampling::stream::Stream;
use crate::space::{Ray, Space};

/// The pure random walk.
#[derive(Clone, Copy, Debug)]
pub struct Kajiya {
    /// Longest path in segments: the camera ray is the first, the one that hits a lamp or leaves
    /// the scene the last.
    pub max_depth: u32,
}

impl Kajiya {
    /// Its row of the table.
    pub const ENTRY: Entry = Entry::of_light(
        [
            "kajiya",
            "a random walk that finds lamps by chance",
            "A random walk, all paths L(S|D)*E; finds lamps and sky by chance only, and point and \
             directional lights never",
        ],
        Finds::BY_CHANCE,
        |settings| {
            Box::new(Kajiya {
                max_depth: settings.max_depth,
            })
        },
    );
}

impl Kajiya {
    // ANCHOR: kajiya
    /// One estimate of the radiance along a ray from the eye.
    pub fn walk<S: Space>(&self, world: &mut impl World<S>, ray: &Ray<S>, stream: &Stream) -> Rgb {
        let mut li = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        let mut ray = *ray;
        for depth in 1..=self.max_depth {
            let hit = world.intersect(&ray, depth);

            // The light that comes along the path by itself.
            li += beta * world.emitted(&ray, hit.as_ref());
            let Some(here) = hit else { break };
            if depth == self.max_depth {
                break;
            }

            // Choose where to look next.
            let Some(step) = world.sample_bsdf(&here, u64::from(depth), stream) else {
                break;
            };
            beta *= step.weight;
            ray = step.ray;
        }
        li
    }
    // ANCHOR_END: kajiya
}
