//! `halfdisk merge`: a picture from its shards.

use super::Stop;
use crate::lab::chapter::tell;
use crate::output::{self, Display, Provenance};
use crate::render::{Shard, State};
use clap::Args;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Put the shards of a picture together: the bytes of the picture that one render makes.
///
/// All shards have to be there, each once, whole, and of the same scene, settings and version.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub struct Merge {
    /// The files of `halfdisk render --shard`, in any order
    #[arg(required = true, value_name = "PART")]
    parts: Vec<PathBuf>,
    /// The picture: .exr with errors, counts and the exact state, .png for screens, .hdr
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

const AFTER_HELP: &str = "\
Example, of four machines that share a folder:
  halfdisk render mine.toml --spp 1024 --shard 1/4 --out part-1.exr      (2/4, 3/4, 4/4 elsewhere)
  halfdisk merge part-*.exr --out mine.exr";

/// A part, and the name of its file.
struct Part {
    file: String,
    facts: Provenance,
    shard: Shard,
    state: State,
}

impl Merge {
    pub(super) fn run(self) -> Result<(), Stop> {
        let mut parts: BTreeMap<u32, Part> = BTreeMap::new();
        let mut first: Option<(String, Provenance, [u32; 2])> = None;
        for path in &self.parts {
            let part = Part::read(path)?;
            let size = [part.state.film.width(), part.state.film.height()];
            let (file, facts, its) =
                first.get_or_insert_with(|| (part.file.clone(), part.facts.clone(), size));
            let what = match *its == size {
                true => difference(facts, &part.facts),
                false => Some("is of another size".to_owned()),
            };
            if let Some(what) = what {
                return Err(Stop::Input(format!(
                    "{}: {what} than that of {file}",
                    part.file
                )));
            }
            if let Some(other) = parts
                .values()
                .find(|other| other.shard.count != part.shard.count)
            {
                let [a, b] = [&part, other].map(|part| part.shard.count);
                let what = format!(
                    "{}: is one of {a} shards, {} one of {b}",
                    part.file, other.file
                );
                return Err(Stop::Input(what));
            }
            if let Some(same) = parts.get(&part.shard.index) {
                let what = format!(
                    "{}: is shard {}, as {} is",
                    part.file, part.shard, same.file
                );
                return Err(Stop::Input(what));
            }
            parts.insert(part.shard.index, part);
        }
        let (Some((_, facts, _)), Some(count)) =
            (first, parts.values().next().map(|part| part.shard.count))
        else {
            return Ok(());
        };
        let missing: Vec<String> = (1..=count)
            .filter(|index| !parts.contains_key(index))
            .map(|index| format!("{index}/{count}"))
            .collect();
        if !missing.is_empty() {
            return Err(Stop::Input(format!(
                "missing: the shards {}",
                missing.join(", ")
            )));
        }
        let states: Vec<State> = parts.into_values().map(|part| part.state).collect();
        let State { film, tally } = State::of_shards(&states);
        let facts = Provenance {
            tally: Some(tally),
            ..facts
        };
        let kept = output::write_somewhere(&self.out, &film, Display::Radiance, &facts)?;
        tell(format_args!(
            "wrote {} of {count} shards",
            kept.path.display()
        ));
        kept.complaint()
            .map_or(Ok(()), |what| Err(Stop::Failure(what)))
    }
}

impl Part {
    /// Reads a part that is whole.
    fn read(path: &std::path::Path) -> Result<Part, Stop> {
        let file = path.display().to_string();
        let (mut facts, state) = output::made(path)?;
        let (Some(state), Some(shard)) = (state, facts.shard.take()) else {
            let what =
                "is no shard: only files of `halfdisk render --shard I/N` can be put together";
            return Err(Stop::Input(format!("{file}: {what}")));
        };
        let has = state.spp(Some(shard));
        if u64::from(has) < facts.spp {
            return Err(Stop::Input(format!(
                "{file}: has {has} of {0} samples per pixel; halfdisk render --resume {file} --spp {0} goes on with it",
                facts.spp
            )));
        }
        // The command of the whole picture is what comes before the shard.
        facts
            .command
            .truncate(facts.command.len().saturating_sub(2));
        Ok(Part {
            file,
            facts,
            shard,
            state,
        })
    }
}

/// What one picture has other than another, if anything.
fn difference(first: &Provenance, other: &Provenance) -> Option<String> {
    let differ = [
        ("version", first.software.clone(), other.software.clone()),
        ("scene", first.scene.clone(), other.scene.clone()),
        (
            "integrator",
            first.integrator.clone(),
            other.integrator.clone(),
        ),
        ("seed", first.seed.to_string(), other.seed.to_string()),
        (
            "number of samples",
            first.spp.to_string(),
            other.spp.to_string(),
        ),
        (
            "longest path",
            first.max_depth.to_string(),
            other.max_depth.to_string(),
        ),
    ];
    if let Some((name, a, b)) = differ.into_iter().find(|(_, a, b)| a != b) {
        return Some(format!("has another {name}, {b} rather than {a},"));
    }
    if first.fingerprint != other.fingerprint {
        return Some("is of another state of the scene".to_owned());
    }
    (first != other).then(|| {
        let [a, b] = [first, other].map(|facts| facts.command.join(" "));
        format!("has other settings, `{b}` rather than `{a}`,")
    })
}
