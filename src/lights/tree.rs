//! A light tree: choosing one of many lights by what it may give at a point.

use super::bounds::LightBounds;
use crate::sampling::discrete::LAST_FINE;
use glam::Vec3;

/// A binary tree over lights, which knows of each branch where its lights are, which way they shine
/// and how strong they are.
///
/// On the way down each branch is chosen by its bound at the point: intensity over the square of the
/// distance, as far as any normal faces the point. What a surface does with the light is not asked,
/// so that the choice serves glass as well as walls.
///
/// Source: Conty Estevez, Kulla, Importance Sampling of Many Lights with Adaptive Tree Splitting
/// (PACMCGIT 1(2), 2018), without splitting: one light is chosen.
#[derive(Clone, Debug)]
pub struct LightTree {
    /// The root first, and each branch's first child behind it.
    nodes: Vec<Node>,
    /// For each light the way to its leaf: from the lowest bit on, one for each second child.
    ways: Vec<u64>,
}

#[derive(Clone, Debug)]
struct Node {
    bounds: LightBounds,
    below: Below,
}

#[derive(Clone, Copy, Debug)]
enum Below {
    /// The number of one light.
    Light(u32),
    /// The place of the second child.
    Branch(u32),
}

/// Deeper down lights are split in halves, whatever it costs: a way has 64 bits.
const DEEPEST_BY_COST: u32 = 24;
/// Places at which a group of lights may be split along an axis.
const BINS: usize = 12;

impl LightTree {
    /// The tree over these lights; `None` for none.
    pub fn new(lights: &[LightBounds]) -> Option<Self> {
        if lights.is_empty() {
            return None;
        }
        let mut tree = LightTree {
            nodes: Vec::with_capacity(2 * lights.len()),
            ways: vec![0; lights.len()],
        };
        let mut all: Vec<u32> = (0..lights.len() as u32).collect();
        tree.add(lights, &mut all, 0, 0);
        Some(tree)
    }

    fn add(&mut self, lights: &[LightBounds], group: &mut [u32], depth: u32, way: u64) {
        let of = |i: &u32| lights[*i as usize];
        let place = self.nodes.len();
        if let [light] = *group {
            self.ways[light as usize] = way;
            self.nodes.push(Node {
                bounds: of(&light),
                below: Below::Light(light),
            });
            return;
        }
        let middle = split(lights, group, depth);
        let (first, second) = group.split_at_mut(middle);
        self.nodes.push(Node {
            bounds: of(&first[0]),
            below: Below::Light(0),
        });
        self.add(lights, first, depth + 1, way);
        let at = self.nodes.len();
        self.add(lights, second, depth + 1, way | 1 << depth);
        self.nodes[place] = Node {
            bounds: self.nodes[place + 1].bounds.union(self.nodes[at].bounds),
            below: Below::Branch(at as u32),
        };
    }

    /// About the fluence of all lights at `p`, in W/m² (see [`LightBounds::fluence`]).
    pub fn fluence(&self, p: Vec3) -> f64 {
        self.nodes[0].bounds.fluence(p)
    }

    /// Draws a light for the point `p`, with its probability and what is left of the uniform; `None`
    /// where all that is left of the lights shines away from there.
    ///
    /// * Domain: `u` in `[0, 1)`, of 53 bits.
    /// * Probability: [`LightTree::probability`].
    pub fn choose(&self, p: Vec3, mut u: f64) -> Option<(u32, f64, f64)> {
        let (mut at, mut probability) = (0, 1.0);
        loop {
            let second = match self.nodes[at].below {
                Below::Light(light) => return Some((light, probability, u)),
                Below::Branch(second) => second as usize,
            };
            let share = self.first_share(at + 1, second, p)?;
            let (next, chance, below) = if u < share {
                (at + 1, share, 0.0)
            } else {
                (second, 1.0 - share, share)
            };
            u = ((u - below) / chance).clamp(0.0, LAST_FINE);
            probability *= chance;
            at = next;
        }
    }

    /// The probability with which [`LightTree::choose`] draws `light` for the point `p`.
    pub fn probability(&self, p: Vec3, light: u32) -> f64 {
        let (mut at, mut probability) = (0, 1.0);
        let mut way = self.ways[light as usize];
        while let Below::Branch(second) = self.nodes[at].below {
            let second = second as usize;
            let Some(share) = self.first_share(at + 1, second, p) else {
                return 0.0;
            };
            let (next, chance) = if way & 1 == 0 {
                (at + 1, share)
            } else {
                (second, 1.0 - share)
            };
            probability *= chance;
            way >>= 1;
            at = next;
        }
        probability
    }

    /// The share of the first of two children; `None` where neither shines towards `p`.
    fn first_share(&self, first: usize, second: usize, p: Vec3) -> Option<f64> {
        let [a, b] = [first, second].map(|child| self.nodes[child].bounds.fluence(p));
        (a + b > 0.0).then(|| a / (a + b))
    }
}

/// Puts those of a group that belong together side by side, and says where the second half begins.
fn split(lights: &[LightBounds], group: &mut [u32], depth: u32) -> usize {
    let center = |i: &u32| lights[*i as usize].center();
    let low = group.iter().map(center).fold(Vec3::INFINITY, Vec3::min);
    let high = group.iter().map(center).fold(Vec3::NEG_INFINITY, Vec3::max);
    let size = high.as_dvec3() - low.as_dvec3();
    let bin = |i: &u32, axis: usize| {
        let share = (f64::from(center(i)[axis]) - f64::from(low[axis])) / size[axis];
        ((share * BINS as f64) as usize).min(BINS - 1)
    };
    let mut best: Option<(f64, usize, usize)> = None;
    for axis in (0..3).filter(|&axis| size[axis] > 0.0 && depth < DEEPEST_BY_COST) {
        let mut bins: [Option<LightBounds>; BINS] = [None; BINS];
        for i in group.iter() {
            let slot = &mut bins[bin(i, axis)];
            let light = lights[*i as usize];
            *slot = Some(slot.map_or(light, |bounds| bounds.union(light)));
        }
        let all = |bins: &[Option<LightBounds>]| {
            bins.iter().flatten().copied().reduce(LightBounds::union)
        };
        for at in 1..BINS {
            if let (Some(first), Some(second)) = (all(&bins[..at]), all(&bins[at..])) {
                // Long thin boxes are split across their length.
                let cost = (first.cost() + second.cost()) * size.max_element() / size[axis];
                if best.is_none_or(|(least, ..)| cost < least) {
                    best = Some((cost, axis, at));
                }
            }
        }
    }
    match best {
        Some((_, axis, at)) => {
            group.sort_by_key(|i| bin(i, axis));
            group.partition_point(|i| bin(i, axis) < at)
        }
        None => {
            let axis = size.max_position();
            group.sort_by(|a, b| center(a)[axis].total_cmp(&center(b)[axis]));
            group.len() / 2
        }
    }
}
