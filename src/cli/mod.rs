//! The `halfdisk` command, one file for each thing it does.
//!
//! Text for people goes to stderr, results to stdout. Exit codes: 0 done, 1 failed, 2 bad usage or
//! input, 130 interrupted by Ctrl-C, 143 asked to terminate. A report that nobody can read ends nothing.

mod answer;
mod checkpoint;
mod choices;
mod classify;
mod completions;
mod converge;
mod cost;
mod demand;
mod doctor;
mod effects;
mod exercises;
mod exposure;
mod info;
mod left_out;
mod light_paths;
mod long;
mod maps;
mod merge;
mod page;
mod patching;
mod photons;
mod picture;
mod render;
mod report;
mod resume;
mod scenes;
mod shares;
mod sheet;
mod stop;
mod tour;
mod views;

use crate::lab::chapter::{self, interrupted_code, tell};
use crate::lab::drawing::ChartError;
use crate::output::{self, OutputError};
use crate::scene::SceneError;
use clap::{Parser, Subcommand};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Light transport by running it: from Whitted ray tracing to path tracing, step by step
#[derive(Debug, Parser)]
#[command(name = "halfdisk", version, max_term_width = 100, after_help = AFTER_HELP)]
pub struct Command {
    #[command(subcommand)]
    action: Action,
}

const AFTER_HELP: &str = "\
Start here:
  halfdisk tour                       run every chapter, then open out/index.html
  halfdisk scenes                     what there is to render
  halfdisk render cornell             a picture in out/cornell.png
  halfdisk scenes --show cornell > mine.toml
  halfdisk render mine.toml --spp 256 --out mine.exr
  halfdisk effects caustic            what does this scene call for, and why?
  halfdisk classify cornell           how much of its light came by which paths?
  halfdisk render spheres --target-error 2%
  halfdisk render --resume mine.exr --spp 1024
  halfdisk info mine.exr               how was it made, and how is it made again?
  halfdisk converge half-disk         how fast does its error fall?
  halfdisk cost cornell               what does accuracy cost?
  halfdisk doctor                     what do the usual mistakes read?
  halfdisk exercises                  write it yourself; the checker names the mistake";

#[derive(Debug, Subcommand)]
enum Action {
    /// Run the chapters in order; write the gallery page and the ledger
    Tour(tour::Tour),
    /// Render a scene
    Render(Box<render::Render>),
    /// Say how a picture was made, and print the command that makes it again
    Info(info::Info),
    /// Put the shards of a picture together
    Merge(merge::Merge),
    /// List the scenes of the gallery, or show one's file
    Scenes(scenes::Scenes),
    /// Measure how fast the error of an estimator falls
    Converge(converge::Converge),
    /// Measure what accuracy costs in a scene, for every method
    Cost(cost::Cost),
    /// Name the mistake behind a wrong reading, or list the mistakes
    Doctor(doctor::Doctor),
    /// Exercises whose checker names the mistake
    Exercises(exercises::Exercises),
    /// Say what a scene calls for and why, what is left out and why, and what each effect costs
    Effects(effects::EffectsOf),
    /// Sort a scene's light by its paths, written as words
    Classify(classify::Classify),
    /// Print the completions of a shell
    Completions(completions::Completions),
}

impl Command {
    /// Reads the arguments, and does what they ask.
    pub fn start() -> ExitCode {
        match chapter::arguments::<Command>() {
            Ok(command) => command.run(),
            Err(code) => code,
        }
    }

    fn run(self) -> ExitCode {
        let result = match self.action {
            Action::Tour(tour) => tour.run(),
            Action::Render(render) => render.run(),
            Action::Info(info) => info.run(),
            Action::Merge(merge) => merge.run(),
            Action::Scenes(scenes) => scenes.run(),
            Action::Converge(converge) => converge.run(),
            Action::Cost(cost) => cost.run(),
            Action::Doctor(doctor) => doctor.run(),
            Action::Exercises(exercises) => exercises.run(),
            Action::Effects(effects) => effects.run(),
            Action::Classify(classify) => classify.run(),
            Action::Completions(completions) => completions.run(),
        };
        match result {
            Ok(()) => ExitCode::SUCCESS,
            Err(Stop::Interrupted) => ExitCode::from(interrupted_code()),
            Err(Stop::NotRight) => ExitCode::FAILURE,
            Err(Stop::Input(what)) => {
                tell(format_args!("error: {what}"));
                ExitCode::from(2)
            }
            Err(Stop::Failure(what)) => {
                tell(format_args!("error: {what}"));
                ExitCode::FAILURE
            }
        }
    }
}

/// Why a command ended early.
#[derive(Debug)]
enum Stop {
    /// What the user asked for cannot be: exit code 2.
    Input(String),
    /// Something went wrong on the way: exit code 1.
    Failure(String),
    /// Ctrl-C, or a request to terminate: exit code 130 or 143.
    Interrupted,
    /// An exercise is not right, as its report says: exit code 1.
    NotRight,
}

/// Says that a program built without optimisation is slow.
fn note_slow_build() {
    if cfg!(debug_assertions) {
        tell("note: built for development; `cargo run --release` is several times faster");
    }
}

/// The file of that ending beside others of one name, which may have dots of its own.
fn with_ending(name: &Path, ending: &str) -> PathBuf {
    let mut file = name.as_os_str().to_owned();
    file.push(ending);
    file.into()
}

/// A file and what is in it.
type Bytes = (PathBuf, Vec<u8>);

/// A chart as the files NAME.svg and NAME.png; `None` where it has nothing to show.
fn drawn(
    name: &Path,
    svg: Result<String, ChartError>,
    png: Result<Vec<u8>, ChartError>,
) -> Result<Option<[Bytes; 2]>, Stop> {
    let file = |ending| with_ending(name, ending);
    match svg.and_then(|svg| Ok([svg.into_bytes(), png?])) {
        Ok([svg, png]) => Ok(Some([(file(".svg"), svg), (file(".png"), png)])),
        Err(ChartError::Empty(_)) => Ok(None),
        Err(error) => Err(error.into()),
    }
}

/// The name of a scene's file without its ending, after which results are called; a scene of the
/// gallery has its name.
fn stem(scene: &str) -> String {
    let stem = Path::new(scene).file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}

/// Where the results of a command go: the folder that was asked for, or one named after the scene's file.
fn folder(asked: &Option<PathBuf>, command: &str, scene: &str) -> PathBuf {
    let usual = || Path::new("out").join(command).join(stem(scene));
    asked.clone().unwrap_or_else(usual)
}

/// The size of a picture of the same shape that has at most `most` pixels along a side of so many.
fn reduced(size: [u32; 2], side: u32, most: u32) -> [u32; 2] {
    let along = |n: u32| (u64::from(n) * u64::from(most.min(side)) / u64::from(side)).max(1) as u32;
    size.map(along)
}

/// Checks, before the work is done, that results can be written into a folder, which is made.
fn check_folder(folder: &Path) -> Result<(), Stop> {
    let failure = |e| Stop::Failure(format!("{}: {e}", folder.display()));
    output::can_save(&folder.join("index.html")).map_err(failure)
}

/// Writes a result's file: whole, or not at all.
fn save(path: &Path, bytes: impl AsRef<[u8]>) -> Result<(), Stop> {
    let failure = |e| Stop::Failure(format!("{}: {e}", path.display()));
    output::save(path, bytes.as_ref()).map_err(failure)
}

/// Sets how many threads work; without a number, one for each core.
fn use_threads(threads: Option<u16>) -> Result<(), Stop> {
    let Some(threads) = threads else {
        return Ok(());
    };
    rayon::ThreadPoolBuilder::new()
        .num_threads(usize::from(threads))
        .build_global()
        .map_err(|e| Stop::Failure(format!("the threads cannot be started: {e}")))
}

impl From<SceneError> for Stop {
    fn from(error: SceneError) -> Self {
        Stop::Input(error.to_string())
    }
}

impl From<OutputError> for Stop {
    fn from(error: OutputError) -> Self {
        match error {
            OutputError::Format(_) | OutputError::Needed(_) | OutputError::Part(_) => {
                Stop::Input(error.to_string())
            }
            _ => Stop::Failure(error.to_string()),
        }
    }
}

/// Errors that are no mistake of the user.
macro_rules! failures {
    ($($error:ty),*) => {
        $(impl From<$error> for Stop {
            fn from(error: $error) -> Self {
                Stop::Failure(error.to_string())
            }
        })*
    };
}

failures!(ChartError, serde_json::Error, std::io::Error);
