//! `halfdisk completions`.

use super::answer::print;
use super::{Command, Stop};
use clap::{Args, CommandFactory};
use clap_complete::Shell;

/// Print the completions of a shell.
#[derive(Debug, Args)]
pub struct Completions {
    /// The shell
    shell: Shell,
}

impl Completions {
    pub(super) fn run(self) -> Result<(), Stop> {
        let mut command = Command::command();
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut command, "halfdisk", &mut script);
        print(&String::from_utf8_lossy(&script))
    }
}
