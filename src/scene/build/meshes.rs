//! Triangles, alone and in meshes.

use crate::geometry::{
    Aabb, DEFAULT_UVS, Instance, InstancedShape, Mesh, Primitive, Shape, SharedMesh, Triangle,
};
use crate::scene::contacts::NEAR;
use crate::scene::description as said;
use crate::scene::field::{Checked, Problem, check};
use crate::scene::mapping::{Corners, Mapping};
use crate::scene::mesh_file::{self, MeshFile};
use crate::scene::motion::PlacedInstance;
use crate::scene::parts::{Parts, alone};
use crate::scene::placement::Placement;
use crate::scene::value::Triple;
use glam::{DVec3, Vec3};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A mesh file that several objects name.
pub struct Repeated {
    found: Arc<MeshFile>,
    /// The mesh in its own coordinates, once an object asked for it.
    shared: Option<(Arc<SharedMesh>, Mapping)>,
}

impl Parts<'_> {
    pub(super) fn triangle(
        &mut self,
        corners: [Triple; 3],
        place: &Placement,
    ) -> Checked<(Vec<Shape>, Mapping)> {
        let vertices = corners
            .into_iter()
            .map(Triple::get)
            .collect::<Checked<_>>()?;
        let mesh = Mesh {
            vertices,
            triangles: vec![[0, 1, 2]],
            uvs: Vec::new(),
        };
        let (shapes, mapping) = self.mesh(&mesh, place);
        let what = "has no area: its corners lie on one line, or too far away";
        check(!shapes.is_empty(), what)?;
        Ok((shapes, mapping))
    }

    pub(super) fn mesh_file(
        &mut self,
        file: &Path,
        place: &Placement,
    ) -> Checked<(Vec<Shape>, Mapping)> {
        let path = alone(self.folder)?.join(file);
        let complain = |what: &str| Problem::new(format!("names {}, which {what}", path.display()));
        let found = match self.repeated.get(file) {
            Some(Repeated { found, .. }) => Arc::clone(found),
            None => Arc::new(mesh_file::read(&path).map_err(|what| complain(&what))?),
        };
        if self.said_often.contains(file) && !self.repeated.contains_key(file) {
            let repeated = Repeated {
                found: Arc::clone(&found),
                shared: None,
            };
            self.repeated.insert(file.to_owned(), repeated);
        }
        self.degenerate_triangles += found.without_area;
        for note in &found.notes {
            self.note(format!("{}: {note}", file.display()));
        }
        let mesh = self.mesh(&found.mesh, place);
        match mesh.0.is_empty() {
            true => Err(complain("has no triangle with an area")),
            false => Ok(mesh),
        }
    }

    pub(super) fn mesh(&mut self, mesh: &Mesh, place: &Placement) -> (Vec<Shape>, Mapping) {
        let mirrored = place.mirrors();
        let from_camera = |p: DVec3| place.point(p) - self.origin;
        for corners in &mesh.triangles {
            let corners = corners.map(|i| from_camera(mesh.vertices[i as usize]));
            let [a, b, c] = corners.map(|p| p.as_vec3());
            self.misplaced.triangle(&corners, &Triangle { a, b, c });
        }
        let triangles = mesh.to_triangles(|p| from_camera(p).as_vec3());
        self.degenerate_triangles += mesh.triangles.len() - triangles.len();
        let mapping = mapping(mesh, triangles.iter().map(|(at, _)| *at));
        let turned = |(_, t): &(usize, Triangle)| match mirrored {
            true => Shape::Triangle(Triangle {
                b: t.c,
                c: t.b,
                ..*t
            }),
            false => Shape::Triangle(*t),
        };
        let shapes = triangles.iter().map(turned).collect();
        (
            shapes,
            if mirrored {
                mapping.mirrored()
            } else {
                mapping
            },
        )
    }

    /// The shape as an instance of a mesh that several objects name; `None` where it is none, or must be
    /// stored for itself.
    pub(super) fn instance(
        &mut self,
        said: &said::Shape,
        place: &Placement,
    ) -> Option<(Instance, Arc<SharedMesh>, Mapping)> {
        let said::Shape::Mesh { file } = said else {
            return None;
        };
        let repeated = self.repeated.get_mut(file)?;
        let (mesh, mapping) = repeated.shared.get_or_insert_with(|| {
            let mesh = &repeated.found.mesh;
            let triangles = mesh.to_triangles(|p| p.as_vec3());
            let mapping = mapping(mesh, triangles.iter().map(|(at, _)| *at));
            let triangles = triangles.into_iter().map(|(_, t)| t).collect();
            (Arc::new(SharedMesh::new(triangles)), mapping)
        });
        let (linear, shift) = place.affine();
        let shape: Arc<dyn InstancedShape> = Arc::<SharedMesh>::clone(mesh);
        let instance = Instance::new(shape, linear, shift - self.origin)?;
        Some((instance, Arc::clone(mesh), mapping.clone()))
    }

    /// A shape of one's own in its place.
    pub(super) fn custom(
        &self,
        shape: &Arc<dyn InstancedShape>,
        place: &Placement,
    ) -> Checked<Instance> {
        let (linear, shift) = place.affine();
        let instance = Instance::new(Arc::clone(shape), linear, shift - self.origin);
        let what = "has a transformation that stretches by more than 10 000 times as much in one \
                    direction as in another, or leads too far away";
        instance.ok_or(Problem::new(what))
    }

    /// Stores those instances for themselves that are so near to a lamp that one rule must decide which of
    /// both is met.
    pub(super) fn part_from_lights(&mut self) {
        let lamp = |(shape, object): &(Shape, u32)| {
            let shines = self.objects[*object as usize].light.is_some();
            let span = self.spans[*object as usize];
            shines.then(|| shape.bounds().union(shape.moved(span).bounds()))
        };
        let lamps: Vec<Aabb> = self.all.iter().filter_map(lamp).collect();
        let shapes = self.all.iter().map(|(shape, _)| shape.bounds());
        let boxes = self.instances.iter().map(|placed| placed.instance.bounds());
        let around = shapes.chain(boxes).fold(Aabb::EMPTY, Aabb::union);
        let near = (around.max - around.min).length() * NEAR as f32;
        let touches = |placed: &PlacedInstance| {
            let Aabb { min, max } = placed.instance.bounds();
            let (min, max) = (min - Vec3::splat(near), max + Vec3::splat(near));
            placed.mesh.is_some()
                && lamps
                    .iter()
                    .any(|lamp| min.cmple(lamp.max).all() && lamp.min.cmple(max).all())
        };
        let (close, apart) = self.instances.drain(..).partition(touches);
        self.instances = apart;
        let close: Vec<PlacedInstance> = close;
        for placed in close {
            let shapes = placed.triangles().map(Shape::Triangle);
            self.all.extend(shapes.map(|shape| (shape, placed.object)));
            let mapping = &mut self.objects[placed.object as usize].mapping;
            if placed.instance.mirrors() {
                *mapping = mapping.mirrored();
            }
        }
    }
}

/// The texture coordinates of some triangles of a mesh.
fn mapping(mesh: &Mesh, kept: impl Iterator<Item = usize>) -> Mapping {
    Mapping::of(match mesh.uvs.is_empty() {
        true => Corners::Same(DEFAULT_UVS),
        false => Corners::Each(kept.map(|at| mesh.uv(at)).collect()),
    })
}

/// The mesh files that several objects name.
pub(super) fn said_often(said: &said::Description) -> Vec<PathBuf> {
    let files = said
        .objects
        .iter()
        .filter_map(|object| match &object.shape {
            said::Shape::Mesh { file } => Some(file),
            _ => None,
        });
    let mut files: Vec<&PathBuf> = files.collect();
    files.sort();
    let pairs = files.windows(2).filter(|pair| pair[0] == pair[1]);
    pairs.map(|pair| pair[0].clone()).collect()
}
