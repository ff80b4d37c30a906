//! How the tree comes to be: boxes in groups, groups in nodes.

use super::node::{Child, Counts, Link, Node, WIDTH};
use super::packet::Packet;
use crate::geometry::{Aabb, Primitive, Triangle};
use rayon::prelude::*;

/// Slices of the centroid range in which the surface area heuristic looks for a split.
const BINS: usize = 16;
/// Shapes for which several threads are worth their while.
const MANY: usize = 4096;
/// Nodes on the longest way down: enough for 2³⁶ shapes even if all are in one place.
pub(super) const MAX_DEPTH: usize = 12;

/// A shape while the tree is built.
#[derive(Clone, Copy)]
struct Item {
    bounds: Aabb,
    center: [f32; 3],
    id: u32,
}

/// A tree, or a part of one whose links are its own.
#[derive(Clone, Debug)]
pub(super) struct Tree<P> {
    /// The root first; empty for no shapes.
    pub(super) nodes: Vec<Node>,
    pub(super) packets: Vec<Packet>,
    /// The shapes that are in no packet.
    pub(super) shapes: Vec<Held<P>>,
}

/// A shape with its index in the list that the tree was built from.
#[derive(Clone, Debug)]
pub(super) struct Held<P> {
    pub(super) id: u32,
    pub(super) shape: P,
}

/// The tree over these shapes.
pub(super) fn build<P: Primitive>(shapes: &[P]) -> Tree<P> {
    build_by(shapes, MANY)
}

/// The same, with parts of more than `many` shapes built side by side.
fn build_by<P: Primitive>(shapes: &[P], many: usize) -> Tree<P> {
    let item = |(id, shape): (usize, &P)| {
        let bounds = shape.bounds();
        Item {
            bounds,
            center: bounds.center().to_array(),
            id: id as u32,
        }
    };
    let all = shapes.iter().enumerate().map(item);
    let mut items: Vec<Item> = all.filter(|item| item.bounds.is_finite()).collect();
    let mut tree = Tree::default();
    if !items.is_empty() {
        Builder { shapes, many }.add_node(&mut tree, &mut items, MAX_DEPTH);
    }
    tree
}

impl<P> Default for Tree<P> {
    fn default() -> Self {
        Tree {
            nodes: Vec::new(),
            packets: Vec::new(),
            shapes: Vec::new(),
        }
    }
}

impl<P> Tree<P> {
    fn counts(&self) -> Counts {
        Counts {
            nodes: self.nodes.len(),
            shapes: self.shapes.len(),
            packets: self.packets.len(),
        }
    }

    /// Adds all of another tree, and says where its root is.
    fn absorb(&mut self, mut other: Tree<P>) -> usize {
        let before = self.counts();
        for link in other.nodes.iter_mut().flat_map(|node| &mut node.links) {
            *link = link.after(before);
        }
        self.nodes.append(&mut other.nodes);
        self.packets.append(&mut other.packets);
        self.shapes.append(&mut other.shapes);
        before.nodes
    }
}

/// What trees are made of.
struct Builder<'a, P> {
    shapes: &'a [P],
    many: usize,
}

/// Items that belong together.
struct Group<'i> {
    items: &'i mut [Item],
    bounds: Aabb,
}

impl<'i> Group<'i> {
    fn new(items: &'i mut [Item]) -> Self {
        Group {
            bounds: items
                .iter()
                .fold(Aabb::EMPTY, |b, item| b.union(item.bounds)),
            items,
        }
    }

    /// True where its items do not fit into one node.
    fn is_large(&self) -> bool {
        self.items.len() > WIDTH
    }
}

impl<P: Primitive> Builder<'_, P> {
    /// Adds the subtree over the items, at most `depth` nodes deep, and says where.
    fn add_node(&self, tree: &mut Tree<P>, items: &mut [Item], depth: usize) -> usize {
        let at = tree.nodes.len();
        tree.nodes.push(Node::new(&[]));
        let side_by_side = items.len() > self.many;
        let groups = self.children(items, depth);
        let children: Vec<(Aabb, Child)> = if side_by_side {
            let part = |group: Group| {
                let (mut part, bounds) = (Tree::default(), group.bounds);
                let child = self.add(&mut part, group, depth);
                (part, bounds, child)
            };
            let parts: Vec<_> = groups.into_par_iter().map(part).collect();
            let absorb = |(part, bounds, child): (Tree<P>, Aabb, Child)| {
                let child = Link::from(child).after(tree.counts()).child();
                tree.absorb(part);
                (bounds, child)
            };
            parts.into_iter().map(absorb).collect()
        } else {
            let add = |group: Group| (group.bounds, self.add(tree, group, depth));
            groups.into_iter().map(add).collect()
        };
        tree.nodes[at] = Node::new(&children);
        at
    }

    /// Adds a group of a node at this depth, and says what is in its box.
    fn add(&self, tree: &mut Tree<P>, group: Group, depth: usize) -> Child {
        if let [item] = &group.items {
            let (id, shape) = (item.id, &self.shapes[item.id as usize]);
            if shape.still_triangle().is_none() {
                let shape = shape.clone();
                tree.shapes.push(Held { id, shape });
                return Child::Shape(tree.shapes.len() - 1);
            }
        }
        match self.packet(group.items) {
            Some(packet) => {
                tree.packets.push(packet);
                Child::Packet(tree.packets.len() - 1)
            }
            None => Child::Node(self.add_node(tree, group.items, depth - 1)),
        }
    }

    /// The packet of a few items that are all triangles.
    fn packet(&self, items: &[Item]) -> Option<Packet> {
        if items.len() > WIDTH {
            return None;
        }
        let triangle = |item: &Item| {
            let triangle = self.shapes[item.id as usize].still_triangle()?;
            Some((item.id, triangle))
        };
        let triangles: Option<Vec<(u32, Triangle)>> = items.iter().map(triangle).collect();
        Some(Packet::new(&triangles?))
    }

    /// Divides items into at most eight groups.
    fn children<'i>(&self, items: &'i mut [Item], depth: usize) -> Vec<Group<'i>> {
        // A child of almost all items must still find room below; else halves make eighths.
        let by_count = items.len() as u64 > (WIDTH as u64).pow(depth as u32 - 1);
        let mut groups = vec![Group::new(items)];
        while groups.len() < WIDTH {
            let size = |g: &Group| match by_count {
                true => g.items.len() as f64,
                false => g.bounds.half_area(),
            };
            let large = groups.iter().enumerate().filter(|(_, g)| g.is_large());
            let Some((at, _)) = large.max_by(|a, b| size(a.1).total_cmp(&size(b.1))) else {
                break;
            };
            let items = groups.swap_remove(at).items;
            let middle = divide(items, by_count, self.many);
            let (left, right) = items.split_at_mut(middle);
            groups.push(Group::new(left));
            groups.push(Group::new(right));
        }
        // Where places are left, the smallest groups need no node of their own.
        groups.sort_by_key(|g| g.items.len());
        let mut free = WIDTH - groups.len();
        let mut children = Vec::with_capacity(WIDTH);
        for group in groups {
            let more = group.items.len() - 1;
            if more <= free && self.packet(group.items).is_none() {
                free -= more;
                children.extend(group.items.chunks_mut(1).map(Group::new));
            } else {
                children.push(group);
            }
        }
        children
    }
}

/// Orders `items` into a left and a right part and says where the right one begins.
fn divide(items: &mut [Item], by_count: bool, many: usize) -> usize {
    match best_plane(items, items.len() > many) {
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

/// The cheapest plane over the three axes, looked for along them one by one or side by side; `None` where all centres
/// coincide.
fn best_plane(items: &[Item], side_by_side: bool) -> Option<Plane> {
    let along = |axis| best_plane_along(items, axis);
    let planes: Vec<Option<Plane>> = match side_by_side {
        true => (0..3).into_par_iter().map(along).collect(),
        false => (0..3).map(along).collect(),
    };
    let planes = planes.into_iter().flatten();
    planes.min_by(|a, b| a.cost.total_cmp(&b.cost))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Shape, Sphere};
    use crate::sampling::stream::{Purpose, Stream};
    use glam::Vec3;

    #[test]
    fn a_triangle_of_a_mesh_takes_some_sixty_bytes() {
        let corner = |x: u32, y: u32| Vec3::new(x as f32, y as f32, libm::sinf((x * x + y) as f32));
        let cells = (0..100).flat_map(|x| (0..100).map(move |y| (x, y)));
        let mesh: Vec<Shape> = cells
            .flat_map(|(x, y)| {
                let (a, c) = (corner(x, y), corner(x + 1, y + 1));
                [corner(x + 1, y), corner(x, y + 1)].map(|b| Shape::Triangle(Triangle { a, b, c }))
            })
            .collect();
        let tree = build(&mesh);
        assert!(tree.shapes.is_empty());
        let bytes = tree.nodes.len() * size_of::<Node>() + tree.packets.len() * size_of::<Packet>();
        let each = bytes / mesh.len();
        assert!((45..65).contains(&each), "{each} bytes a triangle");
    }

    #[test]
    fn parts_built_side_by_side_make_the_same_tree() {
        let shapes: Vec<Shape> = (0..3000)
            .map(|i| {
                let mut numbers = Stream::new(4, i, 0).at(0, Purpose::Direction);
                let mut point = || Vec3::from([(); 3].map(|()| numbers.one()));
                let (a, b, c) = (point(), point() * 0.1, point() * 0.1);
                match i % 7 {
                    0 => Shape::Sphere(Sphere::new(a, 0.01)),
                    _ => Shape::Triangle(Triangle {
                        a,
                        b: a + b,
                        c: a + c,
                    }),
                }
            })
            .collect();
        let one = build_by(&shapes, usize::MAX);
        assert!(one.packets.len() > 300 && one.shapes.len() > 300 && one.nodes.len() > 100);
        for many in [0, 30, 1000] {
            let parts = build_by(&shapes, many);
            assert!(
                format!("{parts:?}") == format!("{one:?}"),
                "{many}: another tree"
            );
        }
    }
}
