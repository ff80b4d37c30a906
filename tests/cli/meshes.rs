//! The same mesh in every format gives the same picture.

use super::{complaint, folder, halfdisk, shades};
use std::path::Path;

/// Corners and faces, the faces counter-clockwise from outside.
pub struct Solid {
    pub vertices: &'static [[f32; 3]],
    pub faces: &'static [&'static [i32]],
}

pub const TETRAHEDRON: Solid = Solid {
    vertices: &[
        [0.0, 1.0, 0.0],
        [-1.0, -0.75, 0.5],
        [1.0, -0.75, 0.5],
        [0.1, -0.5, -1.0],
    ],
    faces: &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 1], &[1, 3, 2]],
};

/// A cube whose top is a polygon of five corners.
const CUBE: Solid = Solid {
    vertices: &[
        [-1.0, -1.0, -1.0],
        [1.0, -1.0, -1.0],
        [1.0, -1.0, 1.0],
        [-1.0, -1.0, 1.0],
        [-1.0, 1.0, -1.0],
        [1.0, 1.0, -1.0],
        [1.0, 1.0, 1.0],
        [-1.0, 1.0, 1.0],
        [-1.25, 1.0, 0.0],
    ],
    faces: &[
        &[0, 1, 2, 3],
        &[7, 6, 5, 4, 8],
        &[3, 2, 6, 7],
        &[1, 0, 4, 5],
        &[2, 1, 5, 6],
        &[0, 3, 7, 4],
        &[3, 8, 4],
    ],
};

#[derive(Clone, Copy, PartialEq)]
pub enum Ply {
    Ascii,
    Little,
    Big,
}

impl Solid {
    pub fn ply(&self, kind: Ply) -> Vec<u8> {
        let format = match kind {
            Ply::Ascii => "ascii",
            Ply::Little => "binary_little_endian",
            Ply::Big => "binary_big_endian",
        };
        let mut file = format!(
            "ply\nformat {format} 1.0\ncomment made by a test\nelement vertex {}\nproperty float x\n\
             property float y\nproperty uchar red\nproperty float z\nelement face {}\n\
             property list uchar int vertex_indices\nproperty float quality\nend_header\n",
            self.vertices.len(),
            self.faces.len()
        )
        .into_bytes();
        let word = |bytes: [u8; 4]| match kind {
            Ply::Big => bytes.into_iter().rev().collect::<Vec<u8>>(),
            _ => bytes.to_vec(),
        };
        for [x, y, z] in self.vertices {
            if kind == Ply::Ascii {
                file.extend(format!("{x} {y} 200 {z}\n").bytes());
                continue;
            }
            let number = |x: &f32| word(x.to_le_bytes());
            file.extend([number(x), number(y), vec![200], number(z)].concat());
        }
        for face in self.faces {
            if kind == Ply::Ascii {
                let corners: Vec<String> = face.iter().map(i32::to_string).collect();
                file.extend(format!("{} {} 0.5\n", face.len(), corners.join(" ")).bytes());
                continue;
            }
            file.push(face.len() as u8);
            file.extend(face.iter().flat_map(|i| word(i.to_le_bytes())));
            file.extend(word(0.5_f32.to_le_bytes()));
        }
        file
    }

    pub fn obj(&self, corner: impl Fn(i32) -> String) -> Vec<u8> {
        let mut file = String::from("# a comment\nmtllib none.mtl\no solid\nvt 0 0\nvn 0 1 0\n");
        for [x, y, z] in self.vertices {
            file += &format!("v {x} {y} {z}\n");
        }
        file += "usemtl none\nl 1 2 3\np 1\ns off\n";
        for (at, face) in self.faces.iter().enumerate() {
            if at == 2 {
                file += "g second\n";
            }
            let corners: Vec<String> = face.iter().map(|i| corner(*i)).collect();
            file += &format!("f {}\n", corners.join(" "));
        }
        file.into_bytes()
    }

    /// Each face as a fan of triangles.
    fn split(&self) -> Solid {
        let fans = self.faces.iter().flat_map(|face| {
            let (first, rest) = face.split_first().unwrap();
            rest.windows(2).map(|w| &*vec![*first, w[0], w[1]].leak())
        });
        Solid {
            vertices: self.vertices,
            faces: fans.collect::<Vec<_>>().leak(),
        }
    }
}

/// A scene that shows a mesh file.
pub fn scene(mesh: &str) -> String {
    format!(
        r#"name = "solid"
background = [0.25, 0.5, 0.75]
[camera]
from = [1, 2, 5]
to = [0, 0, 0]
fov = 40
[film]
size = [24, 18]
[materials.dull]
lambert = {{ albedo = 0.5 }}
[[lights]]
point = {{ position = [2, 4, 4], intensity = 40 }}
[[objects]]
material = "dull"
mesh = {{ file = "{mesh}" }}
"#
    )
}

/// The picture of a mesh file, and what was said about it.
pub fn picture(folder: &Path, mesh: &str, bytes: &[u8]) -> (Vec<u8>, String) {
    std::fs::write(folder.join(mesh), bytes).unwrap();
    std::fs::write(folder.join("scene.toml"), scene(mesh)).unwrap();
    let output = halfdisk(
        folder,
        &["render", "scene.toml", "--spp", "2", "--out", "p.png"],
    );
    assert!(output.status.success(), "{mesh}: {}", complaint(&output));
    (shades(&folder.join("p.png")), complaint(&output))
}

#[test]
fn every_format_gives_the_same_picture() {
    let folder = folder();
    let see = |name: &str, bytes: Vec<u8>| picture(folder.path(), name, &bytes).0;
    for solid in [TETRAHEDRON, CUBE] {
        let count = solid.vertices.len() as i32;
        let expected = see("a.ply", solid.ply(Ply::Ascii));
        let mut pixels = expected.chunks_exact(3);
        let first = pixels.next().unwrap();
        assert!(pixels.any(|pixel| pixel != first), "it is seen");
        assert!(expected == see("b.ply", solid.ply(Ply::Little)));
        assert!(expected == see("c.PLY", solid.ply(Ply::Big)));
        assert!(expected == see("a.obj", solid.obj(|i| (i + 1).to_string())));
        assert!(expected == see("b.obj", solid.obj(|i| (i - count).to_string())));
        assert!(expected == see("c.OBJ", solid.obj(|i| format!("{}/1/1", i + 1))));
        assert!(expected == see("d.obj", solid.obj(|i| format!("{}//1", i + 1))));
        // Polygons are what their fans are.
        let triangles = solid.split();
        assert!(triangles.faces.iter().all(|f| f.len() == 3));
        assert!(expected == see("d.ply", triangles.ply(Ply::Ascii)));
        assert!(expected == see("e.obj", triangles.obj(|i| (i + 1).to_string())));
    }
}

#[test]
fn degenerate_triangles_are_left_out_and_reported() {
    let folder = folder();
    let with_slivers = Solid {
        vertices: TETRAHEDRON.vertices,
        // The same corner twice, and the same three times.
        faces: &[
            &[0, 1, 1],
            &[0, 1, 2],
            &[0, 2, 3],
            &[0, 3, 1],
            &[1, 3, 2],
            &[2, 2, 2],
        ],
    };
    let (expected, quiet) = picture(folder.path(), "a.ply", &TETRAHEDRON.ply(Ply::Ascii));
    assert!(!quiet.contains("without area"), "{quiet}");
    for (name, bytes) in [
        ("b.ply", with_slivers.ply(Ply::Little)),
        ("b.obj", with_slivers.obj(|i| (i + 1).to_string())),
    ] {
        let (same, said) = picture(folder.path(), name, &bytes);
        assert!(expected == same, "{name}");
        assert!(
            said.contains("2 triangles without area were left out"),
            "{said}"
        );
    }
}

#[test]
fn a_scene_of_ones_own_finds_its_mesh_from_anywhere() {
    let (here, there) = (folder(), folder());
    let own = there.path().join("my scenes");
    std::fs::create_dir(&own).unwrap();
    let (expected, _) = picture(&own, "solid.ply", &TETRAHEDRON.ply(Ply::Big));
    let path = own.join("scene.toml");
    let path = path.to_str().unwrap();
    let output = halfdisk(here.path(), &["render", path, "--spp", "2"]);
    assert!(output.status.success(), "{}", complaint(&output));
    let written = shades(&here.path().join("out/scene.png"));
    assert!(written == expected);
}

#[test]
fn what_a_file_says_that_is_not_read_is_counted_in_a_note() {
    let folder = folder();
    let obj = TETRAHEDRON.obj(|i| (i + 1).to_string());
    let (_, said) = picture(folder.path(), "a.obj", &obj);
    let note = "note: a.obj: ignored: g (1), l (1), mtllib (1), o (1), p (1), s (1), usemtl (1), \
                vn (1)\n";
    assert!(said.contains(note), "{said}");
    let (_, said) = picture(folder.path(), "a.ply", &TETRAHEDRON.ply(Ply::Little));
    assert!(!said.contains("ignored"), "{said}");
}

/// An L of six corners, seen from its front, with a corner in the middle of an edge.
const LETTER: Solid = Solid {
    vertices: &[
        [-1.0, -1.0, 0.0],
        [1.0, -1.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0],
        [0.0, 0.5, 0.0],
        [0.0, 1.0, 0.0],
        [-1.0, 1.0, 0.0],
    ],
    faces: &[&[0, 1, 2, 3, 4, 5, 6]],
};

/// A lamp: bright where its front is seen, black where its back is.
fn shining(mesh: &str) -> String {
    scene(mesh).replace("material = \"dull\"\nmesh", "emits = 1\nmesh")
}

#[test]
fn concave_polygons_cover_themselves_and_face_where_they_are_wound() {
    let folder = folder();
    let squares = Solid {
        vertices: LETTER.vertices,
        faces: &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 4], &[0, 4, 6], &[4, 5, 6]],
    };
    let backwards = Solid {
        vertices: LETTER.vertices,
        faces: &[&[0, 6, 5, 4, 3, 2, 1]],
    };
    let picture = |solid: &Solid, name: &str| {
        let bytes = match name {
            "a.ply" => solid.ply(Ply::Big),
            _ => solid.obj(|i| (i + 1).to_string()),
        };
        std::fs::write(folder.path().join(name), bytes).unwrap();
        std::fs::write(folder.path().join("scene.toml"), shining(name)).unwrap();
        let arguments = ["render", "scene.toml", "--spp", "2", "--out", "p.png"];
        let output = halfdisk(folder.path(), &arguments);
        assert!(output.status.success(), "{}", complaint(&output));
        shades(&folder.path().join("p.png"))
    };
    let expected = picture(&squares, "a.ply");
    for name in ["a.ply", "a.obj"] {
        assert!(picture(&LETTER, name) == expected, "{name}");
        assert!(picture(&backwards, name) != expected, "{name}");
    }
}

#[test]
fn a_mesh_in_map_coordinates_looks_as_it_does_near_the_origin() {
    // Whole multiples of 1/4, so that `f64` adds them exactly; `f32` knows only halves there.
    const FAR: [f64; 3] = [4_485_513.75, 701_362.25, 37.25];
    let folder = folder();
    let (expected, _) = picture(folder.path(), "near.ply", &CUBE.ply(Ply::Little));
    let far = |v: &[f32; 3]| [0, 1, 2].map(|i| f64::from(v[i]) + FAR[i]);
    let places: Vec<[f64; 3]> = CUBE.vertices.iter().map(far).collect();
    let text = |begin: &str| {
        let row = |[x, y, z]: &[f64; 3]| format!("{begin}{x} {y} {z}\n");
        places.iter().map(row).collect::<String>()
    };
    let faces = |begin: &dyn Fn(usize) -> String, first: i32| {
        let face = |face: &&[i32]| {
            let corners: Vec<String> = face.iter().map(|i| (i + first).to_string()).collect();
            format!("{} {}\n", begin(face.len()), corners.join(" "))
        };
        CUBE.faces.iter().map(face).collect::<String>()
    };
    let header = |format: &str| {
        format!(
            "ply\nformat {format} 1.0\nelement vertex {}\nproperty double x\nproperty double y\n\
             property double z\nelement face {}\nproperty list uchar ushort vertex_indices\n\
             end_header\n",
            places.len(),
            CUBE.faces.len()
        )
    };
    let ascii = header("ascii") + &text("") + &faces(&|count| count.to_string(), 0);
    let mut binary = header("binary_big_endian").into_bytes();
    binary.extend(places.iter().flatten().flat_map(|x| x.to_be_bytes()));
    for face in CUBE.faces {
        binary.push(face.len() as u8);
        binary.extend(face.iter().flat_map(|i| (*i as u16).to_be_bytes()));
    }
    let obj = text("v ") + &faces(&|_| "f".to_owned(), 1);
    for (name, bytes) in [
        ("far.obj", obj.into_bytes()),
        ("far.ply", ascii.into_bytes()),
        ("far.ply", binary),
    ] {
        std::fs::write(folder.path().join(name), bytes).unwrap();
        let at = |x: [f64; 3]| {
            let [x, y, z] = [0, 1, 2].map(|i| x[i] + FAR[i]);
            format!("[{x}, {y}, {z}]")
        };
        let text = scene(name)
            .replace("[1, 2, 5]", &at([1.0, 2.0, 5.0]))
            .replace("[0, 0, 0]", &at([0.0; 3]))
            .replace("[2, 4, 4]", &at([2.0, 4.0, 4.0]));
        std::fs::write(folder.path().join("far.toml"), text).unwrap();
        let output = halfdisk(
            folder.path(),
            &["render", "far.toml", "--spp", "2", "--out", "f.png"],
        );
        assert!(output.status.success(), "{}", complaint(&output));
        assert!(shades(&folder.path().join("f.png")) == expected, "{name}");
    }
}
