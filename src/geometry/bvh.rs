//! A bounding volume hierarchy: the first hit without testing every shape.

use super::{Aabb, Crossing, PreparedRay, Ray, Shape};

/// Shapes in a leaf are tested one after the other; below this many no split is tried.
const LEAF_SIZE: usize = 4;
/// Slices of the centroid range in which the surface area heuristic looks for a split.
const BINS: usize = 16;
/// From this depth on nodes are halved by count, which ends within 32 further levels.
const MAX_HEURISTIC_DEPTH: usize = 48;
/// Deep enough for any tree the two rules above can make.
const STACK_SIZE: usize = MAX_HEURISTIC_DEPTH + 32;
/// The cost of visiting an inner node, in units of one shape test.
const VISIT_COST: f64 = 1.0;

/// A binary tree of boxes over shapes.
///
/// Built by the binned surface area heuristic (Wald, On Fast Construction of SAH-based Bounding
/// Volume Hierarchies, Symposium on Interactive Ray Tracing 2007). Shapes whose box is not finite
/// cannot be hit and are left out.
#[derive(Clone, Debug, Default)]
pub struct Bvh {
    /// Depth first: the left child of a node is the next one.
    nodes: Vec<Node>,
    /// In leaf order.
    shapes: Vec<Shape>,
    /// For each of `shapes`, its index in the list the tree was built from.
    ids: Vec<u32>,
}

/// What a ray meets first.
#[derive(Clone, Copy, Debug)]
pub struct Found<'a> {
    /// Where.
    pub crossing: Crossing,
    /// The index of the shape in the list the tree was built from.
    pub id: u32,
    /// The shape.
    pub shape: &'a Shape,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Aabb,
    /// The right child of an inner node, the first shape of a leaf.
    link: u32,
    /// The number of shapes of a leaf; 0 marks an inner node.
    count: u32,
}

/// A shape while the tree is built.
#[derive(Clone, Copy)]
struct Item {
    bounds: Aabb,
    center: [f32; 3],
    id: u32,
}

impl Bvh {
    /// The tree over `shapes`; the index of each in this list is its id.
    pub fn new(shapes: &[Shape]) -> Self {
        let mut items: Vec<Item> = shapes
            .iter()
            .enumerate()
            .map(|(id, shape)| {
                let bounds = shape.bounds();
                Item {
                    bounds,
                    center: bounds.center().to_array(),
                    id: id as u32,
                }
            })
            .filter(|item| item.bounds.is_finite())
            .collect();
        let mut nodes = Vec::with_capacity(items.len());
        if !items.is_empty() {
            build(&mut nodes, &mut items, 0, 0);
        }
        Bvh {
            nodes,
            shapes: items.iter().map(|i| shapes[i.id as usize]).collect(),
            ids: items.iter().map(|i| i.id).collect(),
        }
    }

    /// The first crossing of the ray; of several shapes at the same distance the one with the
    /// lowest id, whatever the order of the tree.
    pub fn first(&self, ray: &Ray) -> Option<Found<'_>> {
        let mut best: Option<Found> = None;
        self.visit(ray, |shape, id, prepared, t_max| {
            if let Some(crossing) = shape.cross(prepared, *t_max)
                && best.is_none_or(|b| crossing.t < b.crossing.t || id < b.id)
            {
                best = Some(Found {
                    crossing,
                    id,
                    shape,
                });
                *t_max = crossing.t;
            }
            false
        });
        best
    }

    /// True where the ray crosses anything at all.
    pub fn any(&self, ray: &Ray) -> bool {
        let mut hit = false;
        self.visit(ray, |shape, _, prepared, t_max| {
            hit = shape.cross(prepared, *t_max).is_some();
            hit
        });
        hit
    }

    /// Calls `meet` with every shape whose box the ray enters before `t_max`, nearest boxes first,
    /// until it answers true.
    #[inline(always)]
    fn visit<'a>(
        &'a self,
        ray: &Ray,
        mut meet: impl FnMut(&'a Shape, u32, &PreparedRay, &mut f32) -> bool,
    ) {
        if self.nodes.is_empty() || !ray.is_valid() {
            return;
        }
        let prepared = PreparedRay::from(ray);
        let mut t_max = ray.reach();
        let mut stack = [(0_u32, 0.0_f32); STACK_SIZE];
        let mut height = 0;
        let mut at = 0_usize;
        if self.nodes[0].bounds.entry(&prepared, t_max).is_none() {
            return;
        }
        loop {
            let node = &self.nodes[at];
            if node.count > 0 {
                let first = node.link as usize;
                for i in first..first + node.count as usize {
                    if meet(&self.shapes[i], self.ids[i], &prepared, &mut t_max) {
                        return;
                    }
                }
            } else {
                let (left, right) = (at + 1, node.link as usize);
                let entry = |i: usize| self.nodes[i].bounds.entry(&prepared, t_max);
                match (entry(left), entry(right)) {
                    (Some(l), Some(r)) => {
                        // The nearer child first; the other waits with its distance.
                        let (near, far, t) = if r < l {
                            (right, left, l)
                        } else {
                            (left, right, r)
                        };
                        stack[height] = (far as u32, t);
                        height += 1;
                        at = near;
                        continue;
                    }
                    (Some(_), None) => {
                        at = left;
                        continue;
                    }
                    (None, Some(_)) => {
                        at = right;
                        continue;
                    }
                    (None, None) => {}
                }
            }
            // Back to the last child left waiting that still begins before the nearest hit.
            loop {
                if height == 0 {
                    return;
                }
                height -= 1;
                let (next, t) = stack[height];
                if t <= t_max {
                    at = next as usize;
                    break;
                }
            }
        }
    }
}

/// Adds the subtree over `items` to `nodes`; `first` is the place of `items[0]` in leaf order.
fn build(nodes: &mut Vec<Node>, items: &mut [Item], first: usize, depth: usize) {
    let bounds = items
        .iter()
        .fold(Aabb::EMPTY, |b, item| b.union(item.bounds));
    let at = nodes.len();
    nodes.push(Node {
        bounds,
        link: first as u32,
        count: items.len() as u32,
    });
    if let Some(middle) = divide(&bounds, items, depth) {
        let (left, right) = items.split_at_mut(middle);
        build(nodes, left, first, depth + 1);
        nodes[at].link = nodes.len() as u32;
        nodes[at].count = 0;
        build(nodes, right, first + middle, depth + 1);
    }
}

/// Orders `items` into a left and a right part and says where the right one begins; `None` where
/// they are better off as a leaf.
fn divide(bounds: &Aabb, items: &mut [Item], depth: usize) -> Option<usize> {
    let many = items.len() > LEAF_SIZE;
    if items.len() > 1
        && depth < MAX_HEURISTIC_DEPTH
        && let Some(plane) = best_plane(items)
    {
        let as_leaf = bounds.half_area() * items.len() as f64;
        let as_node = bounds.half_area() * VISIT_COST + plane.cost;
        return (many || as_node < as_leaf).then(|| plane.partition(items));
    }
    // Where no plane separates the centres, order is all that is left: halve by count.
    many.then_some(items.len() / 2)
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
    let cost = |(b, n): (Aabb, usize)| {
        if n == 0 {
            0.0
        } else {
            b.half_area() * n as f64
        }
    };
    (0..BINS - 1)
        .filter_map(|last| {
            let left = bins[..=last].iter().copied().fold((Aabb::EMPTY, 0), grow);
            let right = bins[last + 1..]
                .iter()
                .copied()
                .fold((Aabb::EMPTY, 0), grow);
            (left.1 > 0 && right.1 > 0).then(|| Plane {
                axis,
                slices,
                last,
                cost: cost(left) + cost(right),
            })
        })
        .min_by(|a, b| a.cost.total_cmp(&b.cost))
}

/// The tree's answer without the tree: every shape is tested. Slow, plain, the yardstick.
pub fn brute_force(shapes: &[Shape], ray: &Ray) -> Option<(Crossing, u32)> {
    if !ray.is_valid() {
        return None;
    }
    let prepared = PreparedRay::from(ray);
    let mut best: Option<(Crossing, u32)> = None;
    for (id, shape) in shapes.iter().enumerate() {
        if let Some(crossing) = shape.cross(&prepared, ray.reach())
            && best.is_none_or(|(b, _)| crossing.t < b.t)
        {
            best = Some((crossing, id as u32));
        }
    }
    best
}
