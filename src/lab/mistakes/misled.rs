//! Walks that combine two techniques, misled about their densities.
//!
//! The walk itself stays as it is: its world tells it something wrong.

use crate::color::Rgb;
use crate::integrators::world::{Diffuse, DirectLight, Step, World};
use crate::lab::estimators::overhead::Overhead;
use crate::materials::Event;
use crate::sampling::mis::Heuristic;
use crate::sampling::stream::{Purpose, Stream};
use crate::space::{Ray, Space};

/// A world that misleads who walks in it.
#[derive(Clone, Copy, Debug)]
pub struct Misled<W> {
    /// The world as it is.
    pub world: W,
    /// What it gets wrong.
    pub slip: Slip,
}

/// What goes wrong where two techniques are combined. The factors are those of the density with
/// which lamps are aimed at, claimed over true.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Slip {
    /// Both weights are one: lamps that both techniques can find count twice.
    CountedTwice,
    /// The density is wrong wherever it is used.
    Density(f32),
    /// It is wrong in both weights alike, and right where estimates are divided by it. The weights
    /// still add up to one: this costs variance, and nothing else.
    BothWeights(f32),
    /// It is wrong in the weight of what chance finds, and nowhere else.
    OneWeight(f32),
    /// One lamp is picked to stand for all, and its light is not divided by the chance of that.
    Selection,
}

impl Slip {
    /// What the floor under a lamp of `parts` parts reads with this slip, exactly; the truth is
    /// [`Overhead::mean`].
    pub fn reading(self, lamp: &Overhead, parts: u32, heuristic: Heuristic) -> f64 {
        let weight = |own, other| heuristic.weight_f64(own, other);
        lamp.integral(|theta| {
            let [chance, whole] = lamp.pdf(theta);
            // A part is seen at a smaller angle, and drawn with a larger density.
            let aim = f64::from(parts) * whole;
            let counts = match self {
                Slip::CountedTwice => 2.0,
                Slip::Density(factor) => {
                    let factor = f64::from(factor);
                    let claimed = factor * aim;
                    weight(chance, claimed) + weight(claimed, chance) / factor
                }
                Slip::BothWeights(_) => 1.0,
                Slip::OneWeight(factor) => {
                    weight(chance, f64::from(factor) * aim) + weight(aim, chance)
                }
                Slip::Selection => weight(chance, aim) + weight(aim, chance) / f64::from(parts),
            };
            counts * lamp.integrand(theta)
        })
    }
}

impl<W> Misled<W> {
    /// The factor in the weight of what chance finds.
    fn when_met(&self) -> f32 {
        match self.slip {
            Slip::CountedTwice => 0.0,
            Slip::Density(factor) | Slip::BothWeights(factor) | Slip::OneWeight(factor) => factor,
            Slip::Selection => 1.0,
        }
    }
}

impl<S: Space, W: World<S>> World<S> for Misled<W> {
    type Point = W::Point;

    fn intersect(&mut self, ray: &Ray<S>, segment: u32) -> Option<W::Point> {
        self.world.intersect(ray, segment)
    }

    fn emitted(&self, ray: &Ray<S>, hit: Option<&W::Point>) -> Rgb {
        self.world.emitted(ray, hit)
    }

    fn diffuse(&self, at: &W::Point) -> Diffuse<S> {
        self.world.diffuse(at)
    }

    fn smooth_event(&self, at: &W::Point) -> Option<Event> {
        self.world.smooth_event(at)
    }

    fn sample_bsdf(&self, at: &W::Point, vertex: u64, stream: &Stream) -> Option<Step<S>> {
        self.world.sample_bsdf(at, vertex, stream)
    }

    fn lights(&self) -> usize {
        match self.slip {
            Slip::Selection => self.world.lights().min(1),
            _ => self.world.lights(),
        }
    }

    fn sample_light(
        &mut self,
        at: &W::Point,
        lamp: usize,
        vertex: u64,
        stream: &Stream,
    ) -> Option<DirectLight> {
        let lamp = match self.slip {
            Slip::Selection => {
                let u = stream.at(vertex, Purpose::Integrand).one();
                (u * self.world.lights() as f32) as usize
            }
            _ => lamp,
        };
        let right = self.world.sample_light(at, lamp, vertex, stream)?;
        Some(match self.slip {
            Slip::CountedTwice => DirectLight {
                pdf_bsdf: 0.0,
                ..right
            },
            Slip::Density(factor) => DirectLight {
                irradiance: right.irradiance / factor,
                pdf: right.pdf.map(|pdf| factor * pdf),
                ..right
            },
            Slip::BothWeights(factor) => DirectLight {
                pdf: right.pdf.map(|pdf| factor * pdf),
                ..right
            },
            Slip::OneWeight(_) | Slip::Selection => right,
        })
    }

    fn pdf_light(&self, from: &W::Point, ray: &Ray<S>, hit: Option<&W::Point>) -> f32 {
        self.when_met() * self.world.pdf_light(from, ray, hit)
    }
}
