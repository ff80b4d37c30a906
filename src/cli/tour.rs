//! `halfdisk tour`.

use super::answer::print;
use super::{Stop, check_folder, page, save};
use crate::lab::chapter::{Record, on_ctrl_c, tell};
use clap::Args;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

/// The chapters: short name and program. The last one draws the pictures of the book's reference pages.
const CHAPTERS: &[(&str, &str)] = &[
    ("ch01", "ch01-from-the-eye"),
    ("ch02", "ch02-whitteds-tree"),
    ("ch03", "ch03-hit-or-miss"),
    ("ch04", "ch04-half-disk"),
    ("ch05", "ch05-importance-sampling"),
    ("ch06", "ch06-gather"),
    ("ch07", "ch07-one-ray"),
    ("ch08", "ch08-which-ray"),
    ("ch09", "ch09-aim-at-the-light"),
    ("ch10", "ch10-roulette"),
    ("ch11", "ch11-combine"),
    ("ch12", "ch12-the-path-tracer"),
    ("ch13", "ch13-six-integrals"),
    ("ch14", "ch14-alphabet"),
    ("ch15", "ch15-patches"),
    ("ch16", "ch16-photons"),
    ("ch17", "ch17-hard-cases"),
    ("ch18", "ch18-cost"),
    ("ch19", "ch19-what-the-scene-asks"),
    ("scenes", "book-pictures"),
];

/// Run the chapters in order; write the gallery page and the ledger. Ctrl-C keeps the chapters that are
/// done.
#[derive(Debug, Args)]
pub struct Tour {
    /// Fewer samples: a first look in seconds
    #[arg(long)]
    quick: bool,
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
        .position(|(known, _)| *known == id)
        .ok_or_else(|| {
            let numbers = CHAPTERS.iter().map(|(id, _)| id.trim_start_matches("ch"));
            let numbers: Vec<&str> = numbers.collect();
            format!("the chapters are {}", numbers.join(", "))
        })
}

impl Tour {
    pub(super) fn run(self) -> Result<(), Stop> {
        check_folder(&self.out)?;
        let folder = programs()?;
        let chosen: Vec<(&str, &str)> = CHAPTERS
            .iter()
            .enumerate()
            .filter(|(place, _)| self.only.is_empty() || self.only.contains(place))
            .map(|(_, names)| *names)
            .collect();
        let mut ended = Ok(());
        let mut said = Ok(());
        let mut done = 0;
        for (id, program) in &chosen {
            let record = match self.run_chapter(&folder, id, program) {
                Ok(record) => record,
                Err(why) => {
                    ended = Err(why);
                    break;
                }
            };
            done += 1;
            let ledger = record.ledger.map(|l| l.to_string()).unwrap_or_default();
            let count = chosen.len();
            let line = format!("[{done}/{count}] {id} {}: {ledger}\n", record.title);
            // The chapters are worth running where nobody can read about them.
            said = said.and(print(&line));
        }
        if matches!(ended, Err(Stop::Interrupted)) {
            tell(format_args!(
                "interrupted: kept {done} of {} chapters",
                chosen.len()
            ));
        }
        // The page shows every chapter that has results, also from an earlier run.
        let mut records = Vec::new();
        for (id, _) in CHAPTERS {
            if self.out.join(id).join("data.json").exists() {
                records.push(read_record(&self.out.join(id))?);
            }
        }
        if records.is_empty() {
            return ended.and(said);
        }
        let index = self.out.join("index.html");
        save(&index, page::html(&records)?)?;
        tell(format_args!(
            "open {} to see the pictures, the charts and the ledger",
            index.display()
        ));
        ended.and(said)
    }

    fn run_chapter(&self, folder: &Path, id: &str, program: &str) -> Result<Record, Stop> {
        let program = file_of(folder, program);
        let mut command = Command::new(&program);
        command.arg("--out").arg(&self.out).stderr(Stdio::inherit());
        if self.quick {
            command.arg("--quick");
        }
        let output = finish(command)
            .map_err(|e| Stop::Failure(format!("{} cannot be started: {e}", program.display())))?;
        if on_ctrl_c().load(Ordering::Relaxed) {
            return Err(Stop::Interrupted);
        }
        if !output.status.success() {
            return Err(Stop::Failure(format!("{id} failed ({})", output.status)));
        }
        let folder = self.out.join(id);
        save(&folder.join("output.txt"), output.stdout)?;
        read_record(&folder)
    }
}

/// How long a chapter may take to end by itself, and how often it is looked at.
const GRACE: Duration = Duration::from_millis(500);
const OFTEN: Duration = Duration::from_millis(20);

/// Runs a program to its end, or until a wish to stop: Ctrl-C reaches it, too, so that it may end by
/// itself; a request to terminate may be this program's alone.
fn finish(mut command: Command) -> std::io::Result<Output> {
    let stop = on_ctrl_c();
    let mut child = command.stdout(Stdio::piped()).spawn()?;
    let pipe = child.stdout.take();
    let reader = std::thread::spawn(move || {
        let mut read = Vec::new();
        let result = pipe.map_or(Ok(0), |mut pipe| pipe.read_to_end(&mut read));
        result.map(|_| read)
    });
    let mut asked = None;
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        if stop.load(Ordering::Relaxed) {
            let asked = *asked.get_or_insert_with(Instant::now);
            if asked.elapsed() > GRACE {
                // Its files are whole at any time.
                child.kill()?;
                break child.wait()?;
            }
        }
        std::thread::sleep(OFTEN);
    };
    let stdout = reader.join().unwrap_or_else(|_| Ok(Vec::new()))?;
    Ok(Output {
        status,
        stdout,
        stderr: Vec::new(),
    })
}

fn read_record(folder: &Path) -> Result<Record, Stop> {
    let path = folder.join("data.json");
    let text = std::fs::read_to_string(&path)
        .map_err(|e| Stop::Failure(format!("{}: {e}", path.display())))?;
    serde_json::from_str(&text).map_err(|e| Stop::Failure(format!("{}: {e}", path.display())))
}

/// The file of a program.
fn file_of(folder: &Path, program: &str) -> PathBuf {
    folder
        .join(program)
        .with_extension(std::env::consts::EXE_EXTENSION)
}

/// The folder of the chapter programs, beside this one. Under cargo they are brought up to date
/// first, as cargo built only this program; installed, they were installed together.
fn programs() -> Result<PathBuf, Stop> {
    let this = std::env::current_exe()?;
    let folder = this.parent().unwrap_or(Path::new(".")).to_owned();
    if let (Some(cargo), Some(package)) = (
        std::env::var_os("CARGO"),
        std::env::var_os("CARGO_MANIFEST_DIR"),
    ) {
        build(Path::new(&cargo), Path::new(&package), &folder)?;
    }
    let missing = CHAPTERS
        .iter()
        .find(|(_, program)| !file_of(&folder, program).exists());
    match missing {
        None => Ok(folder),
        Some((_, program)) => Err(Stop::Failure(format!(
            "{program} is not in {}; build it there with `cargo build --release --bins`, or run \
             `cargo run --release -- tour`",
            folder.display()
        ))),
    }
}

fn build(cargo: &Path, package: &Path, folder: &Path) -> Result<(), Stop> {
    let mut command = Command::new(cargo);
    command.args(["build", "--bins"]).current_dir(package);
    if !cfg!(debug_assertions) {
        command.arg("--release");
    }
    // The profile's folder lies in the target folder, wherever the user has put that.
    if let Some(target) = folder.parent() {
        command.arg("--target-dir").arg(target);
    }
    // Cargo's output must not mix with the ledger on stdout.
    let status = command
        .stdout(Stdio::null())
        .status()
        .map_err(|e| Stop::Failure(format!("{} cannot be started: {e}", cargo.display())))?;
    if status.success() {
        Ok(())
    } else {
        Err(Stop::Failure("the chapters could not be built".to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chapters_are_chosen_by_number_and_the_pictures_of_the_book_by_name() {
        for (text, id) in [
            ("1", "ch01"),
            (" 02", "ch02"),
            ("ch03", "ch03"),
            ("scenes", "scenes"),
        ] {
            assert_eq!(
                chapter(text).map(|place| CHAPTERS[place].0),
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
