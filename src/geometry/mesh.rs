//! A mesh: corners shared by triangles.

use super::Triangle;
use glam::{DVec3, Vec2, Vec3};

/// Texture coordinates of the corners of a triangle that has none of its own, as in PBRT.
pub const DEFAULT_UVS: [Vec2; 3] = [Vec2::ZERO, Vec2::X, Vec2::ONE];

/// A triangle mesh as a file or a formula gives it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corner positions.
    pub vertices: Vec<DVec3>,
    /// Three vertex indices for each triangle, counter-clockwise seen from the front.
    pub triangles: Vec<[u32; 3]>,
    /// Texture coordinates of each triangle's corners, in step with `triangles`; empty where the mesh
    /// has none. They are not the vertices' own, for a vertex on a seam has several.
    pub uvs: Vec<[Vec2; 3]>,
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

    /// Texture coordinates of a triangle's corners: [`DEFAULT_UVS`] where the mesh has none.
    pub fn uv(&self, triangle: usize) -> [Vec2; 3] {
        self.uvs.get(triangle).copied().unwrap_or(DEFAULT_UVS)
    }

    /// Turns each triangle over: its front is where its back was.
    pub fn turn_over(&mut self) {
        self.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        self.uvs.iter_mut().for_each(|uvs| uvs.swap(1, 2));
    }

    /// The proper triangles with `place` applied to each corner, each with its index in the mesh.
    ///
    /// Degenerate triangles, whose corners are collinear, equal or not finite, are left out, for they
    /// have no normal: the plain watertight test reports hits on 16 % of random collinear ones, with a
    /// NaN normal. Corners that do not exist must have been refused before ([`Mesh::bad_index`]).
    pub fn to_triangles(&self, place: impl Fn(DVec3) -> Vec3) -> Vec<(usize, Triangle)> {
        let corners: Vec<Vec3> = self.vertices.iter().copied().map(place).collect();
        let triangles = self.triangles.iter().enumerate().map(|(at, t)| {
            let [a, b, c] = t.map(|i| corners[i as usize]);
            (at, Triangle { a, b, c })
        });
        triangles.filter(|(_, t)| t.is_proper()).collect()
    }
}
