//! Which of many lights to ask.

use super::Light;
use super::bounds::LightBounds;
use super::tree::LightTree;
use crate::sampling::discrete::{Discrete, LAST_FINE};
use glam::Vec3;

/// Chooses one of a scene's lights for a point, by what each may give there.
///
/// Lights that are infinitely far away, and all others, are groups of their own, for distance tells
/// them apart: a sun counts the same everywhere, a lamp counts by how near it is. Neither group, and
/// no light of a group, is ever left to chance alone: what the choice cannot know is what stands
/// between a light and the point.
#[derive(Clone, Debug, Default)]
pub struct LightChoice {
    /// The only light there is: most scenes have no more.
    only: Option<usize>,
    near: Option<Near>,
    far: Option<Far>,
}

/// What was chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChosenLight {
    /// Its index among the scene's lights.
    pub index: usize,
    /// Its probability, positive.
    pub probability: f32,
    /// A uniform again, independent of the choice: it may choose a part of the light.
    pub rest: f64,
}

/// Lights somewhere in the scene.
#[derive(Clone, Debug)]
struct Near {
    tree: LightTree,
    /// The number of each in the tree among the scene's lights.
    indices: Vec<u32>,
}

/// Lights infinitely far away.
#[derive(Clone, Debug)]
struct Far {
    by_fluence: Discrete,
    indices: Vec<u32>,
    fluence: f64,
    /// The share of the choices that they have at least.
    least: f64,
}

/// Either group has at least this share of the choices; a sky of one colour has less.
const LEAST_OF_A_GROUP: f64 = 0.25;
/// A sky of one colour counts for so much of what it gives, and has this share at least where nothing
/// else is far away: rays that leave a surface by chance find it as well as those that aim.
const SKY: f64 = 0.02;
/// So many choices are shared by all lights of a group alike.
const ALIKE: f64 = 0.1;

impl LightChoice {
    /// The choice among `lights`. Some may move: `span` says how far while the shutter is open.
    pub fn new(lights: &[Light], span: impl Fn(usize) -> Vec3) -> Self {
        let (mut bounds, mut near) = (Vec::new(), Vec::new());
        let (mut fluences, mut far, mut least) = (Vec::new(), Vec::new(), SKY);
        for (index, light) in lights.iter().enumerate().filter(|(_, l)| l.shines()) {
            match LightBounds::of(light) {
                Some(bound) => {
                    bounds.push(bound.swept(span(index)));
                    near.push(index as u32);
                }
                None => {
                    let all = light.fluence_from_afar();
                    let is_sky = matches!(light, Light::Sky(_));
                    fluences.push(if is_sky { SKY * all } else { all });
                    least = if is_sky { least } else { LEAST_OF_A_GROUP };
                    far.push(index as u32);
                }
            }
        }
        let fluence: f64 = fluences.iter().sum();
        let alike = ALIKE / fluences.len() as f64;
        let weights = fluences.iter().map(|f| (1.0 - ALIKE) * f / fluence + alike);
        LightChoice {
            only: match (near.as_slice(), far.as_slice()) {
                ([only], []) | ([], [only]) => Some(*only as usize),
                _ => None,
            },
            near: LightTree::new(&bounds).map(|tree| Near {
                tree,
                indices: near,
            }),
            far: Discrete::new(weights).map(|by_fluence| Far {
                by_fluence,
                indices: far,
                fluence,
                least,
            }),
        }
    }

    /// The only light, where there is no more to choose from.
    pub fn only(&self) -> Option<usize> {
        self.only
    }

    /// Draws a light for the point `p`; `None` where there is none, or all that are left on the way
    /// down the tree shine away from there.
    ///
    /// * Domain: `u` in `[0, 1)`, of 53 bits.
    /// * Probability: [`LightChoice::probability`].
    #[inline]
    pub fn choose(&self, p: Vec3, u: f64) -> Option<ChosenLight> {
        match self.only {
            Some(index) => Some(ChosenLight {
                index,
                probability: 1.0,
                rest: u,
            }),
            None => self.choose_one(p, u),
        }
    }

    fn choose_one(&self, p: Vec3, u: f64) -> Option<ChosenLight> {
        let share = self.near_share(p);
        let rescaled = |low: f64, share: f64| ((u - low) / share).clamp(0.0, LAST_FINE);
        let (index, probability, rest) = match (&self.near, &self.far) {
            (Some(near), _) if u < share => {
                let (index, probability, rest) = near.choose(p, rescaled(0.0, share))?;
                (index, probability * share, rest)
            }
            (_, Some(far)) => {
                let chosen = far.by_fluence.sample(rescaled(share, 1.0 - share));
                let probability = f64::from(chosen.probability) * (1.0 - share);
                (far.indices[chosen.index], probability, chosen.rest)
            }
            _ => return None,
        };
        Some(ChosenLight {
            index: index as usize,
            probability: probability as f32,
            rest,
        })
    }

    /// The probability with which [`LightChoice::choose`] draws the light `index` for the point `p`.
    #[inline]
    pub fn probability(&self, p: Vec3, index: usize) -> f32 {
        match self.only {
            Some(only) => f32::from(u8::from(only == index)),
            None => self.probability_of_one(p, index),
        }
    }

    fn probability_of_one(&self, p: Vec3, index: usize) -> f32 {
        let place = |indices: &[u32]| indices.binary_search(&(index as u32)).ok();
        let share = self.near_share(p);
        if let Some(near) = &self.near
            && let Some(at) = place(&near.indices)
        {
            return (near.probability(p, at) * share) as f32;
        }
        if let Some(far) = &self.far
            && let Some(at) = place(&far.indices)
        {
            return (f64::from(far.by_fluence.probability(at)) * (1.0 - share)) as f32;
        }
        0.0
    }

    /// The share of the choices that the lights of the scene have at `p`, beside those from afar.
    fn near_share(&self, p: Vec3) -> f64 {
        match (&self.near, &self.far) {
            (Some(_), None) => 1.0,
            (None, _) => 0.0,
            (Some(near), Some(far)) => {
                let here = near.tree.fluence(p);
                let share = here / (here + far.fluence);
                share.clamp(LEAST_OF_A_GROUP, 1.0 - far.least)
            }
        }
    }
}

impl Near {
    fn choose(&self, p: Vec3, u: f64) -> Option<(u32, f64, f64)> {
        let count = self.indices.len();
        let (at, by_tree, rest) = if u < ALIKE {
            let scaled = u / ALIKE * count as f64;
            let at = (scaled as usize).min(count - 1) as u32;
            let rest = (scaled - f64::from(at)).clamp(0.0, LAST_FINE);
            (at, self.tree.probability(p, at), rest)
        } else {
            self.tree
                .choose(p, ((u - ALIKE) / (1.0 - ALIKE)).min(LAST_FINE))?
        };
        Some((self.indices[at as usize], mixed(by_tree, count), rest))
    }

    fn probability(&self, p: Vec3, at: usize) -> f64 {
        mixed(self.tree.probability(p, at as u32), self.indices.len())
    }
}

/// The probability of a light that the tree draws so often, one of `count`.
fn mixed(by_tree: f64, count: usize) -> f64 {
    (1.0 - ALIKE) * by_tree + ALIKE / count as f64
}
