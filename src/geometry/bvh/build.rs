//! How the tree comes to be: boxes in groups, groups in nodes.

use super::node::{Child, Node, WIDTH};
use super::packet::Packet;
use crate::geometry::{Aabb, Primitive, Triangle};
use std::ops::Range;

/// Slices of the centroid range in which the surface area heuristic looks for a split.
const BINS: usize = 16;
/// Nodes on the longest way down: enough for 2³⁶ shapes even if all are in one place.
pub(super) const MAX_DEPTH: usize = 12;

/// A shape while the tree is built.
#[derive(Clone, Copy)]
struct Item {
    bounds: Aabb,
    center: [f32; 3],
    id: u32,
}

/// A tree that grows.
pub(super) struct Builder<'a, P> {
    shapes: &'a [P],
    items: Vec<Item>,
    pub(super) nodes: Vec<Node>,
    pub(super) packets: Vec<Packet>,
}

/// The tree over these shapes.
pub(super) fn build<P: Primitive>(shapes: &[P]) -> Builder<'_, P> {
    let item = |(id, shape): (usize, &P)| {
        let bounds = shape.bounds();
        Item {
            bounds,
            center: bounds.center().to_array(),
            id: id as u32,
        }
    };
    let all = shapes.iter().enumerate().map(item);
    let mut tree = Builder {
        shapes,
        items: all.filter(|item| item.bounds.is_finite()).collect(),
        nodes: Vec::new(),
        packets: Vec::new(),
    };
    if !tree.items.is_empty() {
        tree.add_node(0..tree.items.len(), MAX_DEPTH);
    }
    tree
}

/// Items that belong together.
struct Group {
    range: Range<usize>,
    bounds: Aabb,
}

impl Group {
    fn new(items: &[Item], range: Range<usize>) -> Self {
        let all = items[range.clone()].iter();
        Group {
            bounds: all.fold(Aabb::EMPTY, |b, item| b.union(item.bounds)),
            range,
        }
    }

    /// True where its items do not fit into one node.
    fn is_large(&self) -> bool {
        self.range.len() > WIDTH
    }
}

impl<P: Primitive> Builder<'_, P> {
    /// The ids of the shapes in the order of the tree.
    pub(super) fn ids(&self) -> Vec<u32> {
        self.items.iter().map(|item| item.id).collect()
    }

    /// Adds the subtree over a range of the items, at most `depth` nodes deep, and says where.
    fn add_node(&mut self, range: Range<usize>, depth: usize) -> usize {
        let at = self.nodes.len();
        self.nodes.push(Node::new(&[]));
        let mut children = Vec::with_capacity(WIDTH);
        for group in self.children(range, depth) {
            let child = if group.range.len() == 1 {
                Child::Shape(group.range.start)
            } else if let Some(packet) = self.packet(&group.range) {
                self.packets.push(packet);
                Child::Packet(self.packets.len() - 1)
            } else {
                Child::Node(self.add_node(group.range, depth - 1))
            };
            children.push((group.bounds, child));
        }
        self.nodes[at] = Node::new(&children);
        at
    }

    /// The packet of a few items that are all triangles.
    fn packet(&self, range: &Range<usize>) -> Option<Packet> {
        if range.len() > WIDTH {
            return None;
        }
        let items = self.items[range.clone()].iter();
        let triangles: Option<Vec<Triangle>> = items
            .map(|item| self.shapes[item.id as usize].still_triangle())
            .collect();
        Some(Packet::new(range.start, &triangles?))
    }

    /// Divides a range of the items into at most eight groups.
    fn children(&mut self, range: Range<usize>, depth: usize) -> Vec<Group> {
        let items = &mut self.items;
        // A child of almost all items must still find room below; else halves make eighths.
        let by_count = range.len() as u64 > (WIDTH as u64).pow(depth as u32 - 1);
        let mut groups = vec![Group::new(items, range)];
        while groups.len() < WIDTH {
            let size = |g: &Group| match by_count {
                true => g.range.len() as f64,
                false => g.bounds.half_area(),
            };
            let large = groups.iter().enumerate().filter(|(_, g)| g.is_large());
            let Some((at, _)) = large.max_by(|a, b| size(a.1).total_cmp(&size(b.1))) else {
                break;
            };
            let Range { start, end } = groups.swap_remove(at).range;
            let middle = start + divide(&mut items[start..end], by_count);
            groups.push(Group::new(items, start..middle));
            groups.push(Group::new(items, middle..end));
        }
        // Where places are left, the smallest groups need no node of their own.
        groups.sort_by_key(|g| g.range.len());
        let mut free = WIDTH - groups.len();
        let mut children = Vec::with_capacity(WIDTH);
        for group in groups {
            let more = group.range.len() - 1;
            if more <= free && self.packet(&group.range).is_none() {
                free -= more;
                children.extend(group.range.map(|i| Group::new(&self.items, i..i + 1)));
            } else {
                children.push(group);
            }
        }
        children
    }
}

/// Orders `items` into a left and a right part and says where the right one begins.
fn divide(items: &mut [Item], by_count: bool) -> usize {
    match best_plane(items) {
        Some(plane) if !by_count => plane.partition(items),
        // Where no plane separates the centres, order is all that is left.
        _ => items.len() / 2,
    }
}

/// A plane between two bins of the centres along one axis.
struct Plane {
    axis: usize,
    slices: Slices,
    /// The last bin on the left.
    last: usize,
    /// Area times count, summed over both sides.
    cost: f64,
}

impl Plane {
    fn partition(&self, items: &mut [Item]) -> usize {
        let mut left = 0;
        for i in 0..items.len() {
            if self.slices.bin(items[i].center[self.axis]) <= self.last {
                items.swap(i, left);
                left += 1;
            }
        }
        left
    }
}

/// Equal slices of a range of coordinates.
#[derive(Clone, Copy)]
struct Slices {
    low: f64,
    per_unit: f64,
}

impl Slices {
    fn bin(&self, coordinate: f32) -> usize {
        let slice = (f64::from(coordinate) - self.low) * self.per_unit;
        (slice as usize).min(BINS - 1)
    }
}

/// The cheapest plane over the three axes; `None` where all centres coincide.
fn best_plane(items: &[Item]) -> Option<Plane> {
    (0..3)
        .filter_map(|axis| best_plane_along(items, axis))
        .min_by(|a, b| a.cost.total_cmp(&b.cost))
}

fn best_plane_along(items: &[Item], axis: usize) -> Option<Plane> {
    let centers = items.iter().map(|item| f64::from(item.center[axis]));
    let low = centers.clone().fold(f64::INFINITY, f64::min);
    let high = centers.fold(f64::NEG_INFINITY, f64::max);
    if low >= high {
        return None;
    }
    let slices = Slices {
        low,
        per_unit: BINS as f64 / (high - low),
    };
    let mut bins = [(Aabb::EMPTY, 0_usize); BINS];
    for item in items {
        let (bounds, count) = &mut bins[slices.bin(item.center[axis])];
        *bounds = bounds.union(item.bounds);
        *count += 1;
    }
    let grow = |(sum, n): (Aabb, usize), (b, m): (Aabb, usize)| (sum.union(b), n + m);
    let cost = |(b, n): (Aabb, usize)| b.half_area() * n.div_ceil(WIDTH) as f64;
    // From the right, what each plane has on its right side; then planes from the left.
    let mut right = bins;
    for i in (0..BINS - 1).rev() {
        right[i] = grow(right[i + 1], bins[i]);
    }
    let mut left = (Aabb::EMPTY, 0);
    (0..BINS - 1)
        .filter_map(|last| {
            left = grow(left, bins[last]);
            (left.1 > 0 && right[last + 1].1 > 0).then(|| Plane {
                axis,
                slices,
                last,
                cost: cost(left) + cost(right[last + 1]),
            })
        })
        .min_by(|a, b| a.cost.total_cmp(&b.cost))
}
