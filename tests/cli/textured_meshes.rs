//! Texture coordinates of mesh files: what is noted, and what is refused.

use super::bad_meshes::check;
use super::folder;
use super::meshes::{Ply, TETRAHEDRON, picture};

/// A PLY file of a square whose vertices have texture coordinates, and the corners of its one face too.
pub fn textured(kind: Ply) -> Vec<u8> {
    let (format, end) = match kind {
        Ply::Ascii => ("ascii", "\n"),
        Ply::Little => ("binary_little_endian", ""),
        Ply::Big => ("binary_big_endian", ""),
    };
    let number = |x: &f32| match kind {
        Ply::Ascii => format!("{x} ").into_bytes(),
        Ply::Little => x.to_le_bytes().to_vec(),
        Ply::Big => x.to_be_bytes().to_vec(),
    };
    let count = |n: u8| match kind {
        Ply::Ascii => format!("{n} ").into_bytes(),
        _ => vec![n],
    };
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let mut file = format!(
        "ply\nformat {format} 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
         property float z\nproperty float s\nproperty float t\nelement face 1\n\
         property list uchar uchar vertex_indices\nproperty list uchar float texcoord\nend_header\n"
    )
    .into_bytes();
    for [x, y] in corners {
        file.extend([x, y, 0.0, x, y].iter().flat_map(number));
        file.extend(end.bytes());
    }
    file.extend([4, 0, 1, 2, 3, 8].into_iter().flat_map(count));
    file.extend(corners.as_flattened().iter().flat_map(number));
    file.extend(end.bytes());
    file
}

#[test]
fn texture_coordinates_move_nothing() {
    let folder = folder();
    let see = |name: &str, bytes: &[u8]| {
        let (bytes, said) = picture(folder.path(), name, bytes);
        assert!(!said.contains("note"), "{said}");
        bytes
    };
    let obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    let expected = see("plain.obj", obj.as_bytes());
    for kind in [Ply::Ascii, Ply::Little, Ply::Big] {
        assert!(expected == see("a.ply", &textured(kind)));
    }
    for corners in [
        "1/1 2/2 3/1 4/2",
        "1/1/7 2/2/7 3/1/7 4/2/7",
        "1// 2/ 3//7 4",
    ] {
        let obj = obj.replace("1 2 3 4", corners) + "vt 0.5 0.5\nvt 1 0.25 0\n";
        assert!(expected == see("textured.obj", obj.as_bytes()));
    }
}

#[test]
fn faces_without_texture_coordinates_beside_others_are_noted() {
    let folder = folder();
    let corner = |i: i32| match i {
        0 => "1/1".to_owned(),
        _ => format!("{}", i + 1),
    };
    let some = [TETRAHEDRON.obj(corner), b"f 1/1 2/1 3/1\n".to_vec()].concat();
    let (_, said) = picture(folder.path(), "some.obj", &some);
    let note = "note: some.obj: 4 faces lack texture coordinates at some corner; their triangles get \
                (0, 0), (1, 0) and (1, 1)\n";
    assert!(said.contains(note), "{said}");
}

#[test]
fn broken_texture_coordinates_of_obj_files() {
    let right = String::from_utf8(TETRAHEDRON.obj(|i| (i + 1).to_string())).unwrap();
    let bad = |from: &str, to: &str, line: usize, words: &str| {
        assert!(right.contains(from), "{from}");
        let words = format!("is not a proper OBJ file: line {line}: {words}");
        check("a.obj", right.replacen(from, to, 1).as_bytes(), &words);
    };
    let wrong = "texture coordinates are u, then v and w if there are any, not ";
    let not_finite = "the texture coordinates are not finite numbers of at most 3.4e38";
    for (line, words) in [
        ("vt", &*format!("{wrong}0 numbers")),
        ("vt 0 0 0 1", &format!("{wrong}4 numbers")),
        ("vt 0 zero", "\"zero\" is not a number"),
        ("vt 0 0/1", "\"0/1\" is not a number"),
        ("vt nan", not_finite),
        ("vt 0 inf", not_finite),
        ("vt 0 -1e39", not_finite),
        ("vt 0 0 nan", not_finite),
    ] {
        bad("vt 0 0", line, 4, words);
    }
    for (corner, words) in [
        ("3/2", "there is no `vt` 2, only 1"),
        ("3/2/1", "there is no `vt` 2, only 1"),
        ("3/4294967296", "there is no `vt` 4294967296, only 1"),
        ("3/4294967297", "there is no `vt` 4294967297, only 1 so far"),
        ("3/-2", "there is no `vt` -2, only 1 so far"),
        (
            "3/-9223372036854775808",
            "there is no `vt` -9223372036854775808",
        ),
        ("3/0", "there is no `vt` 0, only 1 so far"),
        ("3/0/1", "there is no `vt` 0, only 1 so far"),
        ("5/2", "there is no vertex 5, only 4"),
        ("3/1.5", "\"3/1.5\" is not a corner"),
        (
            "3/99999999999999999999",
            "\"3/999999999999999999\" is not a corner",
        ),
        ("3/1/x", "\"3/1/x\" is not a corner"),
        ("/1", "\"/1\" is not a corner"),
    ] {
        bad("f 1 2 3", &format!("f 1 2 {corner}"), 14, words);
    }
    // Of several, the line of the largest; lines and points name what exists too.
    bad(
        "f 1 2 3",
        "f 1/3 2/1\nf 1/2 2/2 3/2",
        14,
        "there is no `vt` 3, only 1",
    );
    check(
        "a.obj",
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/1\n",
        "line 4: there is no `vt` 1, only 0",
    );
}

#[test]
fn broken_texture_coordinates_of_ply_files() {
    let right = String::from_utf8(textured(Ply::Ascii)).unwrap();
    let of_vertices = right.replace("list uchar float texcoord", "list uchar float other");
    let vertex = "has texture coordinates that are not finite numbers in vertex 1";
    let missing = "Line 14: `s` of element `vertex` is missing";
    for (row, words) in [
        ("1 0 0 nan 0", vertex),
        ("1 0 0 1 1e39", vertex),
        ("1 0 0 1 u", "Line 14: \"u\" is not a number"),
        ("1 0 0", missing),
    ] {
        let file = of_vertices.replacen("1 0 0 1 0 ", row, 1);
        check("a.ply", file.as_bytes(), words);
    }
    let face = "has texture coordinates that are not finite numbers in face 0";
    let counts = |count: usize| {
        format!("has {count} numbers in `texcoord` of face 0, not two for each of its 4 corners")
    };
    for (list, words) in [
        ("8 0 0 1 0 1 1 0 -inf", face),
        ("8 0 0 1 0 1e39 1 0 0", face),
        ("9 0 0 1 0 1 1 0 1 0", &counts(9)),
        ("7 0 0 1 0 1 1 0", &counts(7)),
        ("6 0 0 1 0 1 1", &counts(6)),
        ("4 0 1 0 1", &counts(4)),
        ("1 0", &counts(1)),
        ("-8 0 0 1 0 1 1 0 1", "Line 17: a list of -8 numbers"),
        (
            "8 0 0 1 0 1 1 0",
            "Line 17: `texcoord` of element `face` is missing",
        ),
    ] {
        let file = right.replacen("8 0 0 1 0 1 1 0 1 ", list, 1);
        check("a.ply", file.as_bytes(), words);
    }
    for file in [&right, &of_vertices] {
        let words = "no vertex 4, which face 0 uses: there are 4";
        check(
            "a.ply",
            file.replace("4 0 1 2 3", "4 0 1 2 4").as_bytes(),
            words,
        );
    }
    for kind in [Ply::Little, Ply::Big] {
        let whole = textured(kind);
        let last = whole.len() - 4;
        let nan = [&whole[..last], &[0xff; 4]].concat();
        check("a.ply", &nan, face);
        let mut fewer = whole[..last].to_vec();
        let count = fewer.len() - 4 * 7 - 1;
        assert_eq!(std::mem::replace(&mut fewer[count], 7), 8);
        check("a.ply", &fewer, &counts(7));
        for length in count - 5..whole.len() {
            check("a.ply", &whole[..length], "is not a proper PLY file: ");
        }
    }
}
