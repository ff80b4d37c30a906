//! Triangles, alone and in meshes.

use crate::geometry::{Mesh, Shape, Triangle};
use crate::scene::field::{Checked, Problem, check};
use crate::scene::mesh_file;
use crate::scene::parts::{Parts, alone};
use crate::scene::placement::Placement;
use crate::scene::value::Triple;
use glam::DVec3;
use std::path::Path;

impl Parts<'_> {
    pub(super) fn triangle(
        &mut self,
        corners: [Triple; 3],
        place: &Placement,
    ) -> Checked<Vec<Shape>> {
        let vertices = corners
            .into_iter()
            .map(Triple::get)
            .collect::<Checked<_>>()?;
        let triangles = vec![[0, 1, 2]];
        let shapes = self.mesh(
            Mesh {
                vertices,
                triangles,
                ..Mesh::default()
            },
            place,
        );
        let what = "has no area: its corners lie on one line, or too far away";
        check(!shapes.is_empty(), what)?;
        Ok(shapes)
    }

    pub(super) fn mesh_file(&mut self, file: &Path, place: &Placement) -> Checked<Vec<Shape>> {
        let folder = alone(self.folder)?;
        let path = folder.join(file);
        let complain = |what: &str| Problem::new(format!("names {}, which {what}", path.display()));
        let found = mesh_file::read(&path).map_err(|what| complain(&what))?;
        self.degenerate_triangles += found.without_area;
        for note in found.notes {
            self.note(format!("{}: {note}", file.display()));
        }
        let shapes = self.mesh(found.mesh, place);
        match shapes.is_empty() {
            true => Err(complain("has no triangle with an area")),
            false => Ok(shapes),
        }
    }

    pub(super) fn mesh(&mut self, mut mesh: Mesh, place: &Placement) -> Vec<Shape> {
        if place.mirrors() {
            mesh.turn_over();
        }
        let from_camera = |p: DVec3| place.point(p) - self.origin;
        let triangles = mesh.to_triangles(|p| from_camera(p).as_vec3());
        for corners in &mesh.triangles {
            let corners = corners.map(|i| from_camera(mesh.vertices[i as usize]));
            let [a, b, c] = corners.map(|p| p.as_vec3());
            self.misplaced.triangle(&corners, &Triangle { a, b, c });
        }
        self.degenerate_triangles += mesh.triangles.len() - triangles.len();
        let shape = |(_, triangle)| Shape::Triangle(triangle);
        triangles.into_iter().map(shape).collect()
    }
}
