//! Page, pens and letters: what every drawing is made of.
//!
//! Pages are measured in quarters of a pixel. The drawing library knows whole numbers only, and
//! on a grid of whole pixels a smooth curve would tremble; [`px`] turns pixels into units.
//!
//! Text has no exact width here, because an SVG picks its font only when somebody looks at it.
//! [`text_width`] estimates on the wide side, and layouts leave room by it.

use plotters::coord::{CoordTranslate, Shift};
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind};
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::{ChartError, SIZE};

/// A page in units, origin at the upper left.
pub(super) type Page<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// A position on a page, in units.
pub(super) type Pixel = (i32, i32);

const UNITS: i32 = 4;

/// A length in units, given in pixels.
pub(super) const fn px(pixels: i32) -> i32 {
    pixels * UNITS
}

/// Width and height of the usual page.
pub(super) const PAGE: Pixel = (px(SIZE.0 as i32), px(SIZE.1 as i32));

pub(super) const BLUE: RGBColor = RGBColor(0, 114, 178);
pub(super) const VERMILLION: RGBColor = RGBColor(213, 94, 0);
pub(super) const GREEN: RGBColor = RGBColor(0, 158, 115);
pub(super) const ORANGE: RGBColor = RGBColor(230, 159, 0);
pub(super) const SKY: RGBColor = RGBColor(86, 180, 233);
pub(super) const PURPLE: RGBColor = RGBColor(204, 121, 167);
pub(super) const UMBER: RGBColor = RGBColor(122, 72, 32);
pub(super) const INK: RGBColor = RGBColor(34, 34, 34);
pub(super) const GREY: RGBColor = RGBColor(110, 110, 110);
pub(super) const PALE: RGBColor = RGBColor(195, 195, 195);
pub(super) const FAINT: RGBColor = RGBColor(236, 236, 236);

/// The colours of Okabe and Ito, which stay apart for colour-blind eyes. Their yellow is left
/// out: it fades on white.
/// An umber and a grey follow for drawings of many curves.
const PALETTE: [RGBColor; 9] = [
    BLUE, VERMILLION, GREEN, PURPLE, ORANGE, SKY, INK, UMBER, GREY,
];

/// Height of the strip at the top that belongs to the title.
pub(super) const TITLE_BAND: i32 = px(48);

/// Letter heights.
pub(super) const SMALL: i32 = px(13);
pub(super) const NORMAL: i32 = px(15);
const TITLE: i32 = px(19);

/// Colour number `index`, starting over when the palette is used up.
pub(super) fn palette(index: usize) -> RGBColor {
    PALETTE[index % PALETTE.len()]
}

impl From<DrawingAreaErrorKind<std::io::Error>> for ChartError {
    fn from(error: DrawingAreaErrorKind<std::io::Error>) -> Self {
        Self::Drawing(error.to_string())
    }
}

/// A white page of the given width and height with a title, completed by `draw`, as SVG text.
pub(super) fn paint(
    (width, height): Pixel,
    title: &str,
    draw: impl FnOnce(&Page<'_>) -> Result<(), ChartError>,
) -> Result<String, ChartError> {
    let mut svg = String::new();
    {
        let size = (width.unsigned_abs(), height.unsigned_abs());
        let page = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        page.fill(&WHITE)?;
        // A long title shrinks to the page, down to the size of the other letters.
        let room = width - px(24);
        let letter = (TITLE * room / text_width(title, TITLE).max(1)).clamp(SMALL, TITLE);
        let letters = Letters::new(letter).anchored(HPos::Center, VPos::Center);
        letters.write(&page, (width / 2, TITLE_BAND / 2), title)?;
        draw(&page)?;
        page.present()?;
    }
    // The size on the screen is in pixels; the view box keeps the units.
    let units = format!("width=\"{width}\" height=\"{height}\"");
    let [width, height] = [width, height].map(|length| f64::from(length) / f64::from(UNITS));
    let pixels = format!("width=\"{width}\" height=\"{height}\"");
    Ok(svg.replacen(&units, &pixels, 1))
}

/// Estimated width of `text` in letters of the given height.
pub(super) fn text_width(text: &str, height: i32) -> i32 {
    text.chars().count() as i32 * height * 3 / 5
}

/// Breaks a text between words into lines of at most the given width. A word that is wider
/// keeps a line to itself.
pub(super) fn wrap(text: &str, height: i32, width: i32) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if text_width(line, height) + text_width(word, height) + height <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// How a piece of text is set.
#[derive(Clone, Copy)]
pub(super) struct Letters {
    height: i32,
    colour: RGBColor,
    anchor: Pos,
}

impl Letters {
    /// Dark letters whose position is their upper left corner.
    pub(super) fn new(height: i32) -> Self {
        Self {
            height,
            colour: INK,
            anchor: Pos::new(HPos::Left, VPos::Top),
        }
    }

    pub(super) fn coloured(self, colour: RGBColor) -> Self {
        Self { colour, ..self }
    }

    pub(super) fn anchored(self, h: HPos, v: VPos) -> Self {
        Self {
            anchor: Pos::new(h, v),
            ..self
        }
    }

    pub(super) fn text_style(self) -> TextStyle<'static> {
        // The SVG backend divides a font's size by 1.24 before it writes it down.
        let size = f64::from(self.height) * 1.24;
        let style = TextStyle::from(("sans-serif", size).into_font());
        TextStyle {
            color: self.colour.to_backend_color(),
            ..style
        }
        .pos(self.anchor)
    }

    pub(super) fn write(self, page: &Page<'_>, at: Pixel, text: &str) -> Result<(), ChartError> {
        Ok(page.draw(&Text::new(text.to_owned(), at, self.text_style()))?)
    }
}

/// How a line is drawn.
#[derive(Clone, Copy)]
pub(super) struct Pen {
    pub(super) colour: RGBColor,
    /// Width in pixels.
    pub(super) width: i32,
    pub(super) dashed: bool,
}

impl Pen {
    pub(super) fn solid(colour: RGBColor, width: i32) -> Self {
        Self {
            colour,
            width,
            dashed: false,
        }
    }

    pub(super) fn dashed(colour: RGBColor, width: i32) -> Self {
        Self {
            colour,
            width,
            dashed: true,
        }
    }

    pub(super) fn shape(self) -> ShapeStyle {
        self.colour.stroke_width(px(self.width).unsigned_abs())
    }

    /// Draws a path through `points`, which are pixels or, on the plane of a chart, values.
    pub(super) fn trace<C>(
        self,
        area: &DrawingArea<SVGBackend<'_>, C>,
        points: Vec<C::From>,
    ) -> Result<(), ChartError>
    where
        C: CoordTranslate,
        C::From: Clone,
    {
        if self.dashed {
            let dash = DashedPathElement::new(points, px(8), px(5), self.shape());
            Ok(area.draw(&dash)?)
        } else {
            Ok(area.draw(&PathElement::new(points, self.shape()))?)
        }
    }
}

/// Draws a filled disk with its radius in pixels.
pub(super) fn disk<C>(
    area: &DrawingArea<SVGBackend<'_>, C>,
    at: C::From,
    radius: i32,
    colour: RGBColor,
) -> Result<(), ChartError>
where
    C: CoordTranslate,
{
    Ok(area.draw(&Circle::new(at, px(radius), colour.filled()))?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_is_white_and_escapes_its_title() {
        let svg = paint((px(100), px(50)), "a < b", |_| Ok(())).unwrap();
        assert!(svg.starts_with("<svg width=\"100\" height=\"50\""));
        assert!(svg.contains("fill=\"#FFFFFF\""));
        assert!(svg.contains("a &lt; b"));
        assert!(svg.trim_end().ends_with("</svg>"));
    }
}
