//! PLY files (Turk, *The PLY Polygon File Format*, 1994), ascii and binary.

mod ascii;

use super::Said;
use crate::geometry::Polygons;
use ascii::Lines;
use glam::{DVec2, DVec3, Vec2};
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType,
    ScalarType,
};

const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// What PLY files call the list of a face's corners.
const CORNERS: [&str; 2] = ["vertex_indices", "vertex_index"];

/// What they call the texture coordinates of a vertex.
pub(super) const UVS: [[&str; 2]; 5] = [
    ["u", "v"],
    ["s", "t"],
    ["texture_u", "texture_v"],
    ["texture_s", "texture_t"],
    ["u0", "v0"],
];

/// What they call the list of the texture coordinates of a face's corners, two numbers a corner.
const CORNER_UVS: &str = "texcoord";

/// Where a file says texture coordinates.
enum Uvs {
    Nowhere,
    /// Under these names of [`UVS`].
    OfVertices(usize),
    OfCorners,
}

/// Reads the vertices, faces and triangle strips of a PLY file; other elements are counted.
pub(super) fn read(bytes: &[u8]) -> Result<Said, String> {
    let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
    let mut reader = Reader::new(bytes);
    let header = Parser::<Row>::new().read_header(&mut reader);
    let header = header.map_err(|e| complain(&e))?;
    check(&header)?;
    let uvs = Uvs::of(&header);
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
                "vertex" => {
                    said.polygons.vertices.push(row.place);
                    if let Uvs::OfVertices(names) = uvs {
                        said.polygons.uvs.push(finite(row.uvs[names], name, at)?);
                    }
                }
                "face" => face(at, &row, &uvs, &mut said.polygons)?,
                "tristrips" => strips(at, &row.corners, &uvs, &mut said.polygons)?,
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

/// The type of an element's property.
fn kind<'a>(element: &'a ElementDef, property: &str) -> Option<&'a PropertyType> {
    element.properties.get(property).map(|p| &p.data_type)
}

fn is_real(item: &ScalarType) -> bool {
    matches!(item, ScalarType::Float | ScalarType::Double)
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
        if !matches!(kind(vertex, name), Some(PropertyType::Scalar(_))) {
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
        let mut kinds = CORNERS.into_iter().filter_map(|name| kind(element, name));
        kinds.any(|kind| match kind {
            PropertyType::List(_, item) => !is_real(item),
            PropertyType::Scalar(_) => false,
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

impl Uvs {
    /// Where a file has both, lists of faces' corners count, for vertices know no seams.
    fn of(header: &Header) -> Uvs {
        let kind = |element: &str, name: &str| kind(header.elements.get(element)?, name);
        let is_scalar = |name| matches!(kind("vertex", name), Some(PropertyType::Scalar(_)));
        match kind("face", CORNER_UVS) {
            Some(PropertyType::List(_, item)) if is_real(item) => Uvs::OfCorners,
            _ => UVS
                .iter()
                .position(|names| names.iter().all(|name| is_scalar(name)))
                .map_or(Uvs::Nowhere, Uvs::OfVertices),
        }
    }

    /// A corner whose texture coordinates, if there are any, are its vertex's.
    fn corner(&self, vertex: u32) -> (u32, Option<u32>) {
        (vertex, matches!(self, Uvs::OfVertices(_)).then_some(vertex))
    }
}

fn finite(uv: [f64; 2], kind: &str, at: usize) -> Result<Vec2, String> {
    let uv = DVec2::from(uv).as_vec2();
    let what = || format!("has texture coordinates that are not finite numbers in {kind} {at}");
    uv.is_finite().then_some(uv).ok_or_else(what)
}

/// Adds a face; the texture coordinates of its corners are in its own list, or those of its vertices.
fn face(at: usize, row: &Row, uvs: &Uvs, polygons: &mut Polygons) -> Result<(), String> {
    let count = row.corners.len();
    if count < 3 {
        return Err(format!("has fewer than 3 corners in face {at}"));
    }
    let corners = row.corners.iter().map(|i| index(*i, "face", at));
    let corners = corners.collect::<Result<Vec<u32>, String>>()?;
    // An empty list is that of a face without texture coordinates.
    if !matches!(uvs, Uvs::OfCorners) || row.corner_uvs.is_empty() {
        polygons.push(corners.into_iter().map(|i| uvs.corner(i)));
        return Ok(());
    }
    let numbers = row.corner_uvs.len();
    if numbers != 2 * count {
        return Err(format!(
            "has {numbers} numbers in `{CORNER_UVS}` of face {at}, not two for each of its {count} corners"
        ));
    }
    let too_many = |_| "has more texture coordinates than can be counted".to_owned();
    let first = u32::try_from(polygons.uvs.len()).map_err(too_many)?;
    for uv in row.corner_uvs.as_chunks::<2>().0 {
        polygons.uvs.push(finite(*uv, "face", at)?);
    }
    polygons.push(corners.into_iter().zip((first..).map(Some)));
    Ok(())
}

fn index(i: i64, kind: &str, at: usize) -> Result<u32, String> {
    u32::try_from(i).map_err(|_| format!("has a vertex index of {i} in {kind} {at}"))
}

/// The triangles of strips, which -1 ends: each corner from the third on makes one with the two
/// before it, and every other triangle of a strip runs backwards.
fn strips(at: usize, corners: &[i64], uvs: &Uvs, polygons: &mut Polygons) -> Result<(), String> {
    for strip in corners.split(|i| *i == -1) {
        let strip = strip.iter().map(|i| index(*i, "tristrips", at));
        let strip = strip.collect::<Result<Vec<u32>, String>>()?;
        let corners = strip
            .windows(3)
            .filter_map(|w| <[u32; 3]>::try_from(w).ok());
        for (i, [a, b, c]) in corners.enumerate() {
            // A corner said twice turns a strip round; the triangle is not meant to be seen.
            if a != b && b != c && c != a {
                let corners = if i.is_multiple_of(2) {
                    [a, b, c]
                } else {
                    [b, a, c]
                };
                polygons.push(corners.map(|i| uvs.corner(i)));
            }
        }
    }
    Ok(())
}

/// What counts of a row of any element: a place and texture coordinates, or corners and theirs.
struct Row {
    place: DVec3,
    uvs: [[f64; 2]; UVS.len()],
    corners: Vec<i64>,
    corner_uvs: Vec<f64>,
}

impl PropertyAccess for Row {
    fn new() -> Self {
        Row {
            place: DVec3::NAN,
            uvs: [[f64::NAN; 2]; UVS.len()],
            corners: Vec::new(),
            corner_uvs: Vec::new(),
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
        } else if name == CORNER_UVS {
            self.corner_uvs = match value {
                Property::ListFloat(v) => v.into_iter().map(f64::from).collect(),
                Property::ListDouble(v) => v,
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
            _ => {
                let at = UVS.as_flattened().iter().position(|uv| *uv == name)?;
                self.uvs.as_flattened_mut().get_mut(at)
            }
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
