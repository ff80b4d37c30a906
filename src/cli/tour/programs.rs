//! The chapters' programs: where they are, and how they are brought up to date.

use super::CHAPTERS;
use crate::cli::Stop;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The file of a program.
pub(super) fn file_of(folder: &Path, program: &str) -> PathBuf {
    folder
        .join(program)
        .with_extension(std::env::consts::EXE_EXTENSION)
}

/// The folder of the chapter programs, beside this one. Under cargo they are brought up to date
/// first, as cargo built only this program; installed, they were installed together.
pub(super) fn programs() -> Result<PathBuf, Stop> {
    let this = std::env::current_exe()?;
    let folder = this.parent().unwrap_or(Path::new(".")).to_owned();
    if let (Some(cargo), Some(package)) = (
        std::env::var_os("CARGO"),
        std::env::var_os("CARGO_MANIFEST_DIR"),
    ) {
        build(Path::new(&cargo), Path::new(&package), &folder)?;
    }
    let missing = CHAPTERS
        .iter()
        .find(|chapter| !file_of(&folder, chapter.program).exists());
    match missing {
        None => Ok(folder),
        Some(chapter) => Err(Stop::Failure(format!(
            "{} is not in {}; build it there with `cargo build --release --bins`, or run \
             `cargo run --release -- tour`",
            chapter.program,
            folder.display()
        ))),
    }
}

fn build(cargo: &Path, package: &Path, folder: &Path) -> Result<(), Stop> {
    let mut command = Command::new(cargo);
    command.args(["build", "--bins"]).current_dir(package);
    if !cfg!(debug_assertions) {
        command.arg("--release");
    }
    // The profile's folder lies in the target folder, wherever the user has put that.
    if let Some(target) = folder.parent() {
        command.arg("--target-dir").arg(target);
    }
    // Cargo's output must not mix with the lines on stdout.
    let status = command
        .stdout(Stdio::null())
        .status()
        .map_err(|e| Stop::Failure(format!("{} cannot be started: {e}", cargo.display())))?;
    if status.success() {
        Ok(())
    } else {
        Err(Stop::Failure("the chapters could not be built".to_owned()))
    }
}
