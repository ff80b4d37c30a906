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
        /// The coordinates at the first corner of each shape, and at the ends of its first and second
        /// edge; where there is no list they are (0, 0), (1, 0) and (0, 1).
        corners: Option<Arc<[[Vec2; 3]]>>,
    },
    /// On a sphere: the longitude from `+x` over `-z`, counter-clockwise seen from above, and the latitude
    /// from the lower pole to the upper.
    Sphere {
        /// From the normal to the direction from the centre in the sphere's own axes.
        turn: Mat3,
    },
}

impl Default for Mapping {
    fn default() -> Self {
        Mapping::Flat {
            first: 0,
            corners: None,
        }
    }
}

impl Mapping {
    /// Of quads and triangles.
    ///
    /// * `corners`: as in [`Mapping::Flat`].
    /// * `mirrored`: true where both edges of each shape changed places.
    pub(super) fn flat(corners: Option<Vec<[Vec2; 3]>>, mirrored: bool) -> Self {
        let corners = corners.map(|all| {
            let swapped = |[a, b, c]: [Vec2; 3]| if mirrored { [a, c, b] } else { [a, b, c] };
            all.into_iter().map(swapped).collect()
        });
        Mapping::Flat { first: 0, corners }
    }

    /// Says the number of the first shape.
    pub(super) fn begin_at(&mut self, number: u32) {
        if let Mapping::Flat { first, .. } = self {
            *first = number;
        }
    }

    /// That of some of the shapes, as an object of its own.
    pub(super) fn some(&self, which: &[usize]) -> Self {
        match self {
            Mapping::Flat {
                corners: Some(corners),
                ..
            } if corners.len() != which.len() => {
                let corners = which.iter().map(|&i| corners[i]).collect();
                Mapping::flat(Some(corners), false)
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
        self.at(part, [hit.crossing.u, hit.crossing.v], hit.surface.n)
    }

    /// The coordinates of a point of the object's shape number `part`.
    ///
    /// * `place`: the coordinates of the point on a quad or triangle, as in
    ///   [`Crossing`](crate::geometry::Crossing).
    /// * `n`: the unit normal of a sphere.
    pub(super) fn at(&self, part: u32, place: [f32; 2], n: Vec3) -> Vec2 {
        match self {
            Mapping::Flat { corners: None, .. } => place.into(),
            Mapping::Flat {
                corners: Some(corners),
                ..
            } => {
                let [a, b, c] = corners[part as usize];
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
