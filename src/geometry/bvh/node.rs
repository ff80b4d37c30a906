//! Eight boxes side by side, tested as one.

use crate::geometry::aabb::EARLIER;
use crate::geometry::{Aabb, PreparedRay};
use wide::f32x8;

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
pub(super) struct Node {
    /// For each axis the lower faces of all boxes, then the upper ones.
    faces: [[f32x8; 2]; 3],
    /// What is in each box.
    pub(super) links: [Link; WIDTH],
}

impl Node {
    /// A node over children with these boxes; the places left are empty boxes, which no ray enters.
    pub(super) fn new(children: &[(Aabb, Child)]) -> Self {
        let mut boxes = [Aabb::EMPTY; WIDTH];
        let mut links = [Link::default(); WIDTH];
        for (lane, (bounds, child)) in children.iter().enumerate() {
            boxes[lane] = *bounds;
            links[lane] = (*child).into();
        }
        let faces = [0, 1, 2]
            .map(|axis| [boxes.map(|b| b.min[axis]), boxes.map(|b| b.max[axis])].map(f32x8::new));
        Node { faces, links }
    }

    /// [`Aabb::entry`] of all boxes at once, bit for bit, and a mask of those that are entered.
    #[inline(always)]
    pub(super) fn entries(&self, ray: &RayLanes, t_max: f32) -> ([f32; WIDTH], u32) {
        let mut t0 = f32x8::ZERO;
        let mut t1 = f32x8::splat(t_max);
        for axis in 0..3 {
            let (origin, inverse) = (ray.origin[axis], ray.inverse[axis]);
            let backwards = ray.backwards[axis];
            let near = (self.faces[axis][usize::from(backwards)] - origin) * inverse;
            let far = (self.faces[axis][usize::from(!backwards)] - origin) * inverse;
            t0 = larger(near, t0);
            t1 = smaller(far, t1);
        }
        let entries = t0 * f32x8::splat(EARLIER);
        (entries.to_array(), entries.simd_le(t1).to_bitmask())
    }
}

/// What all box tests of a ray have in common, in every lane.
pub(super) struct RayLanes {
    origin: [f32x8; 3],
    inverse: [f32x8; 3],
    backwards: [bool; 3],
}

impl From<&PreparedRay> for RayLanes {
    fn from(ray: &PreparedRay) -> Self {
        RayLanes {
            origin: ray.origin.to_array().map(f32x8::splat),
            inverse: ray.inverse.to_array().map(f32x8::splat),
            backwards: ray.inverse.to_array().map(|x| x < 0.0),
        }
    }
}

/// In each lane `new` where it is larger than `old`, else `old`, also where `new` is NaN.
#[inline(always)]
fn larger(new: f32x8, old: f32x8) -> f32x8 {
    if cfg!(target_arch = "x86_64") {
        // One instruction, which gives its second operand where there is a NaN.
        new.fast_max(old)
    } else {
        new.simd_gt(old).select(new, old)
    }
}

/// In each lane `new` where it is smaller than `old`, else `old`, also where `new` is NaN.
#[inline(always)]
fn smaller(new: f32x8, old: f32x8) -> f32x8 {
    if cfg!(target_arch = "x86_64") {
        new.fast_min(old)
    } else {
        new.simd_lt(old).select(new, old)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Ray;
    use crate::sampling::stream::{Purpose, Stream};
    use glam::Vec3;

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
            let (entries, met) =
                Node::new(&boxes.map(|b| (b, Child::Shape(0)))).entries(&(&ray).into(), f32::MAX);
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
