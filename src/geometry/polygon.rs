//! Polygons, split into triangles.

#[cfg(test)]
mod tests;

use super::{DEFAULT_UVS, Mesh};
use earcut::Earcut;
use glam::{DVec2, DVec3, Vec2, Vec2Swizzles};
use std::ops::Range;

/// Polygons whose corners are indices into `vertices`, as files give them.
#[derive(Clone, Debug, Default)]
pub struct Polygons {
    /// Corner positions.
    pub vertices: Vec<DVec3>,
    /// Texture coordinates, which corners share as they share vertices.
    pub uvs: Vec<Vec2>,
    /// The corners of all polygons, one polygon after the other.
    corners: Vec<u32>,
    /// The index in `uvs` of each corner, or [`NO_UV`]; it ends with the last corner that has one.
    uv_corners: Vec<u32>,
    /// Where in `corners` each polygon ends.
    ends: Vec<usize>,
}

/// In place of the index of a corner's texture coordinates.
const NO_UV: u32 = u32::MAX;

/// The triangles of some polygons, and what was found on the way.
#[derive(Clone, Debug, Default)]
pub struct Triangulation {
    /// The triangles, wound as their polygons are.
    pub mesh: Mesh,
    /// Triangles that polygons lack because some of their corners lie on one line.
    pub without_area: usize,
    /// Polygons whose edges cross each other, so that no set of triangles is theirs.
    pub intersection: usize,
    /// Polygons without texture coordinates at some corner, where others have them at all.
    pub without_uvs: usize,
}

impl Polygons {
    /// Adds a polygon: the vertex of each corner and, if the corner has any, its texture coordinates,
    /// both by index.
    pub fn push(&mut self, corners: impl IntoIterator<Item = (u32, Option<u32>)>) {
        for (vertex, uv) in corners {
            if let Some(uv) = uv {
                self.uv_corners.resize(self.corners.len(), NO_UV);
                self.uv_corners.push(uv);
            }
            self.corners.push(vertex);
        }
        self.ends.push(self.corners.len());
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// True where there are none.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The corners of each polygon.
    pub fn iter(&self) -> impl Iterator<Item = &[u32]> {
        self.ranges().map(|range| &self.corners[range])
    }

    /// Where in `corners` each polygon is.
    fn ranges(&self) -> impl Iterator<Item = Range<usize>> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(a, b)| a..*b)
    }

    /// The first polygon that names a vertex which does not exist, with that index.
    pub fn bad_index(&self) -> Option<(usize, u32)> {
        let count = self.vertices.len();
        self.iter().enumerate().find_map(|(at, polygon)| {
            let bad = polygon.iter().find(|i| **i as usize >= count)?;
            Some((at, *bad))
        })
    }

    /// Splits each polygon of `n` corners into `n - 2` triangles, fewer where corners lie on one line.
    ///
    /// * Method: a quadrilateral by the diagonal that lies inside it; what has more corners by cutting
    ///   ears (Eberly, *Triangulation by Ear Clipping*, 2002), projected along the axis to which its
    ///   normal (Newell's) is closest. That only drops a coordinate, so nothing is rounded.
    ///
    /// Each corner keeps its texture coordinates. Where only some polygons have them, the triangles of
    /// the others get [`DEFAULT_UVS`].
    ///
    /// Vertices that do not exist must have been refused before ([`Polygons::bad_index`]), and so must
    /// texture coordinates.
    pub fn triangulate(self) -> Triangulation {
        let mut found = Triangulation::default();
        let mut cutter = Cutter::default();
        for range in self.ranges() {
            let corners = &self.corners[range.clone()];
            cutter.split(corners, &self.vertices, &mut found);
            let triangles = cutter.triangles.iter();
            let vertices = triangles.clone().map(|t| t.map(|i| corners[i]));
            found.mesh.triangles.extend(vertices);
            if self.uv_corners.is_empty() {
                continue;
            }
            let indices = self.uv_corners.get(range);
            if let Some(indices) = indices.filter(|indices| !indices.contains(&NO_UV)) {
                let uv = |i: usize| self.uvs[indices[i] as usize];
                found.mesh.uvs.extend(triangles.map(|t| t.map(uv)));
            } else {
                found.without_uvs += 1;
                found.mesh.uvs.extend(triangles.map(|_| DEFAULT_UVS));
            }
        }
        found.mesh.vertices = self.vertices;
        found
    }
}

/// What cutting ears needs, kept from polygon to polygon.
struct Cutter {
    earcut: Earcut<f64>,
    /// The corners, counted from the first.
    points: Vec<DVec3>,
    ears: Vec<u32>,
    /// The triangles of the last polygon, by its corners.
    triangles: Vec<[usize; 3]>,
}

impl Default for Cutter {
    fn default() -> Self {
        Cutter {
            earcut: Earcut::new(),
            points: Vec::new(),
            ears: Vec::new(),
            triangles: Vec::new(),
        }
    }
}

impl Cutter {
    fn split(&mut self, polygon: &[u32], vertices: &[DVec3], found: &mut Triangulation) {
        let triangles = &mut self.triangles;
        triangles.clear();
        let (&[first, ..], 4..) = (polygon, polygon.len()) else {
            triangles.extend((polygon.len() == 3).then_some([0, 1, 2]));
            return;
        };
        let origin = vertices[first as usize];
        self.points.clear();
        let points = polygon.iter().map(|i| vertices[*i as usize] - origin);
        self.points.extend(points);
        let fan = |w: &[DVec3]| w[0].cross(w[1]);
        let normal: DVec3 = self.points[1..].windows(2).map(fan).sum();
        if normal == DVec3::ZERO {
            // All corners on one line, or as much of it turned one way as the other.
            let flat = self.points[1..].windows(2).all(|w| fan(w) == DVec3::ZERO);
            found.intersection += usize::from(!flat);
            triangles.extend((2..polygon.len()).map(|i| [0, i - 1, i]));
            return;
        }
        if polygon.len() == 4 {
            // The two corners beside a diagonal lie on opposite sides of it.
            let inside = |w: [usize; 3]| {
                let [p, q, r] = w.map(|i| self.points[i]);
                (q - p).cross(r - p).dot(normal) > 0.0
            };
            if inside([0, 1, 2]) && inside([0, 2, 3]) {
                triangles.extend([[0, 1, 2], [0, 2, 3]]);
                return;
            }
            if inside([1, 2, 3]) && inside([1, 3, 0]) {
                triangles.extend([[1, 2, 3], [1, 3, 0]]);
                return;
            }
        }
        self.cut_ears(normal, found);
    }

    fn cut_ears(&mut self, normal: DVec3, found: &mut Triangulation) {
        // Seen from the tip of the normal the polygon runs counter-clockwise.
        let flat = |p: DVec3| -> DVec2 {
            let n = normal.abs();
            let (along, p) = if n.x >= n.y && n.x >= n.z {
                (normal.x, DVec2::new(p.y, p.z))
            } else if n.y >= n.z {
                (normal.y, DVec2::new(p.z, p.x))
            } else {
                (normal.z, DVec2::new(p.x, p.y))
            };
            if along < 0.0 { p.yx() } else { p }
        };
        let flat: Vec<DVec2> = self.points.iter().map(|p| flat(*p)).collect();
        let data = flat.iter().map(|p| p.to_array());
        self.earcut.earcut(data, &[], &mut self.ears);
        let mut area = 0.0;
        for &[a, b, c] in self.ears.as_chunks::<3>().0 {
            let [a, b, c] = [a, b, c].map(|i| i as usize);
            let [p, q, r] = [flat[a], flat[b], flat[c]];
            let twice = (q - p).perp_dot(r - p);
            area += twice.abs();
            let wound = if twice < 0.0 { [a, c, b] } else { [a, b, c] };
            self.triangles.push(wound);
        }
        let whole = normal.abs().max_element();
        if (area - whole).abs() > CLOSE * whole {
            found.intersection += 1;
        }
        found.without_area += self.points.len() - 2 - self.triangles.len();
    }
}

/// Areas this close to each other are the same area, rounded.
const CLOSE: f64 = 1e-9;
