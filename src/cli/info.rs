//! `halfdisk info`: what a picture says of how it was made.

use super::Stop;
use super::answer::answer;
use crate::output::{self, Provenance};
use clap::Args;
use serde::Serialize;
use std::fmt::{self, Display, Formatter};
use std::path::PathBuf;

/// Say how a picture was made, and print the command that makes it again.
#[derive(Debug, Args)]
pub struct Info {
    /// A .png or .exr file that halfdisk wrote
    file: PathBuf,
    /// Print it as JSON
    #[arg(long)]
    json: bool,
}

/// What a file says.
#[derive(Serialize)]
struct Made {
    file: String,
    facts: Provenance,
    /// The size in pixels, where the file has the state of the render.
    size: Option<[u32; 2]>,
    /// The samples that every pixel has; `None` where the file does not say.
    complete_spp: Option<u64>,
}

impl Info {
    pub(super) fn run(self) -> Result<(), Stop> {
        let (facts, state) = output::made(&self.file)?;
        let state = state.as_ref();
        let made = Made {
            file: self.file.display().to_string(),
            size: state.map(|state| [state.film.width(), state.film.height()]),
            complete_spp: state.map(|state| u64::from(state.spp(facts.shard)).min(facts.spp)),
            facts,
        };
        answer(&made, self.json)
    }
}

impl Display for Made {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let Made { file, facts, .. } = self;
        let Provenance {
            software,
            scene,
            integrator,
            max_depth,
            spp,
            seed,
            ..
        } = facts;
        writeln!(f, "{file}: {scene} by {integrator}, made by {software}")?;
        writeln!(
            f,
            "{spp} samples per pixel, seed {seed}, paths of at most {max_depth} segments"
        )?;
        if let Some(shard) = facts.shard {
            writeln!(
                f,
                "shard {shard}: a part of the picture, for halfdisk merge"
            )?;
        }
        if !facts.seeds.is_empty() {
            let count = facts.seeds.len();
            let seeds = ranges(&facts.seeds);
            writeln!(
                f,
                "average of {count} pictures, of the seeds {seeds}: all their samples"
            )?;
        }
        if let Some(fingerprint) = &facts.fingerprint {
            writeln!(f, "fingerprint of the scene: {fingerprint}")?;
        }
        if let Some(complete) = self.complete_spp {
            let is_whole = complete >= *spp;
            if !is_whole {
                writeln!(
                    f,
                    "interrupted: every pixel has {complete} samples at least"
                )?;
            }
            let more = if is_whole { 4 * spp } else { *spp };
            let file = quoted(file);
            writeln!(
                f,
                "goes on by: halfdisk render --resume {file} --spp {more}"
            )?;
        }
        match facts.command.is_empty() {
            true => writeln!(f, "the command that made it is not known"),
            false => {
                let words: Vec<String> = facts.command.iter().map(|word| quoted(word)).collect();
                let what = match facts.seeds.is_empty() {
                    true => "made again by",
                    false => "its first picture is made again by",
                };
                writeln!(f, "{what}: halfdisk {}", words.join(" "))
            }
        }
    }
}

/// Rising numbers, those that follow on each other as `first-last`.
fn ranges(numbers: &[u64]) -> String {
    let runs = numbers.chunk_by(|a, b| a.checked_add(1) == Some(*b));
    let text = |run: &[u64]| match run {
        [one] => one.to_string(),
        _ => format!("{}-{}", run[0], run[run.len() - 1]),
    };
    runs.map(text).collect::<Vec<_>>().join(", ")
}

/// A word as a shell reads it.
fn quoted(word: &str) -> String {
    // A word with a NUL byte is none that a shell could have passed on.
    shlex::try_quote(word).map_or_else(|_| word.to_owned(), |quoted| quoted.into_owned())
}
