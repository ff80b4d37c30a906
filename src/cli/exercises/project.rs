//! The folder of a learner: a cargo project with a file for each exercise, and how far they are.

use super::super::{Stop, save};
use crate::lab::exercises::Entry;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::env;
use std::fs;
use std::path::{Path, PathBuf};

/// The file by which such a folder is known.
const PROGRESS: &str = "progress.json";
/// The folder that is made where none is named.
const USUAL: &str = "exercises";
/// Where this program was built.
const BUILT: &str = env!("CARGO_MANIFEST_DIR");

/// How far a learner is.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Progress {
    /// The exercises that are solved.
    pub right: BTreeSet<u32>,
    /// How many hints were shown.
    pub hints: BTreeMap<u32, usize>,
    /// True once cargo has built the library.
    pub built: bool,
    /// The folder of halfdisk's source.
    pub source: PathBuf,
}

/// How far an exercise is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum State {
    /// Not begun.
    Open,
    /// Its file is there.
    Started,
    /// It was graded as right.
    Right,
}

/// The folder.
#[derive(Debug)]
pub(super) struct Project {
    pub folder: PathBuf,
    pub progress: Progress,
}

impl Project {
    /// The folder that was asked for, or the one around here; `None` where there is none.
    pub fn found(asked: Option<&Path>) -> Result<Option<Project>, Stop> {
        if let Some(folder) = asked {
            return Project::read(folder).map(Some);
        }
        let here = env::current_dir()?;
        let near = here.ancestors().map(Path::to_path_buf);
        let mut candidates = near.chain([here.join(USUAL)]);
        let folder = candidates.find(|folder| folder.join(PROGRESS).is_file() && is_ours(folder));
        folder.map(|folder| Project::read(&folder)).transpose()
    }

    /// The same where there must be one.
    pub fn open(asked: Option<&Path>) -> Result<Project, Stop> {
        Project::found(asked)?.ok_or_else(|| {
            Stop::Input(format!(
                "no exercises here: `halfdisk exercises start 1` makes a folder {USUAL}, and --folder DIR names another one"
            ))
        })
    }

    fn read(folder: &Path) -> Result<Project, Stop> {
        let file = folder.join(PROGRESS);
        let text = fs::read_to_string(&file).map_err(|e| {
            Stop::Input(format!(
                "{}: {e}: not a folder of exercises",
                file.display()
            ))
        })?;
        let progress = serde_json::from_str(&text)
            .map_err(|e| Stop::Input(format!("{}: {e}", file.display())))?;
        Ok(Project {
            folder: folder.to_path_buf(),
            progress,
        })
    }

    /// Makes the file of an exercise, and the folder where it is not there yet.
    pub fn start(
        exercise: &Entry,
        asked: Option<&Path>,
        source: Option<&Path>,
    ) -> Result<Project, Stop> {
        let there = match asked {
            Some(folder) if !folder.join(PROGRESS).exists() => None,
            _ => Project::found(asked)?,
        };
        let is_new = there.is_none();
        let mut project = there.unwrap_or_else(|| Project {
            folder: asked.unwrap_or(Path::new(USUAL)).to_path_buf(),
            progress: Progress::default(),
        });
        let file = project.file(exercise);
        if file.exists() {
            return Err(Stop::Input(format!(
                "{}: is there already; remove it to start again",
                file.display()
            )));
        }
        if is_new || source.is_some() {
            project.make(source, is_new)?;
        }
        save(&file, exercise.unfilled())?;
        project.save()?;
        Ok(project)
    }

    /// Writes what makes the folder a cargo project.
    fn make(&mut self, source: Option<&Path>, is_new: bool) -> Result<(), Stop> {
        let manifest = self.folder.join("Cargo.toml");
        if is_new && manifest.exists() {
            return Err(Stop::Input(format!(
                "{}: another project is there already; name another folder",
                manifest.display()
            )));
        }
        let source = sources(source)?;
        save(&manifest, manifest_for(&source))?;
        let lock = source.join("Cargo.lock");
        if let Ok(lock) = fs::read(lock) {
            // The same versions as halfdisk's: they are on this machine already, and no network is asked.
            save(&self.folder.join("Cargo.lock"), lock)?;
        }
        save(&self.folder.join(".gitignore"), "/target\n")?;
        self.progress.source = source;
        self.progress.built = false;
        Ok(())
    }

    /// The learner's file of an exercise.
    pub fn file(&self, exercise: &Entry) -> PathBuf {
        let name = format!("{}.rs", exercise.program());
        self.folder.join("src").join("bin").join(name)
    }

    pub fn state(&self, exercise: &Entry) -> State {
        match self.progress.right.contains(&exercise.number) {
            true => State::Right,
            false if self.file(exercise).exists() => State::Started,
            false => State::Open,
        }
    }

    /// Keeps the progress.
    pub fn save(&self) -> Result<(), Stop> {
        let json = serde_json::to_string_pretty(&self.progress)? + "\n";
        save(&self.folder.join(PROGRESS), json)
    }
}

/// Another program's `progress.json` is none of ours.
fn is_ours(folder: &Path) -> bool {
    let text = fs::read_to_string(folder.join(PROGRESS)).unwrap_or_default();
    text.contains("\"right\"") && folder.join("Cargo.toml").exists()
}

/// The folder of the source: the one that is named, or the one where this program was built.
fn sources(asked: Option<&Path>) -> Result<PathBuf, Stop> {
    let folder = asked.unwrap_or(Path::new(BUILT));
    let is_source = |folder: &Path| {
        let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap_or_default();
        manifest.lines().any(|line| line == "name = \"halfdisk\"")
    };
    match (is_source(folder), asked) {
        (true, _) => Ok(fs::canonicalize(folder)?),
        (false, Some(folder)) => Err(Stop::Input(format!(
            "--source: {} is not the folder of halfdisk's source, in which Cargo.toml names it",
            folder.display()
        ))),
        (false, None) => Err(Stop::Input(format!(
            "halfdisk was built in {BUILT}, and its source is no longer there: --source DIR says where it is"
        ))),
    }
}

fn manifest_for(source: &Path) -> String {
    let source = toml::Value::String(source.to_string_lossy().into_owned());
    format!(
        "# Made by `halfdisk exercises start`: each file in src/bin is an exercise.

[package]
name = \"exercises\"
version = \"0.0.0\"
edition = \"2024\"
publish = false

[dependencies]
halfdisk = {{ path = {source}, default-features = false }}

[lints.rust]
# Until an exercise is written, it uses nothing.
unused = \"allow\"

[profile.release]
codegen-units = 16
incremental = true
overflow-checks = true

# A project of its own, wherever it stands.
[workspace]
"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_manifest_is_toml_whatever_the_folder_is_called() {
        for folder in ["/home/a b/half\"disk", "C:\\Users\\a\\halfdisk"] {
            let manifest: toml::Table = manifest_for(Path::new(folder)).parse().expect(folder);
            let dependency = &manifest["dependencies"]["halfdisk"];
            assert_eq!(dependency["path"].as_str(), Some(folder));
            assert_eq!(dependency["default-features"].as_bool(), Some(false));
        }
    }

    #[test]
    fn the_source_is_where_the_program_was_built_or_is_asked_for() {
        assert_eq!(sources(None).expect("it is here"), Path::new(BUILT));
        let elsewhere = tempfile::tempdir().expect("a folder");
        let Err(Stop::Input(said)) = sources(Some(elsewhere.path())) else {
            panic!("an empty folder is no source");
        };
        assert!(
            said.starts_with("--source: ") && said.contains("Cargo.toml"),
            "{said}"
        );
    }
}
