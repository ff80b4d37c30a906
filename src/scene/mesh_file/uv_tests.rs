//! Texture coordinates of mesh files.

use super::{MeshFile, Said, obj, ply, triangles};
use crate::geometry::{DEFAULT_UVS, Mesh};
use glam::{DVec3, Vec2};

fn read(said: Result<Said, String>) -> MeshFile {
    triangles(said.expect("a mesh")).expect("triangles")
}

/// A square in two triangles, each with an image of its own, so that its diagonal is a seam.
const SEAM: [[[f32; 2]; 3]; 2] = [
    [[0.0, 0.0], [0.5, 0.0], [0.5, 1.0]],
    [[0.5, 0.0], [1.0, 1.0], [0.5, 1.0]],
];

fn seam() -> Vec<[Vec2; 3]> {
    SEAM.map(|t| t.map(Vec2::from)).to_vec()
}

/// Checks that a file is a unit square whose texture coordinates are those of [`SEAM`].
fn check_seam(file: &MeshFile) {
    let corners = [[0, 1, 2], [0, 2, 3]];
    let square = [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
    let places = |mesh: &Mesh| {
        let places = |t: &[u32; 3]| t.map(|i| mesh.vertices[i as usize]);
        mesh.triangles.iter().map(places).collect::<Vec<_>>()
    };
    assert_eq!(places(&file.mesh), corners.map(|t| t.map(|i| square[i])));
    assert_eq!(file.mesh.uvs, seam());
}

#[test]
fn corners_of_an_obj_file_have_texture_coordinates_of_their_own() {
    let vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    // One to three numbers: the second is 0 where there is none, the third does not count.
    let uvs = "vt 0\nvt 0.5 0\nvt .5 1 0.75\nvt 1 1 0\n";
    for faces in [
        "f 1/1 2/2 3/3\nf 1/2 3/4 4/3\n",
        "f 1/1/1 2/2/1 3/3/1\nf 1/2/1 3/4/2 4/3/3\n",
        "f -4/-4 -3/-3 -2/-2\nf 1/-3/-1 -2/4/-1 4/3/1\n",
        "f 1/1/ 2/2 3/3/1\nfo 1/2 3/4 \\\n 4/3\n",
    ] {
        let text = format!("{vertices}{uvs}vn 0 0 1\n{faces}");
        check_seam(&read(obj::read(text.as_bytes())));
    }
    // Faces may come before what they name.
    let text = format!("f 1/1 2/2 3/3\n{uvs}f 1/2 3/4 4/-2\n{vertices}");
    check_seam(&read(obj::read(text.as_bytes())));
    let file = read(obj::read(format!("{vertices}{uvs}f 1 2 3 4\n").as_bytes()));
    assert_eq!((file.mesh.uvs, file.notes), (vec![], vec![]));
    assert!(obj::read(format!("f 1/-1 2/1 3/1\n{vertices}{uvs}").as_bytes()).is_err());
}

#[test]
fn triangles_of_polygons_keep_the_texture_coordinates_of_their_corners() {
    // An L with two corners in one place and one on an edge, and a triangle without area before it; each
    // corner has a `vt` of its own, which says where it is.
    let corners = [
        (0, 0),
        (3, 0),
        (3, 1),
        (1, 1),
        (1, 1),
        (1, 3),
        (0, 3),
        (0, 1),
        (0, 0),
    ];
    let mut text = String::new();
    for (x, y) in corners {
        text += &format!("v {x} {y} 0\n");
    }
    // Texture coordinates are numbered backwards.
    for (x, y) in corners.iter().rev() {
        text += &format!("vt {y}.5 {x}.25\n");
    }
    let outline = |corners: &[usize]| {
        let corner = |i: &usize| format!(" {i}/{}", 10 - i);
        corners.iter().map(corner).collect::<String>()
    };
    for face in [
        &[1, 9, 2][..],
        &[1, 2, 3, 4, 5, 6, 7, 8],
        &[1, 9, 2, 3],
        &[2, 3, 4],
    ] {
        text += &format!("f{}\n", outline(face));
    }
    let mesh = read(obj::read(text.as_bytes())).mesh;
    assert_eq!(mesh.uvs.len(), mesh.triangles.len());
    let kept = mesh.to_triangles(|p| p.as_vec3());
    assert!(kept.len() < mesh.triangles.len(), "some have no area");
    for (at, triangle) in kept {
        let places = [triangle.a, triangle.b, triangle.c];
        let expected = places.map(|p| Vec2::new(p.y + 0.5, p.x + 0.25));
        assert_eq!(mesh.uv(at), expected);
    }
}

#[test]
fn faces_without_texture_coordinates_get_the_default_and_are_noted() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0.5\nf 1/1 2/1 3/1\nf 1/1 3/1 4\n\
                f 1 3 4\nf 1//1 3//1 4//1\nf 1/1 2/1\n";
    let file = read(obj::read(text.as_bytes()));
    let own = [Vec2::new(0.0, 0.5); 3];
    assert_eq!(file.mesh.uvs, [own, DEFAULT_UVS, DEFAULT_UVS, DEFAULT_UVS]);
    assert_eq!(
        file.notes,
        [
            "3 faces lack texture coordinates at some corner; their triangles get (0, 0), (1, 0) and \
             (1, 1)",
            "ignored: f of fewer than 3 corners (1)"
        ]
    );
    assert_eq!(Mesh::default().uv(7), DEFAULT_UVS);
}

#[test]
fn a_triangle_turned_over_keeps_its_texture_at_its_corners() {
    let mut mesh = Mesh {
        triangles: vec![[0, 1, 2]],
        uvs: vec![DEFAULT_UVS],
        ..Mesh::default()
    };
    mesh.turn_over();
    let [a, b, c] = DEFAULT_UVS;
    assert_eq!((mesh.triangles[0], mesh.uvs[0]), ([0, 2, 1], [a, c, b]));
}

/// A number of a PLY file, in its type and encoding.
fn number(value: f64, kind: &str, format: &str) -> Vec<u8> {
    let little = match kind {
        _ if format == "ascii" => return format!("{value} ").into_bytes(),
        "uchar" => vec![value as u8],
        "int" => (value as i32).to_le_bytes().to_vec(),
        "float" => (value as f32).to_le_bytes().to_vec(),
        _ => value.to_le_bytes().to_vec(),
    };
    match format {
        "binary_big_endian" => little.into_iter().rev().collect(),
        _ => little,
    }
}

const FORMATS: [&str; 3] = ["ascii", "binary_little_endian", "binary_big_endian"];

/// A PLY file of the square of [`SEAM`], whose vertices have these properties before x, y, z: type, name
/// and which of u and v.
fn ply_file(format: &str, properties: &[(&str, &str, usize)]) -> Vec<u8> {
    let named: String = properties
        .iter()
        .map(|(kind, name, _)| format!("property {kind} {name}\n"))
        .collect();
    let mut bytes = format!(
        "ply\nformat {format} 1.0\nelement vertex 6\n{named}property float x\nproperty float y\n\
         property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
    )
    .into_bytes();
    let line = |bytes: &mut Vec<u8>| bytes.extend((format == "ascii").then_some(b'\n'));
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    for (at, uv) in [0, 1, 2, 0, 2, 3].into_iter().zip(SEAM.as_flattened()) {
        for (kind, _, axis) in properties {
            bytes.extend(number(f64::from(uv[*axis]), kind, format));
        }
        let [x, y] = square[at];
        bytes.extend([x, y, 0.0].map(|x| number(x, "float", format)).concat());
        line(&mut bytes);
    }
    for face in [[0, 1, 2], [3, 4, 5]] {
        bytes.extend(number(3.0, "uchar", format));
        bytes.extend(face.map(|i| number(f64::from(i), "int", format)).concat());
        line(&mut bytes);
    }
    bytes
}

#[test]
fn vertices_of_ply_files_have_texture_coordinates_under_the_names_of_common_writers() {
    for format in FORMATS {
        for [u, v] in ply::UVS {
            for kind in ["float", "double"] {
                for properties in [
                    vec![(kind, u, 0), (kind, v, 1)],
                    vec![(kind, v, 1), ("uchar", "red", 0), (kind, u, 0)],
                ] {
                    let file = read(ply::read(&ply_file(format, &properties)));
                    check_seam(&file);
                    assert!(file.notes.is_empty());
                }
            }
            // One alone is something else.
            for alone in [u, v] {
                let properties = [("float", alone, 0), ("float", "quality", 1)];
                let file = read(ply::read(&ply_file(format, &properties)));
                assert!(file.mesh.uvs.is_empty());
            }
        }
        // The first pair in the order of the names counts, whatever that in the file.
        let both = [
            ("float", "s", 1),
            ("float", "t", 1),
            ("float", "v", 1),
            ("float", "u", 0),
        ];
        check_seam(&read(ply::read(&ply_file(format, &both))));
    }
    let whole = ply_file("binary_big_endian", &[("uchar", "s", 0), ("uchar", "t", 1)]);
    let uvs = read(ply::read(&whole)).mesh.uvs;
    assert_eq!(
        uvs,
        seam()
            .iter()
            .map(|t| t.map(|uv| uv.trunc()))
            .collect::<Vec<_>>()
    );
}

#[test]
fn strips_of_ply_files_have_the_texture_coordinates_of_their_vertices() {
    let text = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
                property float z\nproperty float u\nproperty float v\nelement tristrips 1\n\
                property list int int vertex_indices\nend_header\n\
                0 0 0 0 0\n1 0 0 0.5 0\n0 1 0 0 0.5\n1 1 0 0.5 0.5\n4 0 1 2 3\n";
    let mesh = read(ply::read(text.as_bytes())).mesh;
    let own = |t: &[u32; 3]| t.map(|i| mesh.vertices[i as usize].truncate().as_vec2() * 0.5);
    assert_eq!(mesh.triangles, [[0, 1, 2], [2, 1, 3]]);
    assert_eq!(mesh.uvs, mesh.triangles.iter().map(own).collect::<Vec<_>>());
}

/// A PLY file as MeshLab writes it with texture coordinates by wedge, here for faces as they are given.
fn wedges(faces: &str, count: usize) -> String {
    format!(
        "ply\nformat ascii 1.0\ncomment VCGLIB generated\ncomment TextureFile image.png\n\
         element vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
         property float texture_u\nproperty float texture_v\nelement face {count}\n\
         property list uchar int vertex_indices\nproperty list uchar float texcoord\n\
         property int texnumber\nend_header\n\
         0 0 0 7 7 \n1 0 0 7 7 \n1 1 0 7 7 \n0 1 0 7 7 \n{faces}"
    )
}

#[test]
fn lists_of_a_faces_corners_come_before_what_vertices_say() {
    let faces = "3 0 1 2 6 0 0 0.5 0 0.5 1 0 \n3 0 2 3 6 0.5 0 1 1 0.5 1 0 \n";
    check_seam(&read(ply::read(wedges(faces, 2).as_bytes())));
    // A quadrilateral, split into triangles.
    let file = read(ply::read(
        wedges("4 0 1 2 3 8 0 0 1 0 1 1 0 1 0\n", 1).as_bytes(),
    ));
    let own = |t: &[u32; 3]| t.map(|i| file.mesh.vertices[i as usize].truncate().as_vec2());
    let expected: Vec<_> = file.mesh.triangles.iter().map(own).collect();
    assert_eq!((expected.len(), file.mesh.uvs), (2, expected));
    // Without any, beside one that has some.
    let file = read(ply::read(
        wedges("3 0 1 2 0 0\n3 0 2 3 6 0.5 0 1 1 0.5 1 0\n", 2).as_bytes(),
    ));
    assert_eq!(file.mesh.uvs, [DEFAULT_UVS, seam()[1]]);
    assert!(file.notes[0].starts_with("1 faces lack texture coordinates"));
    for (numbers, words) in [
        (
            "5 0 0 1 0 1",
            "has 5 numbers in `texcoord` of face 0, not two for each of its 3 corners",
        ),
        (
            "3 0 1 1",
            "has 3 numbers in `texcoord` of face 0, not two for each of its 3 corners",
        ),
        ("8 0 0 1 0 1 1 0 1", "has 8 numbers in `texcoord` of face 0"),
        (
            "6 0 0 1 0 1 nan",
            "has texture coordinates that are not finite numbers in face 0",
        ),
    ] {
        let text = wedges(&format!("3 0 1 2 {numbers} 0\n"), 1);
        let what = ply::read(text.as_bytes()).expect_err(numbers);
        assert!(what.contains(words), "{what}");
    }
}

#[test]
fn lists_of_a_faces_corners_are_read_in_every_format() {
    for format in FORMATS {
        for kind in ["float", "double"] {
            let text = String::from_utf8(ply_file("ascii", &[])).unwrap();
            let (header, _) = text.split_once("end_header\n").unwrap();
            let mut bytes = header.replace("ascii", format).into_bytes();
            bytes.extend(format!("property list uchar {kind} texcoord\nend_header\n").bytes());
            let line = |bytes: &mut Vec<u8>| bytes.extend((format == "ascii").then_some(b'\n'));
            for (x, y) in [(0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)] {
                let place = [x, y, 0].map(|x| number(f64::from(x), "float", format));
                bytes.extend(place.concat());
                line(&mut bytes);
            }
            for (face, uvs) in [[0, 1, 2], [3, 4, 5]].into_iter().zip(SEAM) {
                bytes.extend(number(3.0, "uchar", format));
                bytes.extend(face.map(|i| number(f64::from(i), "int", format)).concat());
                bytes.extend(number(6.0, "uchar", format));
                let uvs = uvs.as_flattened().iter();
                bytes.extend(uvs.flat_map(|x| number(f64::from(*x), kind, format)));
                line(&mut bytes);
            }
            check_seam(&read(ply::read(&bytes)));
        }
    }
}

#[test]
fn texture_coordinates_are_read_as_other_programs_write_them() {
    // Blender's OBJ: its faces name texture coordinates that they share.
    let blender = "# Blender 4.2.0\n# www.blender.org\nmtllib square.mtl\no Plane\n\
                   v 0.000000 0.000000 0.000000\nv 1.000000 0.000000 0.000000\n\
                   v 1.000000 1.000000 0.000000\nv 0.000000 1.000000 0.000000\n\
                   vn -0.0000 0.0000 1.0000\nvt 0.000000 0.000000\nvt 0.500000 0.000000\n\
                   vt 0.500000 1.000000\nvt 1.000000 1.000000\ns 0\nusemtl Material\n\
                   f 1/1/1 2/2/1 3/3/1\nf 1/2/1 3/4/1 4/3/1\n";
    check_seam(&read(obj::read(blender.as_bytes())));
    // Its PLY: a vertex for each side of the seam, s and t after the normal.
    let blender = "ply\nformat ascii 1.0\ncomment Created in Blender version 4.2.0\n\
                   element vertex 6\nproperty float x\nproperty float y\nproperty float z\n\
                   property float nx\nproperty float ny\nproperty float nz\nproperty float s\n\
                   property float t\nelement face 2\nproperty list uchar uint vertex_indices\n\
                   end_header\n0 0 0 0 0 1 0 0\n1 0 0 0 0 1 0.5 0\n1 1 0 0 0 1 0.5 1\n\
                   0 0 0 0 0 1 0.5 0\n1 1 0 0 0 1 1 1\n0 1 0 0 0 1 0.5 1\n3 0 1 2\n3 3 4 5\n";
    check_seam(&read(ply::read(blender.as_bytes())));
    // MeshLab's OBJ: vertices have colours, and each wedge a `vt` of its own.
    let meshlab = "####\n#\n# OBJ File Generated by Meshlab\n#\n####\n# Object square.obj\n#\n\
                   # Vertices: 4\n# Faces: 2\n#\n####\nmtllib ./square.obj.mtl\n\n\
                   vn 0.000000 0.000000 1.570796\nv 0.000000 0.000000 0.000000 1.0 1.0 1.0\n\
                   v 1.000000 0.000000 0.000000 1.0 1.0 1.0\nv 1.000000 1.000000 0.000000 1.0 1.0 1.0\n\
                   v 0.000000 1.000000 0.000000 1.0 1.0 1.0\n# 4 vertices, 0 vertices normals\n\n\
                   usemtl material_0\nvt 0.000000 0.000000\nvt 0.500000 0.000000\n\
                   vt 0.500000 1.000000\nf 1/1/1 2/2/1 3/3/1\nvt 0.500000 0.000000\n\
                   vt 1.000000 1.000000\nvt 0.500000 1.000000\nf 1/4/1 3/5/1 4/6/1\n\
                   # 2 faces, 6 coords texture\n\n# End of File\n";
    check_seam(&read(obj::read(meshlab.as_bytes())));
    // pbrt's PLY: binary, u and v after the normal, and each face with its number.
    let header = "ply\nformat binary_little_endian 1.0\nelement vertex 6\nproperty float x\n\
                  property float y\nproperty float z\nproperty float nx\nproperty float ny\n\
                  property float nz\nproperty float u\nproperty float v\nelement face 2\n\
                  property list uint8 int vertex_indices\nproperty int face_indices\nend_header\n";
    let mut pbrt = header.as_bytes().to_vec();
    let places = [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]];
    for ([x, y], uv) in places.into_iter().zip(SEAM.as_flattened()) {
        let row = [x as f32, y as f32, 0.0, 0.0, 0.0, 1.0, uv[0], uv[1]];
        pbrt.extend(row.into_iter().flat_map(f32::to_le_bytes));
    }
    for (at, face) in [[0_i32, 1, 2], [3, 4, 5]].into_iter().enumerate() {
        pbrt.push(3);
        pbrt.extend(
            face.into_iter()
                .chain([at as i32])
                .flat_map(i32::to_le_bytes),
        );
    }
    check_seam(&read(ply::read(&pbrt)));
}
