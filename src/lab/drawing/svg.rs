//! A small writer of SVG: a page with the shapes that drawings need.
//!
//! Lengths are pixels from the upper left corner, written with two decimals.

use super::font::{TITLE, headline, text_width};
use super::palette::{Colour, INK, PAPER, dark_style, hex};
use crate::numeric::fixed;

/// A place on the page.
pub(super) type Place = [f64; 2];

/// How a line is drawn.
#[derive(Clone, Copy)]
pub(super) struct Pen {
    pub(super) colour: Colour,
    pub(super) width: f64,
    pub(super) dashed: bool,
}

impl Pen {
    pub(super) const fn solid(colour: Colour, width: f64) -> Self {
        Self {
            colour,
            width,
            dashed: false,
        }
    }

    pub(super) const fn dashed(colour: Colour, width: f64) -> Self {
        Self {
            colour,
            width,
            dashed: true,
        }
    }

    fn attributes(self) -> String {
        let (colour, width) = (hex(self.colour), n(self.width));
        let dashes = if self.dashed {
            " stroke-dasharray=\"6 4\" stroke-linecap=\"butt\""
        } else {
            ""
        };
        format!("stroke=\"{colour}\" stroke-width=\"{width}\"{dashes}")
    }
}

/// Which part of a text stands at its place.
pub(super) const START: &str = "start";
pub(super) const MIDDLE: &str = "middle";

/// How a text is set: its middle line goes through its place.
#[derive(Clone, Copy)]
pub(super) struct Letters {
    pub(super) height: f64,
    pub(super) colour: Colour,
    pub(super) anchor: &'static str,
    /// Whether lines beneath keep clear of the letters.
    pub(super) halo: bool,
}

impl Letters {
    pub(super) fn new(height: f64, anchor: &'static str) -> Self {
        Self {
            height,
            colour: INK,
            anchor,
            halo: false,
        }
    }
}

/// Shapes, in the order in which they are drawn.
#[derive(Default)]
pub(super) struct Svg {
    body: String,
    /// Colours whose arrow heads are defined.
    heads: Vec<Colour>,
}

impl Svg {
    /// A line through the points; its last one can carry an arrow head.
    pub(super) fn polyline(&mut self, points: &[Place], pen: Pen, arrow: bool) {
        let points: Vec<String> = points.iter().map(|&at| pair(at)).collect();
        let head = if arrow {
            self.head(pen.colour)
        } else {
            String::new()
        };
        self.line(&format!(
            "<polyline points=\"{}\" fill=\"none\" {}{head}/>",
            points.join(" "),
            pen.attributes()
        ));
    }

    fn head(&mut self, colour: Colour) -> String {
        let id = format!("head-{}", &hex(colour)[1..]);
        if !self.heads.contains(&colour) {
            self.heads.push(colour);
            self.line(&format!(
                "<marker id=\"{id}\" markerUnits=\"userSpaceOnUse\" markerWidth=\"10\" \
                 markerHeight=\"8\" refX=\"9.5\" refY=\"4\" orient=\"auto\">\
                 <path d=\"M0 0L10 4L0 8z\" fill=\"{}\"/></marker>",
                hex(colour)
            ));
        }
        format!(" marker-end=\"url(#{id})\"")
    }

    pub(super) fn circle(&mut self, center: Place, radius: f64, pen: Pen) {
        let (at, pen) = (round(center, radius), pen.attributes());
        self.line(&format!("<circle {at} fill=\"none\" {pen}/>"));
    }

    pub(super) fn disk(&mut self, center: Place, radius: f64, colour: Colour) {
        let (at, colour) = (round(center, radius), hex(colour));
        self.line(&format!("<circle {at} fill=\"{colour}\"/>"));
    }

    /// A piece of a circle, less than all of it: from an angle counter-clockwise, in radians.
    pub(super) fn arc(&mut self, center: Place, radius: f64, start: f64, turn: f64, pen: Pen) {
        let at = |angle: f64| {
            let (sin, cos) = libm::sincos(angle);
            pair([center[0] + radius * cos, center[1] - radius * sin])
        };
        let large = u8::from(turn.abs() > std::f64::consts::PI);
        // Counter-clockwise is the other way around where y points down.
        let sweep = u8::from(turn < 0.0);
        let (from, to, radius) = (at(start), at(start + turn), n(radius));
        self.line(&format!(
            "<path d=\"M{from} A{radius} {radius} 0 {large} {sweep} {to}\" fill=\"none\" {}/>",
            pen.attributes()
        ));
    }

    pub(super) fn text(&mut self, at: Place, text: &str, letters: Letters) {
        // Half of the height of a capital letter.
        let base = pair([at[0], at[1] + 0.36 * letters.height]);
        let (x, y) = base.split_once(',').unwrap_or_default();
        let halo = if letters.halo {
            let paper = hex(PAPER);
            format!(" stroke=\"{paper}\" stroke-width=\"4\" paint-order=\"stroke\"")
        } else {
            String::new()
        };
        self.line(&format!(
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\" text-anchor=\"{}\" \
             fill=\"{}\"{halo}>{}</text>",
            n(letters.height),
            letters.anchor,
            hex(letters.colour),
            escape(text)
        ));
    }

    /// A headline; returns its height.
    pub(super) fn headline(&mut self, title: &str, width: f64) -> f64 {
        let (lines, height) = headline(title, width);
        for (middle, line) in lines {
            let letters = Letters::new(TITLE, MIDDLE);
            self.text([width / 2.0, middle], &line, letters);
        }
        height
    }

    /// Lines with their names side by side, centred, in as many rows as the page needs; returns their
    /// height.
    pub(super) fn legend(&mut self, top: f64, width: f64, keys: &[(&str, Pen)]) -> f64 {
        const SWATCH: f64 = 26.0;
        const GAP: f64 = 8.0;
        const ROW: f64 = 20.0;
        let height = super::font::SMALL;
        let key_width = |(name, _): &(&str, Pen)| SWATCH + text_width(name, height) + 3.0 * GAP;
        let mut rows: Vec<(f64, Vec<&(&str, Pen)>)> = Vec::new();
        for key in keys {
            let own = key_width(key);
            match rows.last_mut() {
                Some((taken, row)) if *taken + own <= width => {
                    *taken += own;
                    row.push(key);
                }
                _ => rows.push((own, vec![key])),
            }
        }
        for (i, (taken, row)) in rows.iter().enumerate() {
            let (mut x, y) = (0.5 * (width - taken + GAP), top + (i as f64 + 0.5) * ROW);
            for key in row {
                let pen = Pen {
                    width: key.1.width.max(1.6),
                    ..key.1
                };
                self.polyline(&[[x, y], [x + SWATCH, y]], pen, false);
                let letters = Letters::new(height, START);
                self.text([x + SWATCH + GAP, y], key.0, letters);
                x += key_width(key);
            }
        }
        rows.len() as f64 * ROW
    }

    /// What `draw` adds, cut at the edges of a box from its upper left to its lower right corner.
    pub(super) fn clipped(&mut self, [from, to]: [Place; 2], draw: impl FnOnce(&mut Self)) {
        let [x, y, w, h] = [from[0], from[1], to[0] - from[0], to[1] - from[1]].map(n);
        self.line(&format!(
            "<clipPath id=\"view\"><rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\"/></clipPath>"
        ));
        self.line("<g clip-path=\"url(#view)\">");
        draw(self);
        self.line("</g>");
    }

    /// Adds finished SVG.
    pub(super) fn line(&mut self, svg: &str) {
        self.body.push_str(svg);
        self.body.push('\n');
    }

    /// The page, of a width and a height in pixels; its lengths are in units, so many to the pixel.
    pub(super) fn page(self, [width, height]: [f64; 2], units: f64) -> String {
        let [width, height, wide, tall] = [width, height, units * width, units * height].map(n);
        let (style, paper) = (dark_style(), hex(PAPER));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {wide} {tall}\" font-family=\"sans-serif\" stroke-linecap=\"round\" \
             stroke-linejoin=\"round\">\n<style>{style}</style>\n\
             <rect width=\"100%\" height=\"100%\" fill=\"{paper}\"/>\n{}</svg>\n",
            self.body
        )
    }
}

/// A length, short and the same on every machine.
fn n(x: f64) -> String {
    let text = fixed(x, 2);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn pair(at: Place) -> String {
    format!("{},{}", n(at[0]), n(at[1]))
}

fn round(center: Place, radius: f64) -> String {
    let ([x, y], r) = (center.map(n), n(radius));
    format!("cx=\"{x}\" cy=\"{y}\" r=\"{r}\"")
}

/// A text without the characters that mean something in XML, and without those that XML cannot say.
fn escape(text: &str) -> String {
    let said = text.chars().filter(|c| !c.is_control());
    said.fold(String::new(), |mut safe, c| {
        match c {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            _ => safe.push(c),
        }
        safe
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::drawing::palette::BLUE;

    const PEN: Pen = Pen::solid(BLUE, 2.0);

    #[test]
    fn shapes_are_written_with_two_decimals_and_words_are_escaped() {
        let mut svg = Svg::default();
        svg.polyline(&[[0.0, -0.001], [1.0 / 3.0, 20.0]], PEN, false);
        svg.text([5.0, 7.0], "a < b & \u{1}c", Letters::new(10.0, MIDDLE));
        let page = svg.page([30.0, 20.0], 1.0);
        assert!(page.contains("points=\"0,0 0.33,20\""), "{page}");
        assert!(page.contains(">a &lt; b &amp; c</text>"), "{page}");
        assert!(
            page.contains("width=\"30\" height=\"20\" viewBox=\"0 0 30 20\""),
            "{page}"
        );
    }

    #[test]
    fn an_arc_goes_counter_clockwise_from_its_start_to_its_end() {
        let mut svg = Svg::default();
        let quarter = std::f64::consts::FRAC_PI_2;
        svg.arc([10.0, 10.0], 5.0, 0.0, quarter, PEN);
        svg.arc([10.0, 10.0], 5.0, 0.0, 3.0 * quarter, PEN);
        assert!(svg.body.contains("M15,10 A5 5 0 0 0 10,5"), "{}", svg.body);
        assert!(svg.body.contains("M15,10 A5 5 0 1 0 10,15"), "{}", svg.body);
    }

    #[test]
    fn an_arrow_head_is_defined_once_for_each_colour() {
        let mut svg = Svg::default();
        for _ in 0..3 {
            svg.polyline(&[[0.0, 0.0], [1.0, 0.0]], PEN, true);
        }
        assert_eq!(svg.body.matches("<marker").count(), 1);
        assert_eq!(
            svg.body.matches("marker-end=\"url(#head-0072B2)\"").count(),
            3
        );
    }

    #[test]
    fn a_legend_breaks_into_rows_and_loses_no_name() {
        let mut svg = Svg::default();
        let names: Vec<String> = (0..9).map(|i| format!("a rather long name {i}")).collect();
        let keys: Vec<_> = names.iter().map(|name| (name.as_str(), PEN)).collect();
        assert!(svg.legend(0.0, 600.0, &keys) > 20.0);
        assert!(names.iter().all(|name| svg.body.contains(name)));
        let alone = "x".repeat(200);
        assert_eq!(svg.legend(0.0, 300.0, &[(&alone, PEN)]), 20.0);
    }

    #[test]
    fn a_dark_page_has_other_paper_and_ink() {
        let page = Svg::default().page([1.0, 1.0], 1.0);
        assert!(page.contains("prefers-color-scheme: dark"));
        assert!(page.contains("[fill=\"#FFFFFF\"] { fill: #1B1E24 }"));
    }
}
