//! What a file of the flat world says: plain data, in the file's own words and units.
//!
//! Lengths are in scene units (metres, where power matters), colours linear. Serde derives the
//! reading, and refuses fields that do not exist; every number is checked later, by
//! [`build`](super::build::build).

use crate::scene::description::{Color, Exactly};
use std::collections::BTreeMap;

/// Two coordinates.
pub type Pair = Exactly<f64, 2>;

/// A whole file.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// The world's name.
    pub name: String,
    /// One sentence about it.
    #[serde(default)]
    pub about: String,
    /// Radiance of rays that leave the world, in W/(m·rad).
    pub background: Option<Color>,
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
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Where it is: on an object.
    pub at: Pair,
    /// The normal of that object's surface, on the side of the half disk.
    pub normal: Pair,
}

/// An upright rectangle of the plane.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Window {
    /// Lower left corner.
    pub min: Pair,
    /// Upper right corner.
    pub max: Pair,
}

/// Ideal diffuse reflection, on both sides.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Share of light reflected.
    pub albedo: Color,
}

/// Something with a surface: an albedo, by itself or by the name of a material, an emission, or
/// both, and exactly one shape.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Object {
    /// The name of a material.
    pub material: Option<String>,
    /// Share of light reflected.
    pub albedo: Option<Color>,
    /// Radiance emitted on the front side, in W/(m·rad).
    pub emits: Option<Color>,
    /// A segment.
    pub segment: Option<Segment>,
    /// A circle.
    pub circle: Option<Circle>,
    /// A chain of segments.
    pub polyline: Option<Polyline>,
}

/// A straight wall; it faces the left-hand side of the way from `from` to `to`.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Segment {
    /// One end.
    pub from: Pair,
    /// The other.
    pub to: Pair,
}

/// A round wall, facing outwards.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Circle {
    /// Centre.
    pub center: Pair,
    /// Radius.
    pub radius: f64,
}

/// A chain of segments: a room if it is closed and runs counter-clockwise, a block if clockwise.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Polyline {
    /// The corners in order.
    pub points: Vec<Pair>,
    /// Whether a last segment leads back to the first corner.
    #[serde(default)]
    pub closed: bool,
}

/// A lamp without a surface: exactly one of its kinds.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lamp {
    /// A point.
    pub point: Option<PointLamp>,
}

/// A point that shines the same everywhere.
#[derive(Clone, Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PointLamp {
    /// Where it is.
    pub position: Pair,
    /// In W, over all directions.
    pub power: Color,
}
