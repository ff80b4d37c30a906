//! `halfdisk scenes`.

use super::{Stop, answer};
use crate::output::OutputError;
use crate::scene::gallery::{self, GALLERY};
use crate::scene::{Scene, SceneError};
use clap::Args;
use serde_json::json;
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

/// List the scenes of the gallery, or show one's file.
#[derive(Debug, Args)]
pub struct Scenes {
    /// Print this scene's file: a start for a scene of your own
    #[arg(long, value_name = "NAME", conflicts_with = "json")]
    show: Option<String>,
    /// Write it to this new file instead of printing it
    #[arg(long, value_name = "FILE", requires = "show")]
    out: Option<PathBuf>,
    /// Print the list as JSON
    #[arg(long)]
    json: bool,
}

impl Scenes {
    pub(super) fn run(self) -> Result<(), Stop> {
        if let Some(name) = self.show {
            let text = gallery::text(&name).ok_or_else(|| gallery::unknown(&name))?;
            return match self.out {
                None => answer(text),
                Some(path) => write_new(&path, text),
            };
        }
        let scenes = GALLERY
            .iter()
            .map(|(name, _)| gallery::load(name))
            .collect::<Result<Vec<_>, SceneError>>()?;
        if self.json {
            let list: Vec<_> = scenes
                .iter()
                .map(|s| {
                    json!({
                        "name": s.name,
                        "about": s.about,
                        "size": s.size,
                        "shapes": s.report.shapes,
                        "lights": s.lights.len(),
                        "max_depth": s.suggested.max_depth,
                        "spp": s.suggested.spp,
                    })
                })
                .collect();
            answer(&(serde_json::to_string_pretty(&list)? + "\n"))
        } else {
            let line = |s: &Scene| format!("{:<10} {}\n", s.name, s.about);
            answer(&scenes.iter().map(line).collect::<String>())
        }
    }
}

/// Writes a file that is not there yet: what is there may be somebody's work.
fn write_new(path: &Path, text: &str) -> Result<(), Stop> {
    let file = File::create_new(path);
    let written = file.and_then(|mut file| file.write_all(text.as_bytes()));
    written.map_err(|e| OutputError::File(path.display().to_string(), e).into())
}
