//! The `halfdisk` command: parse, match, run.

use halfdisk::cli::Command;
use halfdisk::lab::chapter;
use std::process::ExitCode;

fn main() -> ExitCode {
    chapter::begin();
    Command::start()
}
