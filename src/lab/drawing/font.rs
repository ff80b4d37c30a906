//! Letters: one embedded font, by whose widths pages are laid out and with which PNG files are written.
//!
//! An SVG file is shown in the reader's own sans-serif font, which is rarely wider than this one.

use plotters::style::{FontDesc, FontFamily, FontStyle, register_font};
use std::sync::Once;

/// Letter heights, in pixels at the width that a figure is shown at.
pub(super) const TITLE: f64 = 16.0;
pub(super) const TEXT: f64 = 13.0;
pub(super) const SMALL: f64 = 12.0;
/// No letter is smaller.
pub(super) const LEAST: f64 = 11.0;

/// The letters of DejaVu Sans that charts use; its licence lies beside it.
static DEJAVU: &[u8] = include_bytes!("font/DejaVuSans-subset.ttf");
static REGISTERED: Once = Once::new();

/// The font at a height. The drawing library divides heights by 1.24 before it writes them down.
pub(super) fn sans(height: f64) -> FontDesc<'static> {
    REGISTERED.call_once(|| {
        // A font that cannot be read makes every drawing an error, which the tests would see.
        let _ = register_font("sans-serif", FontStyle::Normal, DEJAVU);
    });
    FontDesc::new(FontFamily::SansSerif, 1.24 * height, FontStyle::Normal)
}

/// Width of a text in letters of the given height.
pub(super) fn text_width(text: &str, height: f64) -> f64 {
    // Measured large, because the library rounds to whole pixels.
    let large = sans(100.0)
        .box_size(text)
        .map(|(width, _)| f64::from(width));
    large.unwrap_or(60.0 * text.chars().count() as f64) / 100.0 * height
}

/// The largest letters, at most of the given height, in which a text fits; never below [`LEAST`].
pub(super) fn fitting(text: &str, height: f64, width: f64) -> f64 {
    (height * width / text_width(text, height).max(1.0)).clamp(LEAST, height)
}

/// Breaks a text between words into lines of at most the given width. A word that is wider keeps a line
/// to itself.
pub(super) fn wrap(text: &str, height: f64, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if text_width(&format!("{line} {word}"), height) <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// The lines of a headline, each with the height of its middle, and the height of all of them.
pub(super) fn headline(title: &str, width: f64) -> (Vec<(f64, String)>, f64) {
    const LINE: f64 = 1.3 * TITLE;
    const MARGIN: f64 = 10.0;
    let lines = wrap(title, TITLE, width - 2.0 * MARGIN);
    let height = lines.len() as f64 * LINE + 2.0 * MARGIN;
    let middle = |i: usize| MARGIN + (i as f64 + 0.5) * LINE;
    let lines = lines.into_iter().enumerate();
    (lines.map(|(i, line)| (middle(i), line)).collect(), height)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_font_knows_the_letters_of_charts() {
        assert!(text_width("iii", 10.0) < text_width("WWW", 10.0));
        for c in "±×²⁻⁷·°πσ–√≤é".chars() {
            assert!(text_width(&c.to_string(), 10.0) > 1.0, "{c}");
        }
    }

    #[test]
    fn a_text_is_broken_between_words_to_fit() {
        let lines = wrap("a glossy floor below a window", 12.0, 100.0);
        assert!(lines.len() >= 2 && lines.iter().all(|line| text_width(line, 12.0) <= 100.0));
        assert_eq!(lines.join(" "), "a glossy floor below a window");
        assert_eq!(fitting("short", TEXT, 500.0), TEXT);
        assert_eq!(fitting(&"long ".repeat(80), TEXT, 500.0), LEAST);
    }
}
