//! Triangles, alone and in meshes.

use crate::geometry::{Mesh, Shape, Triangle};
use crate::scene::description as said;
use crate::scene::field::{self, Checked, Field};
use crate::scene::parts::Parts;
use crate::scene::placement::Placement;
use crate::scene::{mesh_file, procedural};

impl Parts<'_> {
    pub(super) fn triangle(
        &mut self,
        field: &Field,
        said: &said::Triangle,
        place: &Placement,
    ) -> Checked<Vec<Shape>> {
        let mesh = Mesh {
            vertices: vec![
                field::vector(&field.key("a"), said.a)?,
                field::vector(&field.key("b"), said.b)?,
                field::vector(&field.key("c"), said.c)?,
            ],
            triangles: vec![[0, 1, 2]],
        };
        let shapes = self.mesh(mesh, place);
        if shapes.is_empty() {
            return Err(field.problem("has no area: its corners lie on one line, or too far away"));
        }
        Ok(shapes)
    }

    pub(super) fn mesh_file(
        &mut self,
        field: &Field,
        said: &said::MeshFile,
        place: &Placement,
    ) -> Checked<Vec<Shape>> {
        let field = field.key("file");
        let Some(folder) = self.folder else {
            return Err(field.problem("is only possible in a scene file of its own"));
        };
        let path = folder.join(&said.file);
        let complain =
            |what: String| field.problem(format!("names {}, which {what}", path.display()));
        let found = mesh_file::read(&path).map_err(complain)?;
        self.degenerate_triangles += found.without_area;
        for note in found.notes {
            self.note(format!("{}: {note}", said.file.display()));
        }
        let shapes = self.mesh(found.mesh, place);
        if shapes.is_empty() {
            return Err(complain("has no triangle with an area".to_owned()));
        }
        Ok(shapes)
    }

    pub(super) fn bumpy_sphere(
        &mut self,
        field: &Field,
        said: &said::BumpySphere,
        place: &Placement,
    ) -> Checked<Vec<Shape>> {
        let center = field::vector(&field.key("center"), said.center)?;
        let radius = field::positive(&field.key("radius"), said.radius)?;
        let columns = field::whole(&field.key("columns"), said.columns, 3, 4096)?;
        let rows = field::whole(&field.key("rows"), said.rows, 2, 4096)?;
        let mesh = procedural::bumpy_sphere(center, radius, columns, rows);
        Ok(self.mesh(mesh, place))
    }

    fn mesh(&mut self, mut mesh: Mesh, place: &Placement) -> Vec<Shape> {
        if place.mirrors() {
            mesh.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }
        let (triangles, count) = mesh.to_triangles(|p| self.relative(place.point(p)));
        for corners in &mesh.triangles {
            let corners = corners.map(|i| place.point(mesh.vertices[i as usize]) - self.origin);
            let [a, b, c] = corners.map(|p| p.as_vec3());
            self.misplaced.triangle(&corners, &Triangle { a, b, c });
        }
        self.degenerate_triangles += count.degenerate;
        triangles.into_iter().map(Shape::Triangle).collect()
    }
}
