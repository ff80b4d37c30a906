//! PNG: eight bits per channel, with the picture's provenance as text.

use super::{Display, OutputError, Provenance};
use crate::color::{quantise, srgb_encode};
use crate::render::{Film, Pixel};
use std::io::Cursor;

/// The colour of pixels that have not a single finite sample: magenta, which no one overlooks.
const NO_SAMPLE: [u8; 3] = [255, 0, 255];

/// A film as a PNG file. The same film gives the same bytes.
pub fn png_bytes(
    film: &Film,
    display: Display,
    provenance: &Provenance,
) -> Result<Vec<u8>, OutputError> {
    encode(film, display, provenance).map_err(|e| OutputError::Encoding("PNG".to_owned(), e))
}

/// The shades in which a PNG file shows a film, pixel by pixel.
pub fn shades(film: &Film, display: Display) -> Vec<[u8; 3]> {
    film.pixels().iter().map(|p| shade(p, display)).collect()
}

fn encode(film: &Film, display: Display, provenance: &Provenance) -> Result<Vec<u8>, String> {
    let pixels = shades(film, display).concat();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, film.width(), film.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    if display.exposure().is_some() {
        encoder.set_source_srgb(png::SrgbRenderingIntent::RelativeColorimetric);
    }
    let facts = serde_json::to_string(provenance).map_err(|e| e.to_string())?;
    for (key, text) in [
        ("Software", provenance.software.clone()),
        ("Title", provenance.scene.clone()),
        ("halfdisk", facts),
    ] {
        encoder
            .add_itxt_chunk(key.to_owned(), text)
            .map_err(|e| e.to_string())?;
    }
    let mut writer = encoder.write_header().map_err(|e| e.to_string())?;
    writer
        .write_image_data(&pixels)
        .map_err(|e| e.to_string())?;
    writer.finish().map_err(|e| e.to_string())?;
    Ok(bytes)
}

/// What made the picture of a PNG file.
pub(super) fn provenance(bytes: &[u8]) -> Result<Provenance, String> {
    let reader = png::Decoder::new(Cursor::new(bytes)).read_info();
    let reader = reader.map_err(|e| format!("is no PNG picture that can be read: {e}"))?;
    let mut texts = reader.info().utf8_text.iter();
    let text = texts
        .find(|text| text.keyword == "halfdisk")
        .ok_or("was not written by halfdisk")?;
    let text = text.get_text().map_err(|e| e.to_string())?;
    serde_json::from_str(&text)
        .map_err(|e| format!("was written by another version of halfdisk: {e}"))
}

fn shade(pixel: &Pixel, display: Display) -> [u8; 3] {
    let Some(mean) = pixel.mean() else {
        return NO_SAMPLE;
    };
    mean.map(|x| match display {
        Display::Radiance => quantise(srgb_encode(x)),
        Display::Exposed { stops } => quantise(srgb_encode(x * libm::exp2(stops))),
        Display::Data { white } if white > 0.0 => quantise(x / white),
        Display::Data { .. } => 0,
    })
}
