//! `halfdisk tour`.

use super::{Stop, answer, page};
use crate::desk::{INTERRUPTED, Record, on_ctrl_c};
use clap::Args;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::Ordering;

/// The chapters: short name and program.
const CHAPTERS: &[(&str, &str)] = &[
    ("ch01", "ch01-from-the-eye"),
    ("ch02", "ch02-whitteds-tree"),
    ("ch03", "ch03-alphabet"),
    ("ch04", "ch04-hit-or-miss"),
    ("ch05", "ch05-half-disk"),
    ("ch06", "ch06-bending"),
    ("ch07", "ch07-gather"),
    ("ch08", "ch08-six-integrals"),
    ("ch09", "ch09-one-ray"),
    ("ch10", "ch10-which-ray"),
    ("ch11", "ch11-roulette"),
    ("ch12", "ch12-aim-at-the-light"),
    ("ch13", "ch13-combine"),
    ("ch14", "ch14-cost"),
    ("ch17", "ch17-hard-cases"),
    ("ch18", "ch18-what-the-scene-asks"),
];

/// Run the chapters in order; write the gallery page and the ledger.
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

/// The place in the list of a chapter given by number.
fn chapter(text: &str) -> Result<usize, String> {
    let number = text.trim().trim_start_matches("ch");
    number
        .parse::<usize>()
        .ok()
        .and_then(|n| {
            CHAPTERS
                .iter()
                .position(|(id, _)| *id == format!("ch{n:02}"))
        })
        .ok_or_else(|| {
            let numbers = CHAPTERS.iter().map(|(id, _)| id.trim_start_matches("ch"));
            let numbers: Vec<&str> = numbers.collect();
            format!("the chapters are {}", numbers.join(", "))
        })
}

impl Tour {
    pub(super) fn run(self) -> Result<(), Stop> {
        let folder = programs()?;
        let chosen: Vec<(&str, &str)> = CHAPTERS
            .iter()
            .enumerate()
            .filter(|(place, _)| self.only.is_empty() || self.only.contains(place))
            .map(|(_, names)| *names)
            .collect();
        let stop = on_ctrl_c();
        for (at, (id, program)) in chosen.iter().enumerate() {
            if stop.load(Ordering::Relaxed) {
                return Err(Stop::Interrupted);
            }
            let record = self.run_chapter(&folder, id, program)?;
            let ledger = record.ledger.map(|l| l.to_string()).unwrap_or_default();
            answer(&format!(
                "[{}/{}] {id} {}: {ledger}\n",
                at + 1,
                chosen.len(),
                record.title
            ))?;
        }
        // The page shows every chapter that has results, also from an earlier run.
        let mut records = Vec::new();
        for (id, _) in CHAPTERS {
            if self.out.join(id).join("data.json").exists() {
                records.push(read_record(&self.out.join(id))?);
            }
        }
        let index = self.out.join("index.html");
        std::fs::write(&index, page::html(&records)?)
            .map_err(|e| Stop::Failure(format!("{}: {e}", index.display())))?;
        eprintln!(
            "open {} to see the pictures, the charts and the ledger",
            index.display()
        );
        Ok(())
    }

    fn run_chapter(&self, folder: &Path, id: &str, program: &str) -> Result<Record, Stop> {
        let program = folder
            .join(program)
            .with_extension(std::env::consts::EXE_EXTENSION);
        let mut command = Command::new(&program);
        command.arg("--out").arg(&self.out).stderr(Stdio::inherit());
        if self.quick {
            command.arg("--quick");
        }
        let output = command
            .output()
            .map_err(|e| Stop::Failure(format!("{} cannot be started: {e}", program.display())))?;
        // Ctrl-C reaches the chapter too, which may end by the signal itself.
        let interrupted = output.status.code() == Some(i32::from(INTERRUPTED));
        if interrupted || on_ctrl_c().load(Ordering::Relaxed) {
            return Err(Stop::Interrupted);
        }
        if !output.status.success() {
            return Err(Stop::Failure(format!("{id} failed ({})", output.status)));
        }
        let folder = self.out.join(id);
        std::fs::write(folder.join("output.txt"), output.stdout)?;
        read_record(&folder)
    }
}

fn read_record(folder: &Path) -> Result<Record, Stop> {
    let path = folder.join("data.json");
    let text = std::fs::read_to_string(&path)
        .map_err(|e| Stop::Failure(format!("{}: {e}", path.display())))?;
    serde_json::from_str(&text).map_err(|e| Stop::Failure(format!("{}: {e}", path.display())))
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
    let missing = CHAPTERS.iter().find(|(_, program)| {
        let file = folder
            .join(program)
            .with_extension(std::env::consts::EXE_EXTENSION);
        !file.exists()
    });
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
