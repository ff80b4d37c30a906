use super::*;
use std::f64::consts::TAU;

/// Texture coordinates that tell the points of an outline apart.
fn uv_at(p: DVec3) -> Vec2 {
    DVec2::new(p.x + 0.5 * p.z, p.y - 0.25 * p.z).as_vec2()
}

fn split(points: &[DVec3]) -> Triangulation {
    let last = points.len() as u32 - 1;
    let mut polygons = Polygons {
        vertices: points.to_vec(),
        // Not in the order of the vertices, and never that of a corner beside.
        uvs: points.iter().rev().map(|p| uv_at(*p)).collect(),
        ..Polygons::default()
    };
    polygons.push((0..points.len() as u32).map(|i| (i, Some(last - i))));
    polygons.triangulate()
}

/// The vector area of a closed line of points (Newell).
fn newell(points: &[DVec3]) -> DVec3 {
    let next = points.iter().cycle().skip(1);
    points
        .iter()
        .zip(next)
        .map(|(p, q)| 0.5 * p.cross(*q))
        .sum()
}

/// Checks that the triangles fill a flat polygon once, wound as it is.
fn check(points: &[DVec3]) {
    let found = split(points);
    let normal = newell(points);
    let mesh = &found.mesh;
    let areas = mesh
        .triangles
        .iter()
        .map(|t| newell(&t.map(|i| mesh.vertices[i as usize])));
    let areas: Vec<DVec3> = areas.collect();
    let whole = normal.length();
    assert!(
        areas.iter().all(|a| a.dot(normal) >= 0.0),
        "{points:?}: {areas:?}"
    );
    let sum: f64 = areas.iter().map(|a| a.length()).sum();
    assert!(
        (sum / whole - 1.0).abs() < 1e-7,
        "{points:?}: {sum} of {whole}"
    );
    let lacking = found.without_area;
    assert_eq!(
        mesh.triangles.len() + lacking,
        points.len() - 2,
        "{points:?}"
    );
    assert_eq!(found.intersection, 0, "{points:?}");
    let own = |t: &[u32; 3]| t.map(|i| uv_at(mesh.vertices[i as usize]));
    assert!(mesh.triangles.iter().map(own).eq(mesh.uvs.iter().copied()));
}

#[test]
fn polygons_without_texture_coordinates_get_the_default_beside_others_and_none_alone() {
    let square = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
    let face = |has: fn(u32) -> bool| {
        let corners = (0..4).map(|i| (i, has(i).then_some(i)));
        corners.collect::<Vec<_>>()
    };
    let [all, none, some] = [face(|_| true), face(|_| false), face(|i| i != 2)];
    let own = [[0, 1, 2], [0, 2, 3]].map(|t| t.map(|i: usize| square[i].truncate().as_vec2()));
    let split = |faces: &[Vec<(u32, Option<u32>)>]| {
        let mut polygons = Polygons {
            vertices: square.to_vec(),
            uvs: square.map(|p| p.truncate().as_vec2()).to_vec(),
            ..Polygons::default()
        };
        faces.iter().for_each(|face| polygons.push(face.clone()));
        let found = polygons.triangulate();
        (found.mesh.uvs, found.without_uvs)
    };
    let default = [DEFAULT_UVS; 2];
    assert_eq!(split(&[none.clone(), none.clone()]), (vec![], 0));
    assert_eq!(split(std::slice::from_ref(&all)), (own.to_vec(), 0));
    for lacks in [none, some] {
        let before = split(&[lacks.clone(), lacks.clone(), all.clone()]);
        assert_eq!(before, ([default, default, own].concat(), 2));
        let between = split(&[all.clone(), lacks.clone(), all.clone()]);
        assert_eq!(between, ([own, default, own].concat(), 1));
        let after = split(&[all.clone(), lacks.clone(), lacks]);
        assert_eq!(after, ([own, default, default].concat(), 2));
    }
}

/// Outlines in a plane, counter-clockwise.
fn outlines() -> Vec<Vec<DVec2>> {
    let points = |all: &[(f64, f64)]| all.iter().map(|p| DVec2::new(p.0, p.1)).collect();
    let star = |n: usize, inner: f64| {
        let point = |i: usize| {
            let (sin, cos) = libm::sincos(TAU * i as f64 / n as f64);
            DVec2::new(cos, sin) * if i.is_multiple_of(2) { 1.0 } else { inner }
        };
        (0..n).map(point).collect::<Vec<DVec2>>()
    };
    vec![
        // The quadrilateral whose fan has three times its area.
        points(&[(0.0, 1.0), (0.0, 0.0), (1.0, 0.0), (0.25, 0.25)]),
        points(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)]),
        // Corners on one line.
        points(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 1.0)]),
        points(&[
            (0.0, 0.0),
            (1.0, 0.0),
            (2.0, 0.0),
            (2.0, 2.0),
            (0.0, 2.0),
            (0.0, 1.0),
        ]),
        // An L, a U and a comb.
        points(&[
            (0.0, 0.0),
            (3.0, 0.0),
            (3.0, 1.0),
            (1.0, 1.0),
            (1.0, 3.0),
            (0.0, 3.0),
        ]),
        points(&[
            (0.0, 0.0),
            (3.0, 0.0),
            (3.0, 2.0),
            (2.0, 2.0),
            (2.0, 1.0),
            (1.0, 1.0),
            (1.0, 2.0),
            (0.0, 2.0),
        ]),
        // A square with a square hole, joined by a bridge there and back.
        points(&[
            (0.0, 0.0),
            (4.0, 0.0),
            (4.0, 4.0),
            (0.0, 4.0),
            (0.0, 0.0),
            (1.0, 1.0),
            (1.0, 3.0),
            (3.0, 3.0),
            (3.0, 1.0),
            (1.0, 1.0),
        ]),
        star(5, 1.0),
        star(10, 0.3),
        star(200, 0.9),
    ]
}

#[test]
fn polygons_are_filled_once_in_every_plane_from_every_corner_and_wound_as_they_are() {
    let frames = [
        (DVec3::X, DVec3::Y),
        (DVec3::Y, DVec3::Z),
        (DVec3::Z, DVec3::X),
        (DVec3::Y, DVec3::X),
        (DVec3::new(1.0, 2.0, -0.5), DVec3::new(-2.0, 1.5, 2.0)),
        (DVec3::new(1e-4, 0.0, 2e-4), DVec3::new(0.0, -1e-4, 0.0)),
    ];
    for outline in outlines() {
        for (u, v) in frames {
            // Map coordinates: so far away that single precision would lose the outline.
            for origin in [DVec3::ZERO, DVec3::new(4_485_513.75, 701_362.5, 37.5)] {
                if origin != DVec3::ZERO && u.length() < 0.1 {
                    continue;
                }
                let mut points: Vec<DVec3> =
                    outline.iter().map(|p| origin + p.x * u + p.y * v).collect();
                // Rounding far away bends what lies on one line.
                if origin != DVec3::ZERO && outline.len() == 200 {
                    continue;
                }
                for _ in 0..points.len().min(12) {
                    points.rotate_left(1);
                    check(&points);
                }
                points.reverse();
                check(&points);
            }
        }
    }
}

#[test]
fn polygons_that_cross_themselves_are_counted() {
    let flat = |all: &[(f64, f64)]| {
        let points = all.iter().map(|p| DVec3::new(p.0, p.1, 0.0));
        split(&points.collect::<Vec<_>>())
    };
    let bow_tie = flat(&[(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)]);
    assert_eq!((bow_tie.intersection, bow_tie.without_area), (1, 0));
    let uneven = flat(&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 1.0)]);
    assert_eq!(uneven.intersection, 1);
    let pentagram = (0..5).map(|i| {
        let (sin, cos) = libm::sincos(TAU * f64::from(2 * i) / 5.0);
        (cos, sin)
    });
    assert_eq!(flat(&pentagram.collect::<Vec<_>>()).intersection, 1);
    let line = flat(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (3.0, 0.0)]);
    assert_eq!((line.intersection, line.mesh.triangles.len()), (0, 2));
}
