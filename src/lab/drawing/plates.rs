//! Pictures side by side, each under its name and with words below.

use super::font::{SMALL, TEXT, fitting, headline};
use super::palette::INK;
use super::plot::{Page, Paint, UNITS, encode, letters, png, px, stroke, titled};
use super::{ChartError, FULL};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use image::{RgbImage, imageops};
use plotters::prelude::*;
use plotters::style::text_anchor::VPos;

/// Pictures of one size in rows of three, as SVG or PNG.
#[derive(Clone, Debug, Default)]
pub struct Plates {
    /// Headline.
    pub title: String,
    /// Width of each picture in pixels.
    pub width: u32,
    /// The pictures, from left to right and from the top down.
    pub plates: Vec<Plate>,
}

/// One of the pictures.
#[derive(Clone, Debug, Default)]
pub struct Plate {
    /// Its name, above it.
    pub name: String,
    /// Lines of words below it.
    pub words: Vec<String>,
    /// Its shades, row by row from the top.
    pub shades: Vec<[u8; 3]>,
}

const COLUMNS: usize = 3;
const GAP: f64 = 14.0;
/// Height of a line of words.
const LINE: f64 = 22.0;

impl Plates {
    /// The pictures as SVG text, as wide as a page, their pixels within as PNG.
    pub fn to_svg(&self) -> Result<String, ChartError> {
        self.check()?;
        let mut svg = self.svg()?;
        for (place, plate) in self.plates.iter().enumerate() {
            let [x, y, width, height] = self.window(place).map(px);
            svg.line(&format!(
                "<image x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" \
                 preserveAspectRatio=\"none\" href=\"data:image/png;base64,{}\"/>",
                STANDARD.encode(encode(&self.image(plate))?)
            ));
        }
        Ok(svg.page(self.size(), UNITS))
    }

    /// The same as a PNG file.
    pub fn to_png(&self) -> Result<Vec<u8>, ChartError> {
        self.check()?;
        let mut page = self.pixels()?;
        for (place, plate) in self.plates.iter().enumerate() {
            let [x, y, width, height] = self.window(place).map(px);
            let [width, height] = [width, height].map(i32::unsigned_abs);
            let image = imageops::resize(
                &self.image(plate),
                width,
                height,
                imageops::FilterType::Triangle,
            );
            imageops::replace(&mut page, &image, x.into(), y.into());
        }
        png(&page)
    }

    fn check(&self) -> Result<(), ChartError> {
        let whole = |plate: &Plate| !plate.shades.is_empty() && self.height() > 0;
        match self.width > 0 && !self.plates.is_empty() && self.plates.iter().all(whole) {
            true => Ok(()),
            false => Err(ChartError::Empty(self.title.clone())),
        }
    }

    /// Height of each picture in pixels.
    fn height(&self) -> u32 {
        let shades = self.plates.first().map_or(0, |plate| plate.shades.len());
        shades as u32 / self.width.max(1)
    }

    /// Left, top, width and height of a picture on the page.
    fn window(&self, place: usize) -> [f64; 4] {
        let columns = self.plates.len().min(COLUMNS) as f64;
        let width = (f64::from(FULL) - (columns + 1.0) * GAP) / columns;
        let height = width * f64::from(self.height()) / f64::from(self.width.max(1));
        let (column, row) = ((place % COLUMNS) as f64, (place / COLUMNS) as f64);
        let top = headline(&self.title, f64::from(FULL)).1;
        [
            GAP + column * (width + GAP),
            top + LINE + row * (height + (1.0 + self.lines()) * LINE + GAP),
            width,
            height,
        ]
    }

    /// The most lines of words below a picture.
    fn lines(&self) -> f64 {
        let lines = self.plates.iter().map(|plate| plate.words.len());
        lines.max().unwrap_or(0) as f64
    }

    fn image(&self, plate: &Plate) -> RgbImage {
        RgbImage::from_fn(self.width, self.height(), |x, y| {
            let shade = plate.shades.get((y * self.width + x) as usize);
            image::Rgb(shade.copied().unwrap_or_default())
        })
    }
}

impl Paint for Plates {
    fn size(&self) -> [f64; 2] {
        let [_, top, _, height] = self.window(self.plates.len().saturating_sub(1));
        [
            f64::from(FULL),
            (top + height + self.lines() * LINE + GAP).round(),
        ]
    }

    fn paint<DB: DrawingBackend>(&self, page: &Page<DB>) -> Result<(), ChartError> {
        titled(page, &self.title, f64::from(FULL))?;
        for (place, plate) in self.plates.iter().enumerate() {
            let [x, y, width, height] = self.window(place);
            let middle = px(x + 0.5 * width);
            let write = |text: &str, at: f64, size: f64| {
                let style = letters(size, VPos::Center);
                page.draw(&Text::new(text.to_owned(), (middle, px(at)), style))
            };
            write(
                &plate.name,
                y - 0.5 * LINE,
                fitting(&plate.name, TEXT, width),
            )?;
            for (line, words) in plate.words.iter().enumerate() {
                let below = y + height + (0.6 + 0.9 * line as f64) * LINE;
                write(words, below, fitting(words, SMALL, width))?;
            }
            // A frame, so that a black picture is seen on dark paper.
            let corners = [(px(x), px(y)), (px(x + width), px(y + height))];
            page.draw(&Rectangle::new(corners, stroke(INK, 1.0)))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::drawing::plot::tests::{decoded, texts};

    fn plates() -> Plates {
        let plate = |name: &str, shade: u8| Plate {
            name: name.to_owned(),
            words: vec![format!("{shade} %"), "light".to_owned()],
            shades: vec![[shade; 3]; 8],
        };
        Plates {
            title: "classes".to_owned(),
            width: 4,
            plates: [("LE", 10), ("LDE", 60), ("LSE", 90), ("all", 200)]
                .map(|(name, shade)| plate(name, shade))
                .into(),
        }
    }

    #[test]
    fn each_picture_has_its_name_and_its_words() {
        let svg = plates().to_svg().unwrap();
        let words = texts(&svg);
        for word in ["classes", "LE", "10 %", "all", "200 %", "light"] {
            assert!(words.iter().any(|text| text == word), "{word} in {words:?}");
        }
        assert_eq!(svg.matches("data:image/png").count(), 4);
        let nothing = Plates {
            plates: Vec::new(),
            ..plates()
        };
        assert!(nothing.to_svg().is_err() && nothing.to_png().is_err());
    }

    #[test]
    fn a_png_shows_each_picture_in_its_place() {
        let plates = plates();
        let (wide, pixels) = decoded(&plates.to_png().unwrap());
        for (place, plate) in plates.plates.iter().enumerate() {
            let [x, y, width, height] = plates.window(place);
            let (x, y) = ((2.0 * x + width) as usize, (2.0 * y + height) as usize);
            let from = 3 * (y * wide + x);
            assert_eq!(pixels[from..from + 3], plate.shades[0], "{}", plate.name);
        }
        // Three in a row: the fourth stands below the first.
        assert_eq!(plates.window(3)[0], plates.window(0)[0]);
        assert!(plates.window(3)[1] > plates.window(0)[1] + plates.window(0)[3]);
    }
}
