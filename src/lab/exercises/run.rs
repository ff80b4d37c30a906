//! The end of a learner's program: grade, and say it.

use super::{Exam, Report, Verdict};
use std::any::Any;
use std::env;
use std::fs;
use std::io::{self, Write};
use std::panic::{self, AssertUnwindSafe};
use std::process::ExitCode;
use std::sync::{Mutex, PoisonError};

/// The random numbers of a program's grade: the same each time, so that a grade can be repeated.
const SEED: u64 = 1;

/// How `todo!` begins.
const UNWRITTEN: &str = "not yet implemented";

/// Grades an answer as the whole of a program: prints the report, or writes it as JSON to FILE where the arguments are
/// `--report FILE`. The exit code is 0 for a right answer, else 1.
pub fn main<A>(exam: &Exam<A>, answer: &A) -> ExitCode {
    let place: &'static Mutex<String> = Box::leak(Box::default());
    panic::set_hook(Box::new(move |info| {
        let at = info
            .location()
            .map_or_else(String::new, |l| format!(" at {l}"));
        *place.lock().unwrap_or_else(PoisonError::into_inner) = at;
    }));
    let mut report = guarded(exam, answer, SEED);
    if report.verdict == Verdict::Panics {
        report.said += &place.lock().unwrap_or_else(PoisonError::into_inner);
    }
    let mut arguments = env::args_os().skip(1);
    let written = match (arguments.next(), arguments.next()) {
        (Some(option), Some(file)) if option == "--report" => {
            let json = serde_json::to_vec(&report).map_err(io::Error::from);
            json.and_then(|json| fs::write(file, json))
        }
        _ => write!(io::stdout(), "{report}"),
    };
    match written {
        Ok(()) if report.passed() => ExitCode::SUCCESS,
        _ => ExitCode::FAILURE,
    }
}

/// Grades an answer that may panic, or may not be written yet.
pub fn guarded<A>(exam: &Exam<A>, answer: &A, seed: u64) -> Report {
    let graded = panic::catch_unwind(AssertUnwindSafe(|| exam.grade(answer, seed)));
    graded.unwrap_or_else(|panic| {
        let message = words(panic.as_ref());
        match message.starts_with(UNWRITTEN) {
            true => {
                let said = format!("not written yet.\n\n{}", exam.entry.task());
                Report::unasked(exam.entry, Verdict::Unwritten, said)
            }
            false => {
                let said = format!("your answer panics: {message}");
                Report::unasked(exam.entry, Verdict::Panics, said)
            }
        }
    })
}

fn words(panic: &(dyn Any + Send)) -> &str {
    match (panic.downcast_ref::<&str>(), panic.downcast_ref::<String>()) {
        (Some(text), _) => text,
        (_, Some(text)) => text,
        _ => "without a message",
    }
}
