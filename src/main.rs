//! The `halfdisk` command: parse, match, run.

use clap::Parser;
use halfdisk::cli::Command;
use std::process::ExitCode;

fn main() -> ExitCode {
    Command::parse().run()
}
