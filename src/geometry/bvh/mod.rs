//! A bounding volume hierarchy: the first hit without testing every shape.

mod build;
mod node;
mod packet;

use super::{Aabb, Intersection, PreparedRay, Primitive, Ray, Shape};
use arrayvec::ArrayVec;
use build::{MAX_DEPTH, build};
use fearless_simd::{Level, Simd, dispatch};
use node::{Child, Link, Node, RayLanes, WIDTH};
use packet::Packet;

/// Every node on the way down leaves at most all its children but one waiting.
const STACK_SIZE: usize = MAX_DEPTH * (WIDTH - 1) + 1;

/// A tree of boxes over shapes, eight to a node.
///
/// Built by the binned surface area heuristic (Wald, On Fast Construction of SAH-based Bounding
/// Volume Hierarchies, Symposium on Interactive Ray Tracing 2007), wide for the sake of vector
/// instructions (Wald, Benthin, Boulos, Getting Rid of Packets, Symposium on Interactive Ray
/// Tracing 2008). Every shape has a box of its own in some node, so that few are tested which the
/// ray does not cross. Shapes whose box is not finite cannot be hit and are left out.
///
/// A tree over [`Moving`](super::Moving) shapes is the same code.
#[derive(Clone, Debug)]
pub struct Bvh<P = Shape> {
    /// The root first; empty for no shapes.
    nodes: Vec<Node>,
    packets: Vec<Packet>,
    /// In the order of the tree.
    shapes: Vec<P>,
    /// For each of `shapes`, its index in the list the tree was built from.
    ids: Vec<u32>,
    /// The processor's instructions for eight boxes at once.
    level: Level,
}

/// What a ray meets first.
#[derive(Clone, Copy, Debug)]
pub struct ClosestHit<'a, P = Shape> {
    /// Where.
    pub intersection: Intersection,
    /// The index of the shape in the list the tree was built from.
    pub id: u32,
    /// The shape.
    pub shape: &'a P,
}

/// What waits to be visited, with the distance of its box in the upper half: the order of these
/// numbers is that of the distances, for those are not negative.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
struct StackEntry(u64);

impl StackEntry {
    #[inline(always)]
    fn new(entry: f32, link: Link) -> Self {
        StackEntry(u64::from(entry.to_bits()) << 32 | u64::from(link.0))
    }

    #[inline(always)]
    fn entry(self) -> f32 {
        f32::from_bits((self.0 >> 32) as u32)
    }

    #[inline(always)]
    fn link(self) -> Link {
        Link(self.0 as u32)
    }
}

impl<P: Primitive> Bvh<P> {
    /// The tree over `shapes`; the index of each in this list is its id.
    pub fn new(shapes: &[P]) -> Self {
        let tree = build(shapes);
        let ids = tree.ids();
        Bvh {
            nodes: tree.nodes,
            packets: tree.packets,
            shapes: ids.iter().map(|id| shapes[*id as usize].clone()).collect(),
            ids,
            level: Level::new(),
        }
    }

    /// The box of all shapes, wherever they are while the shutter is open.
    pub fn bounds(&self) -> Aabb {
        let boxes = self.shapes.iter().map(Primitive::bounds);
        boxes.fold(Aabb::EMPTY, Aabb::union)
    }

    /// The shapes, each with its index in the list the tree was built from, in no particular order.
    pub fn shapes(&self) -> impl Iterator<Item = (u32, &P)> {
        self.ids.iter().copied().zip(&self.shapes)
    }

    /// The first crossing of the ray, at its moment; of several shapes at the same distance the one
    /// with the lowest id, whatever the order of the tree.
    pub fn first_hit(&self, ray: &Ray) -> Option<ClosestHit<'_, P>> {
        dispatch!(self.level, s => self.find_first(s, ray))
    }

    #[inline(always)]
    fn find_first<S: Simd>(&self, s: S, ray: &Ray) -> Option<ClosestHit<'_, P>> {
        let mut best: Option<(Intersection, usize)> = None;
        self.visit(s, ray, |at, intersection| {
            if best.is_none_or(|(b, i)| intersection.t < b.t || self.ids[at] < self.ids[i]) {
                best = Some((intersection, at));
            }
            false
        });
        best.map(|(intersection, at)| ClosestHit {
            intersection,
            id: self.ids[at],
            shape: &self.shapes[at],
        })
    }

    /// True where the ray crosses anything at all, at its moment.
    pub fn occluded(&self, ray: &Ray) -> bool {
        dispatch!(self.level, s => self.find_any(s, ray))
    }

    #[inline(always)]
    fn find_any<S: Simd>(&self, s: S, ray: &Ray) -> bool {
        let mut hit = false;
        self.visit(s, ray, |_, _| {
            hit = true;
            true
        });
        hit
    }

    /// Calls `meet` with every crossing that may be the first, and the place of its shape, nearest
    /// boxes first, until it answers true.
    #[inline(always)]
    fn visit<S: Simd>(&self, s: S, ray: &Ray, mut meet: impl FnMut(usize, Intersection) -> bool) {
        if self.nodes.is_empty() || !ray.is_valid() {
            return;
        }
        let prepared = PreparedRay::from(ray);
        let lanes_of_ray = RayLanes::new(s, &prepared);
        let mut t_max = ray.reach();
        let mut stack = ArrayVec::<StackEntry, STACK_SIZE>::new();
        let mut next = StackEntry::new(0.0, Child::Node(0).into());
        loop {
            if next.entry() <= t_max {
                match next.link().child() {
                    Child::Shape(at) => {
                        if let Some(intersection) =
                            self.shapes[at].intersect_from(&prepared, t_max, next.entry())
                        {
                            t_max = intersection.t;
                            if meet(at, intersection) {
                                return;
                            }
                        }
                    }
                    Child::Packet(at) => {
                        let packet = &self.packets[at];
                        for lane in lanes(packet.candidates(s, &prepared)) {
                            if let Some(intersection) =
                                packet.triangle(lane).intersect(&prepared, t_max)
                            {
                                t_max = intersection.t;
                                if meet(packet.first as usize + lane, intersection) {
                                    return;
                                }
                            }
                        }
                    }
                    Child::Node(at) => {
                        let node = &self.nodes[at];
                        let (entries, met) = node.entries(s, &lanes_of_ray, t_max);
                        let base = stack.len();
                        for lane in lanes(met) {
                            // The nearest is the last to be pushed, and the first to be visited.
                            let mut child = StackEntry::new(entries[lane], node.links[lane]);
                            for before in &mut stack[base..] {
                                (*before, child) = (child.max(*before), child.min(*before));
                            }
                            stack.push(child);
                        }
                    }
                }
            }
            match stack.pop() {
                Some(waiting) => next = waiting,
                None => return,
            }
        }
    }
}

/// The lanes whose bits are set.
#[inline(always)]
fn lanes(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = mask.trailing_zeros() as usize % WIDTH;
        let left = mask != 0;
        mask &= mask.wrapping_sub(1);
        left.then_some(lane)
    })
}

/// The tree's answer without the tree: every shape is tested. Slow, plain, the yardstick.
pub fn brute_force<P: Primitive>(shapes: &[P], ray: &Ray) -> Option<(Intersection, u32)> {
    if !ray.is_valid() {
        return None;
    }
    let prepared = PreparedRay::from(ray);
    let mut best: Option<(Intersection, u32)> = None;
    for (id, shape) in shapes.iter().enumerate() {
        if let Some(intersection) = shape.intersect(&prepared, ray.reach())
            && best.is_none_or(|(b, _)| intersection.t < b.t)
        {
            best = Some((intersection, id as u32));
        }
    }
    best
}
