//! Several paths from the first surface on: something between a tree and a path.
//!
//! Simulates what [`NextEvent`](halfdisk::integrators::NextEvent) simulates, with the same expected
//! value. The ray from the eye is shared by all paths of a sample, and so is what it decides: where
//! in its pixel it passes, and which surface it meets. More paths for each such ray average less of
//! that, and save the ray.
//!
//! Source: Arvo, Kirk, Particle Transport and Image Synthesis (SIGGRAPH 1990), for splitting.

use halfdisk::color::Rgb;
use halfdisk::integrators::Integrator;
use halfdisk::integrators::world::{World, next_event};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::Tracer;
use halfdisk::space::{Ray, Solid, Space};

/// Random walks with shadow rays that share their first segment.
#[derive(Clone, Copy, Debug)]
pub struct Split {
    /// Paths from the first surface, at least 1.
    pub paths: u32,
    /// Longest path in segments, at least 1: the camera ray is the first.
    pub max_depth: u32,
}

impl Split {
    // ANCHOR: split
    /// One estimate of the radiance along a ray from the eye.
    pub fn walk<S: Space>(&self, world: &mut impl World<S>, ray: &Ray<S>, stream: &Stream) -> Rgb {
        let hit = world.intersect(ray, 1);
        let li = world.emitted(ray, hit.as_ref());
        let Some(first) = hit else { return li };
        let paths = (0..self.paths).map(|path| self.path_from(world, first.clone(), path, stream));
        li + paths.sum::<Rgb>() * (1.0 / self.paths as f32)
    }
    // ANCHOR_END: split

    /// What one path brings to the first surface and on to the eye.
    fn path_from<S: Space, W: World<S>>(
        &self,
        world: &mut W,
        first: W::Point,
        path: u32,
        stream: &Stream,
    ) -> Rgb {
        let mut li = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        let mut here = first;
        for depth in 2..=self.max_depth {
            // As in a walk, the places of one path are 1, 2, 3 ...; those of the next come after.
            let vertex = u64::from(path) * u64::from(self.max_depth) + u64::from(depth) - 1;
            li += beta * next_event(world, &here, vertex, stream);
            let Some(step) = world.sample_bsdf(&here, vertex, stream) else {
                break;
            };
            beta *= step.weight;
            let hit = world.intersect(&step.ray, depth);
            let asked = step.pdf.is_some() && world.pdf_light(&here, &step.ray, hit.as_ref()) > 0.0;
            if !asked {
                li += beta * world.emitted(&step.ray, hit.as_ref());
            }
            let Some(next) = hit else { break };
            here = next;
        }
        li
    }
}

impl Integrator for Split {
    fn li(&self, tracer: &mut Tracer, ray: &Ray<Solid>, stream: &Stream) -> Rgb {
        self.walk::<Solid>(tracer, ray, stream)
    }
}
