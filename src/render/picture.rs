//! A picture as numbers: values, and their errors where they are known.

use super::{Film, Pixel};

/// What is left of a film when only values and errors count; also what a file of an image holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Red, green, blue of each pixel, linear, row by row from the top.
    pub values: Vec<[f64; 3]>,
    /// The standard error of each value, where it is known.
    pub errors: Option<Vec<[f64; 3]>>,
}

impl From<&Film> for Picture {
    /// Pixels without a sample are NaN.
    fn from(film: &Film) -> Self {
        let error = |p: &Pixel| p.channels.map(|c| c.std_error());
        let pixels = film.pixels();
        Picture {
            size: [film.width(), film.height()],
            values: pixels
                .iter()
                .map(|p| p.mean().unwrap_or([f64::NAN; 3]))
                .collect(),
            errors: Some(pixels.iter().map(error).collect()),
        }
    }
}

impl Picture {
    /// The mean over all pixels and channels, and its standard error: pixels are independent, the
    /// channels of each share their samples and count as fully correlated.
    pub fn mean(&self) -> (f64, Option<f64>) {
        let n = self.values.len() as f64;
        let third = |p: &[f64; 3]| p.iter().sum::<f64>() / 3.0;
        let mean = self.values.iter().map(third).sum::<f64>() / n;
        let error = self.errors.as_ref().map(|errors| {
            let squares: f64 = errors.iter().map(|p| third(p).powi(2)).sum();
            squares.sqrt() / n
        });
        (mean, error)
    }
}
