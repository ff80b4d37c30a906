//! Path tracing of any length: Russian roulette in vertex of a depth cut.
//!
//! Simulates the paths `L(S|G|D)*E` of lamps with extent and of the background, all of them.
//!
//! Differs from `kajiya`: at each surface the path survives with a probability `q`, and what a
//! survivor finds counts `1/q`. A cut loses the light of all longer paths; this loses none in the
//! mean. What it costs is variance: with albedo `ρ` everywhere and a constant `q` that variance is
//! infinite for `q <= ρ²`, and nothing but the survivors' number tells.
//!
//! Source: Arvo, Kirk, Particle Transport and Image Synthesis (SIGGRAPH 1990), "Russian roulette".

use super::world::World;
use super::{Entry, Finds};
use crate::color::Rgb;
use crate::sampling::stream::{Purpose, Stream};
use crate::space::{Ray, Space};

/// The random walk that ends by chance.
#[derive(Clone, Copy, Debug)]
pub struct Roulette {
    /// How likely a path is to survive.
    pub survival: Survival,
}

/// The probability with which a path goes on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Survival {
    /// Always the same, in `(0, 1)`.
    Constant(f32),
    /// The largest channel of the path's throughput, but at least this: a path that carries little
    /// is worth little work.
    Throughput(f32),
}

impl Survival {
    /// The probability for a path of throughput `beta`. Never more than 0.95: between white
    /// surfaces a throughput stays one for ever.
    pub fn probability(self, beta: Rgb) -> f32 {
        match self {
            Survival::Constant(q) => q,
            Survival::Throughput(least) => beta.max_channel().clamp(least, 0.95),
        }
    }
}

impl Roulette {
    /// Its row of the table.
    pub const ENTRY: Entry = Entry {
        is_endless: true,
        ..Entry::of_light(
            [
                "roulette",
                "kajiya without a longest path: it ends by chance",
                "The random walk of kajiya without a longest path: it ends by Russian roulette",
            ],
            Finds::BY_CHANCE,
            |_| {
                Box::new(Roulette {
                    survival: Survival::Throughput(0.05),
                })
            },
        )
    };
}

impl Roulette {
    // ANCHOR: roulette
    /// One estimate of the radiance along a ray from the eye.
    pub fn walk<S: Space>(&self, world: &mut impl World<S>, ray: &Ray<S>, stream: &Stream) -> Rgb {
        let mut li = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        let mut ray = *ray;
        for depth in 1.. {
            let hit = world.intersect(&ray, depth);

            // The light that comes along the path by itself.
            li += beta * world.emitted(&ray, hit.as_ref());
            let Some(here) = hit else { break };

            // Choose where to look next.
            let vertex = u64::from(depth);
            let Some(step) = world.sample_bsdf(&here, vertex, stream) else {
                break;
            };
            beta *= step.weight;
            ray = step.ray;

            // Does the path go on? If so, it also stands for those that did not. No number is below
            // a probability that is none, so a broken path ends here, too.
            let q = self.survival.probability(beta);
            let survives = stream.at(vertex, Purpose::Survival).one() < q;
            if !survives {
                break;
            }
            beta = beta / q;
        }
        li
    }
    // ANCHOR_END: roulette
}
