//! What a scene is put together from.

use super::build::Repeated;
use super::field::{Checked, Problem, check};
use super::motion::PlacedInstance;
use super::spacing::Misplaced;
use super::{Inventory, Object};
use crate::geometry::Shape;
use crate::lights::Light;
use crate::materials::Material;
use glam::{DVec3, Vec3};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// A scene while it is put together.
#[derive(Default)]
pub(super) struct Parts<'a> {
    /// The camera's place: all coordinates become relative to it.
    pub(super) origin: DVec3,
    pub(super) folder: Option<&'a Path>,
    /// When the shutter opens and when it closes.
    pub(super) shutter: [f64; 2],
    pub(super) materials: BTreeMap<String, Material>,
    /// All shapes, where they are when the shutter opens, and the objects they belong to.
    pub(super) all: Vec<(Shape, u32)>,
    pub(super) objects: Vec<Object>,
    /// Shapes that a transformation puts in their places.
    pub(super) instances: Vec<PlacedInstance>,
    /// Mesh files that several objects name, and what was read of them.
    pub(super) said_often: BTreeSet<PathBuf>,
    pub(super) repeated: BTreeMap<PathBuf, Repeated>,
    /// The way of each object while the shutter is open.
    pub(super) spans: Vec<Vec3>,
    pub(super) lights: Vec<Light>,
    pub(super) degenerate_triangles: usize,
    /// For each object its number in the file.
    pub(super) numbers: Vec<usize>,
    /// What is so large that rounding moves it.
    pub(super) misplaced: Misplaced,
    /// What else is to be said about the scene.
    pub(super) notes: Vec<String>,
    /// What was found so far.
    pub(super) inventory: Inventory,
    /// Names of the materials that objects use.
    pub(super) used: BTreeSet<String>,
    /// Where lamps are, to the last bit.
    pub(super) light_places: BTreeSet<Vec<u32>>,
    /// Shapes left out because a lamp shines in their very place.
    pub(super) hidden_lights: usize,
}

impl Parts<'_> {
    /// Keeps a sentence for the report, once.
    pub(super) fn note(&mut self, sentence: String) {
        if !self.notes.contains(&sentence) {
            self.notes.push(sentence);
        }
    }

    /// A point, relative to the camera; worth nothing where `f32` cannot hold it.
    pub(super) fn relative(&self, p: DVec3) -> Checked<Vec3> {
        let p = (p - self.origin).as_vec3();
        check(p.is_finite(), "must be at most 3.4e38 away from the camera").map(|()| p)
    }
}

/// The folder of a scene file, in which it looks for other files.
pub(super) fn alone(folder: Option<&Path>) -> Checked<&Path> {
    folder.ok_or(Problem::new("is only possible in a scene file of its own"))
}
