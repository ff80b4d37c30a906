//! What a scene was made from, so that another can be made from it.

use super::Scene;
use super::build::build;
use super::description::Description;
use super::read::{SceneError, Source};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A description, and the file that it was read from.
#[derive(Clone, Debug)]
pub(super) struct MadeFrom {
    pub(super) description: Description,
    /// Where meshes and images are looked for.
    pub(super) folder: Option<PathBuf>,
    /// All files that take part.
    pub(super) files: Vec<PathBuf>,
    file: String,
    text: String,
    reading: Duration,
}

impl MadeFrom {
    /// Reads a text.
    pub(super) fn new(source: Source, folder: Option<&Path>) -> Result<Self, SceneError> {
        let start = Instant::now();
        let description: Description = source.parse()?;
        let beside = folder.unwrap_or(Path::new(""));
        Ok(MadeFrom {
            files: description.files().map(|f| beside.join(f)).collect(),
            description,
            folder: folder.map(Path::to_owned),
            file: source.file.to_owned(),
            text: source.text.to_owned(),
            reading: start.elapsed(),
        })
    }

    /// The scene of the description after a change, which may have no use for some of the files.
    pub(super) fn build(
        mut self,
        change: impl FnOnce(&mut Description),
    ) -> Result<Scene, SceneError> {
        let start = Instant::now();
        change(&mut self.description);
        let from = Arc::new(self);
        let source = Source {
            file: &from.file,
            text: &from.text,
        };
        let mut scene = build(&from).map_err(|problem| source.locate(&problem))?;
        scene.report.time = from.reading + start.elapsed();
        Ok(scene)
    }
}
