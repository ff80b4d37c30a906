//! Path tracing with both techniques at once: aim at the lamps, and look where the surface scatters,
//! each weighted by how likely it was to find what it found.
//!
//! Simulates the paths `L(S|G|D)*E` of lamps with extent and of the background, and of point and
//! directional lights `L(D|G)(S|G|D)*E`, like `next_event` and with the same expected value.
//!
//! Differs from `next_event`: where that drops the light of a lamp hit by chance, this keeps both
//! estimates and gives each a weight; the two weights of one direction add up to one. Large and
//! close lamps are found better by chance, small and far ones by aiming, and nobody has to say
//! which is which.
//!
//! Source: Veach, Guibas, Optimally Combining Sampling Techniques for Monte Carlo Rendering
//! (SIGGRAPH 1995).

use super::world::World;
use super::{Entry, Finds};
use crate::color::Rgb;
use crate::sampling::mis::Heuristic;
use crate::sampling::stream::Stream;
use crate::space::{Ray, Space};

/// The random walk with weighted shadow rays.
#[derive(Clone, Copy, Debug)]
pub struct Combine {
    /// Longest path in segments: the camera ray is the first, the shadow ray, or the ray that hits
    /// a lamp or leaves the scene, the last.
    pub max_depth: u32,
    /// How weights follow densities.
    pub heuristic: Heuristic,
}

/// What the two techniques found, kept apart; the estimate is their sum.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shares {
    /// Light found by chance, weighted, and all light straight from the eye or after a mirror.
    pub by_chance: Rgb,
    /// Light found by aiming at lamps, weighted.
    pub by_aiming: Rgb,
}

impl Combine {
    /// Its row of the table, by the power heuristic.
    pub const ENTRY: Entry = Entry::of_light(
        [
            "combine",
            "lamps found both ways, weighted",
            "The walk of next-event with both techniques weighted: aiming at every lamp, and finding it by chance",
        ],
        Finds::BY_AIMING,
        |settings| {
            Box::new(Combine {
                max_depth: settings.max_depth,
                heuristic: Heuristic::Power,
            })
        },
    );
}

impl Combine {
    // ANCHOR: combine
    /// One estimate of the radiance along a ray from the eye, by technique.
    pub fn walk<S: Space>(
        &self,
        world: &mut impl World<S>,
        ray: &Ray<S>,
        stream: &Stream,
    ) -> Shares {
        let mut li = Shares::default();
        let mut beta = Rgb::WHITE;
        let mut ray = *ray;
        // The surface that drew the ray, and with what density; nobody else could have drawn one
        // from the eye or after a mirror.
        let mut drawn = None;
        for depth in 1..=self.max_depth {
            let hit = world.intersect(&ray, depth);

            // The light that comes along the path by itself: aiming could have found it, too.
            let weight = drawn.map_or(1.0, |(from, pdf)| {
                let pdf_light = world.pdf_light(&from, &ray, hit.as_ref());
                self.heuristic.weight(pdf, pdf_light)
            });
            li.by_chance += beta * world.emitted(&ray, hit.as_ref()) * weight;
            let Some(here) = hit else { break };
            if depth == self.max_depth {
                break;
            }

            // The light of each lamp that is scattered once, here: chance could have found it.
            let vertex = u64::from(depth);
            for lamp in 0..world.lights() {
                if let Some(direct) = world.sample_light(&here, lamp, vertex, stream) {
                    let weight = direct
                        .pdf
                        .map_or(1.0, |pdf| self.heuristic.weight(pdf, direct.pdf_bsdf));
                    li.by_aiming += beta * direct.scattered() * weight;
                }
            }

            // Choose where to look next.
            let Some(step) = world.sample_bsdf(&here, vertex, stream) else {
                break;
            };
            drawn = step.pdf.map(|pdf| (here, pdf));
            beta *= step.weight;
            ray = step.ray;
        }
        li
    }
    // ANCHOR_END: combine
}
