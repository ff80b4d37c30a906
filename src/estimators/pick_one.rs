//! Next-event estimation that asks one lamp, where [`NextEvent`](crate::integrators::NextEvent) asks
//! all of them.
//!
//! Simulates the same paths with the same expected value: a lamp that is asked with probability `p`
//! counts `1/p` times. The rays no longer grow with the lamps. The variance depends on how well the
//! probabilities know who lights what.
//!
//! Source: Shirley, Wang, Zimmerman, Monte Carlo Techniques for Direct Lighting Calculations (TOG
//! 15(1), 1996).

use crate::color::Rgb;
use crate::geometry;
use crate::integrators::Integrator;
use crate::integrators::walkable::Walkable;
use crate::sampling::discrete::Discrete;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::Tracer;
use crate::space::{Ray, Solid, Space};

/// The random walk with one shadow ray at each surface.
#[derive(Clone, Debug)]
pub struct PickOne {
    /// Longest path in segments, counted as in `NextEvent`.
    pub max_depth: u32,
    /// The choice among the world's lamps, in their order.
    pub choice: Discrete,
}

impl PickOne {
    // ANCHOR: pick_one
    /// The light of one lamp, for that of all.
    fn ask_one<S: Space, W: Walkable<S>>(
        &self,
        world: &mut W,
        at: &W::Point,
        place: u64,
        stream: &Stream,
    ) -> Rgb {
        // The lamps' own numbers are those of their places in the list; this is the next one.
        let mut numbers = stream.at_item(place, Purpose::LightPoint, world.lamps() as u32);
        let chosen = self.choice.sample(numbers.fine());
        match world.aim(at, chosen.index, place, stream) {
            Some(aimed) => aimed.light * (1.0 / chosen.probability),
            None => Rgb::BLACK,
        }
    }
    // ANCHOR_END: pick_one

    /// One estimate of the radiance along a ray from the eye.
    pub fn walk<S: Space>(
        &self,
        world: &mut impl Walkable<S>,
        ray: &Ray<S>,
        stream: &Stream,
    ) -> Rgb {
        let mut li = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        let mut ray = *ray;
        let mut asked = None;
        for depth in 1..=self.max_depth {
            let met = world.follow(&ray, depth);
            let was_asked = |from| world.pdf_aim(&from, &ray, met.as_ref()) > 0.0;
            if !asked.is_some_and(was_asked) {
                li += beta * world.arriving(&ray, met.as_ref());
            }
            let Some(here) = met else { break };
            if depth == self.max_depth {
                break;
            }
            let place = u64::from(depth);
            li += beta * self.ask_one(world, &here, place, stream);
            let Some(step) = world.scatter(&here, place, stream) else {
                break;
            };
            asked = step.pdf.map(|_| here);
            beta *= step.weight;
            ray = step.ray;
        }
        li
    }
}

impl Integrator for PickOne {
    fn li(&self, tracer: &mut Tracer, ray: &geometry::Ray, stream: &Stream) -> Rgb {
        self.walk::<Solid>(tracer, &ray.into(), stream)
    }
}
