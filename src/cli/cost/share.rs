//! Shares of the replicates of `halfdisk cost`.

use crate::cli::shares::{self, Share};
use crate::cli::{Stop, check_folder};
use crate::lab::chapter::tell;
use crate::lab::experiment::cost::{Measured, Method};
use crate::render::Shard;
use crate::scene::Scene;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// What all shares of a measurement have in common.
#[derive(PartialEq, Serialize, Deserialize)]
pub(super) struct Shared {
    /// That of the scene at the size that is measured.
    pub fingerprint: Option<String>,
    pub size: [u32; 2],
    pub replicates: u32,
    pub seed: u64,
    /// Of each method's largest picture.
    pub rays: u64,
    pub methods: Vec<Method>,
}

/// Writes a share, which is whole or not there.
pub(super) fn write(
    folder: &Path,
    shard: Shard,
    shared: Shared,
    measured: Measured,
) -> Result<(), Stop> {
    if measured.interrupted {
        tell("interrupted: a share is whole or not there, so nothing is written");
        return Err(Stop::Interrupted);
    }
    check_folder(folder)?;
    let path = shares::file(&folder.join("cost"), shard);
    Share::write(&path, shard, shared, measured)?;
    tell(format_args!("wrote {}", path.display()));
    Ok(())
}

/// What all shares of a scene gave together.
pub(super) fn merged(
    name: &str,
    scene: &Scene,
    files: &[PathBuf],
) -> Result<(Shared, Measured), Stop> {
    let (shared, shares) = Share::<Shared, Measured>::read_all(files)?;
    let scene = scene.clone().sized(shared.size);
    if scene.fingerprint().ok() != shared.fingerprint {
        let what = format!("the shares are of another scene than {name}, or it has changed");
        return Err(Stop::Input(what));
    }
    let measured = Measured::joined(shares).filter(|m| m.replicates == shared.replicates);
    let unlike = "the shares differ in their sizes or their reference: were they made by machines of different kinds?";
    let measured = measured.ok_or_else(|| Stop::Input(unlike.to_owned()))?;
    Ok((shared, measured))
}
