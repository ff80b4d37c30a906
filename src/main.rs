//! The `halfdisk` command: parse, match, run.

use halfdisk::cli::Command;
use halfdisk::lab::chapter;
use std::process::ExitCode;

fn main() -> ExitCode {
    match chapter::begin() {
        Ok(()) => Command::start(),
        Err(code) => code,
    }
}
