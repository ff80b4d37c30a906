//! Images from EXR, HDR and PNG files, as linear light.

mod hdr;
#[cfg_attr(not(feature = "programs"), path = "no_exr.rs")]
mod open_exr;

pub use open_exr::layer;

use crate::color::{Rgb, srgb_decode};
use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

/// An image: the length of a row, and all pixels, row by row from the top.
pub type Pixels = (usize, Vec<Rgb>);

/// Reads an image; the error is a sentence that begins with what is wrong.
pub fn read(path: &Path, max_pixels: usize) -> Result<Pixels, String> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("");
    let read_kind = match extension.to_ascii_lowercase().as_str() {
        "exr" => open_exr::read,
        "hdr" => hdr::read,
        "png" => read_png,
        _ => {
            let what = "is not an image this program reads; allowed are .exr, .hdr and .png";
            return Err(what.to_owned());
        }
    };
    read_kind(open(path)?, max_pixels)
}

fn open(path: &Path) -> Result<BufReader<File>, String> {
    let file = File::open(path).map_err(|e| format!("cannot be opened: {e}"))?;
    Ok(BufReader::new(file))
}

fn read_png(mut file: BufReader<File>, max_pixels: usize) -> Result<Pixels, String> {
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)
        .map_err(|e| format!("cannot be read: {e}"))?;
    let reader = || {
        let bytes = std::io::Cursor::new(&bytes);
        image::ImageReader::with_format(bytes, image::ImageFormat::Png)
    };
    let (width, height) = reader().into_dimensions().map_err(|e| complain(&e))?;
    check_size(width as usize, height as usize, max_pixels)?;
    let image = reader().decode().map_err(|e| complain(&e))?.into_rgb32f();
    let linear = |x: f32| srgb_decode(f64::from(x)) as f32;
    let pixels = image.pixels().map(|p| Rgb::from(p.0.map(linear)));
    Ok((width as usize, pixels.collect()))
}

fn complain(error: &dyn std::fmt::Display) -> String {
    format!("is not a proper image: {error}")
}

fn check_size(width: usize, height: usize, max_pixels: usize) -> Result<(), String> {
    match width.checked_mul(height) {
        Some(0) => Err("has no pixels".to_owned()),
        Some(count) if count <= max_pixels => Ok(()),
        _ => Err(format!(
            "must have at most {max_pixels} pixels in all, not {width} x {height}"
        )),
    }
}
