//! A bounding volume hierarchy: the first hit without testing every shape.

mod build;
mod node;
mod packet;

use super::{Aabb, Intersection, PreparedRay, Primitive, Ray, Shape, Surface, Triangle};
use arrayvec::ArrayVec;
use build::{Held, MAX_DEPTH, Tree, build};
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
/// Tracing 2008). Triangles are kept eight by eight, in some 50 bytes each; every other shape has a
/// box of its own in some node, so that few are tested which the ray does not cross. Shapes whose box
/// is not finite cannot be hit and are left out.
///
/// A tree over [`Moving`](super::Moving) shapes is the same code.
#[derive(Clone, Debug)]
pub struct Bvh<P = Shape> {
    tree: Tree<P>,
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
    shape: Met<'a, P>,
}

/// A shape of a tree.
#[derive(Clone, Copy, Debug)]
enum Met<'a, P> {
    Shape(&'a P),
    Triangle(Triangle),
}

impl<P: Primitive> ClosestHit<'_, P> {
    /// The surface there.
    ///
    /// * `ray`: the one that met it.
    pub fn surface(&self, ray: &Ray) -> Surface {
        match &self.shape {
            Met::Shape(shape) => shape.surface(ray, self.intersection),
            Met::Triangle(triangle) => Surface {
                time: ray.time,
                ..triangle.surface(self.intersection)
            },
        }
    }
}

/// Where in the tree a shape is.
#[derive(Clone, Copy)]
enum Place {
    Shape(usize),
    /// A packet, and the lane of a triangle in it.
    Packet(usize, usize),
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
    ///
    /// Large trees are built by all threads, and are the same for any number of them.
    pub fn new(shapes: &[P]) -> Self {
        Bvh {
            tree: build(shapes),
            level: Level::new(),
        }
    }

    /// The box of all shapes, wherever they are while the shutter is open.
    pub fn bounds(&self) -> Aabb {
        self.tree.nodes.first().map_or(Aabb::EMPTY, Node::bounds)
    }

    /// The first crossing of the ray, at its moment; of several shapes at the same distance the one
    /// with the lowest id, whatever the order of the tree.
    pub fn first_hit(&self, ray: &Ray) -> Option<ClosestHit<'_, P>> {
        dispatch!(self.level, s => self.find_first::<_, false>(s, ray))
    }

    /// The same among the shapes that are triangles at all times: [`Primitive::still_triangle`].
    pub fn first_triangle(&self, ray: &Ray) -> Option<ClosestHit<'_, P>> {
        dispatch!(self.level, s => self.find_first::<_, true>(s, ray))
    }

    /// True where the ray crosses anything at all, at its moment.
    pub fn occluded(&self, ray: &Ray) -> bool {
        dispatch!(self.level, s => self.find_any::<_, false>(s, ray))
    }

    /// The same of the shapes that are triangles at all times.
    pub fn occluded_by_triangles(&self, ray: &Ray) -> bool {
        dispatch!(self.level, s => self.find_any::<_, true>(s, ray))
    }

    /// Visits the nearest boxes first, and none beyond what was met.
    #[inline(always)]
    fn find_first<S: Simd, const TRIANGLES: bool>(
        &self,
        s: S,
        ray: &Ray,
    ) -> Option<ClosestHit<'_, P>> {
        let tree = &self.tree;
        if tree.nodes.is_empty() || !ray.is_valid() {
            return None;
        }
        let prepared = PreparedRay::from(ray);
        let lanes_of_ray = RayLanes::new(s, &prepared);
        let mut t_max = ray.reach();
        let mut best: Option<(Intersection, u32, Place)> = None;
        let mut meet = |met: Intersection, id: u32, place: Place| {
            if best.is_none_or(|(before, i, _)| met.t < before.t || id < i) {
                best = Some((met, id, place));
            }
            met.t
        };
        let mut stack = ArrayVec::<StackEntry, STACK_SIZE>::new();
        let mut next = StackEntry::new(0.0, Child::Node(0).into());
        loop {
            if next.entry() <= t_max {
                match next.link().child() {
                    Child::Shape(at) => {
                        let Held { id, shape } = &tree.shapes[at];
                        if !TRIANGLES
                            && let Some(met) = shape.intersect_from(&prepared, t_max, next.entry())
                        {
                            t_max = meet(met, *id, Place::Shape(at));
                        }
                    }
                    Child::Packet(at) => {
                        let packet = &tree.packets[at];
                        for lane in lanes(packet.candidates(s, &prepared)) {
                            if let Some(met) = packet.triangle(lane).intersect(&prepared, t_max) {
                                t_max = meet(met, packet.ids[lane], Place::Packet(at, lane));
                            }
                        }
                    }
                    Child::Node(at) => {
                        let node = &tree.nodes[at];
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
                None => break,
            }
        }
        best.map(|(intersection, id, place)| ClosestHit {
            intersection,
            id,
            shape: match place {
                Place::Shape(at) => Met::Shape(&tree.shapes[at].shape),
                Place::Packet(at, lane) => Met::Triangle(tree.packets[at].triangle(lane)),
            },
        })
    }

    /// Visits boxes in no particular order, for anything will do.
    #[inline(always)]
    fn find_any<S: Simd, const TRIANGLES: bool>(&self, s: S, ray: &Ray) -> bool {
        let tree = &self.tree;
        if tree.nodes.is_empty() || !ray.is_valid() {
            return false;
        }
        let prepared = PreparedRay::from(ray);
        let lanes_of_ray = RayLanes::new(s, &prepared);
        let t_max = ray.reach();
        let mut stack = ArrayVec::<StackEntry, STACK_SIZE>::new();
        let mut next = StackEntry::new(0.0, Child::Node(0).into());
        loop {
            let met = match next.link().child() {
                Child::Shape(at) => {
                    let shape = &tree.shapes[at].shape;
                    !TRIANGLES
                        && shape
                            .intersect_from(&prepared, t_max, next.entry())
                            .is_some()
                }
                Child::Packet(at) => {
                    let packet = &tree.packets[at];
                    let mut met = false;
                    for lane in lanes(packet.candidates(s, &prepared)) {
                        met |= packet.triangle(lane).intersect(&prepared, t_max).is_some();
                    }
                    met
                }
                Child::Node(at) => {
                    let node = &tree.nodes[at];
                    let (entries, met) = node.entries(s, &lanes_of_ray, t_max);
                    for lane in lanes(met) {
                        stack.push(StackEntry::new(entries[lane], node.links[lane]));
                    }
                    false
                }
            };
            if met {
                return true;
            }
            match stack.pop() {
                Some(waiting) => next = waiting,
                None => return false,
            }
        }
    }
}

impl Bvh {
    /// The shapes, each with its index in the list the tree was built from, in no particular order.
    pub fn shapes(&self) -> impl Iterator<Item = (u32, Shape)> {
        let shapes = self.tree.shapes.iter().map(|held| (held.id, held.shape));
        let triangles = self.tree.packets.iter().flat_map(Packet::triangles);
        shapes.chain(triangles.map(|(id, triangle)| (id, Shape::Triangle(triangle))))
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
