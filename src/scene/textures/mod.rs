//! Colours of a scene file that may differ from point to point. To add a texture: a file, a variant, and an
//! arm of `build`.

mod checker;
mod image;

pub use checker::Checker;
pub use image::{Image, ImageTexture};

use super::field::{Checked, Problem, Within};
use super::image_file;
use super::parts::{Parts, alone};
use super::value::{Albedo, Emission, Positive, Radiance};
use crate::color::Rgb;
use crate::materials::{Color, Texture};
use serde::Deserialize;
use std::path::Path;
use std::sync::Arc;

/// A colour of type `C`, or a texture of such colours.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename = "kind of texture", rename_all = "snake_case")]
pub enum Textured<C> {
    /// The same colour everywhere.
    #[serde(rename = "a colour")]
    Constant(C),
    /// Fields of two colours in turn.
    Checker(Checker<C>),
    /// An image.
    Image(Image),
}

impl<C: Default> Default for Textured<C> {
    fn default() -> Self {
        C::default().into()
    }
}

impl<C> From<C> for Textured<C> {
    fn from(color: C) -> Self {
        Textured::Constant(color)
    }
}

/// A kind of colour with a rule.
pub trait Rule: Copy {
    /// The colour, if the rule allows it.
    fn color(self) -> Checked<Rgb>;
    /// The colour of a pixel, if it may be one among others.
    fn pixel(rgb: [f64; 3]) -> Checked<Rgb>;
    /// Nothing, if a texture may have this as its brightest colour.
    fn brightest(rgb: [f64; 3]) -> Checked<()>;
}

impl Rule for Albedo {
    fn color(self) -> Checked<Rgb> {
        self.get()
    }

    fn pixel(rgb: [f64; 3]) -> Checked<Rgb> {
        Albedo(rgb).get()
    }

    fn brightest(_: [f64; 3]) -> Checked<()> {
        Ok(())
    }
}

impl Rule for Emission {
    fn color(self) -> Checked<Rgb> {
        Radiance(self.0).get()
    }

    fn pixel(rgb: [f64; 3]) -> Checked<Rgb> {
        Radiance(rgb).get()
    }

    fn brightest(rgb: [f64; 3]) -> Checked<()> {
        Emission(rgb).get().map(|_| ())
    }
}

/// Pixels that an image may have: each takes 12 bytes.
const MAX_PIXELS: usize = 1 << 26;

impl<C: Rule> Textured<C> {
    /// The file that it names, if it is an image.
    pub(super) fn file(&self) -> Option<&Path> {
        match self {
            Textured::Image(image) => Some(&image.file),
            _ => None,
        }
    }

    /// Checks it; images are read.
    pub(super) fn build(&self, parts: &mut Parts) -> Checked<Color> {
        let texture: Arc<dyn Texture> = match self {
            Textured::Constant(color) => {
                let color = color.color()?;
                C::brightest(color.channels().map(f64::from))?;
                return Ok(Color::Constant(color));
            }
            Textured::Checker(said) => {
                said.fields.get().within("fields").within("checker")?;
                Arc::new(Checker {
                    even: said.even.color().within("even").within("checker")?,
                    odd: said.odd.color().within("odd").within("checker")?,
                    fields: said.fields,
                })
            }
            Textured::Image(said) => Arc::new(image::<C>(said, parts).within("image")?),
        };
        C::brightest(texture.brightest().channels().map(f64::from))?;
        Ok(Color::Textured(texture))
    }
}

fn image<C: Rule>(said: &Image, parts: &mut Parts) -> Checked<ImageTexture> {
    let repeat = said.repeat.get().within("repeat")?;
    let scale = said.scale.map_or(Ok(1.0), Positive::get).within("scale")?;
    let path = alone(parts.folder).within("file")?.join(&said.file);
    let complain = |what: String| {
        Problem::new(format!("names {}, which {what}", path.display())).within("file")
    };
    let (width, pixels) = image_file::read(&path, MAX_PIXELS).map_err(complain)?;
    let colored = |(at, pixel): (usize, &Rgb)| {
        let rgb = pixel.channels().map(|x| f64::from(x) * scale);
        C::pixel(rgb).map_err(|problem| {
            let (column, row) = (at % width, at / width);
            complain(format!(
                "has a pixel in column {column} of row {row} that {}",
                problem.what
            ))
        })
    };
    let pixels = pixels
        .iter()
        .enumerate()
        .map(colored)
        .collect::<Checked<Vec<Rgb>>>()?;
    ImageTexture::new(width, pixels, repeat).ok_or_else(|| complain("has no pixels".to_owned()))
}
