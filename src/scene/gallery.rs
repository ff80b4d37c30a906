//! The scenes that come with the program, and how a name or a path becomes a scene.

use super::build::build;
use super::read::{SceneError, Source};
use super::{Scene, description::Description};
use std::path::Path;
use std::time::Instant;

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
    (
        "caustic",
        include_str!("../../examples/scenes/caustic.toml"),
    ),
    ("mesh", include_str!("../../examples/scenes/mesh.toml")),
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
    if let Some(text) = text(scene) {
        return from_text(Source { file: scene, text }, None, change);
    }
    let path = Path::new(scene);
    if path.extension().is_none() && !path.exists() {
        return Err(unknown(scene));
    }
    let refuse = |reason: String| SceneError::File {
        file: scene.to_owned(),
        reason,
    };
    if !path
        .extension()
        .is_some_and(|e| e.eq_ignore_ascii_case("toml"))
    {
        let reason = "is not a scene file: their names end in .toml";
        return Err(refuse(reason.to_owned()));
    }
    let bytes = std::fs::read(path).map_err(|e| refuse(format!("cannot be read: {e}")))?;
    let text = String::from_utf8(bytes).map_err(|e| SceneError::not_text(scene, &e))?;
    let source = Source {
        file: scene,
        text: &text,
    };
    from_text(source, path.parent(), change)
}

/// The error of a name that is neither in the gallery nor a file.
pub fn unknown(name: &str) -> SceneError {
    let names: Vec<&str> = GALLERY.iter().map(|(name, _)| *name).collect();
    SceneError::File {
        file: name.to_owned(),
        reason: format!(
            "is neither a scene of the gallery ({}) nor a file",
            names.join(", ")
        ),
    }
}

/// The scene a text describes; meshes are looked for in `folder`.
pub fn from_text(
    source: Source,
    folder: Option<&Path>,
    change: impl FnOnce(&mut Description),
) -> Result<Scene, SceneError> {
    let start = Instant::now();
    let mut description = source.parse()?;
    change(&mut description);
    let mut scene = build(&description, folder).map_err(|problem| source.locate(&problem))?;
    scene.report.time = start.elapsed();
    Ok(scene)
}
