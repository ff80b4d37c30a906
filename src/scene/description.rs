//! What a scene file says: plain data, in the file's own words and units.
//!
//! Lengths are in scene units, angles in degrees, colours linear. Serde derives the reading, and
//! refuses fields that do not exist; every number is checked later, by [`super::build`].

mod materials;

pub use materials::{Glass, Glossy, Lambert, Material, Mirror, Mixture, RoughGlass};

use serde::de::{self, Deserialize, Deserializer, SeqAccess, Visitor};
use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;
use std::path::{Path, PathBuf};

/// Three coordinates.
pub type Triple = Exactly<f64, 3>;

/// A whole file.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// The scene's name.
    pub name: String,
    /// One sentence about it.
    #[serde(default)]
    pub about: String,
    /// Radiance of rays that leave the scene.
    pub background: Option<Color>,
    /// The same with more to say.
    pub environment: Option<Environment>,
    /// Suggested settings.
    #[serde(default)]
    pub render: Render,
    /// The camera.
    pub camera: Camera,
    /// The film.
    #[serde(default)]
    pub film: Film,
    /// Materials by name.
    #[serde(default)]
    pub materials: BTreeMap<String, Material>,
    /// Everything with a surface.
    #[serde(default)]
    pub objects: Vec<Object>,
    /// Lights without a surface.
    #[serde(default)]
    pub lights: Vec<Light>,
}

impl Description {
    /// The files that it names, as they are written.
    pub fn files(&self) -> impl Iterator<Item = &Path> {
        let meshes = self
            .objects
            .iter()
            .filter_map(|o| Some(&o.mesh.as_ref()?.file));
        let images = self.environment.iter().filter_map(|e| e.image.as_ref());
        meshes.chain(images).map(PathBuf::as_path)
    }
}

/// Suggested settings of a render.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Render {
    /// Longest path, in segments.
    pub max_depth: i64,
    /// Samples per pixel.
    pub spp: i64,
}

impl Default for Render {
    fn default() -> Self {
        Render {
            max_depth: 12,
            spp: 64,
        }
    }
}

/// A camera: a pinhole, unless it has a lens.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// Where it is.
    pub from: Triple,
    /// A point it looks at.
    pub to: Triple,
    /// A direction that is up in the picture.
    #[serde(default = "up")]
    pub up: Triple,
    /// Full angle across the image height, in degrees.
    pub fov: f64,
    /// Radius of the lens; 0 is a pinhole.
    #[serde(default)]
    pub lens_radius: f64,
    /// Distance of what is sharp, along the direction of view; the point looked at, if not given.
    pub focus: Option<f64>,
    /// When the shutter opens and when it closes, in units of time.
    #[serde(default = "never_open")]
    pub shutter: Exactly<f64, 2>,
}

fn never_open() -> Exactly<f64, 2> {
    Exactly([0.0, 0.0])
}

fn up() -> Triple {
    Exactly([0.0, 1.0, 0.0])
}

/// The film.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Film {
    /// Width and height in pixels.
    #[serde(deserialize_with = "two")]
    pub size: [i64; 2],
}

fn two<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[i64; 2], D::Error> {
    Exactly::deserialize(deserializer).map(|Exactly(pair)| pair)
}

impl Default for Film {
    fn default() -> Self {
        Film { size: [256, 256] }
    }
}

/// Something with a surface: a material, an emission or both, and exactly one shape.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Object {
    /// The name of a material; without one the surface absorbs everything.
    pub material: Option<String>,
    /// Radiance emitted on the front side.
    pub emits: Option<Color>,
    /// True for light on both sides; of quads, triangles and meshes.
    pub two_sided: Option<bool>,
    /// Where the shape is put.
    pub transform: Option<Transform>,
    /// How far it moves in a unit of time; at time 0 it is where its shape is put.
    pub motion: Option<Triple>,
    /// A sphere.
    pub sphere: Option<Sphere>,
    /// A parallelogram.
    pub quad: Option<Quad>,
    /// A triangle.
    pub triangle: Option<Triangle>,
    /// Six quads.
    #[serde(rename = "box")]
    pub cuboid: Option<Cuboid>,
    /// A mesh from a file.
    pub mesh: Option<MeshFile>,
    /// A mesh from a formula.
    pub bumpy_sphere: Option<BumpySphere>,
}

/// Scale first, then rotation, then translation.
#[derive(Clone, Debug, Default, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Transform {
    /// One factor, or one for each axis.
    pub scale: Option<Color>,
    /// A rotation about an axis through the origin.
    pub rotate: Option<Rotation>,
    /// A shift.
    pub translate: Option<Triple>,
}

/// A rotation about an axis through the origin, counter-clockwise seen from the axis' tip.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rotation {
    /// The axis.
    pub axis: Triple,
    /// The angle.
    pub degrees: f64,
}

/// A sphere.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    /// Centre.
    pub center: Triple,
    /// Radius.
    pub radius: f64,
    /// True where its front is inside.
    #[serde(default)]
    pub inward: bool,
}

/// The parallelogram `corner + s u + t v`; it faces along `u × v`.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Quad {
    /// A corner.
    pub corner: Triple,
    /// An edge from the corner.
    pub u: Triple,
    /// The other edge from the corner.
    pub v: Triple,
}

/// A triangle; it faces the side from which `a`, `b`, `c` run counter-clockwise.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Triangle {
    /// First corner.
    pub a: Triple,
    /// Second corner.
    pub b: Triple,
    /// Third corner.
    pub c: Triple,
}

/// An axis-aligned box, facing outwards.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cuboid {
    /// The corner with the smallest coordinates.
    pub min: Triple,
    /// The corner with the largest.
    pub max: Triple,
}

/// A mesh in a file.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MeshFile {
    /// `.ply` or `.obj`, relative to the scene file.
    pub file: PathBuf,
}

/// A sphere with bumps, as triangles.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BumpySphere {
    /// Centre.
    pub center: Triple,
    /// Mean radius.
    pub radius: f64,
    /// Columns round the vertical axis.
    pub columns: i64,
    /// Rows from pole to pole.
    pub rows: i64,
}

/// A light without a surface: exactly one of its kinds.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Light {
    /// A point.
    pub point: Option<PointLight>,
    /// A direction.
    pub directional: Option<DirectionalLight>,
}

/// What is seen beyond the scene: a radiance or an image.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Environment {
    /// The same radiance everywhere.
    pub radiance: Option<Color>,
    /// `.exr`, `.hdr` or `.png` in latitude and longitude, relative to the scene file.
    pub image: Option<PathBuf>,
    /// A factor for the image's values.
    pub scale: Option<f64>,
    /// The image's rotation about `+y` in degrees, counter-clockwise seen from above.
    pub rotate: Option<f64>,
}

/// A point that shines the same everywhere.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PointLight {
    /// Where it is.
    pub position: Triple,
    /// In W/sr.
    pub intensity: Color,
}

/// Parallel light.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DirectionalLight {
    /// Where the light goes.
    pub direction: Triple,
    /// Irradiance of a surface that faces the light, in W/m².
    pub irradiance: Color,
}

/// A list of `N` values and no more: serde's own arrays pass over what follows the last one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exactly<T, const N: usize>(pub [T; N]);

impl<'de, T: Deserialize<'de>, const N: usize> Deserialize<'de> for Exactly<T, N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct List<T, const N: usize>(PhantomData<T>);

        impl<'de, T: Deserialize<'de>, const N: usize> Visitor<'de> for List<T, N> {
            type Value = Exactly<T, N>;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                write!(f, "{N} numbers in brackets")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Self::Value, A::Error> {
                array(seq, &self).map(Exactly)
            }
        }

        deserializer.deserialize_seq(List(PhantomData))
    }
}

/// All items of a list, if there are as many as expected.
fn array<'de, T: Deserialize<'de>, A: SeqAccess<'de>, const N: usize>(
    mut list: A,
    expected: &dyn de::Expected,
) -> Result<[T; N], A::Error> {
    let mut items = Vec::new();
    while let Some(item) = list.next_element()? {
        items.push(item);
    }
    items
        .try_into()
        .map_err(|items: Vec<T>| de::Error::invalid_length(items.len(), expected))
}

/// Three channels, written `[r, g, b]` or as one number for all three.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Color(pub [f64; 3]);

impl<'de> Deserialize<'de> for Color {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NumberOrThree;

        impl<'de> Visitor<'de> for NumberOrThree {
            type Value = Color;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("3 numbers in brackets, or one number for all three")
            }

            fn visit_f64<E: de::Error>(self, x: f64) -> Result<Color, E> {
                Ok(Color([x; 3]))
            }

            fn visit_i64<E: de::Error>(self, x: i64) -> Result<Color, E> {
                Ok(Color([x as f64; 3]))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Color, A::Error> {
                array(seq, &self).map(Color)
            }
        }

        deserializer.deserialize_any(NumberOrThree)
    }
}
