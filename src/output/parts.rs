//! One picture from several files.

use super::exr_file::Packed;
use super::{Format, OutputError, Provenance, exr_file, made};
use crate::render::{Film, Shard, State, Tally, known_mean};
use crate::stats::{Estimate, Measurement};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// What the files are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parts {
    /// The shards of one picture.
    Shards,
    /// Whole pictures of different seeds, all of as many samples.
    Seeds,
}

/// A picture that was put together.
#[derive(Clone, Debug)]
pub struct Merged {
    /// The picture.
    pub film: Film,
    /// What made it. Of shards with the state of the render that never was in parts; of seeds without a state, for
    /// no single render goes on from there.
    pub facts: Provenance,
    /// How many parts it has.
    pub parts: usize,
    /// Of seeds: the mean of the picture and its standard error. Light of one path may come to many pixels, so where the
    /// means of the parts scatter more than independent pixels would, that counts.
    pub mean: Option<Measurement>,
}

/// The picture of all shards of a render, bit for bit, or the average of the pictures of several seeds; the same in any
/// order of the files.
///
/// Shards are copied. The pixels of seeds are merged one after the other in the order of their seeds (see
/// [`Estimate::merge`]): sums in `f64` are not associative, and this order is one that the files themselves tell. Two
/// pictures are in memory at a time.
///
/// # Errors
///
/// Names the first file that cannot be read or is damaged; is unfinished; is no such part; was made by another version or of
/// another scene, size, integrator or setting than the first one; is there twice; or else the shards that are missing.
pub fn merged(files: &[PathBuf], parts: Parts) -> Result<Merged, OutputError> {
    let mut all: Vec<Part> = Vec::new();
    for path in files {
        let part = Part::of(path, parts)?;
        if let Some(problem) = all.first().and_then(|first| part.differs(first)) {
            return Err(part.refuse_whole(problem));
        }
        all.push(part);
    }
    all.sort_by_key(|part| part.number);
    for pair in all.windows(2) {
        if let Some(problem) = pair[1].repeats(&pair[0]) {
            return Err(pair[1].refuse_whole(problem));
        }
    }
    let Some((first, others)) = all.split_first() else {
        return Err(OutputError::Part("there are no parts".to_owned()));
    };
    first.alone(&all, parts)?;
    let sampler = first.facts.sampler;
    let mut whole = first.read()?;
    let mut means = Estimate::new();
    match first.shard {
        Some(shard) => {
            let mut film = Film::empty(first.size);
            film.unpack(&whole.film, shard);
            whole.film = film;
        }
        None => means.add(whole.film.mean().0),
    }
    for part in others {
        let state = part.read()?;
        match part.shard {
            Some(shard) => whole.add_shard(&state, shard),
            None => {
                means.add(state.film.mean().0);
                whole.add_seed(&state, sampler);
            }
        }
    }
    let State { film, tally } = whole;
    let mut facts = first.facts.clone();
    let mean = match parts {
        Parts::Shards => {
            facts.command = first.whole_command().to_vec();
            facts.shard = None;
            facts.tally = Some(tally);
            None
        }
        Parts::Seeds => {
            facts.spp = facts.spp.saturating_mul(all.len() as u64);
            facts.seeds = all.iter().map(|part| part.facts.seed).collect();
            let Tally { rays, .. } = tally;
            Some(known_mean(&film, means.std_error(), &rays))
        }
    };
    Ok(Merged {
        film,
        facts,
        parts: all.len(),
        mean,
    })
}

/// A file and what its head says.
struct Part {
    path: PathBuf,
    facts: Provenance,
    size: [u32; 2],
    shard: Option<Shard>,
    /// That of its shard, or its seed: no other part has it.
    number: u64,
}

impl Part {
    /// What the head of a file says, which is far shorter than the file.
    fn of(path: &Path, parts: Parts) -> Result<Part, OutputError> {
        let said = match Format::of(path) {
            Some(Format::Exr) => exr_file::facts(path)?,
            _ => (made(path)?.0, None),
        };
        let (facts, size) = said;
        let refuse = |what: &str| {
            let what = format!("{}: {what}", path.display());
            Err(OutputError::Part(what))
        };
        if !facts.seeds.is_empty() {
            return refuse(
                "is an average of several seeds already: merge the pictures of all seeds",
            );
        }
        let shard = facts.shard;
        let number = match (parts, shard) {
            (Parts::Shards, Some(shard)) => shard.index.into(),
            (Parts::Seeds, None) => facts.seed,
            (Parts::Shards, None) => {
                return refuse(
                    "is no shard: only files of `halfdisk render --shard I/N` can be put together",
                );
            }
            (Parts::Seeds, Some(_)) => {
                return refuse("is a shard: put those of its seed together first");
            }
        };
        let Some(size) = size else {
            return refuse(
                "says no more than the picture: only .exr files of `halfdisk render` can be merged",
            );
        };
        Ok(Part {
            path: path.to_owned(),
            facts,
            size,
            shard,
            number,
        })
    }

    fn refuse(&self, what: String) -> OutputError {
        OutputError::Part(format!("{}: {what}", self.path.display()))
    }

    /// The same for what its head says, unless the file is damaged: then that is what there is to say.
    fn refuse_whole(&self, what: String) -> OutputError {
        made(&self.path).err().unwrap_or_else(|| self.refuse(what))
    }

    /// Why it is not a part of the same picture as another one, if so.
    fn differs(&self, other: &Part) -> Option<String> {
        let file = other.path.display();
        let difference = match self.size == other.size {
            true => self.difference(other),
            false => Some("is of another size".to_owned()),
        };
        if let Some(what) = difference {
            return Some(format!("{what} than that of {file}"));
        }
        let [a, b] = [self.shard, other.shard].map(|shard| shard.map_or(0, |shard| shard.count));
        (a != b).then(|| format!("is one of {a} shards, {file} one of {b}"))
    }

    /// Why it is the same part as another one, if so.
    fn repeats(&self, other: &Part) -> Option<String> {
        let file = other.path.display();
        let same = match self.shard {
            Some(shard) => format!("is shard {shard}, as {file} is"),
            None => format!("has seed {}, as {file} has", self.number),
        };
        (self.number == other.number).then_some(same)
    }

    /// What it has other than another part, if anything.
    fn difference(&self, other: &Part) -> Option<String> {
        let [own, its] = [self, other].map(Part::common);
        let texts = |f: &Provenance| {
            [
                ("version", f.software.clone()),
                ("scene", f.scene.clone()),
                ("integrator", f.integrator.clone()),
                ("seed", f.seed.to_string()),
                ("number of samples", f.spp.to_string()),
                ("longest path", f.max_depth.to_string()),
            ]
        };
        let mut pairs = texts(&own).into_iter().zip(texts(&its));
        if let Some(((name, a), (_, b))) = pairs.find(|(a, b)| a != b) {
            return Some(format!("has another {name}, {a} rather than {b},"));
        }
        if own.fingerprint != its.fingerprint {
            return Some("is of another state of the scene".to_owned());
        }
        (own != its).then(|| {
            let [a, b] = [self, other].map(|part| part.facts.command.join(" "));
            format!("has other settings, `{a}` rather than `{b}`,")
        })
    }

    /// What all parts of a picture have in common.
    fn common(&self) -> Provenance {
        let mut facts = self.facts.clone();
        facts.command = self.whole_command().to_vec();
        // Whose fingerprint is known may lie elsewhere on another machine.
        if let (Some(_), Some(path)) = (&facts.fingerprint, facts.command.get_mut(1)) {
            path.clear();
        }
        if facts.shard.take().is_none() {
            facts.seed = 0;
            let mut words = facts.command.iter_mut();
            words.by_ref().find(|word| *word == "--seed");
            words.next().into_iter().for_each(String::clear);
        }
        facts
    }

    /// The command of the whole picture: what comes before the shard.
    fn whole_command(&self) -> &[String] {
        let command = &self.facts.command;
        let shard = 2 * usize::from(self.shard.is_some());
        &command[..command.len().saturating_sub(shard)]
    }

    /// Refuses, as the first of all parts, gaps and what is too little.
    fn alone(&self, all: &[Part], parts: Parts) -> Result<(), OutputError> {
        let Some(Shard { count, .. }) = self.shard else {
            let only = parts == Parts::Seeds && all.len() == 1;
            let what = "is the only one: an average takes pictures of two seeds at least";
            return match only {
                true => Err(self.refuse(what.to_owned())),
                false => Ok(()),
            };
        };
        let there: BTreeSet<u64> = all.iter().map(|part| part.number).collect();
        let missing: Vec<String> = (1..=count)
            .filter(|&index| !there.contains(&index.into()))
            .map(|index| format!("{index}/{count}"))
            .collect();
        if missing.is_empty() {
            return Ok(());
        }
        for part in all {
            made(&part.path)?;
        }
        let missing = missing.join(", ");
        Err(OutputError::Part(format!("missing: the shards {missing}")))
    }

    /// Its state, which is whole; of a shard with its film packed.
    fn read(&self) -> Result<State, OutputError> {
        let name = || self.path.display().to_string();
        let bytes = fs::read(&self.path).map_err(|e| OutputError::File(name(), e))?;
        let read = exr_file::read_packed(&bytes);
        let (facts, state) = read.map_err(|what| OutputError::Reading(name(), what))?;
        let same = |(state, picture): &Packed| {
            facts == self.facts && picture.unwrap_or(state.size()) == self.size
        };
        let Some((state, _)) = state.filter(same) else {
            return Err(self.refuse("was replaced while it was read".to_owned()));
        };
        let has = match self.shard {
            None => state.spp(None),
            Some(shard) => state.packed_spp(shard, self.size),
        };
        let spp = facts.spp;
        if u64::from(has) < spp {
            let file = self.path.display();
            return Err(self.refuse(format!(
                "has {has} of {spp} samples per pixel; halfdisk render --resume {file} --spp {spp} goes on with it"
            )));
        }
        Ok(state)
    }
}
