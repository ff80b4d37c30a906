//! What charts have in common: a page with a headline, a plot with its axes, and a legend at its right or
//! below, all of it drawn by the library of charts, as SVG or as pixels.

use super::ChartError;
use super::curves::Style;
use super::font::{SMALL, TEXT, TITLE, fitting, headline, sans, text_width};
use super::palette::{Colour, FAINT, INK, PALE};
use super::scale::Scale;
use super::svg::Svg;
use image::{ImageFormat, RgbImage, imageops};
use plotters::coord::Shift;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::io::Cursor;

/// The library knows whole numbers only, and on a grid of whole pixels a smooth curve would tremble: so
/// many of its units make a pixel.
pub(super) const UNITS: f64 = 4.0;
/// Pixels of a PNG file to a pixel of the page, for screens that are fine.
const FINE: u32 = 2;

/// A length in units, given in pixels.
pub(super) fn px(pixels: f64) -> i32 {
    (pixels * UNITS).round() as i32
}

/// A page in units.
pub(super) type Page<DB> = DrawingArea<DB, Shift>;
/// A plot whose coordinates are values.
pub(super) type Plot<'a, DB> = ChartContext<'a, DB, Cartesian2d<Scale, Scale>>;

impl<E: std::error::Error + Send + Sync> From<DrawingAreaErrorKind<E>> for ChartError {
    fn from(error: DrawingAreaErrorKind<E>) -> Self {
        Self::Drawing(error.to_string())
    }
}

/// What can be drawn on a page of any backend.
pub(super) trait Paint {
    /// Width and height of the page in pixels.
    fn size(&self) -> [f64; 2];

    fn paint<DB: DrawingBackend>(&self, page: &Page<DB>) -> Result<(), ChartError>;

    /// The page as SVG, still open for more.
    fn svg(&self) -> Result<Svg, ChartError> {
        let mut drawn = String::new();
        {
            let [width, height] = self.size().map(|length| px(length).unsigned_abs());
            let page = SVGBackend::with_string(&mut drawn, (width, height)).into_drawing_area();
            self.paint(&page)?;
            page.present()?;
        }
        // The library escapes what means something in XML, but not what XML cannot say.
        drawn.retain(|c| c == '\n' || !c.is_control());
        let mut svg = Svg::default();
        svg.line(&drawn);
        Ok(svg)
    }

    /// The page as pixels, as many as there are units.
    fn pixels(&self) -> Result<RgbImage, ChartError> {
        let [width, height] = self.size().map(|length| px(length).unsigned_abs());
        let mut pixels = RgbImage::from_pixel(width, height, image::Rgb([255; 3]));
        {
            let page = BitMapBackend::with_buffer(&mut pixels, (width, height)).into_drawing_area();
            self.paint(&page)?;
            page.present()?;
        }
        Ok(pixels)
    }
}

/// Pixels as many as there are units become a PNG file: means of some of them, so that edges are smooth.
pub(super) fn png(pixels: &RgbImage) -> Result<Vec<u8>, ChartError> {
    let [width, height] = [pixels.width(), pixels.height()].map(|n| n * FINE / UNITS as u32);
    encode(&imageops::thumbnail(pixels, width, height))
}

/// The bytes of a PNG file.
pub(super) fn encode(pixels: &RgbImage) -> Result<Vec<u8>, ChartError> {
    let mut bytes = Cursor::new(Vec::new());
    let written = pixels.write_to(&mut bytes, ImageFormat::Png);
    written.map_err(|error| ChartError::Drawing(error.to_string()))?;
    Ok(bytes.into_inner())
}

/// Letters of a height in pixels, centred at their place.
pub(super) fn letters(height: f64, vertical: VPos) -> TextStyle<'static> {
    let style = TextStyle::from(sans(height * UNITS)).color(&INK);
    style.pos(Pos::new(HPos::Center, vertical))
}

/// A line of a width in pixels.
pub(super) fn stroke(colour: Colour, width: f64) -> ShapeStyle {
    colour.stroke_width(px(width).unsigned_abs())
}

/// Writes the headline at the top of a page and returns what is left of it.
pub(super) fn titled<DB: DrawingBackend>(
    page: &Page<DB>,
    title: &str,
    width: f64,
) -> Result<Page<DB>, ChartError> {
    let (lines, height) = headline(title, width);
    for (middle, line) in lines {
        let at = (px(0.5 * width), px(middle));
        page.draw(&Text::new(line, at, letters(TITLE, VPos::Center)))?;
    }
    Ok(page.split_vertically(px(height)).1)
}

/// One name of a legend.
pub(super) struct Key {
    pub(super) name: String,
    pub(super) colour: Colour,
    /// How its curve is drawn; none for bars.
    pub(super) style: Option<Style>,
}

/// Length of the piece of curve before a name, and the space around legends.
const SWATCH: f64 = 26.0;
const GAP: f64 = 6.0;
/// Height of a name: what the library takes for one line.
const ROW: f64 = 1.25 * 1.24 * SMALL;

/// The data of a chart.
pub(super) trait Data {
    fn draw<DB: DrawingBackend>(&self, plot: &mut Plot<'_, DB>) -> Result<(), ChartError>;
}

/// A chart: data within axes, under a title.
pub(super) struct Chart<'c, D> {
    pub(super) title: &'c str,
    pub(super) labels: [&'c str; 2],
    pub(super) x: Scale,
    pub(super) y: Scale,
    pub(super) keys: Vec<Key>,
    /// Whether lines rise from the ticks of the x axis.
    pub(super) upright: bool,
    pub(super) width: f64,
    pub(super) data: &'c D,
}

/// Height of a plot with its axes on a page of the given width.
fn plot_height(width: f64) -> f64 {
    0.36 * width + 130.0
}

/// How many ticks have room along both axes.
pub(super) fn most_ticks(width: f64) -> [usize; 2] {
    [
        (width / 90.0) as usize,
        (plot_height(width) / 45.0) as usize,
    ]
}

impl<D: Data> Chart<'_, D> {
    pub(super) fn to_svg(&self) -> Result<String, ChartError> {
        Ok(self.svg()?.page(self.size(), UNITS))
    }

    pub(super) fn to_png(&self) -> Result<Vec<u8>, ChartError> {
        png(&self.pixels()?)
    }

    /// Width of the widest name with its swatch.
    fn key_width(&self) -> f64 {
        let names = self.keys.iter().map(|key| text_width(&key.name, SMALL));
        SWATCH + 3.0 * GAP + names.fold(0.0, f64::max)
    }

    /// Whether the legend stands at the right of the plot, and not below it.
    fn beside(&self) -> bool {
        let fits = self.keys.len() as f64 * ROW <= plot_height(self.width) - 60.0;
        fits && self.width >= 500.0 && self.key_width() <= 0.34 * self.width
    }

    /// Columns and rows of a legend below the plot.
    fn below(&self) -> (usize, usize) {
        let columns = (self.width / self.key_width()) as usize;
        let columns = columns.clamp(1, self.keys.len().max(1));
        (columns, self.keys.len().div_ceil(columns))
    }

    /// Height of the words below the x axis: names share its width.
    fn x_letters(&self, width: f64) -> f64 {
        let ticks = &self.x.ticks;
        let room = width / ticks.len().max(1) as f64 - 8.0;
        let heights = ticks.iter().map(|tick| fitting(&tick.label, SMALL, room));
        heights.fold(SMALL, f64::min)
    }

    fn draw_plot<DB: DrawingBackend>(&self, area: &Page<DB>) -> Result<(), ChartError> {
        let [x_label, y_label] = self.labels;
        let ticks = self
            .y
            .ticks
            .iter()
            .map(|tick| text_width(&tick.label, SMALL));
        let left = ticks.fold(0.0, f64::max) + 34.0;
        let fit = |label, room| fitting(label, TEXT, room);
        let desc =
            fit(y_label, plot_height(self.width) - 20.0).min(fit(x_label, self.width - left));
        let mut plot = ChartBuilder::on(area)
            .margin_top(px(4.0))
            .margin_left(px(4.0))
            .margin_right(px(18.0))
            .margin_bottom(px(6.0))
            .set_label_area_size(LabelAreaPosition::Left, px(left))
            .set_label_area_size(LabelAreaPosition::Bottom, px(44.0))
            .build_cartesian_2d(self.x.clone(), self.y.clone())?;
        let mut mesh = plot.configure_mesh();
        mesh.bold_line_style(stroke(PALE, 0.75))
            .light_line_style(stroke(FAINT, 0.75))
            .axis_style(stroke(INK, 1.0))
            .set_all_tick_mark_size(px(5.0))
            .label_style(letters(SMALL, VPos::Center))
            .x_label_style(letters(self.x_letters(self.width - left), VPos::Center))
            .axis_desc_style(letters(desc, VPos::Center))
            .x_desc(x_label)
            .y_desc(y_label);
        if !self.upright {
            mesh.disable_x_mesh();
        }
        mesh.draw()?;
        self.data.draw(&mut plot)
    }
}

impl<D: Data> Paint for Chart<'_, D> {
    fn size(&self) -> [f64; 2] {
        let legend = match self.keys.is_empty() || self.beside() {
            true => 0.0,
            false => self.below().1 as f64 * ROW + 2.0 * GAP,
        };
        let top = headline(self.title, self.width).1;
        [self.width, (top + plot_height(self.width) + legend).round()]
    }

    fn paint<DB: DrawingBackend>(&self, page: &Page<DB>) -> Result<(), ChartError> {
        let body = titled(page, self.title, self.width)?;
        if self.keys.is_empty() {
            return self.draw_plot(&body);
        }
        if self.beside() {
            let (body, legend) = body.split_horizontally(px(self.width - self.key_width()));
            self.draw_plot(&body)?;
            return draw_keys(&legend, &self.keys);
        }
        let (body, legend) = body.split_vertically(px(plot_height(self.width)));
        self.draw_plot(&body)?;
        let (columns, rows) = self.below();
        let areas = legend.split_evenly((1, columns));
        let mut parts = areas.iter().zip(self.keys.chunks(rows));
        parts.try_for_each(|(area, keys)| draw_keys(area, keys))
    }
}

/// The library's legend of series, in an area of its own.
fn draw_keys<DB: DrawingBackend>(area: &Page<DB>, keys: &[Key]) -> Result<(), ChartError> {
    let mut chart = ChartBuilder::on(area).build_cartesian_2d(0.0..1.0, 0.0..1.0)?;
    for Key {
        name,
        colour,
        style,
    } in keys
    {
        let (pen, fill, long) = (stroke(*colour, 2.0), colour.filled(), px(20.0));
        let series = chart.draw_series(std::iter::empty::<Circle<(f64, f64), i32>>())?;
        series.label(name.clone());
        match style {
            Some(Style::Marks) => {
                series.legend(move |(x, y)| Circle::new((x + long / 2, y), px(3.5), fill))
            }
            Some(Style::Dashed) => series.legend(move |(x, y)| {
                DashedPathElement::new([(x, y), (x + long, y)], px(6.0), px(4.0), pen)
            }),
            Some(Style::Line | Style::MarksAndLine) => {
                series.legend(move |(x, y)| PathElement::new(vec![(x, y), (x + long, y)], pen))
            }
            None => series.legend(move |(x, y)| {
                Rectangle::new([(x, y - px(4.5)), (x + long, y + px(4.5))], fill)
            }),
        };
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::Coordinate(0, 0))
        .margin(px(GAP))
        .legend_area_size(px(SWATCH))
        .label_font(TextStyle::from(sans(SMALL * UNITS)).color(&INK))
        .draw()?;
    Ok(())
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// The words of an SVG file.
    pub(in crate::lab::drawing) fn texts(svg: &str) -> Vec<String> {
        let ends = svg
            .split("</text>")
            .filter_map(|part| part.rsplit_once('>'));
        ends.map(|(_, text)| text.trim().to_owned()).collect()
    }

    /// The numbers of an attribute.
    pub(in crate::lab::drawing) fn points_of(tag: &str, attribute: &str) -> Vec<f64> {
        let (_, from) = tag
            .split_once(&format!(" {attribute}=\""))
            .expect("the attribute");
        let text = from.split('"').next().unwrap_or_default();
        let numbers = text.split([' ', ',']).filter(|number| !number.is_empty());
        numbers
            .map(|number| number.parse().expect("a number"))
            .collect()
    }

    /// Left, top, right and bottom of the plot, in units: from its axes, which cross at lower left.
    pub(in crate::lab::drawing) fn plot_window(svg: &str) -> [f64; 4] {
        let ink = svg
            .lines()
            .filter(|line| line.starts_with("<polyline") && line.contains("#222222"));
        let lines: Vec<Vec<f64>> = ink.map(|line| points_of(line, "points")).collect();
        let length = |p: &&Vec<f64>, axis: usize| (p[axis] - p[axis + 2]).abs();
        let longest = |axis: usize| {
            let by_length =
                |a: &&Vec<f64>, b: &&Vec<f64>| length(a, axis).total_cmp(&length(b, axis));
            lines.iter().max_by(by_length).expect("an axis").clone()
        };
        let (across, up) = (longest(0), longest(1));
        [
            across[0].min(across[2]),
            up[1].min(up[3]),
            across[0].max(across[2]),
            up[1].max(up[3]),
        ]
    }

    /// Width and pixels of a PNG file.
    pub(in crate::lab::drawing) fn decoded(bytes: &[u8]) -> (usize, Vec<u8>) {
        let picture = image::load_from_memory(bytes).expect("a PNG").to_rgb8();
        (picture.width() as usize, picture.into_raw())
    }

    #[test]
    fn fine_pixels_are_means() {
        // Four units to a pixel, two of them to a pixel of the file.
        let mut units = RgbImage::new(4, 4);
        units.put_pixel(0, 0, image::Rgb([200, 100, 40]));
        let (width, pixels) = decoded(&png(&units).expect("a PNG"));
        assert_eq!(width, 2);
        assert_eq!(
            (&pixels[..3], &pixels[3..]),
            (&[50, 25, 10][..], &[0; 9][..])
        );
    }
}
