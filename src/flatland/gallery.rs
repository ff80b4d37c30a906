//! The flat worlds that come with the program, and how a name or a path becomes a world.

use super::FlatWorld;
use super::build::build;
use super::description::Description;
use crate::scene::read::{self, SceneError, Source};

/// The gallery: name and text of each world, in the order in which it is listed.
pub const GALLERY: &[(&str, &str)] = &[
    (
        "furnace",
        include_str!("../../examples/flatland/furnace.toml"),
    ),
    ("lamp", include_str!("../../examples/flatland/lamp.toml")),
    (
        "plates",
        include_str!("../../examples/flatland/plates.toml"),
    ),
    ("room", include_str!("../../examples/flatland/room.toml")),
    ("yard", include_str!("../../examples/flatland/yard.toml")),
];

/// The world of a gallery name, or of a path to a `.toml` file.
pub fn load(world: &str) -> Result<FlatWorld, SceneError> {
    let text = read::text_of(world, GALLERY)?;
    from_text(Source {
        file: world,
        text: &text,
    })
}

/// The world a text describes.
pub fn from_text(source: Source) -> Result<FlatWorld, SceneError> {
    let description: Description = source.parse()?;
    build(&description).map_err(|problem| source.locate(&problem))
}
