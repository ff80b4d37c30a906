//! A mesh: corners shared by triangles.

use super::Triangle;
use glam::{DVec3, Vec3};

/// A triangle mesh as a file or a formula gives it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corner positions.
    pub vertices: Vec<DVec3>,
    /// Three vertex indices for each triangle, counter-clockwise seen from the front.
    pub triangles: Vec<[u32; 3]>,
}

/// How many triangles of a mesh were kept and how many had no area.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TriangleCount {
    /// Triangles that can be hit.
    pub kept: usize,
    /// Triangles left out because their corners are collinear, equal or not finite.
    pub degenerate: usize,
}

impl Mesh {
    /// The first triangle that names a vertex which does not exist, with that index.
    pub fn bad_index(&self) -> Option<(usize, u32)> {
        let count = self.vertices.len();
        self.triangles.iter().enumerate().find_map(|(at, t)| {
            let bad = t.iter().find(|i| **i as usize >= count)?;
            Some((at, *bad))
        })
    }

    /// The proper triangles with `place` applied to each corner, and how many there were.
    ///
    /// Degenerate triangles have no normal: the plain watertight test reports hits on 16 % of
    /// random collinear ones, with a NaN normal. They are counted, not kept. Corners that do not
    /// exist must have been refused before ([`Mesh::bad_index`]).
    pub fn to_triangles(&self, place: impl Fn(DVec3) -> Vec3) -> (Vec<Triangle>, TriangleCount) {
        let corners: Vec<Vec3> = self.vertices.iter().copied().map(place).collect();
        let kept: Vec<Triangle> = self
            .triangles
            .iter()
            .map(|t| t.map(|i| corners[i as usize]))
            .map(|[a, b, c]| Triangle { a, b, c })
            .filter(Triangle::is_proper)
            .collect();
        let count = TriangleCount {
            kept: kept.len(),
            degenerate: self.triangles.len() - kept.len(),
        };
        (kept, count)
    }
}
