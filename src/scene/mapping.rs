//! Texture coordinates of points of an object.

use super::interaction::Hit;
use glam::{Mat3, Vec2, Vec3};
use std::f32::consts::{FRAC_1_PI, TAU};
use std::sync::Arc;

/// How the points of an object get their texture coordinates.
#[derive(Clone, Debug)]
pub enum Mapping {
    /// On quads and triangles: linearly, from one corner and the two next to it.
    Flat {
        /// The number of the object's first shape.
        first: u32,
        /// The coordinates of these corners.
        corners: Corners,
    },
    /// On a sphere: the longitude from `+x` over `-z`, counter-clockwise seen from above, and the latitude
    /// from the lower pole to the upper.
    Sphere {
        /// From the normal to the direction from the centre in the sphere's own axes.
        turn: Mat3,
    },
}

/// Texture coordinates at the first corner of a shape, and at the ends of its first and second edge.
#[derive(Clone, Debug)]
pub enum Corners {
    /// The same for all shapes.
    Same([Vec2; 3]),
    /// For each shape its own.
    Each(Arc<[[Vec2; 3]]>),
}

impl Default for Mapping {
    fn default() -> Self {
        Mapping::of(Corners::Same([Vec2::ZERO, Vec2::X, Vec2::Y]))
    }
}

impl Mapping {
    /// Of quads and triangles.
    pub(super) fn of(corners: Corners) -> Self {
        Mapping::Flat { first: 0, corners }
    }

    /// That of shapes whose two edges changed places.
    pub(super) fn mirrored(&self) -> Self {
        let swapped = |[a, b, c]: [Vec2; 3]| [a, c, b];
        match self {
            Mapping::Flat { first, corners } => Mapping::Flat {
                first: *first,
                corners: match corners {
                    Corners::Same(corners) => Corners::Same(swapped(*corners)),
                    Corners::Each(all) => Corners::Each(all.iter().copied().map(swapped).collect()),
                },
            },
            Mapping::Sphere { .. } => self.clone(),
        }
    }

    /// Says the number of the first shape.
    pub(super) fn begin_at(&mut self, number: u32) {
        if let Mapping::Flat { first, .. } = self {
            *first = number;
        }
    }

    /// True where each shape has coordinates of its own.
    pub(super) fn is_own(&self) -> bool {
        matches!(
            self,
            Mapping::Flat {
                corners: Corners::Each(_),
                ..
            }
        )
    }

    /// That of some of the shapes, as an object of its own.
    pub(super) fn some(&self, which: &[usize]) -> Self {
        match self {
            Mapping::Flat {
                corners: Corners::Each(all),
                ..
            } if all.len() != which.len() => {
                Mapping::of(Corners::Each(which.iter().map(|&i| all[i]).collect()))
            }
            _ => self.clone(),
        }
    }

    /// The coordinates where a ray hit the object.
    #[inline(never)]
    pub(super) fn uv(&self, hit: &Hit) -> Vec2 {
        let part = match self {
            Mapping::Flat { first, .. } => hit.shape - first,
            Mapping::Sphere { .. } => 0,
        };
        self.at(
            part,
            [hit.intersection.u, hit.intersection.v],
            hit.surface.n,
        )
    }

    /// The coordinates of a point of the object's shape number `part`.
    ///
    /// * `place`: the coordinates of the point on a quad or triangle, as in
    ///   [`Intersection`](crate::geometry::Intersection).
    /// * `n`: the unit normal of a sphere.
    pub(super) fn at(&self, part: u32, place: [f32; 2], n: Vec3) -> Vec2 {
        match self {
            Mapping::Flat { corners, .. } => {
                let [a, b, c] = match corners {
                    Corners::Same(corners) => *corners,
                    Corners::Each(all) => all[part as usize],
                };
                let [u, v] = place;
                a + (b - a) * u + (c - a) * v
            }
            Mapping::Sphere { turn } => {
                let w = *turn * n;
                let longitude = crate::numeric::atan2(-w.z, w.x) / TAU;
                // From the length across the axis: near the poles the height has no digits to spare.
                let across = (w.x * w.x + w.z * w.z).sqrt();
                let latitude = crate::numeric::atan2(w.y, across) * FRAC_1_PI;
                Vec2::new(longitude.rem_euclid(1.0), 0.5 + latitude)
            }
        }
    }
}
