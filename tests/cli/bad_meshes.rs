//! Broken mesh files: the sentence names the scene's line and field, and the mesh.

use super::meshes::{Ply, Solid, TETRAHEDRON, scene};
use super::{folder, scene_refused};
use std::time::{Duration, Instant};

/// Checks that a mesh file is refused, in a sentence with `words`, and without delay.
pub fn check(name: &str, bytes: &[u8], words: &str) {
    let folder = folder();
    std::fs::write(folder.path().join(name), bytes).unwrap();
    let start = Instant::now();
    let sentence = mesh_refused(folder.path(), name, words);
    // Seconds would mean that a number in the file was believed.
    assert!(start.elapsed() < Duration::from_secs(2), "{sentence}");
    assert!(sentence.len() < 300, "{sentence}");
}

fn mesh_refused(folder: &std::path::Path, name: &str, words: &str) -> String {
    let text = scene(name);
    let line = 1 + text.lines().position(|l| l.contains("mesh =")).unwrap();
    let named = format!("names {name}, which ");
    scene_refused(
        folder,
        text.as_bytes(),
        line,
        "objects[0].mesh.file",
        &[&named, words],
    )
}

/// An ASCII file of a tetrahedron with one change.
fn ply(right: &str, wrong: &str) -> Vec<u8> {
    let text = String::from_utf8(TETRAHEDRON.ply(Ply::Ascii)).unwrap();
    assert!(text.contains(right), "{right}");
    text.replacen(right, wrong, 1).into_bytes()
}

#[test]
fn files_that_are_no_mesh() {
    let folder = folder();
    for name in ["none.ply", "none.obj", "no/folder/none.ply"] {
        mesh_refused(folder.path(), name, "cannot be opened: ");
    }
    std::fs::create_dir(folder.path().join("folder.ply")).unwrap();
    std::fs::create_dir(folder.path().join("folder.obj")).unwrap();
    for name in ["folder.ply", "folder.obj"] {
        mesh_refused(folder.path(), name, "directory");
    }
    check("solid.stl", b"solid", "allowed are .ply and .obj");
    check("solid", b"solid", "allowed are .ply and .obj");
}

#[test]
fn broken_ply_files() {
    check("a.ply", b"", "is not a proper PLY file: ");
    check("a.ply", b"plx\n", "magic number");
    check(
        "a.ply",
        b"\x7fELF\0\0\0\xff\xff\n",
        "is not a proper PLY file: ",
    );
    check(
        "a.ply",
        &ply("end_header\n", ""),
        "is not a proper PLY file: ",
    );
    check("a.ply", &ply("format ascii 1.0\n", ""), "format");
    check(
        "a.ply",
        &ply("format ascii 1.0", "format utf8 1.0"),
        "Line 2",
    );
    check(
        "a.ply",
        &ply("format ascii 1.0", "format ascii 70000.0"),
        "version",
    );
    check(
        "a.ply",
        &ply("property float x", "property number x"),
        "Line 5",
    );
    check(
        "a.ply",
        &ply("element vertex", "element point"),
        "no element `vertex`",
    );
    check(
        "a.ply",
        &ply("element face", "element fase"),
        "no element `face` or `tristrips`",
    );
    check("a.ply", &ply("float z", "float w"), "no property `z`");
    check(
        "a.ply",
        &ply("vertex_indices", "corners"),
        "no list `vertex_indices`",
    );
    check(
        "a.ply",
        &ply("list uchar int", "list uchar float"),
        "no list `vertex_indices`",
    );
    check(
        "a.ply",
        &ply("0 1 200 0\n", "0 nan 200 0\n"),
        "vertex (number 0) whose coordinates",
    );
    check("a.ply", &ply("0 1 200 0\n", "0 one 200 0\n"), "Line 13");
    check("a.ply", &ply("0 1 200 0\n", "0 1 200 0 7\n"), "Line 13");
    check("a.ply", &ply("0 1 200 0\n", "0 1\n"), "Line 13");
    check(
        "a.ply",
        &ply("0 1 200 0\n", "0 1e39 200 0\n"),
        "vertex (number 0) whose coordinates",
    );
    check(
        "a.ply",
        &ply("3 0 1 2", "3 0 1 4"),
        "no vertex 4, which face 0 uses: there are 4",
    );
    check(
        "a.ply",
        &ply("3 0 1 2", "3 0 1 -1"),
        "has a vertex index of -1 in face 0",
    );
    check(
        "a.ply",
        &ply("3 0 1 2", "2 0 1"),
        "fewer than 3 corners in face 0",
    );
    check(
        "a.ply",
        &ply("3 0 1 2", "0"),
        "fewer than 3 corners in face 0",
    );
    check("a.ply", &ply("3 0 1 2", "-3 0 1 2"), "Line 17");
    check("a.ply", &ply("3 0 1 2", "4000000000000 0 1 2"), "Line 17");
    check(
        "a.ply",
        &ply("vertex 4", "vertex 5"),
        "is not a proper PLY file: ",
    );
    check("a.ply", &ply("face 4", "face 5"), "end of file");
}

#[test]
fn truncated_binary_ply_files() {
    for kind in [Ply::Little, Ply::Big] {
        let whole = TETRAHEDRON.ply(kind);
        for length in 1..whole.len() {
            if length % 17 == 0 || length + 1 == whole.len() {
                check("a.ply", &whole[..length], "is not a proper PLY file: ");
            }
        }
    }
    let mut bytes = TETRAHEDRON.ply(Ply::Little);
    let first = bytes.len() - 4 * 17 - 4 * 13;
    bytes[first..first + 4].copy_from_slice(&f32::NAN.to_le_bytes());
    check("a.ply", &bytes, "vertex (number 0) whose coordinates");
}

#[test]
fn counts_in_a_header_are_not_believed() {
    let huge = u64::MAX.to_string();
    for count in ["4000000000", "9223372036854775807", &huge] {
        for kind in [Ply::Ascii, Ply::Little] {
            for element in ["vertex", "face"] {
                let header = format!("element {element} {count}\n");
                let mut bytes = TETRAHEDRON.ply(kind);
                let old = format!("element {element} 4\n").into_bytes();
                let at = bytes.windows(old.len()).position(|w| w == old).unwrap();
                bytes.splice(at..at + old.len(), header.into_bytes());
                check("a.ply", &bytes, "is not a proper PLY file: ");
            }
        }
    }
    // Nothing to read for each of them: no end of the file would ever stop it.
    let vertices = "element vertex 0\nproperty float x\nproperty float y\nproperty float z\n";
    let faces = "element face 0\nproperty list uchar int vertex_indices\n";
    for (name, others) in [
        ("vertex", faces.to_owned()),
        ("face", vertices.to_owned()),
        ("edge", format!("{vertices}{faces}")),
    ] {
        let file = format!(
            "ply\nformat binary_little_endian 1.0\nelement {name} 9000000000000000000\n\
             {others}end_header\n"
        );
        let words = format!("element `{name}` has no properties");
        check("a.ply", file.as_bytes(), &words);
    }
}

#[test]
fn broken_obj_files() {
    let right = String::from_utf8(TETRAHEDRON.obj(|i| (i + 1).to_string())).unwrap();
    let obj = |from: &str, to: &str| {
        assert!(right.contains(from), "{from}");
        right.replacen(from, to, 1).into_bytes()
    };
    check("a.obj", b"", "has no faces, only 0 vertices");
    check(
        "a.obj",
        b"v 0 0 0\nl 1 1\n",
        "has no faces, only 1 vertices; ignored: l (1)",
    );
    check("a.obj", b"\x7fELF\0\xff\xfe\n", "line 1: ");
    let begin = "is not a proper OBJ file: line ";
    let bad = |from: &str, to: &str, line: usize, words: &str| {
        check("a.obj", &obj(from, to), &format!("{begin}{line}: {words}"));
    };
    let (v, f) = (6, 14);
    bad("f 1 2 3", "f 1 2 5", f, "there is no vertex 5, only 4");
    bad(
        "f 1 2 3",
        "f 1 2 -5",
        f,
        "there is no vertex -5, only 4 so far",
    );
    bad("f 1 2 3", "f 0 1 2", f, "there is no vertex 0");
    bad(
        "f 1 2 3",
        "f 1 2 9223372036854775807",
        f,
        "there is no vertex 9223372036854775807",
    );
    bad(
        "f 1 2 3",
        "f 1 2 99999999999999999999",
        f,
        "\"99999999999999999999\" is not a corner",
    );
    bad("f 1 2 3", "f 1 2 x", f, "\"x\" is not a corner");
    bad("f 1 2 3", "f 1 2 3/a", f, "\"3/a\" is not a corner");
    bad("f 1 2 3", "f 1/1/1/1 2 3", f, "\"1/1/1/1\" is not a corner");
    bad("f 1 2 3", "f 1 2 3.5", f, "\"3.5\" is not a corner");
    bad("f 1 2 3", "f", f, "the face has no corners");
    bad("v 0 1 0", "v 0 1", v, "a vertex is x, y, z");
    bad("v 0 1 0", "v 0 1 0 1 1", v, "a vertex is x, y, z");
    bad("v 0 1 0", "v 0 one 0", v, "\"one\" is not a number");
    bad("v 0 1 0", "v 0,1 0 0", v, "\"0,1\" is not a number");
    bad(
        "v 0 1 0",
        "v 0 nan 0",
        v,
        "the vertex has coordinates that are not finite",
    );
    bad(
        "v 0 1 0",
        "v 0 1e39 0",
        v,
        "the vertex has coordinates that are not finite",
    );
    bad("v 0 1 0", "0 1 0", v, "\"0\" is no keyword");
    let long = "x".repeat(10_000);
    bad(
        "v 0 1 0",
        &long,
        v,
        "\"xxxxxxxxxxxxxxxxxxxx\" is no keyword",
    );
}

#[test]
fn a_mesh_without_faces_is_refused() {
    let no_faces = |vertices| Solid {
        vertices,
        faces: &[],
    };
    let empty = no_faces(TETRAHEDRON.vertices);
    for kind in [Ply::Ascii, Ply::Little, Ply::Big] {
        check("a.ply", &empty.ply(kind), "has no faces, only 4 vertices");
        check(
            "a.ply",
            &no_faces(&[]).ply(kind),
            "has no faces, only 0 vertices",
        );
    }
    check(
        "a.obj",
        &empty.obj(|i| i.to_string()),
        "has no faces, only 4 vertices",
    );
    // Nor is anything to be seen of faces that are lines.
    let line = Solid {
        vertices: TETRAHEDRON.vertices,
        faces: &[&[0, 1, 1], &[2, 2, 2, 2]],
    };
    check(
        "a.ply",
        &line.ply(Ply::Ascii),
        "has no triangle with an area",
    );
    check(
        "a.obj",
        &line.obj(|i| (i + 1).to_string()),
        "has no triangle with an area",
    );
}

#[test]
fn what_follows_the_last_element_of_a_ply_file_is_not_passed_over() {
    for kind in [Ply::Ascii, Ply::Little, Ply::Big] {
        let mut bytes = TETRAHEDRON.ply(kind);
        bytes.extend(b"3 0 1 2 0\n");
        check("a.ply", &bytes, "it goes on after the last of its elements");
    }
}
