//! OBJ files (Wavefront, *Object Files*, appendix B1 of the Advanced Visualizer's manual).

use super::{Said, start};
use crate::geometry::Polygons;
use glam::{DVec3, Vec2};

/// Reads the vertices, texture coordinates and faces of an OBJ file; other keywords are counted.
///
/// A line ends with its line break, or with the next one that no `\` stands before; `#` begins a
/// comment. Of a vertex only its place counts, not its weight or colour; of texture coordinates the
/// first two, and one alone has 0 for the second; of a face's corner not its normal. A face of one or two corners is a point or a line, and counted like one.
pub(super) fn read(bytes: &[u8]) -> Result<Said, String> {
    let text = String::from_utf8_lossy(bytes);
    let mut lines = (1..).zip(text.trim_start_matches('\u{feff}').lines());
    let mut said = Said::default();
    // The largest index of a vertex and that of texture coordinates, which may be still to come, each
    // with the line that names it.
    let (mut last_vertex, mut last_uv) = ((0, 0), (0, 0));
    while let Some((line, first)) = lines.next() {
        let mut words: Vec<&str> = Vec::new();
        let mut part = first;
        loop {
            let code = part.split('#').next().unwrap_or_default().trim_end();
            let Some(begun) = code.strip_suffix('\\') else {
                words.extend(code.split_whitespace());
                break;
            };
            words.extend(begun.split_whitespace());
            match lines.next() {
                Some((_, next)) => part = next,
                None => break,
            }
        }
        let complain = |what: String| format!("is not a proper OBJ file: line {line}: {what}");
        match words.as_slice() {
            [] => {}
            ["v", numbers @ ..] => {
                let place = vertex(numbers).map_err(complain)?;
                said.polygons.vertices.push(place);
            }
            ["vt", numbers @ ..] => {
                let uv = texture_coordinates(numbers).map_err(complain)?;
                said.polygons.uvs.push(uv);
            }
            // `fo` is what the first versions of the format called a face.
            [keyword @ ("f" | "fo"), corners @ ..] => {
                let face = face(corners, &said.polygons).map_err(complain)?;
                for (vertex, uv) in &face {
                    last_vertex = last_vertex.max((*vertex, line));
                    last_uv = last_uv.max(uv.map_or((0, 0), |uv| (uv, line)));
                }
                match face.len() {
                    1 | 2 => said.ignore(&format!("{keyword} of fewer than 3 corners")),
                    _ => said.polygons.push(face),
                }
            }
            [keyword, ..] if is_keyword(keyword) => said.ignore(keyword),
            [other, ..] => {
                return Err(complain(format!("{:?} is no keyword", start(other))));
            }
        }
    }
    let polygons = &said.polygons;
    for ((last, line), count, what) in [
        (last_vertex, polygons.vertices.len(), "vertex"),
        (last_uv, polygons.uvs.len(), "`vt`"),
    ] {
        if last as usize >= count && line > 0 {
            return Err(format!(
                "is not a proper OBJ file: line {line}: there is no {what} {}, only {count}",
                u64::from(last) + 1
            ));
        }
    }
    Ok(said)
}

fn is_keyword(word: &str) -> bool {
    let rest = |c: char| c.is_ascii_alphanumeric() || c == '_';
    word.starts_with(|c: char| c.is_ascii_alphabetic())
        && word.len() <= 20
        && word.chars().all(rest)
}

fn numbers(words: &[&str]) -> Result<Vec<f64>, String> {
    let number = |word: &&str| {
        let value = word.parse::<f64>().ok();
        value.ok_or_else(|| format!("{:?} is not a number", start(word)))
    };
    words.iter().map(number).collect()
}

fn texture_coordinates(words: &[&str]) -> Result<Vec2, String> {
    let numbers = numbers(words)?;
    let (&[u, ref rest @ ..], 1..=3) = (numbers.as_slice(), numbers.len()) else {
        return Err(format!(
            "texture coordinates are u, then v and w if there are any, not {} numbers",
            numbers.len()
        ));
    };
    if numbers.iter().all(|x| (*x as f32).is_finite()) {
        Ok(Vec2::new(u as f32, rest.first().map_or(0.0, |v| *v as f32)))
    } else {
        Err("the texture coordinates are not finite numbers of at most 3.4e38".to_owned())
    }
}

fn vertex(words: &[&str]) -> Result<DVec3, String> {
    let numbers = numbers(words)?;
    let (&[x, y, z, ..], 3 | 4 | 6 | 7) = (numbers.as_slice(), numbers.len()) else {
        return Err(format!(
            "a vertex is x, y, z, then its weight or its colour if it has one, not {} numbers",
            numbers.len()
        ));
    };
    let place = DVec3::new(x, y, z);
    if place.as_vec3().is_finite() {
        Ok(place)
    } else {
        Err("the vertex has coordinates that are not finite numbers of at most 3.4e38".to_owned())
    }
}

/// The vertex of each of a face's corners and its texture coordinates if it has any, both counted
/// from 0.
fn face(corners: &[&str], so_far: &Polygons) -> Result<Vec<(u32, Option<u32>)>, String> {
    if corners.is_empty() {
        return Err("the face has no corners".to_owned());
    }
    let (vertices, uvs) = (so_far.vertices.len(), so_far.uvs.len());
    let corner = |word: &&str| {
        let not_a_corner = || format!("{:?} is not a corner", start(word));
        let (vertex, uv) = indices(word).ok_or_else(not_a_corner)?;
        let uv = uv.map(|uv| from_zero(uv, uvs, "`vt`")).transpose()?;
        Ok((from_zero(vertex, vertices, "vertex")?, uv))
    };
    corners.iter().map(corner).collect()
}

/// A corner as it is written: a vertex, texture coordinates, and a normal that is not looked for.
fn indices(word: &str) -> Option<(i64, Option<i64>)> {
    let mut parts = word.split('/');
    let vertex = parts.next()?.parse().ok()?;
    let mut index = || match parts.next() {
        None | Some("") => Some(None),
        Some(part) => part.parse::<i64>().ok().map(Some),
    };
    let (uv, _normal) = (index()?, index()?);
    parts.next().is_none().then_some((vertex, uv))
}

/// An index counted from 1, or backwards from the last of those so far.
fn from_zero(index: i64, count: usize, what: &str) -> Result<u32, String> {
    let from_zero = match index {
        ..0 => index + count as i64,
        _ => index - 1,
    };
    let found = u32::try_from(from_zero).ok();
    found.ok_or_else(|| format!("there is no {what} {index}, only {count} so far"))
}
