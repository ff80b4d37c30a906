//! A program that runs for so long at most.

use super::super::Stop;
use crate::lab::chapter::on_ctrl_c;
use std::io;
use std::process::{Child, Command, ExitStatus};
use std::sync::atomic::Ordering;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// How often a program is asked whether it has ended.
const PAUSE: Duration = Duration::from_millis(5);

/// Runs a program to its end; `None` where it had to be ended, because the time was over.
pub(super) fn run_for(command: &mut Command, limit: Duration) -> Result<Option<ExitStatus>, Stop> {
    let stop = on_ctrl_c();
    let begun = Instant::now();
    let mut child = command.spawn()?;
    loop {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status));
        }
        if stop.load(Ordering::Relaxed) {
            end(&mut child)?;
            return Err(Stop::Interrupted);
        }
        if begun.elapsed() > limit {
            end(&mut child)?;
            return Ok(None);
        }
        sleep(PAUSE);
    }
}

fn end(child: &mut Child) -> io::Result<()> {
    child.kill()?;
    child.wait().map(drop)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn a_program_without_end_is_ended_and_one_that_ends_is_not() {
        let begun = Instant::now();
        let mut endless = Command::new("sleep");
        let ended = run_for(endless.arg("60"), Duration::from_millis(50));
        assert!(ended.expect("sleep starts").is_none());
        assert!(begun.elapsed() < Duration::from_secs(20));
        let done = run_for(&mut Command::new("true"), Duration::from_secs(20));
        assert!(
            done.expect("true starts")
                .is_some_and(|status| status.success())
        );
        assert!(run_for(&mut Command::new("/no/such/program"), PAUSE).is_err());
    }
}
