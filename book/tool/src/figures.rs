//! `{{#figure chapter/file}}` and rows of them: pictures inside the page itself.
//!
//! A picture is embedded as a data URI, so that a page can be read, moved or mailed on its own. Renders
//! can be given a width; charts and drawings have one of their own, at which their letters can be read.

use std::fs;

use base64::prelude::{BASE64_STANDARD, Engine as _};

use crate::data::{REMEDY, Run};
use crate::markup::escape;

/// Width in pixels of the page's column, and of each of two figures beside each other.
const COLUMN: f64 = 720.0;
const HALF: f64 = 348.0;
/// No letter in a drawing is smaller, in pixels.
const LEAST_LETTERS: f64 = 11.0;

/// Narrower renders are shown with their pixels sharp: there every pixel is worth seeing.
const SMALL: u32 = 160;

/// One figure, `chapter/file` and perhaps `width=50%`.
pub fn expand(arguments: &[&str], run: &Run) -> Result<String, String> {
    match arguments {
        [path] => figure(path, None, COLUMN, run),
        [path, width] => figure(path, Some(percentage(width)?), COLUMN, run),
        [] | [_, _, ..] => Err("write `chapter/file` and perhaps `width=50%`".to_string()),
    }
}

/// A row of figures, side by side.
pub fn expand_row(arguments: &[&str], run: &Run) -> Result<String, String> {
    if arguments.len() < 2 {
        return Err("a row has at least two figures; for one write `{{#figure …}}`".to_string());
    }
    let place = if arguments.len() == 2 {
        HALF
    } else {
        HALF * 2.0 / arguments.len() as f64
    };
    let figures: Result<String, String> = arguments
        .iter()
        .map(|path| figure(path, None, place, run))
        .collect();
    Ok(format!("<div class=\"figures\">{}</div>", figures?))
}

/// One figure in a place of so many pixels.
fn figure(path: &str, width: Option<u32>, place: f64, run: &Run) -> Result<String, String> {
    let (chapter, file) = path
        .split_once('/')
        .ok_or_else(|| format!("write `chapter/file` instead of `{path}`"))?;
    let (figure, picture) = run.figure(chapter, file)?;
    let bytes =
        fs::read(picture).map_err(|error| format!("cannot read `{path}`: {error}; {REMEDY}"))?;
    let (kind, class) = match file.rsplit_once('.') {
        Some((_, "svg")) if width.is_some() => {
            return Err(format!("`{path}` is shown at the width it is drawn at"));
        }
        Some((_, "svg")) => {
            readable(&String::from_utf8_lossy(&bytes), place)
                .map_err(|says| format!("`{path}` {says}"))?;
            ("svg+xml", " class=\"drawing\"")
        }
        Some((_, "png")) => match png_width(&bytes) {
            None => return Err(format!("`{path}` is not a PNG")),
            Some(0..SMALL) => ("png", " class=\"pixels\""),
            Some(_) => ("png", ""),
        },
        _ => return Err(format!("`{path}` is neither a .png nor a .svg")),
    };
    let style = width.map_or(String::new(), |width| format!(" style=\"width: {width}%\""));
    let caption = escape(&figure.caption);
    let data = BASE64_STANDARD.encode(bytes);
    Ok(format!(
        "<figure><img{class}{style} alt=\"{caption}\" src=\"data:image/{kind};base64,{data}\">\
         <figcaption>{caption}</figcaption></figure>"
    ))
}

/// Refuses a drawing that is wider than its place, or has letters that are too small there.
fn readable(svg: &str, place: f64) -> Result<(), String> {
    let head = svg.split_once('>').map_or(svg, |(head, _)| head);
    let [width, units] = [numbers(head, "width=\""), numbers(head, "viewBox=\"0 0 ")]
        .map(|list| list.first().copied());
    let (Some(width), Some(units)) = (width, units) else {
        return Err("says no width and viewBox".to_string());
    };
    if width > place {
        return Err(format!("is {width} pixels wide, in a place of {place}"));
    }
    // Units are as fine as a quarter of a pixel, and letters are rounded to them.
    let letters = numbers(svg, "font-size=\"")
        .into_iter()
        .map(|units_high| units_high * width / units);
    match letters.reduce(f64::min) {
        Some(least) if least < LEAST_LETTERS - 0.01 => Err(format!(
            "has letters of {least:.1} pixels, below {LEAST_LETTERS}"
        )),
        _ => Ok(()),
    }
}

/// The numbers that follow a mark.
fn numbers(text: &str, mark: &str) -> Vec<f64> {
    let after = text.split(mark).skip(1);
    let number = |rest: &str| {
        let end = rest
            .find(|c: char| !c.is_ascii_digit() && c != '.')
            .unwrap_or(rest.len());
        rest[..end].parse().ok()
    };
    after.filter_map(number).collect()
}

/// The percentage in `width=50%`.
fn percentage(argument: &str) -> Result<u32, String> {
    argument
        .strip_prefix("width=")
        .and_then(|width| width.strip_suffix('%')?.parse().ok())
        .filter(|width| (1..=100).contains(width))
        .ok_or_else(|| format!("`{argument}` is no width from `width=1%` to `width=100%`"))
}

/// The width in pixels, which a PNG keeps in a fixed place of its first chunk.
fn png_width(bytes: &[u8]) -> Option<u32> {
    let chunk = bytes.strip_prefix(b"\x89PNG\r\n\x1a\n")?;
    let width = chunk.get(4..)?.strip_prefix(b"IHDR")?.first_chunk()?;
    Some(u32::from_be_bytes(*width))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::tests::fixtures;

    #[test]
    fn a_small_png_is_embedded_with_sharp_pixels() {
        let html = expand(&["ch01/image.png", "width=50%"], &fixtures()).unwrap();
        let caption = "A &quot;small&quot; view, 4 &lt; 160 pixels wide.";
        let start = format!(
            "<figure><img class=\"pixels\" style=\"width: 50%\" alt=\"{caption}\" \
             src=\"data:image/png;base64,iVBORw0KGgo"
        );
        assert!(html.starts_with(&start), "{html}");
        assert!(html.ends_with(&format!("<figcaption>{caption}</figcaption></figure>")));
        assert!(!html.contains('\n'));
    }

    #[test]
    fn a_row_holds_each_figure() {
        let html = expand_row(&["ch01/image.png", "ch01/plot.svg"], &fixtures()).unwrap();
        assert_eq!(html.matches("<figure>").count(), 2);
        assert!(html.contains("data:image/svg+xml;base64,PHN2Zy"));
    }

    #[test]
    fn letters_that_are_too_small_or_a_drawing_that_is_too_wide_are_refused() {
        let svg = |width: u32, letters: f64| {
            format!(
                "<svg width=\"{width}\" viewBox=\"0 0 {} 9\"><text font-size=\"60\">a</text>\
                 <text font-size=\"{}\">b</text></svg>",
                4 * width,
                4.0 * letters
            )
        };
        assert_eq!(readable(&svg(720, 11.0), COLUMN), Ok(()));
        assert_eq!(readable(&svg(300, 12.5), HALF), Ok(()));
        let small = readable(&svg(720, 10.5), COLUMN).unwrap_err();
        assert_eq!(small, "has letters of 10.5 pixels, below 11");
        let wide = readable(&svg(720, 20.0), HALF).unwrap_err();
        assert_eq!(wide, "is 720 pixels wide, in a place of 348");
        assert!(readable("<svg>", COLUMN).is_err());
    }

    #[test]
    fn mistakes_are_refused() {
        let run = fixtures();
        let one = |arguments: &[&str]| expand(arguments, &run).unwrap_err();
        assert!(one(&["ch01/lost.png"]).starts_with("cannot read `ch01/lost.png`"));
        assert!(one(&["ch01/nothing.png"]).starts_with("unknown figure in ch01"));
        assert!(one(&["image.png"]).contains("instead of `image.png`"));
        assert!(one(&["ch01/image.png", "width=0%"]).contains("is no width"));
        assert!(one(&["ch01/image.png", "50%"]).contains("is no width"));
        assert!(one(&["ch01/plot.svg", "width=50%"]).contains("is shown at the width"));
        assert!(one(&[]).contains("write `chapter/file`"));
        assert!(expand_row(&["ch01/image.png"], &run).is_err());
        assert_eq!(png_width(b"<svg/>"), None);
    }
}
