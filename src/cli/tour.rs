//! `halfdisk tour`.

mod child;
mod programs;
mod waiting;

use super::answer::print;
use super::{Stop, check_folder, page, save};
use crate::lab::chapter::{Record, on_ctrl_c, tell};
use clap::Args;
use programs::{file_of, programs};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::Ordering;
use std::time::Instant;
use waiting::{Waiting, lasting};

/// A chapter of the tour.
struct Stage {
    /// Short name, and the folder of its results.
    id: &'static str,
    program: &'static str,
    /// Seconds of a full run on two cores. Only the time that is left is told from them.
    usual: f64,
}

const fn stage(id: &'static str, program: &'static str, usual: f64) -> Stage {
    Stage { id, program, usual }
}

/// The chapters. The last one draws the pictures of the book's reference pages.
const CHAPTERS: &[Stage] = &[
    stage("ch01", "ch01-from-the-eye", 3.0),
    stage("ch02", "ch02-whitteds-tree", 1.5),
    stage("ch03", "ch03-hit-or-miss", 2.0),
    stage("ch04", "ch04-half-disk", 2.0),
    stage("ch05", "ch05-importance-sampling", 2.5),
    stage("ch06", "ch06-gather", 2.5),
    stage("ch07", "ch07-one-ray", 3.0),
    stage("ch08", "ch08-which-ray", 3.5),
    stage("ch09", "ch09-aim-at-the-light", 4.0),
    stage("ch10", "ch10-roulette", 3.0),
    stage("ch11", "ch11-combine", 2.5),
    stage("ch12", "ch12-the-path-tracer", 8.0),
    stage("ch13", "ch13-six-integrals", 3.5),
    stage("ch14", "ch14-alphabet", 4.0),
    stage("ch15", "ch15-patches", 5.5),
    stage("ch16", "ch16-photons", 6.0),
    stage("ch17", "ch17-hard-cases", 1.5),
    stage("ch18", "ch18-cost", 4.0),
    stage("ch19", "ch19-what-the-scene-asks", 8.0),
    stage("scenes", "book-pictures", 14.0),
];

/// The chapters by their short names, with their programs.
#[cfg(test)]
pub(super) fn programs_by_id() -> impl Iterator<Item = (&'static str, &'static str)> {
    CHAPTERS.iter().map(|stage| (stage.id, stage.program))
}

/// Run the chapters in order; write the gallery page and the ledger. Ctrl-C keeps the chapters that are
/// done.
#[derive(Debug, Args)]
pub struct Tour {
    /// Fewer samples: a first look in seconds
    #[arg(long)]
    quick: bool,
    /// Pictures for print: sixteen times the samples, and larger
    #[arg(long, conflicts_with = "quick")]
    fine: bool,
    /// Only these chapters, such as 01,02
    #[arg(long, value_delimiter = ',', value_name = "CHAPTERS", value_parser = chapter)]
    only: Vec<usize>,
    /// Folder for the results; index.html is the page to open
    #[arg(long, value_name = "DIR", default_value = "out")]
    out: PathBuf,
}

/// The place in the list of a chapter given by number, or by name.
fn chapter(text: &str) -> Result<usize, String> {
    let name = text.trim().trim_start_matches("ch");
    let id = name
        .parse::<usize>()
        .map_or(name.to_owned(), |number| format!("ch{number:02}"));
    CHAPTERS
        .iter()
        .position(|known| known.id == id)
        .ok_or_else(|| {
            let numbers = CHAPTERS.iter().map(|c| c.id.trim_start_matches("ch"));
            let numbers: Vec<&str> = numbers.collect();
            format!("the chapters are {}", numbers.join(", "))
        })
}

impl Tour {
    pub(super) fn run(self) -> Result<(), Stop> {
        check_folder(&self.out)?;
        let folder = programs()?;
        let chosen: Vec<&Stage> = CHAPTERS
            .iter()
            .enumerate()
            .filter(|(place, _)| self.only.is_empty() || self.only.contains(place))
            .map(|(_, stage)| stage)
            .collect();
        let start = Instant::now();
        let mut waiting = Waiting::new(chosen.iter().map(|stage| stage.usual).collect());
        let mut ended = Ok(());
        let mut said = Ok(());
        let mut done = 0;
        for stage in &chosen {
            let record = self.run_chapter(&folder, stage, &waiting);
            waiting.end();
            let record = match record {
                Ok(record) => record,
                Err(why) => {
                    ended = Err(why);
                    break;
                }
            };
            done += 1;
            // The chapters are worth running where nobody can read about them.
            said = said.and(print(&line(done, chosen.len(), &record)));
        }
        if matches!(ended, Err(Stop::Interrupted)) {
            tell(format_args!(
                "interrupted: kept {done} of {} chapters",
                chosen.len()
            ));
        }
        // The page shows every chapter that has results, also from an earlier run.
        let mut records = Vec::new();
        for stage in CHAPTERS {
            if self.out.join(stage.id).join("data.json").exists() {
                let record = read_record(&self.out.join(stage.id))?;
                records.push((record, stage.program));
            }
        }
        if records.is_empty() {
            return ended.and(said);
        }
        let index = self.out.join("index.html");
        save(&index, page::html(&records, &self.out)?)?;
        tell(format_args!(
            "{done} chapters in {}; open {} to see them",
            lasting(start.elapsed().as_secs_f64()),
            index.display()
        ));
        ended.and(said)
    }

    fn run_chapter(&self, folder: &Path, stage: &Stage, waiting: &Waiting) -> Result<Record, Stop> {
        let program = file_of(folder, stage.program);
        let mut command = Command::new(&program);
        command.arg("--out").arg(&self.out);
        if self.quick {
            command.arg("--quick");
        }
        if self.fine {
            command.arg("--fine");
        }
        let output = child::finish(command, waiting.begin(stage.program))
            .map_err(|e| Stop::Failure(format!("{} cannot be started: {e}", program.display())))?;
        if on_ctrl_c().load(Ordering::Relaxed) {
            return Err(Stop::Interrupted);
        }
        if !output.status.success() {
            let why = String::from_utf8_lossy(&output.stderr);
            let (id, status) = (stage.id, output.status);
            return Err(Stop::Failure(format!(
                "{id} failed ({status}): {}",
                why.trim()
            )));
        }
        let folder = self.out.join(stage.id);
        save(&folder.join("output.txt"), output.stdout)?;
        read_record(&folder)
    }
}

/// What a chapter found, in one line.
fn line(done: usize, of: usize, record: &Record) -> String {
    let width = of.to_string().len();
    let (seconds, gain) = match &record.ledger {
        Some(ledger) => (lasting(ledger.seconds), ledger.gain.as_str()),
        None => Default::default(),
    };
    let title = &record.title;
    format!("[{done:>width$}/{of}] {seconds:>6}  {title}: {gain}\n")
}

fn read_record(folder: &Path) -> Result<Record, Stop> {
    let path = folder.join("data.json");
    let text = std::fs::read_to_string(&path)
        .map_err(|e| Stop::Failure(format!("{}: {e}", path.display())))?;
    serde_json::from_str(&text).map_err(|e| Stop::Failure(format!("{}: {e}", path.display())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::ledger::Ledger;

    #[test]
    fn a_chapter_is_told_in_one_line_without_jargon() {
        let record = Record {
            chapter: "ch03".to_owned(),
            title: "Hit or miss".to_owned(),
            question: String::new(),
            seed: 1,
            quick: false,
            numbers: Default::default(),
            figures: Vec::new(),
            ledger: Some(Ledger {
                seconds: 4.27,
                variance: Some(2.7),
                ..Ledger::of("Four times the darts for half the error.")
            }),
        };
        assert_eq!(
            line(3, 20, &record),
            "[ 3/20]  4.3 s  Hit or miss: Four times the darts for half the error.\n"
        );
    }

    #[test]
    fn chapters_are_chosen_by_number_and_the_pictures_of_the_book_by_name() {
        for (text, id) in [
            ("1", "ch01"),
            (" 02", "ch02"),
            ("ch03", "ch03"),
            ("scenes", "scenes"),
        ] {
            assert_eq!(
                chapter(text).map(|place| CHAPTERS[place].id),
                Ok(id),
                "{text}"
            );
        }
        for wrong in ["0", "99", "scene", "-1", ""] {
            let says = chapter(wrong).unwrap_err();
            assert!(says.starts_with("the chapters are 01, 02"), "{says}");
            assert!(says.ends_with(", scenes"), "{says}");
        }
    }
}
