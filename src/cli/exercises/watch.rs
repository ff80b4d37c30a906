//! Checking whatever is saved.

use super::super::Stop;
use super::super::answer::answer;
use super::check::check;
use super::project::{Project, State};
use crate::lab::chapter::{on_ctrl_c, tell};
use crate::lab::exercises::{Entry, LADDER};
use std::fs;
use std::sync::atomic::Ordering;
use std::thread::sleep;
use std::time::{Duration, SystemTime};

/// How often the files are looked at.
const PAUSE: Duration = Duration::from_millis(100);

/// When each exercise's file was written; `None` where there is none.
fn times(project: &Project) -> [Option<SystemTime>; LADDER.len()] {
    LADDER.map(|entry| {
        let written = fs::metadata(project.file(entry)).and_then(|file| file.modified());
        written.ok()
    })
}

/// The exercises whose files were written since.
fn saved(
    before: &[Option<SystemTime>],
    now: &[Option<SystemTime>],
) -> impl Iterator<Item = &'static Entry> {
    let moved: Vec<bool> = before
        .iter()
        .zip(now)
        .map(|(a, b)| b.is_some() && a != b)
        .collect();
    let pairs = LADDER.into_iter().zip(moved);
    pairs.filter(|(_, moved)| *moved).map(|(entry, _)| entry)
}

/// Checks the first exercise that is started and not right, and then whatever is saved, until Ctrl-C.
pub(super) fn watch(mut project: Project, limit: Duration) -> Result<(), Stop> {
    let stop = on_ctrl_c();
    tell(format_args!(
        "watching {}; Ctrl-C ends",
        project.folder.join("src/bin").display()
    ));
    let mut seen = times(&project);
    let started = LADDER
        .into_iter()
        .find(|entry| project.state(entry) == State::Started);
    let mut next: Vec<&'static Entry> = started.into_iter().collect();
    loop {
        for entry in next.drain(..) {
            answer(&check(&mut project, entry, limit, false)?, false)?;
        }
        if stop.load(Ordering::Relaxed) {
            return Err(Stop::Interrupted);
        }
        sleep(PAUSE);
        let now = times(&project);
        next.extend(saved(&seen, &now));
        seen = now;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_is_written_or_made_is_noticed_and_one_that_is_removed_is_not() {
        let moment = |s| Some(SystemTime::UNIX_EPOCH + Duration::from_secs(s));
        let mut before = [None; LADDER.len()];
        before[1] = moment(5);
        before[2] = moment(5);
        let mut now = before;
        assert_eq!(saved(&before, &now).count(), 0);
        now[0] = moment(9);
        now[1] = moment(6);
        now[2] = None;
        let numbers: Vec<u32> = saved(&before, &now).map(|entry| entry.number).collect();
        assert_eq!(numbers, [1, 2]);
    }
}
