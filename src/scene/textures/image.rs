//! Images as textures.

use crate::color::Rgb;
use crate::materials::Texture;
use crate::scene::value::{Positive, Repeat};
use glam::{DVec2, Vec2};
use serde::Deserialize;
use std::path::PathBuf;
use std::sync::Arc;

/// An image that repeats itself in both directions, as a file describes it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Image {
    /// `.exr`, `.hdr` or `.png`, relative to the scene file.
    pub file: PathBuf,
    /// How often it is repeated from 0 to 1 along `u` and along `v`.
    #[serde(default)]
    pub repeat: Repeat,
    /// A factor for its values.
    pub scale: Option<Positive>,
}

/// An image that repeats itself in both directions, linearly interpolated between the middles of its
/// pixels.
#[derive(Clone, Debug)]
pub struct ImageTexture {
    pixels: Arc<[Rgb]>,
    width: usize,
    height: usize,
    /// How often the image is repeated from 0 to 1 along `u` and along `v`.
    repeat: DVec2,
    brightest: Rgb,
}

impl ImageTexture {
    /// The image of these pixels, row by row, the upper row first; `None` where they are not at least one
    /// full row.
    ///
    /// * `repeat`: how often it is repeated from 0 to 1 along `u` and along `v`.
    pub fn new(width: usize, pixels: impl Into<Arc<[Rgb]>>, repeat: DVec2) -> Option<Self> {
        let pixels = pixels.into();
        let height = pixels.len().checked_div(width)?;
        (height > 0 && pixels.len() == width * height).then(|| ImageTexture {
            brightest: pixels.iter().fold(Rgb::BLACK, |a, b| a.max(*b)),
            pixels,
            width,
            height,
            repeat,
        })
    }

    fn pixel(&self, column: usize, row: usize) -> Rgb {
        self.pixels[row % self.height * self.width + column % self.width]
    }
}

impl Texture for ImageTexture {
    fn color(&self, uv: Vec2) -> Rgb {
        // Rows run downwards. Half a pixel less is the distance from the middle of the first one.
        let place = |x: f64, size: usize| {
            let size = size as f64;
            let x = (x - x.floor()) * size - 0.5;
            let low = x.floor();
            ((low + size) as usize, (x - low) as f32)
        };
        let [u, v] = (uv.as_dvec2() * self.repeat).to_array();
        let ((column, s), (row, t)) = (place(u, self.width), place(-v, self.height));
        let along = |row| {
            let (left, right) = (self.pixel(column, row), self.pixel(column + 1, row));
            left * (1.0 - s) + right * s
        };
        let color = along(row) * (1.0 - t) + along(row + 1) * t;
        // Never more than rounding adds: a surface makes no light.
        color.min(self.brightest)
    }

    fn brightest(&self) -> Rgb {
        self.brightest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_image_stands_upright_repeats_itself_and_is_itself_in_the_middle_of_its_pixels() {
        let colors = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6].map(Rgb::grey);
        let image = ImageTexture::new(3, colors.to_vec(), DVec2::ONE).expect("six pixels");
        for row in 0..2 {
            for column in 0..3 {
                let uv = Vec2::new((column as f32 + 0.5) / 3.0, 1.0 - (row as f32 + 0.5) / 2.0);
                for shift in [Vec2::ZERO, Vec2::new(5.0, -2.0)] {
                    let off = image.color(uv + shift).r - colors[row * 3 + column].r;
                    assert!(off.abs() < 1e-5, "{column} {row}: {off}");
                }
            }
        }
        // Half way between the last pixel of a row and the first, which is its neighbour.
        let seam = image.color(Vec2::new(1.0, 0.75)).r;
        assert!((seam - 0.2).abs() < 1e-6, "{seam}");
        assert_eq!(image.brightest(), Rgb::grey(0.6));
    }

    #[test]
    fn rows_that_are_not_full_are_no_image() {
        for (width, count) in [(0, 0), (0, 3), (2, 3), (3, 0)] {
            let pixels = vec![Rgb::WHITE; count];
            assert!(ImageTexture::new(width, pixels, DVec2::ONE).is_none());
        }
    }

    #[test]
    fn coordinates_of_any_size_give_a_color_between_those_of_the_image() {
        let colors = [0.25, 0.5].map(Rgb::grey);
        let image = ImageTexture::new(2, colors.to_vec(), DVec2::splat(0.3)).expect("two pixels");
        for x in [
            0.0,
            -0.0,
            1e-30,
            -1e-30,
            1e30,
            -3e38,
            0.999_999_94,
            123_456.7,
        ] {
            let color = image.color(Vec2::new(x, -x)).r;
            assert!((0.25..=0.5).contains(&color), "{x}: {color}");
        }
    }
}
