//! Pictures from files, with their errors where the file knows them.

use super::{Format, OutputError};
use crate::render::Picture;
use crate::scene::image_file;
use std::path::Path;

/// The most pixels a picture may have that is read.
const MAX_PIXELS: usize = 1 << 25;

/// Reads a picture: PNG (decoded to linear light), HDR, or EXR, whose channels `error.R`, `error.G`
/// and `error.B` are standard errors, if there are any.
pub fn read(path: &Path) -> Result<Picture, OutputError> {
    let name = || path.display().to_string();
    let format = Format::of(path).ok_or_else(|| OutputError::Format(name()))?;
    let (width, pixels) =
        image_file::read(path, MAX_PIXELS).map_err(|what| OutputError::Reading(name(), what))?;
    let height = pixels.len() / width;
    let errors = match format {
        Format::Exr => errors(path, pixels.len()),
        Format::Png | Format::Hdr => None,
    };
    Ok(Picture {
        size: [width as u32, height as u32],
        values: pixels.iter().map(|p| p.channels().map(f64::from)).collect(),
        errors,
    })
}

/// The errors in an EXR file; `None` where it has none, or they are of another size.
fn errors(path: &Path, count: usize) -> Option<Vec<[f64; 3]>> {
    let (_, errors) = image_file::layer(path, "error", MAX_PIXELS).ok()??;
    let errors: Vec<[f64; 3]> = errors.iter().map(|e| e.channels().map(f64::from)).collect();
    (errors.len() == count).then_some(errors)
}
