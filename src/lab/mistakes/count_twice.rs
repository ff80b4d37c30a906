//! Next-event estimation that counts lamps twice: by the shadow ray, and again where the walk meets
//! them.
//!
//! All light that is aimed at doubles: a surface under a lamp reflects twice what it should, and so
//! does every bounce. What reaches the eye straight from a lamp or by mirrors alone is right, since
//! nobody aimed there.

use crate::color::Rgb;
use crate::integrators::Integrator;
use crate::integrators::world::{World, next_event};
use crate::sampling::stream::Stream;
use crate::scene::Tracer;
use crate::space::{Ray, Solid, Space};

/// `NextEvent`, without its one condition.
#[derive(Clone, Copy, Debug)]
pub struct CountTwice {
    /// Longest path in segments.
    pub max_depth: u32,
}

impl CountTwice {
    /// One estimate of twice the radiance along a ray from the eye.
    pub fn walk<S: Space>(&self, world: &mut impl World<S>, ray: &Ray<S>, stream: &Stream) -> Rgb {
        let mut li = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        let mut ray = *ray;
        for depth in 1..=self.max_depth {
            let hit = world.intersect(&ray, depth);
            // The mistake: whether this light was asked for is not asked.
            li += beta * world.emitted(&ray, hit.as_ref());
            let Some(here) = hit else { break };
            if depth == self.max_depth {
                break;
            }
            let vertex = u64::from(depth);
            li += beta * next_event(world, &here, vertex, stream);
            let Some(step) = world.sample_bsdf(&here, vertex, stream) else {
                break;
            };
            beta *= step.weight;
            ray = step.ray;
        }
        li
    }
}

impl Integrator for CountTwice {
    fn li(&self, tracer: &mut Tracer, ray: &Ray<Solid>, stream: &Stream) -> Rgb {
        self.walk::<Solid>(tracer, ray, stream)
    }
}
