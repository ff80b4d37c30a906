//! The desk at which every chapter works: options, output folder, numbers, figures, ledger.
//!
//! A chapter writes `out/chNN/`: its figures and a `data.json` with every number it found. The
//! book and the gallery page are made from these files, so they cannot say anything else.

mod bar;
mod finale;
mod interrupt;
mod record;
mod tell;
mod whole;

pub use bar::Bar;
pub use finale::Finale;
pub use interrupt::{interrupted_code, on_ctrl_c};
pub use record::{Figure, Number, Record};
pub use tell::{answer, tell};
pub use whole::whole;

use crate::integrators::Refused;
use crate::lab::drawing::ChartError;
use crate::lab::ledger::Ledger;
use crate::output::{Display, OutputError, Provenance, can_save, png_bytes, save, write};
use crate::radiosity::RadiosityError;
use crate::render::Film;
use crate::scene::{Scene, SceneError};
use crate::stats::Estimate;
use clap::Parser;
use std::cell::RefCell;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

/// The samples of pictures for print over those of others: a quarter of the error.
const FINER: u32 = 16;

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
    /// Pictures for print: sixteen times the samples, and the last one twice as wide
    #[arg(long, conflicts_with = "quick")]
    pub fine: bool,
    /// Threads to render on; changes no result [default: one for each core]
    #[arg(long, allow_negative_numbers = true, value_parser = whole(1_u16..=1024))]
    pub threads: Option<u16>,
    /// Write pictures as OpenEXR, too: their numbers with standard errors
    #[arg(long)]
    pub exr: bool,
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
    /// An integrator refused its scene.
    #[error(transparent)]
    Refused(#[from] Refused),
    /// Patches refused its scene.
    #[error(transparent)]
    Radiosity(#[from] RadiosityError),
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
    /// Stops by which pictures are brightened.
    stops: f64,
    /// Why a line could not be printed: the first time.
    unsaid: RefCell<Option<std::io::Error>>,
}

/// How a program begins, before anything else: a file that grows beyond what is allowed is an error that it hears of.
pub fn begin() {
    interrupt::survive_large_files();
}

/// Reads the arguments of a program; where they are wrong, or only help is asked for, the code to end
/// with.
pub fn arguments<T: Parser>() -> Result<T, ExitCode> {
    T::try_parse().map_err(|said| match said.print() {
        Err(error) if !said.use_stderr() && error.kind() != ErrorKind::BrokenPipe => {
            tell(format_args!("error: stdout: {error}"));
            ExitCode::FAILURE
        }
        _ if said.use_stderr() => ExitCode::from(2),
        _ => ExitCode::SUCCESS,
    })
}

impl Desk {
    /// Runs a chapter: reads the options, makes its folder, lets it work, and turns an error into
    /// a sentence and an exit code.
    pub fn run(
        chapter: &'static Chapter,
        work: fn(&mut Desk) -> Result<Ledger, DeskError>,
    ) -> ExitCode {
        begin();
        let options = match arguments::<Options>() {
            Ok(options) => options,
            Err(code) => return code,
        };
        interrupt::end_soon(DeskError::Interrupted.to_string());
        match Desk::open(*chapter, options).and_then(|mut desk| {
            let ledger = work(&mut desk)?;
            desk.close(ledger)
        }) {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => {
                tell(format_args!("error: {error}"));
                match error {
                    DeskError::Scene(_) => ExitCode::from(2),
                    DeskError::Interrupted => ExitCode::from(interrupted_code()),
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
        can_save(&folder.join("data.json"))
            .map_err(|e| DeskError::File(folder.display().to_string(), e))?;
        let desk = Desk {
            record: Record::new(chapter, &options),
            options,
            folder,
            start: Instant::now(),
            stops: 0.0,
            unsaid: RefCell::new(None),
        };
        desk.say(&format!("{}: {}", chapter.id, chapter.title));
        desk.say(&format!("{}\n", chapter.question));
        Ok(desk)
    }

    /// `full`, or `quick` where the user is in a hurry.
    pub fn choose<T>(&self, full: T, quick: T) -> T {
        if self.options.quick { quick } else { full }
    }

    /// Samples per pixel of a picture: the user's choice, or the chapter's.
    pub fn spp(&self, full: u32, quick: u32) -> u32 {
        let full = if self.options.fine {
            FINER * full
        } else {
            full
        };
        self.options.spp.unwrap_or(self.choose(full, quick))
    }

    /// Says something that is not a number.
    pub fn say(&self, text: &str) {
        if !self.options.json {
            self.print(text);
        }
    }

    /// Prints a line. The figures are still wanted where that fails; the program ends with the error.
    fn print(&self, text: &str) {
        if let Err(error) = answer(&format!("{text}\n")) {
            self.unsaid.borrow_mut().get_or_insert(error);
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
        save_as(&self.folder.join(file), bytes.as_ref())?;
        self.record.figures.push(Figure {
            file: file.to_owned(),
            caption: caption.to_owned(),
        });
        Ok(())
    }

    /// Shows the pictures that follow brighter by so many stops: each doubles the light. Their numbers stay as they
    /// are, also in EXR files.
    pub fn expose(&mut self, stops: f64) {
        self.stops = stops;
    }

    /// Writes a picture of `scene` as PNG and records it; with `--exr`, an EXR file stands beside it.
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
        if self.options.exr {
            let path = self.folder.join(file).with_extension("exr");
            write(&path, film, Display::Radiance, &facts)?;
        }
        let png = png_bytes(film, Display::Exposed { stops: self.stops }, &facts)?;
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
        let text = serde_json::to_string_pretty(&self.record)
            .map_err(|e| DeskError::File(path.display().to_string(), e.into()))?;
        save_as(&path, format!("{text}\n").as_bytes())?;
        if self.options.json {
            self.print(&text);
        }
        match self.unsaid.take() {
            Some(error) => Err(DeskError::File("stdout".to_owned(), error)),
            None => Ok(()),
        }
    }
}

fn save_as(path: &Path, bytes: &[u8]) -> Result<(), DeskError> {
    save(path, bytes).map_err(|e| DeskError::File(path.display().to_string(), e))
}
