//! What a file of the flat world says: plain data, in the file's own words and units.
//!
//! Lengths are in scene units (metres, where power matters), colours linear. It is read as scenes are:
//! serde refuses fields that do not exist, and each value is of a type that says what is allowed.

use crate::scene::value::{Albedo, Emission, Ior, Pair, Positive, Radiance};
use serde::Deserialize;
use std::collections::BTreeMap;

/// A whole file.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// The world's name.
    pub name: String,
    /// One sentence about it.
    #[serde(default)]
    pub about: String,
    /// Radiance of rays that leave the world, in W/(m·rad).
    pub background: Option<Radiance>,
    /// The point whose half disk is drawn.
    pub probe: Option<Probe>,
    /// The part of the plane that drawings show; without it, all of it.
    pub window: Option<Window>,
    /// Materials by name.
    #[serde(default)]
    pub materials: BTreeMap<String, Material>,
    /// Everything with a surface.
    #[serde(default)]
    pub objects: Vec<Object>,
    /// Lamps without a surface.
    #[serde(default)]
    pub lamps: Vec<Lamp>,
}

/// A point of a surface, named P in the drawings.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Where it is: on an object.
    pub at: Pair,
    /// The normal of that object's surface, on the side of the half disk.
    pub normal: Pair,
}

/// On top of the unit circle.
impl Default for Probe {
    fn default() -> Self {
        let up = Pair([0.0, 1.0]);
        Probe { at: up, normal: up }
    }
}

/// An upright rectangle of the plane.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Window {
    /// Lower left corner.
    pub min: Pair,
    /// Upper right corner.
    pub max: Pair,
}

/// What holds the unit circle.
impl Default for Window {
    fn default() -> Self {
        Window {
            min: Pair([-1.0; 2]),
            max: Pair([1.0; 2]),
        }
    }
}

/// Ideal diffuse reflection, on both sides.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Share of light reflected.
    pub albedo: Albedo,
}

/// Something with a surface: an albedo, by itself or by the name of a material, a mirror or glass, an
/// emission, or some of them, and a shape.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Object {
    /// The name of a material.
    pub material: Option<String>,
    /// Share of light reflected.
    pub albedo: Option<Albedo>,
    /// Share of light mirrored, on both sides.
    pub mirror: Option<Albedo>,
    /// Index of refraction of the glass behind its front.
    pub glass: Option<Ior>,
    /// Radiance emitted on the front side, in W/(m·rad).
    pub emits: Option<Emission>,
    /// Its shape.
    #[serde(rename = "a shape")]
    pub shape: Shape,
}

/// A shape.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename = "shape", rename_all = "snake_case", deny_unknown_fields)]
pub enum Shape {
    /// A straight wall; it faces the left-hand side of the way from `from` to `to`.
    Segment {
        /// One end.
        from: Pair,
        /// The other.
        to: Pair,
    },
    /// A round wall, facing outwards.
    Circle {
        /// Centre.
        center: Pair,
        /// Radius.
        radius: Positive,
    },
    /// A circle, stretched along the axes; it faces outwards.
    Ellipse {
        /// Centre.
        center: Pair,
        /// Half the width, and half the height.
        axes: Pair,
    },
    /// A chain of segments: a room if it is closed and runs counter-clockwise, a block if clockwise.
    Polyline {
        /// The corners in order.
        points: Vec<Pair>,
        /// Whether a last segment leads back to the first corner.
        #[serde(default)]
        closed: bool,
    },
}

/// The unit circle.
impl Default for Shape {
    fn default() -> Self {
        Shape::Circle {
            center: Pair::default(),
            radius: Positive::default(),
        }
    }
}

/// A lamp without a surface.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename = "kind of lamp", rename_all = "snake_case")]
#[serde(deny_unknown_fields)]
pub enum Lamp {
    /// A point that shines the same everywhere.
    Point {
        /// Where it is.
        position: Pair,
        /// In W, over all directions.
        power: Emission,
    },
}

/// A point at the origin.
impl Default for Lamp {
    fn default() -> Self {
        Lamp::Point {
            position: Pair::default(),
            power: Emission::default(),
        }
    }
}
