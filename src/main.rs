//! The `halfdisk` command: parse, match, run.

use halfdisk::{cli::Command, desk};
use std::process::ExitCode;

fn main() -> ExitCode {
    match desk::begin() {
        Ok(()) => Command::start(),
        Err(code) => code,
    }
}
