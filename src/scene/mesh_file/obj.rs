//! OBJ files (Wavefront, *Object Files*, appendix B1 of the Advanced Visualizer's manual).

use super::{Said, start};
use crate::geometry::Polygons;
use glam::DVec3;

/// Reads the vertices and faces of an OBJ file; other keywords are counted.
///
/// A line ends with its line break, or with the next one that no `\` stands before; `#` begins a
/// comment. Of a vertex only its place counts, not its weight or colour; of a face's corner only its
/// vertex. A face of one or two corners is a point or a line, and counted like one.
pub(super) fn read(bytes: &[u8]) -> Result<Said, String> {
    let text = String::from_utf8_lossy(bytes);
    let mut lines = (1..).zip(text.trim_start_matches('\u{feff}').lines());
    let mut said = Said::default();
    // The largest index of a vertex that was still to come, and the line that names it.
    let mut ahead = (0, 0);
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
            // `fo` is what the first versions of the format called a face.
            [keyword @ ("f" | "fo"), corners @ ..] => {
                let face = face(corners, &said.polygons).map_err(complain)?;
                ahead = face.iter().map(|i| (*i, line)).fold(ahead, Ord::max);
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
    let count = said.polygons.vertices.len();
    let (last, line) = ahead;
    if last as usize >= count && line > 0 {
        return Err(format!(
            "is not a proper OBJ file: line {line}: there is no vertex {}, only {count}",
            u64::from(last) + 1
        ));
    }
    Ok(said)
}

fn is_keyword(word: &str) -> bool {
    let rest = |c: char| c.is_ascii_alphanumeric() || c == '_';
    word.starts_with(|c: char| c.is_ascii_alphabetic())
        && word.len() <= 20
        && word.chars().all(rest)
}

fn vertex(words: &[&str]) -> Result<DVec3, String> {
    let number = |word: &&str| {
        let value = word.parse::<f64>().ok();
        value.ok_or_else(|| format!("{:?} is not a number", start(word)))
    };
    let numbers = words.iter().map(number).collect::<Result<Vec<f64>, _>>()?;
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

/// The vertices of a face's corners, counted from 0.
fn face(corners: &[&str], so_far: &Polygons) -> Result<Vec<u32>, String> {
    if corners.is_empty() {
        return Err("the face has no corners".to_owned());
    }
    let count = so_far.vertices.len() as i64;
    let corner = |word: &&str| {
        let mut parts = word.split('/');
        let index = |part: &str| part.parse::<i64>().ok();
        let vertex = parts.next().and_then(index);
        // Texture coordinates and normals have to be indices, but are not looked for.
        let others = parts.clone().count();
        let proper = others <= 2 && parts.all(|part| part.is_empty() || index(part).is_some());
        let (Some(vertex), true) = (vertex, proper) else {
            return Err(format!("{:?} is not a corner", start(word)));
        };
        let from_zero = if vertex < 0 {
            count + vertex
        } else {
            vertex - 1
        };
        let found = u32::try_from(from_zero).ok().filter(|_| vertex != 0);
        found.ok_or_else(|| format!("there is no vertex {vertex}, only {count} so far"))
    };
    corners.iter().map(corner).collect()
}
