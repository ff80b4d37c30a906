//! From a scene file to something rays can meet.
//!
//! [`read`] turns a file into a [`description`] (plain data, derived by serde, of [`value`]s with
//! rules), [`build`] makes a [`Scene`] of it, [`gallery`] holds the scenes that come with the program, and
//! [`tracer`] is the only way integrators look at a scene: it counts what they ask.

mod ball;
mod brightest;
pub mod build;
mod caustic_guide;
mod contacts;
mod defaults;
pub mod description;
mod effects;
mod facets;
pub mod field;
mod fingerprint;
mod focusing;
pub mod gallery;
pub mod image_file;
mod images;
mod interaction;
mod lamps;
pub mod lanes;
mod made_from;
mod mapping;
pub mod mesh_file;
mod motion;
mod parts;
mod placement;
mod procedural;
pub mod read;
mod solids;
mod spacing;
pub mod textures;
pub mod tracer;
mod tree;
pub mod value;

pub use caustic_guide::{CausticGuide, GuideAt};
pub use effects::{Effect, Effects, Inventory, Sky};
pub use facets::Facet;
pub use gallery::load;
pub use interaction::Interaction;
pub use mapping::{Corners, Mapping};
pub use read::SceneError;
pub use spacing::Coarse;
pub use tracer::{RayCounts, Tracer};

use crate::camera::Camera;
use crate::color::Rgb;
use crate::geometry::{Bvh, Ray};
use crate::lights::{EmissionChoice, Light, LightChoice};
use crate::materials::{Color, Material};
use crate::sampling::stream::{Purpose, Stream};
use contacts::Contacts;
use description::Description;
use glam::{DVec3, Vec3};
use made_from::MadeFrom;
use motion::TransformedShapes;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// A scene ready to be rendered.
///
/// Coordinates are relative to the camera: they are subtracted in `f64` when the scene is built,
/// so that a scene far from the origin keeps its detail near the eye.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Its name.
    pub name: String,
    /// What it shows, in a sentence; may be empty.
    pub about: String,
    /// Where it is seen from.
    pub camera: Camera,
    /// Image width and height in pixels.
    pub size: [u32; 2],
    /// Lights one can aim at: those without a surface in the order of the file, then those of
    /// objects, then an image around the scene or a sky of one colour.
    pub lights: Vec<Light>,
    /// What focuses light.
    pub casters: CausticGuide,
    /// Chooses one of [`Scene::lights`] by what it may give at a point.
    pub light_choice: LightChoice,
    /// Chooses one of [`Scene::lights`] for a path to start from.
    pub emission_choice: EmissionChoice,
    /// The same for a path that starts towards what focuses light; dark where no rough surface could show what
    /// comes of it.
    pub caustic_choice: EmissionChoice,
    /// The index in [`Scene::lights`] of the image around the scene. Where there is one, a ray that
    /// leaves the scene after the lights were asked brings nothing new.
    pub environment_light: Option<usize>,
    /// The index in [`Scene::lights`] of a sky of one colour. Integrators that ask all lights leave it
    /// out, and count it whenever a ray leaves: on diffuse surfaces chance finds it as well as aiming.
    pub sky_light: Option<usize>,
    /// What the file suggests for a render.
    pub suggested: Suggested,
    /// What is in it.
    pub inventory: Inventory,
    /// What happened while the scene was built.
    pub report: BuildReport,
    made_from: Arc<MadeFrom>,
    /// The camera's place in the world.
    origin: DVec3,
    background: Rgb,
    kinds: u8,
    /// True where nothing shines and nobody need look.
    dark: bool,
    /// For each light whose radiance differs from point to point, its object.
    textured_lights: BTreeMap<u32, u32>,
    objects: Vec<Object>,
    /// For each shape of the hierarchy the object it belongs to.
    object_of_shape: Vec<u32>,
    bvh: Bvh,
    /// What moves, and instances of meshes; `None` for most scenes.
    transformed: Option<TransformedShapes>,
    /// What lies within rounding of lamps; `None` for most scenes.
    contacts: Option<Contacts>,
}

impl Scene {
    /// The same scene as an image of another size.
    ///
    /// # Panics
    ///
    /// Where a side has no pixel.
    #[must_use]
    pub fn sized(self, [width, height]: [u32; 2]) -> Scene {
        assert!(
            width > 0 && height > 0,
            "an image of {width} x {height} pixels"
        );
        Scene {
            camera: self
                .camera
                .with_aspect(f64::from(width) / f64::from(height)),
            size: [width, height],
            ..self
        }
    }

    /// The scene that its description, with a change, describes: an image of the same size.
    pub fn changed(&self, change: impl FnOnce(&mut Description)) -> Result<Scene, SceneError> {
        let scene = self.made_from.as_ref().clone().build(change)?;
        Ok(scene.sized(self.size))
    }

    /// Where the origin of all coordinates is in those of the file: the camera's place.
    pub fn origin(&self) -> DVec3 {
        self.origin
    }

    /// The scene as the camera of another one sees it: an image of the same size.
    pub fn with_camera_of(&self, other: &Scene) -> Result<Scene, SceneError> {
        self.changed(|said| said.camera = other.made_from.description.camera.clone())
    }

    /// True where anything moves while the shutter is open.
    pub fn moves(&self) -> bool {
        let transformed = self.transformed.as_ref();
        transformed.is_some_and(|shapes| shapes.moves())
    }

    /// The materials of its objects besides `Lambert`: a set of [`kinds`](crate::materials::kinds).
    pub fn kinds(&self) -> u8 {
        self.kinds
    }

    /// How many of [`Scene::lights`], the first ones, an integrator asks that asks all: not a sky of
    /// one colour.
    pub fn sampled_lights(&self) -> usize {
        self.sky_light.unwrap_or(self.lights.len())
    }

    /// The index in [`Scene::lights`] of the light that is met where a ray leaves the scene.
    pub fn beyond_light(&self) -> Option<usize> {
        self.environment_light.or(self.sky_light)
    }

    /// True where nothing shines, so that no ray need be traced.
    pub fn is_dark(&self) -> bool {
        self.dark
    }

    /// True where a path, by whatever way, leads to a file that the scene was made from.
    pub fn needs(&self, path: &Path) -> bool {
        let same = |a: &Path| a.canonicalize().ok();
        same(path).is_some_and(|path| {
            let mut files = self.report.files.iter();
            files.any(|file| same(file).as_ref() == Some(&path))
        })
    }

    /// The camera ray of a sample of a pixel, by column and row, and by the sample's random numbers. It looks at the scene
    /// at a random moment, where anything moves.
    pub fn camera_ray(&self, [x, y]: [u32; 2], stream: &Stream) -> Ray {
        let [width, height] = self.size;
        let [u, v] = stream.at(0, Purpose::Pixel).two();
        let s = (x as f32 + u) / width as f32;
        let t = (y as f32 + v) / height as f32;
        let mut ray = self.camera.sample_ray(s, t, stream);
        if self.moves() {
            ray.time = stream.at(0, Purpose::Time).one();
        }
        ray
    }

    /// Radiance along a ray that leaves the scene in the unit `direction`.
    pub fn background(&self, direction: Vec3) -> Rgb {
        match self.environment_light.and_then(|i| self.lights.get(i)) {
            Some(Light::Environment(image)) => image.radiance(direction),
            _ => self.background,
        }
    }
}

/// What all points of an object have in common.
#[derive(Clone, Debug, Default)]
pub struct Object {
    /// What it is made of; `None` absorbs everything.
    pub material: Option<Material>,
    /// Radiance it emits, on its front side or on both; black for most.
    pub emission: Color,
    /// Where textures are on it.
    pub mapping: Mapping,
    /// True where it emits on both sides.
    pub two_sided: bool,
    /// The index in [`Scene::lights`] of the light that it is; `None` where it emits nothing.
    pub light: Option<u32>,
}

impl Object {
    /// True where the side of the normal `n` that is seen from `wo` emits light.
    #[inline]
    pub(super) fn shines_from(&self, n: Vec3, wo: Vec3) -> bool {
        self.two_sided || n.dot(wo) > 0.0
    }
}

/// The settings a scene file suggests; the command line has the last word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Suggested {
    /// Longest path in segments, the camera ray first and the one that ends on the light last.
    pub max_depth: u32,
    /// Samples per pixel.
    pub spp: u32,
}

/// What happened while a scene was built.
#[derive(Clone, Debug, Default)]
pub struct BuildReport {
    /// Shapes in the hierarchy.
    pub shapes: usize,
    /// Objects that are meshes stored once for several objects.
    pub instances: usize,
    /// Triangles left out because they have no area.
    pub degenerate_triangles: usize,
    /// What else is to be said about the scene, in sentences.
    pub notes: Vec<String>,
    /// Shapes of lamps left out because an earlier lamp shines in their very place.
    pub hidden_lights: usize,
    /// What is too small for the numbers that say where it is.
    pub coarse: Option<Coarse>,
    /// The files it was made from: the scene's own, meshes and images. A scene of the gallery has none.
    pub files: Vec<PathBuf>,
    /// Time to read, check and build.
    pub time: Duration,
}
