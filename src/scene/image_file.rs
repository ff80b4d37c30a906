//! Images from EXR, HDR and PNG files, as linear light.

use crate::color::{Rgb, srgb_decode};
use exr::prelude::{ReadChannels, ReadLayers};
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// Reads an image: the length of a row and all pixels, row by row from the top; the error is a
/// sentence that begins with what is wrong.
pub fn read(path: &Path, max_pixels: usize) -> Result<(usize, Vec<Rgb>), String> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or("");
    let format = match extension.to_ascii_lowercase().as_str() {
        "exr" => None,
        "hdr" => Some(image::ImageFormat::Hdr),
        "png" => Some(image::ImageFormat::Png),
        _ => {
            let what = "is not an image this program reads; allowed are .exr, .hdr and .png";
            return Err(what.to_owned());
        }
    };
    let open = || File::open(path).map_err(|e| format!("cannot be opened: {e}"));
    let (width, height, pixels) = match format {
        None => read_exr(BufReader::new(open()?), max_pixels)?,
        Some(format) => {
            let size = image::ImageReader::with_format(BufReader::new(open()?), format);
            let (width, height) = size.into_dimensions().map_err(|e| complain(&e))?;
            check_size(width as usize, height as usize, max_pixels)?;
            read_other(BufReader::new(open()?), format)?
        }
    };
    check_size(width, height, max_pixels)?;
    Ok((width, pixels))
}

type Pixels = (usize, usize, Vec<Rgb>);

fn read_other(file: BufReader<File>, format: image::ImageFormat) -> Result<Pixels, String> {
    let reader = image::ImageReader::with_format(file, format);
    let image = reader.decode().map_err(|e| complain(&e))?.into_rgb32f();
    let linear = |x: f32| match format {
        image::ImageFormat::Png => srgb_decode(f64::from(x)) as f32,
        _ => x,
    };
    let pixels = image.pixels().map(|p| Rgb::from(p.0.map(linear)));
    let (width, height) = image.dimensions();
    Ok((width as usize, height as usize, pixels.collect()))
}

/// The first layer that has the channels `R`, `G` and `B`.
fn read_exr(file: BufReader<File>, max_pixels: usize) -> Result<Pixels, String> {
    let complain = |e: exr::error::Error| format!("is not a proper image: {e}");
    let mut file = file;
    let meta = exr::meta::MetaData::read_from_buffered(&mut file, false).map_err(complain)?;
    for header in &meta.headers {
        let size = header.layer_size;
        check_size(size.width(), size.height(), max_pixels)?;
    }
    std::io::Seek::rewind(&mut file).map_err(|e| format!("cannot be read: {e}"))?;
    let image = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |size, _| (size.width(), vec![Rgb::BLACK; size.width() * size.height()]),
            |(width, pixels): &mut (usize, Vec<Rgb>), at, (r, g, b): (f32, f32, f32)| {
                pixels[at.y() * *width + at.x()] = Rgb::new(r, g, b);
            },
        )
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(file)
        .map_err(complain)?;
    let layer = image.layer_data;
    let (width, pixels) = layer.channel_data.pixels;
    Ok((width, layer.size.height(), pixels))
}

fn complain(error: &image::ImageError) -> String {
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
