//! `halfdisk scenes`.

use super::Stop;
use super::answer::{List, answer, print};
use crate::output::OutputError;
use crate::scene::SceneError;
use crate::scene::gallery::{self, GALLERY};
use clap::Args;
use serde::Serialize;
use std::fmt::{self, Display, Formatter};
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
                None => print(text),
                Some(path) => write_new(&path, text),
            };
        }
        let entries = GALLERY.iter().map(|(name, _)| Entry::of(name));
        let entries = entries.collect::<Result<_, SceneError>>()?;
        answer(&List(entries), self.json)
    }
}

/// A scene in the list.
#[derive(Serialize)]
struct Entry {
    name: String,
    about: String,
    size: [u32; 2],
    shapes: usize,
    lights: usize,
    max_depth: u32,
    spp: u32,
}

impl Entry {
    fn of(name: &str) -> Result<Entry, SceneError> {
        let scene = gallery::load(name)?;
        Ok(Entry {
            size: scene.size,
            shapes: scene.report.shapes,
            lights: scene.lights.len(),
            max_depth: scene.suggested.max_depth,
            spp: scene.suggested.spp,
            name: scene.name,
            about: scene.about,
        })
    }
}

impl Display for Entry {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        writeln!(f, "{:<10} {}", self.name, self.about)
    }
}

/// Writes a file that is not there yet: what is there may be somebody's work.
fn write_new(path: &Path, text: &str) -> Result<(), Stop> {
    let file = File::create_new(path);
    let written = file.and_then(|mut file| file.write_all(text.as_bytes()));
    written.map_err(|e| OutputError::File(path.display().to_string(), e).into())
}
