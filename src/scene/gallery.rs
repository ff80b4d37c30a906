//! The scenes that come with the program, and how a name or a path becomes a scene.

use super::made_from::MadeFrom;
use super::read::{self, SceneError, Source};
use super::{Scene, description::Description};
use std::borrow::Cow;
use std::path::Path;

/// The gallery: name and text of each scene, in the order in which it is listed.
pub const GALLERY: &[(&str, &str)] = &[
    (
        "cornell",
        include_str!("../../examples/scenes/cornell.toml"),
    ),
    (
        "spheres",
        include_str!("../../examples/scenes/spheres.toml"),
    ),
    ("final", include_str!("../../examples/scenes/final.toml")),
    (
        "courtyard",
        include_str!("../../examples/scenes/courtyard.toml"),
    ),
    ("room", include_str!("../../examples/scenes/room.toml")),
    (
        "caustic",
        include_str!("../../examples/scenes/caustic.toml"),
    ),
    ("mesh", include_str!("../../examples/scenes/mesh.toml")),
    ("gloss", include_str!("../../examples/scenes/gloss.toml")),
    (
        "mixture",
        include_str!("../../examples/scenes/mixture.toml"),
    ),
    (
        "textures",
        include_str!("../../examples/scenes/textures.toml"),
    ),
    ("lens", include_str!("../../examples/scenes/lens.toml")),
    ("motion", include_str!("../../examples/scenes/motion.toml")),
    ("six", include_str!("../../examples/scenes/six.toml")),
    (
        "whitted",
        include_str!("../../examples/scenes/whitted.toml"),
    ),
    ("lamp", include_str!("../../examples/scenes/lamp.toml")),
    ("slab", include_str!("../../examples/scenes/slab.toml")),
    (
        "splitter",
        include_str!("../../examples/scenes/splitter.toml"),
    ),
    ("tunnel", include_str!("../../examples/scenes/tunnel.toml")),
    (
        "furnace",
        include_str!("../../examples/scenes/furnace.toml"),
    ),
    ("veach", include_str!("../../examples/scenes/veach.toml")),
];

/// The text of a gallery scene.
pub fn text(name: &str) -> Option<&'static str> {
    GALLERY
        .iter()
        .find(|(n, _)| *n == name)
        .map(|(_, text)| *text)
}

/// The scene of a gallery name, or of a path to a `.toml` file.
pub fn load(scene: &str) -> Result<Scene, SceneError> {
    load_with(scene, |_| {})
}

/// The same, with a change to the description before it is checked and built, such as another
/// image size.
pub fn load_with(scene: &str, change: impl FnOnce(&mut Description)) -> Result<Scene, SceneError> {
    let text = read::text_of(scene, GALLERY)?;
    // Gallery scenes are borrowed, and stand in no folder.
    let folder = match text {
        Cow::Borrowed(_) => None,
        Cow::Owned(_) => Path::new(scene).parent(),
    };
    let source = Source {
        file: scene,
        text: &text,
    };
    let mut made_from = MadeFrom::new(source, folder)?;
    if folder.is_some() {
        made_from.files.push(source.file.into());
    }
    made_from.build(change)
}

/// The error of a name that is neither in the gallery nor a file.
pub fn unknown(name: &str) -> SceneError {
    read::unknown(name, GALLERY)
}

/// The scene a text describes; meshes are looked for in `folder`.
pub fn from_text(
    source: Source,
    folder: Option<&Path>,
    change: impl FnOnce(&mut Description),
) -> Result<Scene, SceneError> {
    MadeFrom::new(source, folder)?.build(change)
}
