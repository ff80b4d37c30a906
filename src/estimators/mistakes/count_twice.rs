//! Next-event estimation that counts lamps twice: by the shadow ray, and again where the walk meets
//! them.
//!
//! All light that is aimed at doubles: a surface under a lamp reflects twice what it should, and so
//! does every bounce. What reaches the eye straight from a lamp or by mirrors alone is right, since
//! nobody aimed there.

use crate::color::Rgb;
use crate::geometry;
use crate::integrators::Integrator;
use crate::integrators::walkable::{Walkable, ask_all};
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
    pub fn walk<S: Space>(
        &self,
        world: &mut impl Walkable<S>,
        ray: &Ray<S>,
        stream: &Stream,
    ) -> Rgb {
        let mut li = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        let mut ray = *ray;
        for depth in 1..=self.max_depth {
            let met = world.follow(&ray, depth);
            // The mistake: whether this light was asked for is not asked.
            li += beta * world.arriving(&ray, met.as_ref());
            let Some(here) = met else { break };
            if depth == self.max_depth {
                break;
            }
            let place = u64::from(depth);
            li += beta * ask_all(world, &here, place, stream);
            let Some(step) = world.scatter(&here, place, stream) else {
                break;
            };
            beta *= step.weight;
            ray = step.ray;
        }
        li
    }
}

impl Integrator for CountTwice {
    fn li(&self, tracer: &mut Tracer, ray: &geometry::Ray, stream: &Stream) -> Rgb {
        self.walk::<Solid>(tracer, &ray.into(), stream)
    }
}
