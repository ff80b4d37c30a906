//! Renders that take long: in several runs, on several machines.

use super::Stop;
use super::stop::time;
use crate::lab::chapter::tell;
use crate::output::{self, Format};
use crate::render::Shard;
use clap::Args;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// In how many runs, and on how many machines, a picture is made.
#[derive(Clone, Debug, Args)]
pub(super) struct Long {
    /// Go on with the render whose picture this .exr file holds, with its settings, to --spp, --target-error or
    /// --time: to the bytes of a render that never stopped. SCENE only where its file has moved; --out is this file
    #[arg(long, help_heading = HEADING, value_name = "FILE", conflicts_with_all = SETTINGS)]
    pub resume: Option<PathBuf>,
    /// Write what there is so often, such as every 5m, to --out FILE.exr: whatever stops the machine, --resume goes
    /// on from there
    #[arg(long, help_heading = HEADING, value_name = "TIME", value_parser = time)]
    pub checkpoint: Option<Duration>,
    /// Render only share I of N of the picture's tiles, to --out FILE.exr; `halfdisk merge` puts them together, to the
    /// bytes of the whole picture. Each shard traces all paths from the lights: 8 shards of `caustic` take 2.8 times the
    /// work of one render, by `light-tracer` 5.2 times. There, divide the samples: --seed, and `merge --seeds`
    #[arg(long, help_heading = HEADING, value_name = "I/N", conflicts_with_all = ["target_error", "time", "files", "maps"])]
    pub shard: Option<Shard>,
}

const HEADING: &str = "Long renders";

/// The settings that a file has already: none of them may be given again.
const SETTINGS: [&str; 15] = [
    "integrator",
    "max_depth",
    "sampler",
    "size",
    "seed",
    "light_paths",
    "patches",
    "patch_size",
    "photons",
    "radius",
    "files",
    "paths",
    "without",
    "all_effects",
    "shard",
];

impl Long {
    /// Removes what was left by a render of this picture that was killed while it wrote.
    pub fn sweep(&self, path: &Path) {
        if self.resume.is_none() && self.checkpoint.is_none() {
            return;
        }
        if let Err(what) = output::sweep(path) {
            tell(format_args!("note: {}: {what}", path.display()));
        }
    }

    /// Only some files can be gone on with, or put together.
    pub fn check(&self, path: &Path) -> Result<(), Stop> {
        let said = match (self.checkpoint, self.shard) {
            (Some(_), _) => "--checkpoint: only .exr files can be gone on with",
            (_, Some(_)) => "--shard: only .exr files can be put together",
            _ => return Ok(()),
        };
        match Format::of(path) {
            Some(Format::Exr) => Ok(()),
            _ => Err(Stop::Input(format!(
                "{said}, not {}: --out FILE.exr",
                path.display()
            ))),
        }
    }
}
