//! Meshes from PLY and OBJ files.

use crate::geometry::Mesh;
use glam::DVec3;
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{Property, PropertyAccess, PropertyAccessResult};
use std::fs::File;
use std::io::BufReader;
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
    let options = tobj::LoadOptions {
        triangulate: true,
        ..tobj::LoadOptions::default()
    };
    // Materials come from the scene file, so those an OBJ file names are not looked for.
    let no_materials = |_: &Path| Ok((Vec::new(), Default::default()));
    let (models, _) = tobj::load_obj_buf(&mut reader, &options, no_materials)
        .map_err(|e| format!("is not a proper OBJ file: {e}"))?;
    let mut mesh = Mesh::default();
    for model in models {
        let first = mesh.vertices.len() as u32;
        let positions = model.mesh.positions.as_chunks::<3>().0;
        mesh.vertices
            .extend(positions.iter().map(|p| DVec3::from(p.map(f64::from))));
        let corners = model.mesh.indices.as_chunks::<3>().0;
        mesh.triangles
            .extend(corners.iter().map(|t| t.map(|i| first + i)));
    }
    Ok(mesh)
}

fn read_ply(reader: BufReader<File>) -> Result<Mesh, String> {
    let complain = |e: ply_rs_bw::parser::ParseError| {
        let text = e.to_string();
        let one_line = text.split_whitespace().collect::<Vec<_>>().join(" ");
        format!("is not a proper PLY file: {one_line}")
    };
    let mut reader = Reader::new(reader);
    let header = Parser::<Ignored>::new()
        .read_header(&mut reader)
        .map_err(complain)?;
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
                    mesh.triangles.extend(fan(at, &face.0)?);
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

/// A polygon as triangles that share its first corner.
fn fan(face: usize, corners: &[i64]) -> Result<Vec<[u32; 3]>, String> {
    let corners: Vec<u32> = corners
        .iter()
        .map(|&i| u32::try_from(i).map_err(|_| format!("has a vertex index of {i} in face {face}")))
        .collect::<Result<_, _>>()?;
    match corners.as_slice() {
        [first, rest @ ..] if rest.len() >= 2 => {
            Ok(rest.windows(2).map(|w| [*first, w[0], w[1]]).collect())
        }
        few => Err(format!(
            "has a face (number {face}) with {} corners; a face has at least 3",
            few.len()
        )),
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

/// A PLY face: the indices of its corners.
struct Face(Vec<i64>);

impl PropertyAccess for Face {
    fn new() -> Self {
        Face(Vec::new())
    }

    fn set_property(&mut self, name: &str, value: Property) -> PropertyAccessResult {
        if !matches!(name, "vertex_indices" | "vertex_index") {
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
