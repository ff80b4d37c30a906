//! Meshes from PLY and OBJ files.

mod obj;
mod ply;

#[cfg(test)]
mod tests;
#[cfg(test)]
mod uv_tests;

use crate::geometry::{Mesh, Polygons};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// A mesh from a file.
#[derive(Debug)]
pub struct MeshFile {
    /// What it holds, as triangles.
    pub mesh: Mesh,
    /// Triangles that its polygons lack because some of their corners lie on one line.
    pub without_area: usize,
    /// What else is to be said about it: sentences that begin with what was found.
    pub notes: Vec<String>,
}

/// What a file says.
#[derive(Debug, Default)]
struct Said {
    polygons: Polygons,
    /// How often it says what counts for nothing here.
    ignored: BTreeMap<String, usize>,
}

impl Said {
    fn ignore(&mut self, keyword: &str) {
        match self.ignored.get_mut(keyword) {
            Some(count) => *count += 1,
            None => {
                self.ignored.insert(keyword.to_owned(), 1);
            }
        }
    }

    /// What was ignored, as a list; `None` where nothing was.
    fn ignored(&self) -> Option<String> {
        let names = self.ignored.iter().map(|(name, n)| format!("{name} ({n})"));
        let names: Vec<String> = names.collect();
        (!names.is_empty()).then(|| names.join(", "))
    }
}

/// Reads a mesh, its polygons split into triangles; the error is a sentence that begins with what is
/// wrong.
pub fn read(path: &Path) -> Result<MeshFile, String> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("");
    let read_kind = match extension.to_ascii_lowercase().as_str() {
        "ply" => ply::read,
        "obj" => obj::read,
        _ => return Err("is not a mesh this program reads; allowed are .ply and .obj".to_owned()),
    };
    let mut file = File::open(path).map_err(|e| format!("cannot be opened: {e}"))?;
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)
        .map_err(|e| format!("cannot be read: {e}"))?;
    triangles(read_kind(&bytes)?)
}

fn triangles(said: Said) -> Result<MeshFile, String> {
    let ignored = said.ignored();
    let polygons = said.polygons;
    let count = polygons.vertices.len();
    if polygons.is_empty() {
        let what = match &ignored {
            Some(names) => format!("; ignored: {names}"),
            None => String::new(),
        };
        return Err(format!("has no faces, only {count} vertices{what}"));
    }
    if let Some((face, index)) = polygons.bad_index() {
        return Err(format!(
            "has no vertex {index}, which face {face} uses: there are {count}, counted from 0"
        ));
    }
    let is_bad = |v: &glam::DVec3| !v.as_vec3().is_finite();
    if let Some(at) = polygons.vertices.iter().position(is_bad) {
        return Err(format!(
            "has a vertex (number {at}) whose coordinates are not finite numbers"
        ));
    }
    let found = polygons.triangulate();
    let intersection = (found.intersection > 0).then(|| {
        format!(
            "{} polygons whose edges cross, filled somehow",
            found.intersection
        )
    });
    let untextured = (found.without_uvs > 0).then(|| {
        format!(
            "{} faces lack texture coordinates at some corner; their triangles get (0, 0), (1, 0) and \
             (1, 1)",
            found.without_uvs
        )
    });
    let ignored = ignored.map(|names| format!("ignored: {names}"));
    Ok(MeshFile {
        mesh: found.mesh,
        without_area: found.without_area,
        notes: [intersection, untextured, ignored]
            .into_iter()
            .flatten()
            .collect(),
    })
}

/// The start of a word, which in a file of no known kind may be very long.
fn start(word: &str) -> String {
    word.chars().take(20).collect()
}
