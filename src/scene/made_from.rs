//! What a scene was made from, so that another can be made from it.

use super::Scene;
use super::build::assemble;
use super::description::Description;
use super::read::{SceneError, Source};
use crate::time::Moment;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

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
        let start = Moment::now();
        let described = MadeFrom::described(source.parse()?, folder);
        Ok(MadeFrom {
            file: source.file.to_owned(),
            text: source.text.to_owned(),
            reading: start.elapsed().unwrap_or_default(),
            ..described
        })
    }

    /// What no file says.
    pub(super) fn described(description: Description, folder: Option<&Path>) -> Self {
        let beside = folder.unwrap_or(Path::new(""));
        MadeFrom {
            files: description.files().map(|f| beside.join(f)).collect(),
            folder: folder.map(Path::to_owned),
            file: description.name.clone(),
            text: String::new(),
            reading: Duration::ZERO,
            description,
        }
    }

    /// The scene of the description after a change, which may have no use for some of the files.
    pub(super) fn build(
        mut self,
        change: impl FnOnce(&mut Description),
    ) -> Result<Scene, SceneError> {
        let start = Moment::now();
        change(&mut self.description);
        let from = Arc::new(self);
        let source = Source {
            file: &from.file,
            text: &from.text,
        };
        let mut scene = assemble(&from).map_err(|problem| source.locate(&problem))?;
        scene.report.time = from.reading + start.elapsed().unwrap_or_default();
        Ok(scene)
    }
}
