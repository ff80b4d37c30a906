//! Pictures as files: PNG for the screen, EXR and HDR for the numbers.

#[cfg_attr(not(feature = "programs"), path = "no_exr.rs")]
mod exr_file;
mod file;
mod hdr_file;
mod made;
mod parts;
mod png_file;
mod read;
#[cfg(feature = "programs")]
mod state_file;

pub use file::{can_save, save, sweep};
pub use made::made;
pub use parts::{Merged, Parts, merged};
pub use png_file::{png_bytes, shades};
pub use read::read;

use crate::render::{Film, Shard, Tally};
use crate::sampling::stream::Sampler;
use crate::scene::Scene;
use std::io;
use std::path::{Path, PathBuf};

/// How values become the shades of a screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Display {
    /// Radiance: 1 is white, encoded with the sRGB curve.
    Radiance,
    /// Radiance, brighter by so many stops: each doubles it. Only what a screen shows changes, in PNG files.
    Exposed {
        /// The stops, of either sign.
        stops: f64,
    },
    /// Data such as normals: the given value is white, and shades are proportional.
    Data {
        /// The value shown as white.
        white: f64,
    },
}

impl Display {
    /// The factor of radiance before it is encoded; `None` for data.
    fn exposure(self) -> Option<f64> {
        match self {
            Display::Radiance => Some(1.0),
            Display::Exposed { stops } => Some(libm::exp2(stops)),
            Display::Data { .. } => None,
        }
    }
}

/// The pixels of which a channel is brighter than the white of the file; `None` where the format has no white, or
/// the picture shows data.
pub fn clipped(film: &Film, display: Display, path: &Path) -> Option<usize> {
    let factor = display.exposure()?;
    let is_clipped = |mean: [f64; 3]| mean.iter().any(|x| x * factor > 1.0);
    let means = film.pixels().iter().filter_map(|pixel| pixel.mean());
    (Format::of(path)? == Format::Png).then(|| means.filter(|mean| is_clipped(*mean)).count())
}

/// What made a picture; written into the file where its format can hold it.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
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
    /// Paths from the lights in each sample of all pixels; `None` where caustics are not traced from there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light_paths: Option<u32>,
    /// The photons of a picture that has some.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub photons: Option<PhotonFacts>,
    /// The share of the picture's tiles that the file has; `None` for all.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shard: Option<Shard>,
    /// Of an average of the pictures of several seeds: all of them, the smallest first. `seed` and `command` are then
    /// those of the first picture, and `spp` counts the samples of all.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub seeds: Vec<u64>,
    /// The fingerprint of the scene: see [`Scene::fingerprint`].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fingerprint: Option<String>,
    /// The arguments of `halfdisk` that make this picture again.
    #[serde(skip_serializing_if = "Vec::is_empty", default)]
    pub command: Vec<String>,
    /// What is known of all samples together. With it an EXR file keeps the exact state of the render, from which it
    /// can go on.
    #[serde(skip)]
    pub tally: Option<Tally>,
}

/// The photons of a picture.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct PhotonFacts {
    /// Walks from the lights in each pass.
    pub walks: u32,
    /// Radius of the discs of the first pass, in scene units.
    pub first_radius: f32,
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
            light_paths: None,
            photons: None,
            shard: None,
            seeds: Vec::new(),
            fingerprint: None,
            command: Vec::new(),
            tally: None,
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

    /// The ending of its names.
    fn ending(self) -> &'static str {
        match self {
            Format::Png => "png",
            Format::Exr => "exr",
            Format::Hdr => "hdr",
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
    File(String, io::Error),
    /// The scene is made from what stands there.
    #[error("{0}: the scene needs this file, so it cannot be replaced: choose another name")]
    Needed(String),
    /// The file system refused, and so did the folder for temporary files.
    #[error(
        "{0}: {1}; nor could the picture be kept elsewhere: {2}; with --out on another disk the same \
         command renders the same picture"
    )]
    Lost(String, io::Error, Box<OutputError>),
    /// A file does not fit the others of a picture.
    #[error("{0}")]
    Part(String),
    /// What is in the file is no picture.
    #[error("{0} {1}")]
    Reading(String, String),
    /// The encoder refused.
    #[error("the picture cannot be encoded as {0}: {1}")]
    Encoding(String, String),
}

/// Checks, before the work is done, that a picture can be written here, and that the scene does not need
/// what stands here; folders are made where they are missing.
pub fn prepare(path: &Path, scene: &Scene) -> Result<(), OutputError> {
    let name = || path.display().to_string();
    Format::of(path).ok_or_else(|| OutputError::Format(name()))?;
    if scene.needs(path) {
        return Err(OutputError::Needed(name()));
    }
    can_save(path).map_err(|e| OutputError::File(name(), e))
}

/// Writes a picture in the format its name asks for; folders are made where they are missing. Where it
/// cannot be written, what stood there stays.
pub fn write(
    path: &Path,
    film: &Film,
    display: Display,
    provenance: &Provenance,
) -> Result<(), OutputError> {
    let name = || path.display().to_string();
    let format = Format::of(path).ok_or_else(|| OutputError::Format(name()))?;
    let bytes = encoded(format, film, display, provenance)?;
    save(path, &bytes).map_err(|e| OutputError::File(name(), e))
}

/// Where a picture is.
#[derive(Debug)]
pub struct Kept {
    /// Its file.
    pub path: PathBuf,
    /// Why that is not the file it should be, but one in the folder for temporary files.
    pub refused: Option<OutputError>,
}

impl Kept {
    /// What is wrong with where it is.
    pub fn complaint(&self) -> Option<String> {
        let refused = self.refused.as_ref()?;
        Some(format!(
            "{refused}; the picture is in {}",
            self.path.display()
        ))
    }
}

/// Like [`write()`], for a picture that took long: where its file cannot be written, on a full disk, the
/// picture is kept in the folder for temporary files, and if there is little room there, too, as PNG.
pub fn write_somewhere(
    path: &Path,
    film: &Film,
    display: Display,
    provenance: &Provenance,
) -> Result<Kept, OutputError> {
    let (name, error) = match write(path, film, display, provenance) {
        Ok(()) => {
            let path = path.to_owned();
            let refused = None;
            return Ok(Kept { path, refused });
        }
        // A platform without files, as the web is, has no such folder either.
        Err(OutputError::File(name, error)) if error.kind() != io::ErrorKind::Unsupported => {
            (name, error)
        }
        Err(other) => return Err(other),
    };
    let stem = path.file_stem().unwrap_or_default();
    let keep = |format| {
        let bytes = encoded(format, film, display, provenance)?;
        file::keep(stem, format.ending(), &bytes)
            .map_err(|e| OutputError::File(std::env::temp_dir().display().to_string(), e))
    };
    let wanted = Format::of(path).unwrap_or(Format::Png);
    match keep(wanted).or_else(|_| keep(Format::Png)) {
        Ok(path) => Ok(Kept {
            path,
            refused: Some(OutputError::File(name, error)),
        }),
        Err(again) => Err(OutputError::Lost(name, error, Box::new(again))),
    }
}

/// A picture as the bytes of a file.
fn encoded(
    format: Format,
    film: &Film,
    display: Display,
    provenance: &Provenance,
) -> Result<Vec<u8>, OutputError> {
    match format {
        Format::Png => png_bytes(film, display, provenance),
        Format::Exr => exr_file::bytes(film, provenance),
        Format::Hdr => hdr_file::bytes(film),
    }
}
