//! Pictures from files, with their errors where the file knows them.

use super::{Format, OutputError};
use crate::render::Picture;
use crate::scene::image_file;
use exr::prelude::*;
use std::path::Path;

/// The most pixels a picture may have that is read.
const MAX_PIXELS: usize = 1 << 25;

/// Reads a picture: PNG (decoded to linear light), HDR, or EXR, whose channels `error.R`, `error.G`
/// and `error.B` are standard errors, if there are any.
pub fn read(path: &Path) -> std::result::Result<Picture, OutputError> {
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

/// The error channels of an EXR file; `None` where it has not all three.
fn errors(path: &Path, count: usize) -> Option<Vec<[f64; 3]>> {
    let image = read_first_flat_layer_from_file(path).ok()?;
    let channel = |name: &str| -> Option<Vec<f64>> {
        let mut all = image.layer_data.channel_data.list.iter();
        let found = all.find(|c| c.name.eq(name))?;
        let values: Vec<f64> = found.sample_data.values_as_f32().map(f64::from).collect();
        (values.len() == count).then_some(values)
    };
    let [r, g, b] = ["error.R", "error.G", "error.B"].map(channel);
    let (r, g, b) = (r?, g?, b?);
    Some((0..count).map(|i| [r[i], g[i], b[i]]).collect())
}
