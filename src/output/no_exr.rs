//! EXR pictures without the feature `programs`: there are none.

use super::{OutputError, Provenance};
use crate::render::{Film, State};
use std::path::Path;

const WHY: &str = "halfdisk was built without its feature `programs`";

pub(super) fn bytes(_: &Film, _: &Provenance) -> Result<Vec<u8>, OutputError> {
    Err(OutputError::Encoding("EXR".to_owned(), WHY.to_owned()))
}

pub(super) fn facts(path: &Path) -> Result<(Provenance, Option<[u32; 2]>), OutputError> {
    let what = format!("is an EXR picture, and {WHY}");
    Err(OutputError::Reading(path.display().to_string(), what))
}

/// As with the feature.
pub(super) type Packed = (State, Option<[u32; 2]>);

pub(super) fn read_packed(_: &[u8]) -> Result<(Provenance, Option<Packed>), String> {
    Err(format!("is an EXR picture, and {WHY}"))
}

pub(super) fn read(_: &[u8]) -> Result<(Provenance, Option<State>), String> {
    Err(format!("is an EXR picture, and {WHY}"))
}
