//! Radiance HDR: three 8-bit mantissas with a shared exponent. The format holds no provenance.

use super::OutputError;
use crate::render::Film;
use image::Rgb;
use image::codecs::hdr::HdrEncoder;

/// A film as an HDR file. A pixel without a finite sample is black: the format has no NaN.
pub fn bytes(film: &Film) -> Result<Vec<u8>, OutputError> {
    let pixels: Vec<Rgb<f32>> = film
        .pixels()
        .iter()
        .map(|p| Rgb(p.mean().map_or([f32::NAN; 3], |m| m.map(|x| x as f32))))
        .collect();
    let mut bytes = Vec::new();
    HdrEncoder::new(&mut bytes)
        .encode(&pixels, film.width() as usize, film.height() as usize)
        .map_err(|e| OutputError::Encoding("HDR".to_owned(), e.to_string()))?;
    Ok(bytes)
}
