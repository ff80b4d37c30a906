//! `halfdisk scenes`.

use super::{Stop, answer};
use crate::scene::gallery::{self, GALLERY};
use crate::scene::{Scene, SceneError};
use clap::Args;
use serde_json::json;

/// List the scenes of the gallery, or show one's file.
#[derive(Debug, Args)]
pub struct Scenes {
    /// Print this scene's file: a start for a scene of your own
    #[arg(long, value_name = "NAME", conflicts_with = "json")]
    show: Option<String>,
    /// Print the list as JSON
    #[arg(long)]
    json: bool,
}

impl Scenes {
    pub(super) fn run(self) -> Result<(), Stop> {
        if let Some(name) = self.show {
            let text = gallery::text(&name).ok_or_else(|| gallery::unknown(&name))?;
            return answer(text);
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
