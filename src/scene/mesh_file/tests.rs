use super::{MeshFile, Said, obj, ply, triangles};
use crate::geometry::Mesh;
use glam::DVec3;

fn read(said: Result<Said, String>) -> MeshFile {
    triangles(said.expect("a mesh")).expect("triangles")
}

fn obj_file(text: &str) -> Mesh {
    read(obj::read(text.as_bytes())).mesh
}

/// Three vertices, in the first words of their lines.
const CORNERS: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

fn corner_places() -> Vec<DVec3> {
    vec![DVec3::ZERO, DVec3::X, DVec3::Y]
}

#[test]
fn every_way_to_write_a_triangle_in_an_obj_file_is_that_triangle() {
    let expected = Mesh {
        vertices: corner_places(),
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let faces = [
        "f 1 2 3",
        "f -3 -2 -1",
        "f 1/ 2/ 3/",
        "f 1//7 2//8 3//9",
        "f 1/ 2// -1//-1",
        "fo 1 2 3",
        "  f\t1  2 3  ",
        "f 1 2 3 # the only face",
        "f 1 2 3#",
        "f 1 \\\n 2 \\\n3",
        "f 1 2 \\  \n3",
        "f 1 2\\\n 3",
        "f 1 2 3\nf 1 2\nf 3",
        "# C:\\models\\\nf 1 2 3",
        "g a b\\\nc\nf 1 2 3",
        "vertex_color 1\nf 1 2 3",
    ];
    for face in faces {
        for text in [
            format!("{CORNERS}{face}\n"),
            format!("\u{feff}{CORNERS}{face}"),
            format!("\u{feff}{CORNERS}{face}\n").replace('\n', "\r\n"),
            format!("# first\n\n{CORNERS}s off\n{face}\n\n"),
        ] {
            assert_eq!(obj_file(&text), expected, "{text:?}");
        }
    }
    // Faces may come before their vertices, but not those counted back.
    assert_eq!(obj_file(&format!("f 1 2 3\n{CORNERS}")), expected);
    assert!(obj::read(format!("f -3 -2 -1\n{CORNERS}").as_bytes()).is_err());
}

#[test]
fn weights_and_colours_of_vertices_do_not_move_them() {
    for more in [
        "",
        " 1",
        " 0.5",
        " 1 0 0",
        " 0.2 0.4 0.6 1",
        " 255 128 0 # red",
    ] {
        let text = format!("{CORNERS}f 1 2 3\n").replacen("v 1 0 0", &format!("v 1 0 0{more}"), 1);
        assert_eq!(obj_file(&text).vertices, corner_places(), "{text:?}");
    }
    for number in ["1.", "+1", "1.0e0", "1E+00", "10e-1", "1.d0"] {
        let text =
            format!("{CORNERS}f 1 2 3\n").replacen("v 1 0 0", &format!("v {number} .0 -0."), 1);
        match obj::read(text.as_bytes()) {
            Ok(said) => assert_eq!(read(Ok(said)).mesh.vertices, corner_places()),
            Err(what) => assert!(number == "1.d0" && what.contains("line 2"), "{what}"),
        }
    }
}

#[test]
fn what_an_obj_file_says_besides_is_counted_by_name() {
    let text = format!(
        "mtllib a.mtl\n{CORNERS}vn 0 0 1\nvn 0 0 1\nusemtl red\nf 1 2 3\nf 1 2\nf 2\ncstype bezier\n\
         curv2 1 2 \\\n 3\nsurf 0 1 0 1 1/2\nvp 0.5\nend\nmy_own 1\n"
    );
    let file = read(obj::read(text.as_bytes()));
    assert_eq!(
        file.notes,
        [
            "ignored: cstype (1), curv2 (1), end (1), f of fewer than 3 corners (2), mtllib (1), \
          my_own (1), surf (1), usemtl (1), vn (2), vp (1)"
        ]
    );
    let crossed = "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n";
    let file = read(obj::read(crossed.as_bytes()));
    assert_eq!(file.notes, ["1 polygons whose edges cross, filled somehow"]);
}

#[test]
fn map_coordinates_keep_their_digits() {
    let places = [
        DVec3::new(4_485_513.72, 701_362.56, 37.5),
        DVec3::new(4_485_514.72, 701_362.56, 37.25),
        DVec3::new(4_485_513.72, 701_363.81, 37.0625),
    ];
    let rows = |before: &str| {
        places
            .map(|p| format!("{before}{} {} {}\n", p.x, p.y, p.z))
            .concat()
    };
    assert_eq!(
        obj_file(&format!("{}f 1 2 3\n", rows("v "))).vertices,
        places
    );
    // In decimals they are what they are, even where the header says `float`.
    for kind in ["float", "double"] {
        let text = format!(
            "{}{}3 0 1 2\n",
            header("ascii", kind, "uchar int"),
            rows("")
        );
        assert_eq!(
            read(ply::read(text.as_bytes())).mesh.vertices,
            places,
            "{kind}"
        );
    }
    for big in [true, false] {
        let order = if big {
            "binary_big_endian"
        } else {
            "binary_little_endian"
        };
        let mut bytes = header(order, "double", "uchar uchar").into_bytes();
        for x in places.iter().flat_map(|p| p.to_array()) {
            bytes.extend(if big {
                x.to_be_bytes()
            } else {
                x.to_le_bytes()
            });
        }
        bytes.extend([3, 0, 1, 2]);
        assert_eq!(read(ply::read(&bytes)).mesh.vertices, places, "{order}");
    }
}

/// A header of three vertices and one face.
fn header(format: &str, real: &str, list: &str) -> String {
    format!(
        "ply\nformat {format} 1.0\nelement vertex 3\nproperty {real} x\nproperty {real} y\n\
         property {real} z\nelement face 1\nproperty list {list} vertex_indices\nend_header\n"
    )
}

#[test]
fn lists_of_whole_numbers_of_every_type_are_corners() {
    // Names of the type, and its size in bytes.
    let types = [
        (["char", "int8"], 1),
        (["uchar", "uint8"], 1),
        (["short", "int16"], 2),
        (["ushort", "uint16"], 2),
        (["int", "int32"], 4),
        (["uint", "uint32"], 4),
    ];
    let word = |value: u32, size: usize, big: bool| {
        let little = value.to_le_bytes()[..size].to_vec();
        if big {
            little.into_iter().rev().collect()
        } else {
            little
        }
    };
    for (counts, count_size) in types {
        for (items, item_size) in types {
            for (count, item) in counts.into_iter().zip(items) {
                let list = format!("{count} {item}");
                let text = format!(
                    "{}0 0 0\n1 0 0\n0 1 0\n3 2 0 1\n",
                    header("ascii", "float", &list)
                );
                assert_eq!(
                    read(ply::read(text.as_bytes())).mesh.triangles,
                    [[2, 0, 1]],
                    "{list}"
                );
                for big in [true, false] {
                    let order = if big {
                        "binary_big_endian"
                    } else {
                        "binary_little_endian"
                    };
                    let mut bytes = header(order, "float32", &list).into_bytes();
                    for x in corner_places().iter().flat_map(|p| p.as_vec3().to_array()) {
                        bytes.extend(word(x.to_bits(), 4, big));
                    }
                    bytes.extend(word(3, count_size, big));
                    bytes.extend([2, 0, 1].map(|i| word(i, item_size, big)).concat());
                    let mesh = read(ply::read(&bytes)).mesh;
                    assert_eq!(mesh.triangles, [[2, 0, 1]], "{order} {list}");
                    assert_eq!(mesh.vertices, corner_places(), "{order} {list}");
                }
            }
        }
    }
    // Numbers above 127 and 32767 are not negative.
    let text = header("ascii", "float", "uchar ushort").replace("vertex 3", "vertex 40000");
    let text = format!("{text}{}3 200 33000 39999\n", "1 2 3\n".repeat(40_000));
    let said = ply::read(text.as_bytes()).expect("a mesh");
    assert_eq!(
        said.polygons.iter().next(),
        Some(&[200, 33_000, 39_999][..])
    );
    for (item, size, corners) in [
        ("uchar", 1, [200, 128, 255]),
        ("ushort", 2, [200, 33_000, 39_999]),
        ("uint", 4, [200, 33_000, 39_999]),
    ] {
        for order in ["binary_big_endian", "binary_little_endian"] {
            let list = format!("uchar {item}");
            let text = header(order, "float", &list).replace("vertex 3", "vertex 40000");
            let mut bytes = text.into_bytes();
            bytes.extend([0; 40_000 * 12]);
            bytes.push(3);
            let big = order == "binary_big_endian";
            bytes.extend(corners.map(|i| word(i, size, big)).concat());
            let said = ply::read(&bytes).expect("a mesh");
            assert_eq!(
                said.polygons.iter().next(),
                Some(&corners[..]),
                "{order} {item}"
            );
        }
    }
}

#[test]
fn ply_numbers_may_be_written_in_all_ways() {
    let expected = corner_places();
    for rows in [
        "0. .0 -0.\n1. 0 0\n0 1.e0 +0\n",
        "0 0 0\r\n1 0 0\r\n0 1 0\r\n",
        "\n0 0 0\n\n1 0 0\n  0\t1   0 \n",
        "0e5 0E-3 0\n1000e-3 0 0\n0 1.000000000000000000000 0\n",
    ] {
        for mark in ["", "\u{feff}"] {
            let text = format!(
                "{mark}{}{rows}3 0 1 2\n",
                header("ascii", "float", "uchar int")
            );
            let crlf = text.replace("\r\n", "\n").replace('\n', "\r\n");
            for text in [text, crlf] {
                let mesh = read(ply::read(text.as_bytes())).mesh;
                assert_eq!(
                    (&mesh.vertices, &mesh.triangles[..]),
                    (&expected, &[[0, 1, 2]][..])
                );
            }
        }
    }
}

#[test]
fn strips_alternate_and_end_at_minus_one() {
    let text = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n\
                property float z\nelement tristrips 2\nproperty list int int vertex_indices\n\
                element edge 1\nproperty int a\nend_header\n\
                0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n\
                9 0 1 2 3 4 5 -1 0 1\n7 -1 0 1 2 -1 -1 3\n7\n";
    let file = read(ply::read(text.as_bytes()));
    let front = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5], [0, 1, 2]];
    assert_eq!(file.mesh.triangles, front);
    assert_eq!(file.notes, ["ignored: edge (1)"]);
    // All of a strip faces one way.
    let up = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| file.mesh.vertices[i as usize]);
        (b - a).cross(c - a).z > 0.0
    };
    assert!(file.mesh.triangles.iter().all(up));
    // A corner said twice turns it round and makes no triangle.
    let text = text
        .replace("9 0 1 2 3 4 5 -1 0 1", "7 0 1 2 2 3 4 5")
        .replace("7 -1 0 1 2 -1 -1 3", "0");
    let file = read(ply::read(text.as_bytes()));
    assert_eq!(file.mesh.triangles, [[0, 1, 2], [3, 2, 4], [3, 4, 5]]);
    let bad = text.replace("2 2 3 4", "2 -2 3 4");
    let what = ply::read(bad.as_bytes()).expect_err("no corner");
    assert_eq!(what, "has a vertex index of -2 in tristrips 0");
}
