//! The `halfdisk` command: parse, match, run.

use halfdisk::{cli::Command, desk};
use std::process::ExitCode;

fn main() -> ExitCode {
    desk::begin(Command::start)
}
