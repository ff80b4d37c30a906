//! `halfdisk merge`: a picture from its parts.

use super::Stop;
use super::picture::display;
use crate::integrators;
use crate::lab::chapter::tell;
use crate::output::{self, Format, Merged, OutputError, Parts};
use crate::render::accuracy::{Accuracy, Measure};
use crate::render::stopping::percent;
use clap::Args;
use std::path::PathBuf;

/// Put the parts of a picture together.
///
/// Shards become the picture of one render, bit for bit. All of them have to be there, each once, whole, and of the same
/// scene, settings and version.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub struct Merge {
    /// The files of `halfdisk render --shard`, in any order; with --seeds, .exr files of different seeds
    #[arg(required = true, value_name = "PART")]
    parts: Vec<PathBuf>,
    /// Average whole pictures that differ in nothing but their --seed: all their samples in one picture. The same bytes
    /// in any order of the files, though not those of one render; --resume cannot go on from it
    #[arg(long)]
    seeds: bool,
    /// The picture: .exr with errors and counts, of shards also with the exact state; .png for screens, .hdr
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

const AFTER_HELP: &str = "\
Four machines that share a folder:
  halfdisk render mine.toml --spp 1024 --shard 1/4 --out part-1.exr      (2/4, 3/4, 4/4 elsewhere)
  halfdisk merge part-*.exr --out mine.exr

A class, each with a number of their own:
  halfdisk render mine.toml --spp 64 --seed 17 --out seed-17.exr
  halfdisk merge --seeds seed-*.exr --out mine.exr

Pictures on Slurm, GNU parallel and others: examples/cluster";

impl Merge {
    pub(super) fn run(self) -> Result<(), Stop> {
        // Before the work, as everywhere.
        let name = || self.out.display().to_string();
        Format::of(&self.out).ok_or_else(|| OutputError::Format(name()))?;
        output::can_save(&self.out).map_err(|e| OutputError::File(name(), e))?;
        let parts = match self.seeds {
            true => Parts::Seeds,
            false => Parts::Shards,
        };
        let Merged {
            film,
            facts,
            parts,
            mean,
        } = output::merged(&self.parts, parts)?;
        let shown = integrators::find(&facts.integrator).map(|entry| display(entry, &film));
        let shown = shown.unwrap_or(output::Display::Radiance);
        let kept = output::write_somewhere(&self.out, &film, shown, &facts)?;
        let file = kept.path.display();
        match mean {
            None => tell(format_args!("wrote {file} of {parts} shards")),
            Some(mean) => tell(format_args!(
                "wrote {file} of {parts} seeds: {} samples per pixel, noise {}, mean {:.5} ± {:.5}",
                facts.spp,
                percent(Accuracy::of(&film).error(Measure::RootMeanSquare)),
                mean.value,
                mean.error,
            )),
        }
        kept.complaint()
            .map_or(Ok(()), |what| Err(Stop::Failure(what)))
    }
}
