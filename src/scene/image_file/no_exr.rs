//! EXR images without the feature `programs`: none can be read.

use super::Pixels;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

const WHY: &str =
    "is an EXR image, and halfdisk was built without its feature `programs`, which reads them";

pub(super) fn read(_: BufReader<File>, _: usize) -> Result<Pixels, String> {
    Err(WHY.to_owned())
}

/// Reads a layer of a file: here always a complaint.
pub fn layer(_: &Path, _: &str, _: usize) -> Result<Option<Pixels>, String> {
    Err(WHY.to_owned())
}
