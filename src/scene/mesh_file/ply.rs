//! PLY files (Turk, *The PLY Polygon File Format*, 1994), ascii and binary.

use super::{Said, start};
use crate::geometry::Polygons;
use glam::DVec3;
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType,
    ScalarType,
};
use std::io::BufRead;

const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// What PLY files call the list of a face's corners.
const CORNERS: [&str; 2] = ["vertex_indices", "vertex_index"];

/// Reads the vertices, faces and triangle strips of a PLY file; other elements are counted.
pub(super) fn read(bytes: &[u8]) -> Result<Said, String> {
    let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
    let mut reader = Reader::new(bytes);
    let header = Parser::<Row>::new().read_header(&mut reader);
    let header = header.map_err(|e| complain(&e))?;
    check(&header)?;
    let mut lines = Lines::after(&mut reader);
    let mut said = Said::default();
    for (name, element) in &header.elements {
        for at in 0..element.count {
            let row = match header.encoding {
                Encoding::Ascii => lines.row(element)?,
                encoding => binary(reader.get_mut(), encoding, element).map_err(|e| {
                    let (what, count) = (complain(&e), element.count);
                    format!("{what} in {name} {at} of {count}")
                })?,
            };
            match name.as_str() {
                "vertex" => said.polygons.vertices.push(row.place),
                "face" => said.polygons.push(face(at, &row.corners)?),
                "tristrips" => strips(at, &row.corners, &mut said.polygons)?,
                other => said.ignore(other),
            }
        }
    }
    let rest = match header.encoding {
        Encoding::Ascii => lines.rest,
        _ => reader.into_inner(),
    };
    // Some programs end a binary file with a line break.
    if rest.iter().all(u8::is_ascii_whitespace) {
        Ok(said)
    } else {
        Err(improper("it goes on after the last of its elements"))
    }
}

fn improper(what: &str) -> String {
    format!("is not a proper PLY file: {what}")
}

fn complain(error: &ParseError) -> String {
    // The first line says what is wrong and where; the others quote the file.
    let text = error.to_string();
    improper(text.lines().next().unwrap_or_default())
}

/// Checks that a PLY file holds a mesh: what the parser does not find it leaves out in silence.
fn check(header: &Header) -> Result<(), String> {
    for (name, element) in &header.elements {
        // Without properties an element takes no bytes, so that no end of the file would ever end
        // the reading of a huge number of them.
        if element.properties.is_empty() {
            return Err(improper(&format!("element `{name}` has no properties")));
        }
    }
    let element = |name: &str| header.elements.get(name);
    let lacks = |what: &str| format!("is not a mesh: its header has no element {what}");
    let vertex = element("vertex").ok_or_else(|| lacks("`vertex`"))?;
    for name in ["x", "y", "z"] {
        let property = vertex.properties.get(name).map(|p| &p.data_type);
        if !matches!(property, Some(PropertyType::Scalar(_))) {
            return Err(format!(
                "is not a mesh: its vertices have no property `{name}` that is one number"
            ));
        }
    }
    let faces: Vec<&ElementDef> = ["face", "tristrips"]
        .into_iter()
        .filter_map(element)
        .collect();
    if faces.is_empty() {
        return Err(lacks("`face` or `tristrips`"));
    }
    let is_list_of_indices = |element: &ElementDef| {
        CORNERS.into_iter().any(|name| {
            let property = element.properties.get(name).map(|p| &p.data_type);
            property.is_some_and(|p| match p {
                PropertyType::List(_, item) => {
                    !matches!(item, ScalarType::Float | ScalarType::Double)
                }
                PropertyType::Scalar(_) => false,
            })
        })
    };
    match faces.iter().find(|element| !is_list_of_indices(element)) {
        None => Ok(()),
        Some(element) => Err(format!(
            "is not a mesh: its element `{}` has no list `vertex_indices` of whole numbers",
            element.name
        )),
    }
}

/// A face's corners as indices.
fn face(at: usize, corners: &[i64]) -> Result<Vec<u32>, String> {
    if corners.len() < 3 {
        return Err(format!("has fewer than 3 corners in face {at}"));
    }
    corners.iter().map(|i| index(*i, "face", at)).collect()
}

fn index(i: i64, kind: &str, at: usize) -> Result<u32, String> {
    u32::try_from(i).map_err(|_| format!("has a vertex index of {i} in {kind} {at}"))
}

/// The triangles of strips, which -1 ends: each corner from the third on makes one with the two
/// before it, and every other triangle of a strip runs backwards.
fn strips(at: usize, corners: &[i64], polygons: &mut Polygons) -> Result<(), String> {
    for strip in corners.split(|i| *i == -1) {
        let strip = strip.iter().map(|i| index(*i, "tristrips", at));
        let strip = strip.collect::<Result<Vec<u32>, String>>()?;
        let corners = strip
            .windows(3)
            .filter_map(|w| <[u32; 3]>::try_from(w).ok());
        for (i, [a, b, c]) in corners.enumerate() {
            // A corner said twice turns a strip round; the triangle is not meant to be seen.
            if a != b && b != c && c != a {
                polygons.push(if i.is_multiple_of(2) {
                    [a, b, c]
                } else {
                    [b, a, c]
                });
            }
        }
    }
    Ok(())
}

/// What counts of a row of any element: a place, or corners.
struct Row {
    place: DVec3,
    corners: Vec<i64>,
}

impl PropertyAccess for Row {
    fn new() -> Self {
        Row {
            place: DVec3::NAN,
            corners: Vec::new(),
        }
    }

    fn set_property(&mut self, name: &str, value: Property) -> PropertyAccessResult {
        if CORNERS.contains(&name) {
            self.corners = match value {
                Property::ListChar(v) => v.into_iter().map(i64::from).collect(),
                Property::ListUChar(v) => v.into_iter().map(i64::from).collect(),
                Property::ListShort(v) => v.into_iter().map(i64::from).collect(),
                Property::ListUShort(v) => v.into_iter().map(i64::from).collect(),
                Property::ListInt(v) => v.into_iter().map(i64::from).collect(),
                Property::ListUInt(v) => v.into_iter().map(i64::from).collect(),
                _ => return PropertyAccessResult::Ignored,
            };
        } else if let Some(coordinate) = self.coordinate(name) {
            *coordinate = match value {
                Property::Char(x) => x.into(),
                Property::UChar(x) => x.into(),
                Property::Short(x) => x.into(),
                Property::UShort(x) => x.into(),
                Property::Int(x) => x.into(),
                Property::UInt(x) => x.into(),
                Property::Float(x) => x.into(),
                Property::Double(x) => x,
                _ => return PropertyAccessResult::Ignored,
            };
        } else {
            return PropertyAccessResult::Ignored;
        }
        PropertyAccessResult::Set
    }
}

impl Row {
    fn coordinate(&mut self, name: &str) -> Option<&mut f64> {
        match name {
            "x" => Some(&mut self.place.x),
            "y" => Some(&mut self.place.y),
            "z" => Some(&mut self.place.z),
            _ => None,
        }
    }
}

fn binary(bytes: &mut &[u8], encoding: Encoding, element: &ElementDef) -> Result<Row, ParseError> {
    let parser = Parser::<Row>::new();
    match encoding {
        Encoding::BinaryBigEndian => parser.read_big_endian_element(bytes, element),
        _ => parser.read_little_endian_element(bytes, element),
    }
}

/// The lines after the header of an ascii file, one for each row.
///
/// Not left to the parser: what is said in decimals is a number, whatever type the header calls it,
/// so that a coordinate keeps all its digits.
struct Lines<'a> {
    rest: &'a [u8],
    line: usize,
}

impl<'a> Lines<'a> {
    fn after(reader: &mut Reader<&'a [u8]>) -> Self {
        Lines {
            rest: reader.get_ref(),
            line: reader.line().saturating_sub(1),
        }
    }

    /// The next line that is not empty, as text.
    fn next(&mut self, element: &str) -> Result<String, String> {
        loop {
            let mut line = Vec::new();
            self.line += 1;
            match self.rest.read_until(b'\n', &mut line) {
                Ok(0) => {
                    let what = format!("end of file where a row of `{element}` should be");
                    return Err(improper(&what));
                }
                Ok(_) if line.iter().all(u8::is_ascii_whitespace) => {}
                Ok(_) => return Ok(String::from_utf8_lossy(&line).into_owned()),
                Err(e) => return Err(format!("cannot be read: {e}")),
            }
        }
    }

    fn row(&mut self, element: &ElementDef) -> Result<Row, String> {
        let text = self.next(&element.name)?;
        let line = self.line;
        let complain = |what: String| improper(&format!("Line {line}: {what}"));
        let mut words = text.split_whitespace();
        let mut next = |name: &str| {
            let lacks = || complain(format!("`{name}` of element `{}` is missing", element.name));
            words.next().ok_or_else(lacks)
        };
        let real = |word: &str| {
            let value = word.parse::<f64>().ok();
            value.ok_or_else(|| complain(format!("{:?} is not a number", start(word))))
        };
        let whole = |word: &str| {
            let value = word.parse::<i64>().ok();
            value.ok_or_else(|| complain(format!("{:?} is not a whole number", start(word))))
        };
        let mut row = Row::new();
        for (name, property) in &element.properties {
            match property.data_type {
                PropertyType::Scalar(_) => {
                    let value = real(next(name)?)?;
                    if let Some(coordinate) = row.coordinate(name) {
                        *coordinate = value;
                    }
                }
                PropertyType::List(..) => {
                    let count = whole(next(name)?)?;
                    let is_corners = CORNERS.contains(&name.as_str());
                    for _ in 0..count {
                        let word = next(name)?;
                        if is_corners {
                            row.corners.push(whole(word)?);
                        } else {
                            real(word)?;
                        }
                    }
                    if count < 0 {
                        return Err(complain(format!("a list of {count} numbers")));
                    }
                }
            }
        }
        match words.next() {
            None => Ok(row),
            Some(_) => Err(complain(format!(
                "a row of `{}` has more numbers than the header says",
                element.name
            ))),
        }
    }
}
