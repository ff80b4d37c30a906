//! The classes of a scene's light, drawn beside each other under their names.

use super::{Stop, drawn, save};
use crate::lab::drawing::{Plate, Plates};
use crate::numeric::three_digits;
use crate::output::{Display, shades};
use crate::render::Film;
use crate::stats::quantile;
use std::path::Path;

/// The share of the pixels that may be brighter than white in the picture of a class.
const CLIPPED: f64 = 0.01;
/// The most by which a dim class is brightened, in stops.
const MOST: f64 = 10.0;

/// The picture of a class.
pub(super) struct OfClass<'a> {
    pub name: &'static str,
    /// Its words, as an expression.
    pub words: &'static str,
    pub film: &'a Film,
    /// Its part of the light.
    pub share: f64,
}

/// Writes the pictures as `name` with the endings `.svg` and `.png`; their names.
pub(super) fn write(name: &Path, title: String, classes: &[OfClass]) -> Result<Vec<String>, Stop> {
    let plate = |class: &OfClass| {
        let stops = stops(class.film);
        let brighter = match stops {
            0.0 => String::new(),
            stops => format!(", shown {} times as bright", libm::exp2(stops)),
        };
        Plate {
            name: class.name.to_owned(),
            words: vec![
                class.words.to_owned(),
                format!("{} %{brighter}", three_digits(100.0 * class.share)),
            ],
            shades: shades(class.film, Display::Exposed { stops }),
        }
    };
    let plates = Plates {
        title,
        width: classes.first().map_or(0, |class| class.film.width()),
        plates: classes.iter().map(plate).collect(),
    };
    let files = drawn(name, plates.to_svg(), plates.to_png())?;
    let mut written = Vec::new();
    for (file, bytes) in files.into_iter().flatten() {
        save(&file, bytes)?;
        written.push(file.display().to_string());
    }
    Ok(written)
}

/// Whole stops that bring a dim picture up to where its brightest pixels are about to clip.
fn stops(film: &Film) -> f64 {
    let means = film.pixels().iter().filter_map(|pixel| pixel.mean());
    let brightest: Vec<f64> = means.map(|[r, g, b]| r.max(g).max(b)).collect();
    match brightest.is_empty() {
        true => 0.0,
        false => match quantile(brightest, 1.0 - CLIPPED) {
            bright if bright > 0.0 => (-libm::log2(bright)).floor().clamp(0.0, MOST),
            _ => 0.0,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;
    use crate::render::Pixel;

    #[test]
    fn a_dim_class_is_brightened_and_says_so_and_a_bright_one_is_left() {
        let film = |light: f32| {
            let mut pixel = Pixel::default();
            pixel.add(Rgb::grey(light));
            Film::new(2, vec![pixel; 4])
        };
        assert_eq!(
            [3.0, 0.7, 0.2, 0.0].map(|light| stops(&film(light))),
            [0.0, 0.0, 2.0, 0.0]
        );
        let folder = tempfile::tempdir().unwrap();
        let film = film(0.2);
        let class = OfClass {
            name: "direct light",
            words: "L(D|G)E",
            film: &film,
            share: 0.2136,
        };
        let files = write(&folder.path().join("classes"), "mine".to_owned(), &[class]).unwrap();
        assert_eq!(files.len(), 2);
        let svg = std::fs::read_to_string(&files[0]).unwrap();
        for words in ["direct light", "L(D|G)E", "21.4 %, shown 4 times as bright"] {
            assert!(svg.contains(words), "{svg}");
        }
    }
}
