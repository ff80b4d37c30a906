//! What a file says of how it was made.

use super::{Format, OutputError, Provenance, exr_file, png_file};
use crate::render::State;
use std::fs;
use std::path::Path;

/// What made the picture of a PNG or EXR file, and the exact state of its render, where an EXR file has one.
///
/// A file that was not written by this program, or is damaged, is an error.
pub fn made(path: &Path) -> Result<(Provenance, Option<State>), OutputError> {
    let name = || path.display().to_string();
    let format = Format::of(path).ok_or_else(|| OutputError::Format(name()))?;
    let bytes = fs::read(path).map_err(|e| OutputError::File(name(), e))?;
    let made = match format {
        Format::Exr => exr_file::read(&bytes),
        Format::Png => png_file::provenance(&bytes).map(|made| (made, None)),
        Format::Hdr => Err("is an HDR picture, which does not say how it was made".to_owned()),
    };
    made.map_err(|what| OutputError::Reading(name(), what))
}
