//! Eight boxes side by side, tested as one.

use crate::geometry::aabb::EARLIER;
use crate::geometry::{Aabb, PreparedRay};
use fearless_simd::f32x8;
use fearless_simd::prelude::*;
use glam::Vec3;

/// Children of a node.
pub(super) const WIDTH: usize = 8;

/// What a box holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Child {
    /// The node of this index.
    Node(usize),
    /// The shape at this place in the order of the tree.
    Shape(usize),
    /// The packet of triangles of this index.
    Packet(usize),
}

/// A [`Child`] in 32 bits: two for the kind, the others for the index.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Link(pub(super) u32);

impl Link {
    const SHAPE: u32 = 1 << 31;
    const PACKET: u32 = 1 << 30;

    #[inline(always)]
    pub(super) fn child(self) -> Child {
        let index = (self.0 & !(Link::SHAPE | Link::PACKET)) as usize;
        if self.0 & Link::SHAPE != 0 {
            Child::Shape(index)
        } else if self.0 & Link::PACKET != 0 {
            Child::Packet(index)
        } else {
            Child::Node(index)
        }
    }

    /// The same child, after this many others of its kind.
    pub(super) fn after(self, before: Counts) -> Self {
        Link::from(match self.child() {
            Child::Node(index) => Child::Node(index + before.nodes),
            Child::Shape(index) => Child::Shape(index + before.shapes),
            Child::Packet(index) => Child::Packet(index + before.packets),
        })
    }
}

/// How many children there are of each kind.
#[derive(Clone, Copy)]
pub(super) struct Counts {
    pub(super) nodes: usize,
    pub(super) shapes: usize,
    pub(super) packets: usize,
}

impl From<Child> for Link {
    fn from(child: Child) -> Self {
        Link(match child {
            Child::Node(index) => index as u32,
            Child::Shape(index) => index as u32 | Link::SHAPE,
            Child::Packet(index) => index as u32 | Link::PACKET,
        })
    }
}

/// The boxes of up to eight children, coordinate by coordinate.
#[derive(Clone, Debug)]
pub(super) struct Node {
    /// For each axis the lower faces of all boxes, then the upper ones.
    faces: [[Eight; 2]; 3],
    /// What is in each box.
    pub(super) links: [Link; WIDTH],
}

impl Node {
    /// A node over children with these boxes; the places left hold the first child in empty boxes, which no ray enters.
    pub(super) fn new(children: &[(Aabb, Child)]) -> Self {
        let mut boxes = [Aabb::EMPTY; WIDTH];
        let first = children.first().map(|(_, child)| (*child).into());
        let mut links = [first.unwrap_or_default(); WIDTH];
        for (lane, (bounds, child)) in children.iter().enumerate() {
            boxes[lane] = *bounds;
            links[lane] = (*child).into();
        }
        let faces = [0, 1, 2]
            .map(|axis| [boxes.map(|b| b.min[axis]), boxes.map(|b| b.max[axis])].map(Eight));
        Node { faces, links }
    }

    /// The box of all boxes.
    pub(super) fn bounds(&self) -> Aabb {
        let each = |side: usize| {
            (0..WIDTH)
                .map(move |lane| Vec3::from([0, 1, 2].map(|axis| self.faces[axis][side].0[lane])))
        };
        Aabb {
            min: each(0).fold(Vec3::INFINITY, Vec3::min),
            max: each(1).fold(Vec3::NEG_INFINITY, Vec3::max),
        }
    }

    /// [`Aabb::entry`] of all boxes at once, bit for bit, and a mask of those that are entered.
    #[inline(always)]
    pub(super) fn entries<S: Simd>(
        &self,
        s: S,
        ray: &RayLanes<S>,
        t_max: f32,
    ) -> ([f32; WIDTH], u32) {
        let mut t0 = f32x8::splat(s, 0.0);
        let mut t1 = f32x8::splat(s, t_max);
        for (axis, faces) in self.faces.iter().enumerate() {
            let (origin, inverse) = (ray.origin[axis], ray.inverse[axis]);
            let backwards = ray.backwards[axis];
            let near = (faces[usize::from(backwards)].get(s) - origin) * inverse;
            let far = (faces[usize::from(!backwards)].get(s) - origin) * inverse;
            // A NaN changes nothing.
            t0 = near.simd_gt(t0).select(near, t0);
            t1 = far.simd_lt(t1).select(far, t1);
        }
        let entries = t0 * EARLIER;
        let mut row = [0.0; WIDTH];
        entries.store_slice(&mut row);
        (row, entries.simd_le(t1).to_bitmask() as u32)
    }
}

/// Eight numbers side by side in memory.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
pub(super) struct Eight(pub(super) [f32; WIDTH]);

impl Eight {
    /// The numbers as a vector.
    #[inline(always)]
    pub(super) fn get<S: Simd>(&self, s: S) -> f32x8<S> {
        f32x8::from_slice(s, &self.0)
    }
}

/// What all box tests of a ray have in common, in every lane.
pub(super) struct RayLanes<S: Simd> {
    origin: [f32x8<S>; 3],
    inverse: [f32x8<S>; 3],
    backwards: [bool; 3],
}

impl<S: Simd> RayLanes<S> {
    #[inline(always)]
    pub(super) fn new(s: S, ray: &PreparedRay) -> Self {
        let [ox, oy, oz] = ray.origin.to_array();
        let [ix, iy, iz] = ray.inverse.to_array();
        RayLanes {
            origin: [
                f32x8::splat(s, ox),
                f32x8::splat(s, oy),
                f32x8::splat(s, oz),
            ],
            inverse: [
                f32x8::splat(s, ix),
                f32x8::splat(s, iy),
                f32x8::splat(s, iz),
            ],
            backwards: [ix < 0.0, iy < 0.0, iz < 0.0],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Ray;
    use crate::sampling::stream::{Purpose, Stream};
    use fearless_simd::{Level, dispatch};

    #[test]
    fn eight_boxes_at_once_are_each_box_alone() {
        let (mut entered, mut if_nan_won) = (0, 0);
        for i in 0..20_000 {
            let mut numbers = Stream::new(1, i, 0).at(0, Purpose::Direction);
            // Few different coordinates, so that many rays lie in faces, and flat boxes.
            let mut point = || Vec3::from([(); 3].map(|()| (numbers.one() * 5.0).floor() - 2.0));
            let boxes = [(); 7].map(|()| Aabb::of([point(), point()]));
            let (origin, mut direction) = (point(), point());
            if i % 2 == 0 {
                direction = Vec3::from(direction.to_array().map(|x| -x * 0.0)) + Vec3::X;
            }
            let ray = Ray::new(origin, direction);
            if !ray.is_valid() {
                continue;
            }
            let ray = PreparedRay::from(&ray);
            let node = Node::new(&boxes.map(|b| (b, Child::Shape(0))));
            let (entries, met) = dispatch!(Level::new(), s => {
                node.entries(s, &RayLanes::new(s, &ray), f32::MAX)
            });
            assert_eq!(met >> 7, 0, "the empty box");
            for (lane, b) in boxes.iter().enumerate() {
                let alone = b.entry(&ray, f32::MAX).map(f32::to_bits);
                let here = (met >> lane & 1 == 1).then(|| entries[lane].to_bits());
                assert_eq!(here, alone, "{b:?} {ray:?}");
                entered += usize::from(alone.is_some());
                let nan = ((b.min - ray.origin) * ray.inverse).is_nan();
                if_nan_won += usize::from(alone.is_some() && nan);
            }
        }
        assert!(
            entered > 10_000 && if_nan_won > 1000,
            "{entered} {if_nan_won}"
        );
    }

    #[test]
    fn links_keep_their_children() {
        for child in [Child::Node(7), Child::Shape(0), Child::Packet(1 << 29)] {
            assert_eq!(Link::from(child).child(), child);
        }
    }
}
