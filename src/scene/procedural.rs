//! Meshes from formulas.

use crate::geometry::Mesh;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// A sphere whose radius waves along both angles:
/// `r (1 + 0.12 sin 6θ sin 8φ sin² θ + 0.03 sin 40θ sin 36φ sin² θ)`,
/// with θ from the upper pole (`+y`) and φ from `+x` towards `+z`.
///
/// It has `columns · rows · 2 - 2 columns` triangles, counter-clockwise seen from outside, in the
/// order: north fan, rings from north to south, south fan. Vertices are rounded to `f32`, so that
/// the mesh is the same as one read from a file of that precision.
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

    let ring = |i: u32| 1 + (i - 1) * columns;
    let sides = || (0..columns).map(|j| (j, (j + 1) % columns));
    let north = sides().map(|(j, k)| [0, ring(1) + k, ring(1) + j]);
    let belts = (1..rows - 1).flat_map(|i| {
        let (a, b) = (ring(i), ring(i + 1));
        let upper = sides().map(move |(j, k)| [a + j, a + k, b + k]);
        let lower = sides().map(move |(j, k)| [a + j, b + k, b + j]);
        upper.chain(lower)
    });
    let south = sides().map(|(j, k)| [ring(rows - 1) + j, ring(rows - 1) + k, last]);
    Mesh {
        triangles: north.chain(belts).chain(south).collect(),
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
}
