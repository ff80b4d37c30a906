//! Scenes that can be rendered, but probably are not meant; and scene files of other encodings.

use super::meshes::{Ply, Solid, TETRAHEDRON};
use super::{complaint, folder, halfdisk, refused};
use halfdisk::scene::gallery;
use halfdisk::scene::read::Source;
use std::path::Path;

/// What is noted of a scene with these objects.
fn notes(folder: &Path, objects: &str) -> Vec<String> {
    let text = format!(
        "name = 'odd'\nbackground = 1\ncamera = {{ from = [0.3, 0.2, 5.1], to = [0, 0, 0], fov = 40 }}\n\
         materials.clear.glass.ior = 1.5\nmaterials.water.glass.ior = 1.33\n\
         materials.frosted.rough_glass = {{ ior = 1.5, roughness = 0.3 }}\n\
         materials.thin.mixture = {{ kd = 0.1, ks = 0.1, kt = 0.7 }}\n\
         materials.paint.mixture = {{ kd = 0.5, ks = 0.1, kt = 0 }}\n\
         materials.dull.lambert.albedo = 0.5\n{objects}"
    );
    let source = Source {
        file: "odd.toml",
        text: &text,
    };
    let scene = gallery::from_text(source, Some(folder), |_| {});
    scene.unwrap_or_else(|e| panic!("{e}")).report.notes
}

fn object(material: &str, shape: &str) -> String {
    let what = match material {
        "lamp" => "emits = 1".to_owned(),
        _ => format!("material = '{material}'"),
    };
    format!("[[objects]]\n{what}\n{shape}\n")
}

/// A solid with each face wound the other way.
fn turned(solid: &Solid) -> Solid {
    let faces = solid.faces.iter().map(|f| {
        let face: Vec<i32> = f.iter().rev().copied().collect();
        &*face.leak()
    });
    Solid {
        vertices: solid.vertices,
        faces: faces.collect::<Vec<_>>().leak(),
    }
}

/// Two solids in one, the second smaller by `scale` and moved.
fn both(a: &Solid, b: &Solid, scale: f32, by: [f32; 3]) -> Solid {
    let count = a.vertices.len() as i32;
    let moved = |v: &[f32; 3]| [0, 1, 2].map(|i| v[i] * scale + by[i]);
    let vertices: Vec<_> = a
        .vertices
        .iter()
        .copied()
        .chain(b.vertices.iter().map(moved))
        .collect();
    let faces = b.faces.iter().map(|f| {
        let face: Vec<i32> = f.iter().map(|i| i + count).collect();
        &*face.leak()
    });
    let faces: Vec<&[i32]> = a.faces.iter().copied().chain(faces).collect();
    Solid {
        vertices: vertices.leak(),
        faces: faces.leak(),
    }
}

#[test]
fn closed_meshes_that_face_inwards_are_told_where_it_matters() {
    let folder = folder();
    let inverted = turned(&TETRAHEDRON);
    let open = Solid {
        vertices: inverted.vertices,
        faces: &inverted.faces[1..],
    };
    let bubble = both(&TETRAHEDRON, &inverted, 0.1, [0.0; 3]);
    let beside = both(&TETRAHEDRON, &inverted, 0.1, [3.0, 0.0, 0.0]);
    for (name, solid) in [
        ("right", &TETRAHEDRON),
        ("inverted", &inverted),
        ("open", &open),
        ("bubble", &bubble),
        ("beside", &beside),
    ] {
        let write = |ending: &str, bytes: Vec<u8>| {
            std::fs::write(folder.path().join(format!("{name}.{ending}")), bytes).unwrap();
        };
        write("ply", solid.ply(Ply::Little));
        write("obj", solid.obj(|i| (i + 1).to_string()));
    }
    let told = |material: &str, file: &str, more: &str| {
        let shape = format!("mesh.file = '{file}'\n{more}");
        let notes = notes(folder.path(), &object(material, &shape));
        notes
            .iter()
            .any(|note| note.starts_with("objects[0] is closed and its front faces inwards"))
    };
    for ending in ["ply", "obj"] {
        for material in ["clear", "frosted", "thin", "lamp"] {
            let told = |name: &str, more: &str| told(material, &format!("{name}.{ending}"), more);
            assert!(told("inverted", ""), "{material}");
            assert!(told("beside", ""), "{material}");
            assert!(told(
                "inverted",
                "transform = { translate = [1e3, 0, 0], scale = 7 }"
            ));
            // A transform that mirrors keeps the front where it is.
            assert!(
                told("inverted", "transform.scale = [-1, 1, 1]"),
                "{material}"
            );
            assert!(!told("right", "transform.scale = [-1, 1, 1]"), "{material}");
            for name in ["right", "open", "bubble"] {
                assert!(!told(name, ""), "{material} {name}");
            }
        }
        for material in ["dull", "paint"] {
            assert!(
                !told(material, &format!("inverted.{ending}"), ""),
                "{material}"
            );
        }
    }
}

#[test]
fn solids_that_refract_and_share_a_face_are_told() {
    let folder = folder();
    let share = |objects: &[(&str, &str)]| {
        let all: String = objects.iter().map(|(m, s)| object(m, s)).collect();
        let notes = notes(folder.path(), &all);
        let found = notes
            .iter()
            .find(|note| note.contains("in one place, and refract"));
        found.map(|note| {
            note.split(" in one place")
                .next()
                .unwrap_or_default()
                .to_owned()
        })
    };
    let left = "box = { min = [-1, -1, -1], max = [0, 1, 1] }";
    let pair = Some("objects[0] and objects[1] have faces".to_owned());
    for material in ["clear", "water", "frosted", "thin"] {
        for right in [
            // The same face, a part of it, a larger one, and one that overlaps it.
            "box = { min = [0, -1, -1], max = [1, 1, 1] }",
            "box = { min = [0, -0.5, -0.5], max = [1, 0.5, 0.7] }",
            "box = { min = [0, -5, -5], max = [1, 5, 5] }",
            "box = { min = [0, 0.5, 0], max = [1, 5, 3] }",
            // Another face of a box that lies in the first.
            "box = { min = [-0.5, -0.5, -0.5], max = [0.5, 1, 0.5] }",
            "triangle = { a = [0, 0, 0], b = [0, 0.5, 0], c = [0, 0, 0.5] }",
            // Rounded elsewhere.
            "box = { min = [-0.3, -1, -1], max = [0.7, 1, 1] }\ntransform.translate = [0.3, 0, 0]",
        ] {
            assert_eq!(
                share(&[("clear", left), (material, right)]),
                pair,
                "{material} {right}"
            );
        }
    }
    for right in [
        "box = { min = [0.001, -1, -1], max = [1, 1, 1] }",
        "box = { min = [0, 1, -1], max = [1, 2, 1] }",
        "box = { min = [-0.5, -0.5, -0.5], max = [0.5, 0.5, 0.5] }",
        "sphere = { center = [1, 0, 0], radius = 1 }",
    ] {
        assert_eq!(share(&[("clear", left), ("water", right)]), None, "{right}");
    }
    let right = "box = { min = [0, -1, -1], max = [1, 1, 1] }";
    assert_eq!(share(&[("clear", left), ("dull", right)]), None);
    let ball = "sphere = { center = [0, 0, 0], radius = 1 }";
    let room = "sphere = { center = [0, 0, 0], radius = 1, inward = true }";
    assert_eq!(share(&[("clear", room), ("water", ball)]), pair);
    assert_eq!(
        share(&[
            ("dull", ball),
            ("clear", left),
            ("lamp", right),
            ("water", right)
        ]),
        Some("objects[1] and objects[3] have faces".to_owned())
    );
    // Two in one mesh.
    let twice = both(&TETRAHEDRON, &turned(&TETRAHEDRON), 1.0, [0.0; 3]);
    std::fs::write(folder.path().join("twice.ply"), twice.ply(Ply::Ascii)).unwrap();
    let alone = Some("objects[0] has two faces".to_owned());
    assert_eq!(share(&[("clear", "mesh.file = 'twice.ply'")]), alone);
}

#[test]
fn what_is_huge_beside_its_distance_is_told_when_rounding_moves_it() {
    let folder = folder();
    let moved = |shape: &str| {
        let notes = notes(folder.path(), &object("dull", shape));
        let note = notes
            .iter()
            .find(|note| note.contains("so large for their distance"))?;
        note.rsplit(' ').next()?.parse::<f64>().ok()
    };
    // A wall behind: its centre is 100 005.35 away, where numbers are 1/128 apart.
    let by = moved("sphere = { center = [0, 0, -100000.25], radius = 100000 }").unwrap();
    assert!(by > 5e-4 && by < 4e-3, "{by}");
    // A floor, and one that is tilted.
    assert!(moved("sphere = { center = [0, -1e6, 0], radius = 999999 }").is_some());
    let tilted = "quad = { corner = [-1e5, -40001.3, 1e5], u = [2e5, 3e4, 0], v = [0, 5e4, -2e5] }";
    assert!(moved(tilted).is_some());
    let triangle =
        "triangle = { a = [-1e5, -4e4, 1e5], b = [1e5, -3e4, 1.1e5], c = [0.4, 69998.3, -2.1e5] }";
    assert!(moved(triangle).is_some());
    for shape in [
        // Rounding takes nothing from these.
        "quad = { corner = [-1e5, -1, 1e5], u = [2e5, 0, 0], v = [0, 0, -2e5] }",
        "sphere = { center = [0.3, 0.2, -99994.9], radius = 99990 }",
        "sphere = { center = [0, 0, -100000.25], radius = 1 }",
        "sphere = { center = [0, -100, 0], radius = 99 }",
        "quad = { corner = [-7, -1, 8], u = [15, 0.3, 0], v = [0, 1, -16] }",
    ] {
        assert_eq!(moved(shape), None, "{shape}");
    }
    for (name, _) in gallery::GALLERY {
        let scene = gallery::load(name).unwrap();
        assert_eq!(scene.report.notes, [""; 0], "{name}");
    }
}

#[test]
fn scene_files_in_utf_16_are_read_as_what_they_say() {
    let folder = folder();
    let text = gallery::text("cornell").unwrap().replace('\n', "\r\n");
    let text = text.replace("name = \"cornell\"", "name = \"Kö𝛑\"");
    let render = |bytes: Vec<u8>| {
        std::fs::write(folder.path().join("u.toml"), bytes).unwrap();
        let arguments = [
            "render", "u.toml", "--spp", "1", "--size", "8x8", "--out", "u.png",
        ];
        let output = halfdisk(folder.path(), &arguments);
        assert!(output.status.success(), "{}", complaint(&output));
        assert!(
            complaint(&output).contains("Kö𝛑: 8 x 8"),
            "{}",
            complaint(&output)
        );
        std::fs::read(folder.path().join("u.png")).unwrap()
    };
    let units = |to: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(to).collect::<Vec<u8>>();
    let plain = render(text.clone().into_bytes());
    let little = units(u16::to_le_bytes);
    assert!(render([b"\xff\xfe".to_vec(), little.clone()].concat()) == plain);
    let big = units(u16::to_be_bytes);
    assert!(render([b"\xfe\xff".to_vec(), big.clone()].concat()) == plain);
    assert!(render([b"\xef\xbb\xbf", text.as_bytes()].concat()) == plain);

    let ascii: Vec<u8> = "name = 'a'\n"
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    for (bytes, words) in [
        (ascii, "bad.toml:1: is not text: it looks like UTF-16"),
        (
            b"\xff\xfea\0b".to_vec(),
            "bad.toml:1: is not text: it begins like UTF-16",
        ),
        (
            b"\xff\xfe\0\xd8a\0".to_vec(),
            "bad.toml:1: is not text: it begins like UTF-16",
        ),
        (
            b"a = 1\n\xff".to_vec(),
            "bad.toml:2: is not text: a scene file must be UTF-8",
        ),
    ] {
        std::fs::write(folder.path().join("bad.toml"), bytes).unwrap();
        let sentence = refused(folder.path(), &["render", "bad.toml"], 2);
        assert!(sentence.starts_with(words), "{sentence}");
    }
}

#[test]
fn a_scene_is_written_into_a_new_file() {
    let folder = folder();
    let show = ["scenes", "--show", "lens", "--out", "mine.toml"];
    let output = halfdisk(folder.path(), &show);
    assert!(output.status.success() && output.stdout.is_empty());
    let written = std::fs::read_to_string(folder.path().join("mine.toml")).unwrap();
    assert_eq!(written, gallery::text("lens").unwrap());
    let other = ["scenes", "--show", "six", "--out", "mine.toml"];
    let sentence = refused(folder.path(), &other, 1);
    assert!(sentence.starts_with("mine.toml: "), "{sentence}");
    let kept = std::fs::read_to_string(folder.path().join("mine.toml")).unwrap();
    assert_eq!(kept, written, "what is there stays");
    for bad in [
        &["--show", "none", "--out", "b.toml"][..],
        &["--out", "b.toml"],
    ] {
        let output = halfdisk(folder.path(), &[&["scenes"], bad].concat());
        assert_eq!(output.status.code(), Some(2));
        assert!(!folder.path().join("b.toml").exists());
    }
}
