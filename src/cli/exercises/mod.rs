//! `halfdisk exercises`.

mod check;
mod project;
mod run;
mod watch;

use super::Stop;
use super::answer::{List, answer, for_terminal, print};
use super::stop::time;
use crate::lab::chapter::tell;
use crate::lab::exercises::{Entry, LADDER, of_number};
use clap::{Args, Subcommand};
use project::{Project, State};
use serde::Serialize;
use std::fmt::{self, Display, Formatter};
use std::path::PathBuf;
use std::time::Duration;

/// Exercises whose checker names the mistake.
///
/// Each exercise is a file with a function or two to write. The checker asks them for numbers that are known in closed
/// form, and compares what it reads with what each of the usual mistakes would read.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub struct Exercises {
    #[command(subcommand)]
    action: Option<Action>,
    /// The folder of your exercises [default: this one, one above it, or ./exercises]
    #[arg(long, global = true, value_name = "DIR")]
    folder: Option<PathBuf>,
    /// Print JSON; of `check`, the format that Exercism's test runners write
    #[arg(long, global = true)]
    json: bool,
}

const AFTER_HELP: &str = "\
Start here:
  halfdisk exercises                 all of them, and how far you are
  halfdisk exercises start 1         makes exercises/src/bin/ex01_half_disk.rs: its head is the task
  halfdisk exercises check 1         builds it, asks it, and says what was forgotten
  halfdisk exercises watch           the same at each save
  halfdisk exercises hint 1          one hint more each time
  halfdisk exercises solution 1      once yours is right

A folder of exercises is a cargo project. Its first build takes two or three minutes, a further one a second; it needs no network.

Exit codes of `check`: 0 right, 1 not right (or not written, not compiled, too slow), 2 bad usage.";

#[derive(Debug, Subcommand)]
enum Action {
    /// List the exercises and how far you are (as without a command)
    List,
    /// Make the file of an exercise, in a folder that is made where it is not there yet
    Start {
        /// The exercise: its number, or its name
        #[arg(value_parser = exercise)]
        exercise: &'static Entry,
        /// The folder of your exercises [default: the one you are in, or ./exercises]
        #[arg(value_name = "DIR")]
        dir: Option<PathBuf>,
        /// The folder of halfdisk's source [default: where this program was built]
        #[arg(long, value_name = "DIR")]
        source: Option<PathBuf>,
    },
    /// Build an exercise and grade it
    Check {
        /// The exercise: its number, or its name
        #[arg(value_parser = exercise)]
        exercise: &'static Entry,
        /// End a program that runs longer
        #[arg(long, value_name = "TIME", default_value = "10s", value_parser = time)]
        time_limit: Duration,
    },
    /// Show the next hint
    Hint {
        /// The exercise: its number, or its name
        #[arg(value_parser = exercise)]
        exercise: &'static Entry,
    },
    /// Check whatever is saved, until Ctrl-C
    Watch {
        /// End a program that runs longer
        #[arg(long, value_name = "TIME", default_value = "10s", value_parser = time)]
        time_limit: Duration,
    },
    /// Print the solution of an exercise that you have solved
    Solution {
        /// The exercise: its number, or its name
        #[arg(value_parser = exercise)]
        exercise: &'static Entry,
        /// Even if it is not solved yet
        #[arg(long)]
        anyway: bool,
    },
}

/// An exercise by its number or name.
fn exercise(text: &str) -> Result<&'static Entry, String> {
    let number = text.parse().ok().and_then(of_number);
    let named = || LADDER.into_iter().find(|entry| entry.name == text);
    number.or_else(named).ok_or_else(|| {
        format!(
            "exercises have numbers from 1 to {} and names: `halfdisk exercises` lists them",
            LADDER.len()
        )
    })
}

impl Exercises {
    pub(super) fn run(self) -> Result<(), Stop> {
        let folder = self.folder.as_deref();
        match self.action {
            None | Some(Action::List) => answer(&list(Project::found(folder)?.as_ref()), self.json),
            Some(Action::Start {
                exercise,
                dir,
                source,
            }) => {
                let project =
                    Project::start(exercise, dir.as_deref().or(folder), source.as_deref())?;
                tell(format_args!(
                    "{} is yours to fill in; then: halfdisk exercises check {}",
                    project.file(exercise).display(),
                    exercise.number
                ));
                print(&exercise.task())
            }
            Some(Action::Check {
                exercise,
                time_limit,
            }) => {
                let mut project = Project::open(folder)?;
                let graded = check::check(&mut project, exercise, time_limit, self.json)?;
                answer(&graded, self.json)?;
                match graded.report.passed() {
                    true => Ok(()),
                    false => Err(Stop::NotRight),
                }
            }
            Some(Action::Hint { exercise }) => hint(Project::found(folder)?, exercise),
            Some(Action::Watch { time_limit }) => watch::watch(Project::open(folder)?, time_limit),
            Some(Action::Solution { exercise, anyway }) => {
                let project = Project::found(folder)?;
                let solved = project.is_some_and(|p| p.state(exercise) == State::Right);
                if solved || anyway {
                    return print(&exercise.solved());
                }
                Err(Stop::Failure(format!(
                    "exercise {} is not solved yet: `halfdisk exercises hint {}` helps, and --anyway shows the solution",
                    exercise.number, exercise.number
                )))
            }
        }
    }
}

/// Shows one hint more than the last time.
fn hint(project: Option<Project>, exercise: &Entry) -> Result<(), Stop> {
    let shown = match project {
        Some(mut project) => {
            let seen = project.progress.hints.entry(exercise.number).or_default();
            *seen = (*seen + 1).min(exercise.hints.len());
            let shown = *seen;
            project.save()?;
            shown
        }
        None => 1,
    };
    let hints = exercise.hints.iter().zip(1..).take(shown);
    let lines = hints.map(|(hint, i)| format!("{i} of {}: {hint}\n", exercise.hints.len()));
    print(&for_terminal(&lines.collect::<String>()))
}

/// An exercise in the list.
#[derive(Serialize)]
struct Row {
    number: u32,
    name: &'static str,
    title: &'static str,
    page: &'static str,
    points: u32,
    state: State,
}

fn list(project: Option<&Project>) -> List<Row> {
    let row = |entry: &'static Entry| Row {
        number: entry.number,
        name: entry.name,
        title: entry.title,
        page: entry.page,
        points: entry.points,
        state: project.map_or(State::Open, |project| project.state(entry)),
    };
    List(LADDER.into_iter().map(row).collect())
}

impl Display for Row {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let state = match self.state {
            State::Open => "",
            State::Started => "started",
            State::Right => "right",
        };
        writeln!(
            f,
            "{:2}  {:7}  {:12} {}",
            self.number, state, self.name, self.title
        )
    }
}
