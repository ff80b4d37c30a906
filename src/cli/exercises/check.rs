//! Building an exercise, and running it to be graded.

use super::super::Stop;
use super::super::answer::for_terminal;
use super::project::{Project, State};
use super::run::run_for;
use crate::lab::chapter::tell;
use crate::lab::exercises::{Entry, LADDER, Report, Verdict};
use serde::{Serialize, Serializer};
use std::env;
use std::ffi::OsString;
use std::fmt::{self, Display, Formatter};
use std::fs::{self, File};
use std::io::Read;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::Duration;

/// A report, and what the exercise's program printed.
pub(super) struct Graded {
    pub report: Report,
    output: String,
    next: Option<&'static Entry>,
}

/// Builds an exercise and grades it; what is right is kept.
pub(super) fn check(
    project: &mut Project,
    exercise: &'static Entry,
    limit: Duration,
    json: bool,
) -> Result<Graded, Stop> {
    if !project.file(exercise).exists() {
        return Err(Stop::Input(format!(
            "{}: is not there; `halfdisk exercises start {}` makes it",
            project.file(exercise).display(),
            exercise.number
        )));
    }
    let (mut report, output) = match build(project, exercise, json)? {
        Ok(program) => {
            if !project.progress.built {
                project.progress.built = true;
                project.save()?;
            }
            grade(project, exercise, program, limit, json)?
        }
        Err(said) => (
            Report::unasked(exercise, Verdict::NotBuilt, said),
            String::new(),
        ),
    };
    report.page = project
        .progress
        .source
        .join(&report.page)
        .display()
        .to_string();
    if report.passed() && project.progress.right.insert(exercise.number) {
        project.save()?;
    }
    let open = |entry: &&Entry| project.state(entry) != State::Right;
    Ok(Graded {
        next: LADDER.into_iter().find(open).filter(|_| report.passed()),
        report,
        output,
    })
}

/// Cargo: the one that runs this program, or the one in the path.
fn cargo() -> OsString {
    env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}

/// Builds; the program, or what was wrong.
fn build(project: &Project, exercise: &Entry, json: bool) -> Result<Result<PathBuf, String>, Stop> {
    let mut command = Command::new(cargo());
    command
        .args(["build", "--release", "--bin", &exercise.program()])
        .arg("--message-format=json-render-diagnostics")
        .current_dir(&project.folder)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(if json {
            Stdio::piped()
        } else {
            Stdio::inherit()
        });
    match project.progress.built {
        true => command.arg("--quiet"),
        false => {
            tell(
                "note: the first build of a folder takes two or three minutes; a further one takes a second",
            );
            &mut command
        }
    };
    let built = command.spawn().and_then(|child| child.wait_with_output());
    let built = built.map_err(|e| {
        let cargo = cargo();
        let cargo = cargo.to_string_lossy();
        Stop::Failure(format!(
            "{cargo}: {e}; exercises are built with Rust's cargo: https://rustup.rs"
        ))
    })?;
    if !built.status.success() {
        let words = String::from_utf8_lossy(&built.stderr);
        let said = match words.trim() {
            "" => "does not compile; the compiler says why.".to_owned(),
            words => format!("does not compile.\n{words}"),
        };
        return Ok(Err(said));
    }
    let messages = String::from_utf8_lossy(&built.stdout);
    let program = messages.lines().find_map(|line| {
        let message: serde_json::Value = serde_json::from_str(line).ok()?;
        let is_it = message["target"]["name"] == exercise.program().as_str();
        let path = message["executable"].as_str().filter(|_| is_it)?;
        Some(PathBuf::from(path))
    });
    let missing =
        || Stop::Failure("cargo built the exercise, and does not say where it is".to_owned());
    program.map(Ok).ok_or_else(missing)
}

/// Runs the program, which grades itself.
fn grade(
    project: &Project,
    exercise: &Entry,
    program: PathBuf,
    limit: Duration,
    json: bool,
) -> Result<(Report, String), Stop> {
    let folder = tempfile::tempdir()?;
    let [file, printed] = ["report.json", "output.txt"].map(|name| folder.path().join(name));
    let mut command = Command::new(program);
    command
        .arg("--report")
        .arg(&file)
        .current_dir(&project.folder)
        .stdin(Stdio::null());
    if json {
        command.stdout(File::create(&printed)?);
    }
    let status = run_for(&mut command, limit)?;
    let report = fs::read(&file)
        .ok()
        .and_then(|text| serde_json::from_slice(&text).ok());
    let report = report.unwrap_or_else(|| {
        let said = match status {
            None => format!(
                "no answer after {} s. Does a loop have no end? (--time-limit allows more time.)",
                limit.as_secs_f64()
            ),
            Some(status) => format!("its program ended without an answer ({status}). Does a function call itself without end?"),
        };
        Report::unasked(exercise, Verdict::Ended, said)
    });
    let mut output = Vec::new();
    if json {
        // More than this is shown nowhere.
        File::open(&printed)?
            .take(10_000)
            .read_to_end(&mut output)?;
    }
    Ok((report, String::from_utf8_lossy(&output).into_owned()))
}

impl Serialize for Graded {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.report.results(&self.output).serialize(serializer)
    }
}

impl Display for Graded {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(&for_terminal(&self.report.to_string()))?;
        match self.next {
            Some(next) => writeln!(
                f,
                "Next: `halfdisk exercises start {}`, {}.",
                next.number, next.title
            ),
            None => Ok(()),
        }
    }
}
