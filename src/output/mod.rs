//! Pictures as files: PNG for the screen, EXR and HDR for the numbers.

mod exr_file;
mod hdr_file;
mod png_file;
mod read;

pub use png_file::png_bytes;
pub use read::read;

use crate::render::Film;
use crate::sampling::stream::Sampler;
use crate::scene::Scene;
use std::path::Path;

/// How values become the shades of a screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Display {
    /// Radiance: 1 is white, encoded with the sRGB curve.
    Radiance,
    /// Data such as normals: the given value is white, and shades are proportional.
    Data {
        /// The value shown as white.
        white: f64,
    },
}

/// What made a picture; written into the file where its format can hold it.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Provenance {
    /// Program and version.
    pub software: String,
    /// Name of the scene.
    pub scene: String,
    /// Name of the integrator.
    pub integrator: String,
    /// Longest path in segments.
    pub max_depth: u32,
    /// Samples per pixel that were asked for.
    pub spp: u64,
    /// The seed.
    pub seed: u64,
    /// How the samples of a pixel lie to each other.
    pub sampler: Sampler,
}

impl Provenance {
    /// What this version of the program makes of `scene`.
    pub fn new(scene: &Scene, integrator: &str, max_depth: u32, spp: u64, seed: u64) -> Self {
        Provenance {
            software: format!("halfdisk {}", env!("CARGO_PKG_VERSION")),
            scene: scene.name.clone(),
            integrator: integrator.to_owned(),
            max_depth,
            spp,
            seed,
            sampler: Sampler::Independent,
        }
    }
}

/// A file format for pictures, by the ending of the file's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// 8 bits per channel, for screens.
    Png,
    /// 32-bit floats: the picture, its standard error, its sample counts.
    Exr,
    /// Shared exponents, 8 bits of precision.
    Hdr,
}

impl Format {
    /// The format that a file's name asks for.
    pub fn of(path: &Path) -> Option<Format> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "png" => Some(Format::Png),
            "exr" => Some(Format::Exr),
            "hdr" => Some(Format::Hdr),
            _ => None,
        }
    }
}

/// Why a picture was not written.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The name has an ending no format answers to.
    #[error("{0}: pictures end in .png, .exr or .hdr")]
    Format(String),
    /// The file system refused.
    #[error("{0}: {1}")]
    File(String, std::io::Error),
    /// What is in the file is no picture.
    #[error("{0} {1}")]
    Reading(String, String),
    /// The encoder refused.
    #[error("the picture cannot be encoded as {0}: {1}")]
    Encoding(String, String),
}

/// Checks, before the work is done, that a picture can be written here; folders are made where they
/// are missing.
pub fn prepare(path: &Path) -> Result<(), OutputError> {
    let failure = |e| OutputError::File(path.display().to_string(), e);
    Format::of(path).ok_or_else(|| OutputError::Format(path.display().to_string()))?;
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(failure)?;
    }
    let is_new = !path.exists();
    let open = std::fs::OpenOptions::new()
        .append(true)
        .create(true)
        .open(path);
    open.map_err(failure)?;
    if is_new {
        std::fs::remove_file(path).map_err(failure)?;
    }
    Ok(())
}

/// Writes a picture in the format its name asks for; folders are made where they are missing.
pub fn write(
    path: &Path,
    film: &Film,
    display: Display,
    provenance: &Provenance,
) -> Result<(), OutputError> {
    let name = || path.display().to_string();
    let bytes = match Format::of(path).ok_or_else(|| OutputError::Format(name()))? {
        Format::Png => png_bytes(film, display, provenance)?,
        Format::Exr => exr_file::bytes(film, provenance)?,
        Format::Hdr => hdr_file::bytes(film)?,
    };
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|e| OutputError::File(name(), e))?;
    }
    std::fs::write(path, bytes).map_err(|e| OutputError::File(name(), e))
}
