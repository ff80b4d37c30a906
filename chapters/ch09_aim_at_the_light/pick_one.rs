//! Next-event estimation that asks one lamp, where [`NextEvent`](halfdisk::integrators::NextEvent) asks
//! all of them.
//!
//! Simulates the same paths with the same expected value: a lamp that is asked with probability `p`
//! counts `1/p` times. The rays no longer grow with the lamps. The variance depends on how well the
//! probabilities know who lights what.
//!
//! Source: Shirley, Wang, Zimmerman, Monte Carlo Techniques for Direct Lighting Calculations (TOG
//! 15(1), 1996).

use halfdisk::color::Rgb;
use halfdisk::integrators::Integrator;
use halfdisk::integrators::world::World;
use halfdisk::sampling::discrete::Discrete;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::Tracer;
use halfdisk::space::{Ray, Solid, Space};

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
    fn ask_one<S: Space, W: World<S>>(
        &self,
        world: &mut W,
        at: &W::Point,
        vertex: u64,
        stream: &Stream,
    ) -> Rgb {
        // The lamps' own numbers are those of their places in the list; this is the next one.
        let mut numbers = stream.at_item(vertex, Purpose::LightPoint, world.lights() as u32);
        let chosen = self.choice.sample(numbers.fine());
        match world.sample_light(at, chosen.index, vertex, stream) {
            Some(direct) => direct.scattered() * (1.0 / chosen.probability),
            None => Rgb::BLACK,
        }
    }
    // ANCHOR_END: pick_one

    /// One estimate of the radiance along a ray from the eye.
    pub fn walk<S: Space>(&self, world: &mut impl World<S>, ray: &Ray<S>, stream: &Stream) -> Rgb {
        let mut li = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        let mut ray = *ray;
        let mut asked = None;
        for depth in 1..=self.max_depth {
            let hit = world.intersect(&ray, depth);
            let was_sampled = |from| world.pdf_light(&from, &ray, hit.as_ref()) > 0.0;
            if !asked.is_some_and(was_sampled) {
                li += beta * world.emitted(&ray, hit.as_ref());
            }
            let Some(here) = hit else { break };
            if depth == self.max_depth {
                break;
            }
            let vertex = u64::from(depth);
            li += beta * self.ask_one(world, &here, vertex, stream);
            let Some(step) = world.sample_bsdf(&here, vertex, stream) else {
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
    fn li(&self, tracer: &mut Tracer, ray: &Ray<Solid>, stream: &Stream) -> Rgb {
        self.walk::<Solid>(tracer, ray, stream)
    }
}
