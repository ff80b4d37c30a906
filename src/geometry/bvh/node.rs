//! Eight boxes side by side, tested as one.

use crate::geometry::aabb::EARLIER;
use crate::geometry::{Aabb, PreparedRay};

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
#[repr(align(32))]
pub(super) struct Node {
    /// For each axis the lower faces of all boxes, then the upper ones.
    faces: [[[f32; WIDTH]; 2]; 3],
    /// What is in each box.
    pub(super) links: [Link; WIDTH],
}

impl Node {
    /// A node of empty boxes, which no ray enters.
    pub(super) const EMPTY: Node = Node {
        faces: [[[f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]]; 3],
        links: [Link(0); WIDTH],
    };

    /// Puts a child in its place.
    pub(super) fn set(&mut self, lane: usize, bounds: &Aabb, child: Child) {
        for axis in 0..3 {
            self.faces[axis][0][lane] = bounds.min[axis];
            self.faces[axis][1][lane] = bounds.max[axis];
        }
        self.links[lane] = child.into();
    }

    /// [`Aabb::entry`] of all boxes at once, bit for bit, and a mask of those that are entered.
    ///
    /// Plain loops over lanes, which compilers turn into vector instructions.
    #[inline(always)]
    pub(super) fn entries(&self, ray: &PreparedRay, t_max: f32) -> ([f32; WIDTH], u32) {
        let mut t0 = [0.0_f32; WIDTH];
        let mut t1 = [t_max; WIDTH];
        for axis in 0..3 {
            let (origin, inverse) = (ray.origin[axis], ray.inverse[axis]);
            let backwards = usize::from(inverse < 0.0);
            let near = &self.faces[axis][backwards];
            let far = &self.faces[axis][1 - backwards];
            for lane in 0..WIDTH {
                let near = (near[lane] - origin) * inverse;
                let far = (far[lane] - origin) * inverse;
                t0[lane] = if near > t0[lane] { near } else { t0[lane] };
                t1[lane] = if far < t1[lane] { far } else { t1[lane] };
            }
        }
        let mut met = 0;
        for lane in 0..WIDTH {
            t0[lane] *= EARLIER;
            met |= u32::from(t0[lane] <= t1[lane]) << lane;
        }
        (t0, met)
    }
}
