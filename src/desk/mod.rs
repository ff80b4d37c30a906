//! The desk at which every chapter works: options, output folder, numbers, figures, ledger.
//!
//! A chapter writes `out/chNN/`: its figures and a `data.json` with every number it found. The
//! book and the gallery page are made from these files, so they cannot say anything else.

mod bar;
mod interrupt;
mod record;
mod whole;

pub use bar::Bar;
pub use interrupt::{INTERRUPTED, on_ctrl_c};
pub use record::{Figure, Number, Record};
pub use whole::whole;

use crate::chart::ChartError;
use crate::ledger::Ledger;
use crate::output::{Display, OutputError, Provenance, png_bytes};
use crate::render::Film;
use crate::scene::{Scene, SceneError};
use crate::stats::Estimate;
use clap::Parser;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

/// What every chapter binary can be told.
#[derive(Clone, Debug, Parser)]
#[command(version, max_term_width = 100)]
pub struct Options {
    /// Folder for the results; the chapter makes one of its own inside
    #[arg(long, value_name = "DIR", default_value = "out")]
    pub out: PathBuf,
    /// Seed of all random numbers: the same seed gives the same bytes
    #[arg(long, default_value_t = 1, allow_negative_numbers = true, value_parser = whole(0..=u64::MAX))]
    pub seed: u64,
    /// Samples per pixel of the chapter's pictures, instead of its own choice
    #[arg(long, allow_negative_numbers = true, value_parser = whole(1_u32..=1 << 20))]
    pub spp: Option<u32>,
    /// Fewer samples: for tests, and for a first look
    #[arg(long)]
    pub quick: bool,
    /// Threads to render on; changes no result [default: one for each core]
    #[arg(long, allow_negative_numbers = true, value_parser = whole(1_u16..=1024))]
    pub threads: Option<u16>,
    /// Print the chapter's data as JSON instead of text
    #[arg(long)]
    pub json: bool,
}

/// Why a chapter stopped.
#[derive(Debug, thiserror::Error)]
pub enum DeskError {
    /// Its scene is not right.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A picture could not be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// A chart could not be drawn.
    #[error(transparent)]
    Chart(#[from] ChartError),
    /// A file could not be written.
    #[error("{0}: {1}")]
    File(String, std::io::Error),
    /// Something the chapter needs is not there.
    #[error("{0}")]
    Missing(String),
    /// Threads could not be started.
    #[error("the threads cannot be started: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    /// Ctrl-C.
    #[error("interrupted; the figures finished so far are kept")]
    Interrupted,
}

/// What a chapter is called and asks.
#[derive(Clone, Copy, Debug)]
pub struct Chapter {
    /// Its short name and output folder, such as `ch01`.
    pub id: &'static str,
    /// Its title.
    pub title: &'static str,
    /// Its question.
    pub question: &'static str,
}

/// A chapter at work.
#[derive(Debug)]
pub struct Desk {
    /// What the user asked for.
    pub options: Options,
    folder: PathBuf,
    record: Record,
    start: Instant,
}

impl Desk {
    /// Runs a chapter: reads the options, makes its folder, lets it work, and turns an error into
    /// a sentence and an exit code.
    pub fn run(chapter: Chapter, work: fn(&mut Desk) -> Result<Ledger, DeskError>) -> ExitCode {
        let options = Options::parse();
        match Desk::open(chapter, options).and_then(|mut desk| {
            let ledger = work(&mut desk)?;
            desk.close(ledger)
        }) {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => {
                eprintln!("error: {error}");
                match error {
                    DeskError::Scene(_) => ExitCode::from(2),
                    DeskError::Interrupted => ExitCode::from(INTERRUPTED),
                    _ => ExitCode::FAILURE,
                }
            }
        }
    }

    fn open(chapter: Chapter, options: Options) -> Result<Desk, DeskError> {
        if let Some(threads) = options.threads {
            rayon::ThreadPoolBuilder::new()
                .num_threads(usize::from(threads))
                .build_global()?;
        }
        let folder = options.out.join(chapter.id);
        std::fs::create_dir_all(&folder)
            .map_err(|e| DeskError::File(folder.display().to_string(), e))?;
        if !options.json {
            print_line(&format!("{}: {}", chapter.id, chapter.title));
            print_line(&format!("{}\n", chapter.question));
        }
        Ok(Desk {
            record: Record::new(chapter, &options),
            options,
            folder,
            start: Instant::now(),
        })
    }

    /// `full`, or `quick` where the user is in a hurry.
    pub fn choose<T>(&self, full: T, quick: T) -> T {
        if self.options.quick { quick } else { full }
    }

    /// Samples per pixel of a picture: the user's choice, or the chapter's.
    pub fn spp(&self, full: u32, quick: u32) -> u32 {
        self.options.spp.unwrap_or(self.choose(full, quick))
    }

    /// Says something that is not a number.
    pub fn say(&self, text: &str) {
        if !self.options.json {
            print_line(text);
        }
    }

    /// Records a number under a name, and prints it.
    pub fn number(&mut self, name: &str, number: Number) {
        self.say(&number.line());
        self.record.numbers.insert(name.to_owned(), number);
    }

    /// Records a value.
    pub fn value(&mut self, name: &str, says: &str, value: f64) {
        self.number(name, Number::new(says, value));
    }

    /// Records a value beside what theory says it is.
    pub fn known(&mut self, name: &str, says: &str, value: f64, exact: f64) {
        self.number(name, Number::new(says, value).exact(exact));
    }

    /// Records an estimate with its error and, where it is known, the truth.
    pub fn estimate(&mut self, name: &str, says: &str, estimate: &Estimate, exact: Option<f64>) {
        let number = Number {
            error: Some(estimate.std_error()),
            exact,
            ..Number::new(says, estimate.mean())
        };
        self.number(name, number);
    }

    /// Writes a figure into the chapter's folder and records it.
    pub fn figure(
        &mut self,
        file: &str,
        caption: &str,
        bytes: impl AsRef<[u8]>,
    ) -> Result<(), DeskError> {
        let path = self.folder.join(file);
        std::fs::write(&path, bytes).map_err(|e| DeskError::File(path.display().to_string(), e))?;
        self.record.figures.push(Figure {
            file: file.to_owned(),
            caption: caption.to_owned(),
        });
        Ok(())
    }

    /// Writes a picture of `scene` as PNG and records it.
    pub fn picture(
        &mut self,
        file: &str,
        caption: &str,
        film: &Film,
        scene: &Scene,
    ) -> Result<(), DeskError> {
        let spp = film.pixels().first().map_or(0, |p| p.count());
        let depth = scene.suggested.max_depth;
        let facts = Provenance::new(scene, &self.record.chapter, depth, spp, self.options.seed);
        let png = png_bytes(film, Display::Radiance, &facts)?;
        self.figure(file, caption, png)
    }

    /// A progress bar for a render of this chapter.
    pub fn bar(&self, what: &str) -> Bar {
        Bar::new(what, on_ctrl_c())
    }

    fn close(mut self, ledger: Ledger) -> Result<(), DeskError> {
        let ledger = Ledger {
            seconds: self.start.elapsed().as_secs_f64(),
            ..ledger
        };
        self.say(&format!("\n{}", ledger.gain));
        self.say(&format!("ledger: {ledger}"));
        self.record.ledger = Some(ledger);
        let path = self.folder.join("data.json");
        let file_error = |e| DeskError::File(path.display().to_string(), e);
        let text = serde_json::to_string_pretty(&self.record)
            .map_err(|e| file_error(std::io::Error::other(e)))?;
        if self.options.json {
            print_line(&text);
        }
        std::fs::write(&path, text + "\n").map_err(file_error)
    }
}

/// Prints a line; nobody there to read it is no reason to stop, for the figures are still wanted.
fn print_line(text: &str) {
    let _ = writeln!(std::io::stdout(), "{text}");
}
