//! What a scene file says: plain data, in the file's own words and units.
//!
//! Lengths are in scene units, angles in degrees, colours linear. Serde derives the reading, and
//! refuses fields that do not exist; each value is of a type that says what is allowed (see
//! [`value`](super::value)). What several values must have in common is checked by [`super::build`].

use super::textures::Textured;
use super::value::{
    Albedo, Direction, Emission, Finite, Fov, Ior, NotNegative, Positive, Radiance, Roughness,
    Scale, Shutter, Triple, Whole,
};
use crate::geometry::InstancedShape;
use crate::lights::CustomLight;
use crate::materials::CustomBsdf;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A whole file.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// The scene's name.
    pub name: String,
    /// One sentence about it.
    #[serde(default)]
    pub about: String,
    /// Radiance of rays that leave the scene.
    pub background: Option<Radiance>,
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
            .filter_map(|object| match &object.shape {
                Shape::Mesh { file } => Some(file.as_path()),
                _ => None,
            });
        let colors = self.materials.values().flat_map(Material::colors);
        let textures = colors.flatten().filter_map(Textured::file);
        let emissions = self
            .objects
            .iter()
            .filter_map(|object| object.emits.as_ref());
        let lights = emissions.filter_map(Textured::file);
        meshes.chain(textures).chain(lights).chain(self.image())
    }

    /// The image around the scene, where there is one.
    pub fn image(&self) -> Option<&Path> {
        match &self.environment.as_ref()?.light {
            Sky::Image(file) => Some(file),
            Sky::Radiance(_) => None,
        }
    }
}

/// Suggested settings of a render.
#[derive(Clone, Debug, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Render {
    /// Longest path, in segments.
    pub max_depth: Whole<1, 100_000>,
    /// Samples per pixel.
    pub spp: Whole<1, 16_777_216>,
}

/// A camera: a pinhole, unless it has a lens.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// Where it is.
    pub from: Triple,
    /// A point it looks at.
    pub to: Triple,
    /// A direction that is up in the picture.
    #[serde(default)]
    pub up: Direction,
    /// Full angle across the image height.
    pub fov: Fov,
    /// Radius of the lens; 0 is a pinhole.
    #[serde(default)]
    pub lens_radius: NotNegative,
    /// Distance of what is sharp, along the direction of view; the point looked at, if not given.
    pub focus: Option<Positive>,
    /// When the shutter opens and when it closes, in units of time.
    #[serde(default)]
    pub shutter: Shutter,
}

/// The film.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Film {
    /// Width and height in pixels.
    pub size: [i64; 2],
}

/// A material.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename = "kind of material", rename_all = "snake_case")]
#[serde(deny_unknown_fields)]
pub enum Material {
    /// Ideal diffuse reflection.
    Lambert {
        /// Share of light reflected.
        albedo: Textured<Albedo>,
    },
    /// A perfect mirror.
    Mirror {
        /// Share of light reflected.
        reflectance: Textured<Albedo>,
    },
    /// A smooth transparent medium.
    Glass {
        /// Index of refraction behind the surface.
        ior: Ior,
    },
    /// A rough mirror.
    Glossy {
        /// Share of light that each facet reflects.
        reflectance: Textured<Albedo>,
        /// The roughness of the facets.
        roughness: Roughness,
    },
    /// A rough transparent medium.
    RoughGlass {
        /// Index of refraction behind the surface.
        ior: Ior,
        /// The roughness of the facets.
        roughness: Roughness,
    },
    /// Diffuse, specular and transmitted light in constant shares.
    Mixture {
        /// Share scattered diffusely.
        kd: Textured<Albedo>,
        /// Share mirrored.
        ks: Textured<Albedo>,
        /// Share refracted.
        kt: Textured<Albedo>,
        /// Index of refraction behind the surface.
        #[serde(default)]
        ior: Ior,
    },
    /// One's own, which no file can name.
    #[serde(skip)]
    Custom(Arc<dyn CustomBsdf>),
}

impl Material {
    /// Its colours; `None` fills the places of those that it has not.
    pub fn colors(&self) -> [Option<&Textured<Albedo>>; 3] {
        match self {
            Material::Lambert { albedo } => [Some(albedo), None, None],
            Material::Mirror { reflectance } | Material::Glossy { reflectance, .. } => {
                [Some(reflectance), None, None]
            }
            Material::Mixture { kd, ks, kt, .. } => [Some(kd), Some(ks), Some(kt)],
            Material::Glass { .. } | Material::RoughGlass { .. } | Material::Custom(_) => [None; 3],
        }
    }
}

/// Something with a surface: a material, an emission or both, and a shape.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Object {
    /// The name of a material; without one the surface absorbs everything.
    pub material: Option<String>,
    /// Radiance emitted on the front side.
    pub emits: Option<Textured<Emission>>,
    /// True for light on both sides; of quads, triangles and meshes.
    pub two_sided: Option<bool>,
    /// Where the shape is put.
    #[serde(default)]
    pub transform: Transform,
    /// How far it moves in a unit of time; at time 0 it is where its shape is put.
    #[serde(default)]
    pub motion: Triple,
    /// Its shape.
    #[serde(rename = "a shape")]
    pub shape: Shape,
}

impl From<Shape> for Object {
    /// The shape where it is, neither made of anything nor shining.
    fn from(shape: Shape) -> Self {
        Object {
            shape,
            ..Object::default()
        }
    }
}

/// Scale first, then rotation, then translation.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Transform {
    /// One factor, or one for each axis.
    pub scale: Scale,
    /// A rotation about an axis through the origin.
    pub rotate: Option<Rotation>,
    /// A shift.
    pub translate: Triple,
}

/// A rotation about an axis through the origin, counter-clockwise seen from the axis' tip.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rotation {
    /// The axis.
    pub axis: Direction,
    /// The angle.
    pub degrees: Finite,
}

/// A shape.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename = "shape", rename_all = "snake_case", deny_unknown_fields)]
pub enum Shape {
    /// A sphere.
    Sphere {
        /// Centre.
        center: Triple,
        /// Radius.
        radius: Positive,
        /// True where its front is inside.
        #[serde(default)]
        inward: bool,
    },
    /// The parallelogram `corner + s u + t v`; it faces along `u × v`.
    Quad {
        /// A corner.
        corner: Triple,
        /// An edge from the corner.
        u: Triple,
        /// The other edge from the corner.
        v: Triple,
    },
    /// A triangle; it faces the side from which `a`, `b`, `c` run counter-clockwise.
    Triangle {
        /// First corner.
        a: Triple,
        /// Second corner.
        b: Triple,
        /// Third corner.
        c: Triple,
    },
    /// An axis-aligned box, facing outwards.
    Box {
        /// The corner with the smallest coordinates.
        min: Triple,
        /// The corner with the largest.
        max: Triple,
    },
    /// A mesh in a file.
    Mesh {
        /// `.ply` or `.obj`, relative to the scene file.
        file: PathBuf,
    },
    /// A shape of one's own, which no file can name; its coordinates are those of the scene.
    #[serde(skip)]
    Custom(Arc<dyn InstancedShape>),
    /// A sphere with bumps, as triangles.
    BumpySphere {
        /// Centre.
        center: Triple,
        /// Mean radius.
        radius: Positive,
        /// Columns round the vertical axis.
        columns: Whole<3, 4096>,
        /// Rows from pole to pole.
        rows: Whole<2, 4096>,
    },
}

/// A light without a surface.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename = "kind of light", rename_all = "snake_case")]
#[serde(deny_unknown_fields)]
pub enum Light {
    /// A point that shines the same everywhere.
    Point {
        /// Where it is.
        position: Triple,
        /// In W/sr.
        intensity: Emission,
    },
    /// Parallel light.
    Directional {
        /// Where the light goes.
        direction: Direction,
        /// Irradiance of a surface that faces the light, in W/m².
        irradiance: Emission,
    },
    /// One's own, which no file can name.
    #[serde(skip)]
    Custom(Arc<dyn CustomLight>),
}

/// What is seen beyond the scene.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Environment {
    /// Where its light comes from.
    #[serde(rename = "a radiance or an image")]
    pub light: Sky,
    /// A factor for the image's values.
    pub scale: Option<Positive>,
    /// The image's rotation about `+y` in degrees, counter-clockwise seen from above.
    pub rotate: Option<Finite>,
}

/// The light of an environment.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename = "kind of environment", rename_all = "snake_case")]
pub enum Sky {
    /// The same radiance everywhere.
    Radiance(Radiance),
    /// `.exr`, `.hdr` or `.png` in latitude and longitude, relative to the scene file.
    Image(PathBuf),
}
