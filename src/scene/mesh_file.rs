//! Meshes from PLY and OBJ files.

use crate::geometry::Mesh;
use glam::DVec3;
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{
    Header, Property, PropertyAccess, PropertyAccessResult, PropertyType, ScalarType,
};
use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

/// Reads a mesh, polygons split into fans; the error is a sentence that begins with what is wrong.
pub fn read(path: &Path) -> Result<Mesh, String> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("");
    let read_kind = match extension.to_ascii_lowercase().as_str() {
        "ply" => read_ply,
        "obj" => read_obj,
        _ => return Err("is not a mesh this program reads; allowed are .ply and .obj".to_owned()),
    };
    let file = File::open(path).map_err(|e| format!("cannot be opened: {e}"))?;
    let mesh = read_kind(BufReader::new(file))?;
    if let Some((triangle, index)) = mesh.bad_index() {
        return Err(format!(
            "has no vertex {index}, which triangle {triangle} uses: there are {} vertices",
            mesh.vertices.len()
        ));
    }
    if let Some(at) = mesh.vertices.iter().position(|v| !v.as_vec3().is_finite()) {
        return Err(format!(
            "has a vertex (number {at}) whose coordinates are not finite numbers"
        ));
    }
    Ok(mesh)
}

fn read_obj(mut reader: BufReader<File>) -> Result<Mesh, String> {
    let mut bytes = Vec::new();
    reader
        .read_to_end(&mut bytes)
        .map_err(|e| format!("cannot be read: {e}"))?;
    // Vertices and faces are all that counts here. Lines, which the parser takes for faces,
    // textures, materials and groups are not shown to it.
    let text = String::from_utf8_lossy(&bytes);
    let counts = |line: &&str| matches!(line.split_whitespace().next(), Some("v" | "f"));
    let text: Vec<&str> = text.lines().filter(counts).collect();
    if text.is_empty() {
        return Err("is not a proper OBJ file: it has no vertices".to_owned());
    }
    let mut text = text.join("\n");
    text.push('\n');
    let no_materials = |_: &Path| Ok((Vec::new(), Default::default()));
    let options = tobj::LoadOptions::default();
    let (mut models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, no_materials)
        .map_err(|e| format!("is not a proper OBJ file: {e}"))?;

    // Without groups there is one model.
    let said = models.pop().map(|m| m.mesh).unwrap_or_default();
    let positions = said.positions.as_chunks::<3>().0;
    let mut mesh = Mesh {
        vertices: positions
            .iter()
            .map(|p| DVec3::from(p.map(f64::from)))
            .collect(),
        triangles: Vec::new(),
    };
    let arities = match said.face_arities.as_slice() {
        // Not said where all are triangles.
        [] => vec![3; said.indices.len() / 3],
        arities => arities.to_vec(),
    };
    let mut rest = said.indices.as_slice();
    for (at, arity) in arities.into_iter().enumerate() {
        let (face, others) = rest.split_at(arity as usize);
        mesh.triangles.extend(fan(at, face)?);
        rest = others;
    }
    Ok(mesh)
}

fn read_ply(reader: BufReader<File>) -> Result<Mesh, String> {
    let complain = |e: ply_rs_bw::parser::ParseError| {
        // The first line says what is wrong and where; the others quote the file.
        let text = e.to_string();
        let first = text.lines().next().unwrap_or_default();
        format!("is not a proper PLY file: {first}")
    };
    let mut reader = Reader::new(reader);
    let header = Parser::<Ignored>::new()
        .read_header(&mut reader)
        .map_err(complain)?;
    check_header(&header)?;
    let mut mesh = Mesh::default();
    for (name, element) in &header.elements {
        match name.as_str() {
            "vertex" => {
                let vertices = Parser::<Vertex>::new()
                    .read_payload_for_element(&mut reader, element, &header)
                    .map_err(complain)?;
                mesh.vertices = vertices.into_iter().map(|v| v.0).collect();
            }
            "face" => {
                let faces = Parser::<Face>::new()
                    .read_payload_for_element(&mut reader, element, &header)
                    .map_err(complain)?;
                for (at, face) in faces.iter().enumerate() {
                    mesh.triangles.extend(fan(at, &indices(at, &face.0)?)?);
                }
            }
            _ => {
                Parser::<Ignored>::new()
                    .read_payload_for_element(&mut reader, element, &header)
                    .map_err(complain)?;
            }
        }
    }
    Ok(mesh)
}

/// Checks that a PLY file holds a mesh: what the parser does not find it leaves out in silence.
fn check_header(header: &Header) -> Result<(), String> {
    for (name, element) in &header.elements {
        // Without properties an element takes no bytes, so that no end of the file would ever end
        // the reading of a huge number of them.
        if element.properties.is_empty() {
            return Err(format!(
                "is not a proper PLY file: element `{name}` has no properties"
            ));
        }
    }
    let element = |name: &str| {
        let found = header.elements.get(name);
        found.ok_or_else(|| format!("is not a mesh: its header has no element `{name}`"))
    };
    let vertex = element("vertex")?;
    for name in ["x", "y", "z"] {
        if !vertex.properties.contains_key(name) {
            return Err(format!(
                "is not a mesh: its vertices have no property `{name}`"
            ));
        }
    }
    let face = element("face")?;
    let is_list_of_indices = |name: &str| {
        face.properties
            .get(name)
            .is_some_and(|p| match &p.data_type {
                PropertyType::List(_, item) => {
                    !matches!(item, ScalarType::Float | ScalarType::Double)
                }
                PropertyType::Scalar(_) => false,
            })
    };
    if CORNERS.into_iter().any(is_list_of_indices) {
        Ok(())
    } else {
        Err("is not a mesh: its faces have no list `vertex_indices` of whole numbers".to_owned())
    }
}

/// A PLY file's corners as indices.
fn indices(face: usize, corners: &[i64]) -> Result<Vec<u32>, String> {
    corners
        .iter()
        .map(|&i| u32::try_from(i).map_err(|_| format!("has a vertex index of {i} in face {face}")))
        .collect()
}

/// A polygon as triangles that share its first corner.
fn fan(face: usize, corners: &[u32]) -> Result<Vec<[u32; 3]>, String> {
    match corners {
        [first, rest @ ..] if rest.len() >= 2 => {
            Ok(rest.windows(2).map(|w| [*first, w[0], w[1]]).collect())
        }
        _ => Err(format!("has fewer than 3 corners in face {face}")),
    }
}

/// A PLY vertex: its position; everything else about it is passed over.
struct Vertex(DVec3);

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Vertex(DVec3::NAN)
    }

    fn set_property(&mut self, name: &str, value: Property) -> PropertyAccessResult {
        let coordinate = match name {
            "x" => &mut self.0.x,
            "y" => &mut self.0.y,
            "z" => &mut self.0.z,
            _ => return PropertyAccessResult::Ignored,
        };
        *coordinate = match value {
            Property::Double(x) => x,
            other => other.to_f32_lossy().map_or(f64::NAN, f64::from),
        };
        PropertyAccessResult::Set
    }
}

/// What PLY files call the list of a face's corners.
const CORNERS: [&str; 2] = ["vertex_indices", "vertex_index"];

/// A PLY face: the indices of its corners.
struct Face(Vec<i64>);

impl PropertyAccess for Face {
    fn new() -> Self {
        Face(Vec::new())
    }

    fn set_property(&mut self, name: &str, value: Property) -> PropertyAccessResult {
        if !CORNERS.contains(&name) {
            return PropertyAccessResult::Ignored;
        }
        self.0 = match value {
            Property::ListChar(v) => v.into_iter().map(i64::from).collect(),
            Property::ListUChar(v) => v.into_iter().map(i64::from).collect(),
            Property::ListShort(v) => v.into_iter().map(i64::from).collect(),
            Property::ListUShort(v) => v.into_iter().map(i64::from).collect(),
            Property::ListInt(v) => v.into_iter().map(i64::from).collect(),
            Property::ListUInt(v) => v.into_iter().map(i64::from).collect(),
            _ => return PropertyAccessResult::Ignored,
        };
        PropertyAccessResult::Set
    }
}

/// An element of no interest here, such as an edge.
struct Ignored;

impl PropertyAccess for Ignored {
    fn new() -> Self {
        Ignored
    }
}
