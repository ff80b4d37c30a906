//! Meshes from formulas.

use crate::geometry::Mesh;
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// A sphere whose radius waves along both angles:
/// `r (1 + 0.12 sin 6θ sin 8φ sin² θ + 0.03 sin 40θ sin 36φ sin² θ)`,
/// with θ from the upper pole (`+y`) and φ from `+x` towards `+z`.
///
/// It has `columns · rows · 2 - 2 columns` triangles, counter-clockwise seen from outside, in the
/// order: north fan, rings from north to south, south fan. Vertices are rounded to `f32`, so that
/// the mesh is the same as one read from a file of that precision.
///
/// Its texture coordinates are those of a globe: u goes once around eastwards, from +x towards -z, and
/// v from 0 at the lower pole to 1 at the upper, each in equal angles. So an image is upright, and not
/// mirrored, seen from outside. At a pole each triangle has the u of its middle.
pub fn bumpy_sphere(center: DVec3, radius: f64, columns: u32, rows: u32) -> Mesh {
    let wave = |theta: f64, phi: f64| {
        let sin2 = libm::sin(theta) * libm::sin(theta);
        1.0 + 0.12 * libm::sin(6.0 * theta) * libm::sin(8.0 * phi) * sin2
            + 0.03 * libm::sin(40.0 * theta) * libm::sin(36.0 * phi) * sin2
    };
    let mut vertices = vec![center + radius * DVec3::Y];
    for i in 1..rows {
        let theta = PI * f64::from(i) / f64::from(rows);
        for j in 0..columns {
            let phi = TAU * f64::from(j) / f64::from(columns);
            let (sin, cos) = (libm::sin(theta), libm::cos(theta));
            let toward = DVec3::new(sin * libm::cos(phi), cos, sin * libm::sin(phi));
            vertices.push(center + radius * wave(theta, phi) * toward);
        }
    }
    vertices.push(center - radius * DVec3::Y);
    let last = vertices.len() as u32 - 1;

    // Corners by row and column: those of the last column are the first one's vertices, with another u.
    let sides = || 0..columns;
    let north = sides().map(|j| [(0, j), (1, j + 1), (1, j)]);
    let belts = (1..rows - 1).flat_map(|i| {
        let upper = sides().map(move |j| [(i, j), (i, j + 1), (i + 1, j + 1)]);
        let lower = sides().map(move |j| [(i, j), (i + 1, j + 1), (i + 1, j)]);
        upper.chain(lower)
    });
    let south = sides().map(|j| [(rows - 1, j), (rows - 1, j + 1), (rows, j)]);
    let corners: Vec<[(u32, u32); 3]> = north.chain(belts).chain(south).collect();
    let is_pole = |i: u32| i == 0 || i == rows;
    let vertex = |(i, j): (u32, u32)| match i {
        0 => 0,
        i if i == rows => last,
        i => 1 + (i - 1) * columns + j % columns,
    };
    let uv = |(i, j): (u32, u32)| {
        let j = f64::from(j) + if is_pole(i) { 0.5 } else { 0.0 };
        let turned = DVec2::new(j / f64::from(columns), f64::from(i) / f64::from(rows));
        (1.0 - turned).as_vec2()
    };
    Mesh {
        triangles: corners.iter().map(|t| t.map(vertex)).collect(),
        uvs: corners.iter().map(|t| t.map(uv)).collect(),
        vertices: vertices
            .into_iter()
            .map(|v| v.as_vec3().as_dvec3())
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_orientation() {
        let center = DVec3::new(278.0, 200.0, 280.0);
        let mesh = bumpy_sphere(center, 130.0, 256, 196);
        assert_eq!(mesh.vertices.len(), 49_922);
        assert_eq!(mesh.triangles.len(), 99_840);
        assert_eq!(mesh.bad_index(), None);
        let outward = mesh.triangles.iter().all(|t| {
            let [a, b, c] = t.map(|i| mesh.vertices[i as usize]);
            (b - a).cross(c - a).dot((a + b + c) / 3.0 - center) > 0.0
        });
        assert!(outward, "every triangle faces outwards");
    }

    #[test]
    fn texture_coordinates_cover_a_globe_once_and_are_those_of_each_place() {
        let (columns, rows) = (16, 12);
        let mesh = bumpy_sphere(DVec3::ZERO, 1.0, columns, rows);
        assert_eq!(mesh.uvs.len(), mesh.triangles.len());
        let mut covered = 0.0;
        for (corners, uvs) in mesh.triangles.iter().zip(&mesh.uvs) {
            let [a, b, c] = uvs.map(|uv| uv.as_dvec2());
            let area = 0.5 * (b - a).perp_dot(c - a);
            // As wide and as high as a cell at most, the seam's too, and not mirrored.
            let wide = a.max(b).max(c) - a.min(b).min(c);
            let cell = DVec2::new(1.0 / f64::from(columns), 1.0 / f64::from(rows));
            assert!(wide.cmple(cell + 1e-6).all() && area > 0.0, "{uvs:?}");
            covered += area;
            for (i, uv) in corners.iter().zip([a, b, c]) {
                let p = mesh.vertices[*i as usize].normalize();
                assert!((libm::acos(-p.y) / PI - uv.y).abs() < 1e-6, "{p} {uv}");
                let turns = libm::atan2(-p.z, p.x) / TAU - uv.x;
                let is_pole = p.y.abs() > 1.0 - 1e-6;
                assert!(is_pole || (turns - turns.round()).abs() < 1e-6, "{p} {uv}");
            }
        }
        // The fans at the poles are half of their rows.
        assert!((covered - (1.0 - 1.0 / f64::from(rows))).abs() < 1e-6);
    }
}
