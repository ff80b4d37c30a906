//! The replicates of a measurement, made in shares: a file for each.

use super::answer::to_json;
use super::{Stop, save};
use crate::render::Shard;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Every n-th replicate of a measurement.
#[derive(Serialize, Deserialize)]
pub(super) struct Share<Design, Runs> {
    /// Program and version.
    software: String,
    /// Which replicates it has: the first, and then each that comes so many later.
    shard: Shard,
    /// What is measured: the same in all shares.
    design: Design,
    /// What was measured.
    runs: Runs,
    /// SHA-256 of the rest.
    checksum: String,
}

fn software() -> String {
    format!("halfdisk {}", env!("CARGO_PKG_VERSION"))
}

impl<Design, Runs> Share<Design, Runs>
where
    Design: Serialize + DeserializeOwned + PartialEq,
    Runs: Serialize + DeserializeOwned,
{
    /// Writes a share. JSON has no infinity, so a number that is not finite is an error.
    pub fn write(path: &Path, shard: Shard, design: Design, runs: Runs) -> Result<(), Stop> {
        let mut share = Share {
            software: software(),
            shard,
            design,
            runs,
            checksum: String::new(),
        };
        share.checksum = share.sum()?;
        let text = to_json(&share)?;
        // What reads as something else is no share.
        Self::parse(text.as_bytes()).map_err(|what| {
            let path = path.display();
            Stop::Failure(format!("{path}: a number of it is not finite: {what}"))
        })?;
        save(path, text)
    }

    /// The design, and the runs of all shares in the order of their numbers.
    pub fn read_all(paths: &[PathBuf]) -> Result<(Design, Vec<Runs>), Stop> {
        let mut first: Option<(String, u32, Design)> = None;
        let mut all: BTreeMap<u32, (String, Runs)> = BTreeMap::new();
        for path in paths {
            let name = path.display().to_string();
            let refuse = |what: String| Stop::Input(format!("{name}: {what}"));
            let bytes = std::fs::read(path).map_err(|e| refuse(e.to_string()))?;
            let share = Self::parse(&bytes).map_err(refuse)?;
            let Shard { index, count } = share.shard;
            match &first {
                None => first = Some((name.clone(), count, share.design)),
                Some((file, _, design)) if *design != share.design => {
                    return Err(refuse(format!("measures something else than {file}")));
                }
                Some((file, n, _)) if *n != count => {
                    return Err(refuse(format!(
                        "is one of {count} shares, {file} one of {n}"
                    )));
                }
                Some(_) => {}
            }
            if let Some((file, _)) = all.get(&index) {
                return Err(refuse(format!("is share {}, as {file} is", share.shard)));
            }
            all.insert(index, (name, share.runs));
        }
        let Some((_, count, design)) = first else {
            return Err(Stop::Input("there are no shares".to_owned()));
        };
        let missing: Vec<String> = (1..=count)
            .filter(|index| !all.contains_key(index))
            .map(|index| format!("{index}/{count}"))
            .collect();
        match missing.is_empty() {
            true => Ok((design, all.into_values().map(|(_, runs)| runs).collect())),
            false => Err(Stop::Input(format!(
                "missing: the shares {}",
                missing.join(", ")
            ))),
        }
    }

    fn parse(bytes: &[u8]) -> Result<Self, String> {
        let share: Self = serde_json::from_slice(bytes)
            .map_err(|e| format!("is no share of this command: {e}"))?;
        let version = software();
        if share.software != version {
            let theirs = share.software;
            return Err(format!("was made by {theirs}, and this is {version}"));
        }
        match share.sum() {
            Ok(sum) if sum == share.checksum => Ok(share),
            _ => Err("is damaged: it does not fit its checksum".to_owned()),
        }
    }

    fn sum(&self) -> Result<String, serde_json::Error> {
        let all = (&self.software, self.shard, &self.design, &self.runs);
        let mut hash = Sha256::new();
        hash.update(serde_json::to_vec(&all)?);
        let digits = hash.finalize();
        Ok(digits.iter().map(|byte| format!("{byte:02x}")).collect())
    }
}

/// The file of a share beside others of one name.
pub(super) fn file(name: &Path, shard: Shard) -> PathBuf {
    super::with_ending(name, &format!("-{}-of-{}.json", shard.index, shard.count))
}
