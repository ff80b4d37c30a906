//! A picture of numbers: the value of each pixel as a colour, and the scale beside it.

use super::font::{SMALL, TEXT, headline};
use super::palette::INK;
use super::plot::{Page, Paint, UNITS, encode, letters, png, px, stroke, titled};
use super::scale::{Axis, Scale};
use super::{ChartError, FULL};
use crate::stats::quantile;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use image::{RgbImage, imageops};
use plotters::prelude::*;
use plotters::style::text_anchor::VPos;

/// A value for each pixel of a picture.
#[derive(Clone, Debug, Default)]
pub struct HeatMap {
    /// Headline.
    pub title: String,
    /// What the colours mean, with the unit.
    pub label: String,
    /// Width in pixels.
    pub width: u32,
    /// The values, row by row from the top. What is not finite is red; on a logarithmic scale, what is
    /// not positive has the lowest colour.
    pub values: Vec<f64>,
    /// Spread of the scale. It leaves out the lowest and the highest two thousandths of the values.
    pub axis: Axis,
}

/// Colours from the lowest value to the highest; their lightness grows evenly.
const RAMP: [[f64; 3]; 6] = [
    [20.0, 14.0, 54.0],
    [62.0, 40.0, 128.0],
    [44.0, 104.0, 158.0],
    [42.0, 156.0, 138.0],
    [150.0, 200.0, 84.0],
    [252.0, 240.0, 150.0],
];
const NOT_FINITE: [u8; 3] = [220, 30, 30];
/// Room at the right for the scale and its words.
const RIGHT: f64 = 100.0;
const MARGIN: f64 = 14.0;
/// The share of the values that the scale leaves out at either end.
const TAIL: f64 = 0.002;

impl HeatMap {
    /// The map as SVG text, as wide as a page, the pixels within as a PNG.
    pub fn to_svg(&self) -> Result<String, ChartError> {
        self.to_svg_at(FULL)
    }

    /// The map as SVG text, of a width in pixels.
    pub fn to_svg_at(&self, width: u32) -> Result<String, ChartError> {
        let laid = self.laid(width)?;
        let mut svg = laid.svg()?;
        let [x, y, width, height] = laid.window().map(px);
        svg.line(&format!(
            "<image x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" \
             preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\" \
             href=\"data:image/png;base64,{}\"/>",
            STANDARD.encode(encode(&laid.colours())?)
        ));
        Ok(svg.page(laid.size(), UNITS))
    }

    /// The map as a PNG file, as wide as a page.
    pub fn to_png(&self) -> Result<Vec<u8>, ChartError> {
        let laid = self.laid(FULL)?;
        let mut page = laid.pixels()?;
        let [left, top, width, height] = laid.window().map(px);
        let [width, height] = [width, height].map(i32::unsigned_abs);
        let map = imageops::resize(&laid.colours(), width, height, imageops::Nearest);
        imageops::replace(&mut page, &map, left.into(), top.into());
        png(&page)
    }

    fn height(&self) -> u32 {
        self.values.len() as u32 / self.width.max(1)
    }

    fn laid(&self, width: u32) -> Result<Laid<'_>, ChartError> {
        let has_place = |x: &f64| x.abs() <= super::LARGEST && self.axis.admits(*x);
        let values: Vec<f64> = self.values.iter().copied().filter(has_place).collect();
        if values.is_empty() || self.width == 0 || self.height() == 0 {
            return Err(ChartError::Empty(self.title.clone()));
        }
        let [low, high] = [TAIL, 1.0 - TAIL].map(|share| quantile(values.clone(), share));
        let width = f64::from(width);
        let across = width - MARGIN - RIGHT;
        // A tall picture is as high as the page is wide.
        let aspect = f64::from(self.height()) / f64::from(self.width);
        let across = across.min(width / aspect);
        Ok(Laid {
            map: self,
            scale: Scale::between(self.axis, low, high, (across * aspect / 40.0) as usize),
            width,
            inner: [across, across * aspect],
        })
    }
}

/// A map with its scale, laid on a page.
struct Laid<'m> {
    map: &'m HeatMap,
    scale: Scale,
    width: f64,
    /// Width and height of the map itself.
    inner: [f64; 2],
}

impl Laid<'_> {
    /// Left, top, width and height of the map, in pixels.
    fn window(&self) -> [f64; 4] {
        let left = self.width - RIGHT - self.inner[0];
        let top = headline(&self.map.title, self.width).1;
        [left, top, self.inner[0], self.inner[1]]
    }

    /// The colours of the values.
    fn colours(&self) -> RgbImage {
        let map = self.map;
        RgbImage::from_fn(map.width, map.height(), |x, y| {
            let value = map.values[(y * map.width + x) as usize];
            image::Rgb(match value.is_finite() {
                true => colour(self.scale.share(value)),
                false => NOT_FINITE,
            })
        })
    }
}

impl Paint for Laid<'_> {
    fn size(&self) -> [f64; 2] {
        let [_, top, _, height] = self.window();
        [self.width, (top + height.max(120.0) + MARGIN).round()]
    }

    /// The headline and a column of all colours with its ticks, at the right of the map.
    fn paint<DB: DrawingBackend>(&self, page: &Page<DB>) -> Result<(), ChartError> {
        const STEPS: u32 = 128;
        const COLUMN: f64 = 16.0;
        let body = titled(page, &self.map.title, self.width)?;
        let (_, right) = body.split_horizontally(px(self.width - RIGHT));
        let mut plot = ChartBuilder::on(&right)
            .margin_left(px(14.0))
            .margin_bottom(px(MARGIN))
            .set_label_area_size(LabelAreaPosition::Right, px(RIGHT - 14.0 - COLUMN))
            .build_cartesian_2d(Scale::named(1.0, []), self.scale.clone())?;
        plot.draw_series((0..STEPS).map(|step| {
            // Each reaches to the top, so that no seam shows between it and the next.
            let low = f64::from(step) / f64::from(STEPS);
            let [r, g, b] = colour(low + 0.5 / f64::from(STEPS));
            let corners = [(0.0, self.scale.at(low)), (1.0, self.scale.at(1.0))];
            Rectangle::new(corners, RGBColor(r, g, b).filled())
        }))?;
        plot.configure_mesh()
            .disable_mesh()
            .axis_style(stroke(INK, 1.0))
            .set_all_tick_mark_size(px(5.0))
            .label_style(letters(SMALL, VPos::Center))
            .axis_desc_style(letters(TEXT, VPos::Center))
            .y_desc(&self.map.label)
            .draw()?;
        Ok(())
    }
}

/// The colour at a share of the way along the ramp.
fn colour(share: f64) -> [u8; 3] {
    let place = share.clamp(0.0, 1.0) * (RAMP.len() - 1) as f64;
    let step = (place as usize).min(RAMP.len() - 2);
    let rest = place - step as f64;
    [0, 1, 2].map(|i| (RAMP[step][i] * (1.0 - rest) + RAMP[step + 1][i] * rest).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::drawing::plot::tests::{decoded, texts};

    fn map() -> HeatMap {
        HeatMap {
            title: "need".into(),
            label: "samples".into(),
            width: 3,
            values: vec![1.0, 10.0, 100.0, 1000.0, 0.0, f64::INFINITY],
            axis: Axis::Log,
        }
    }

    #[test]
    fn a_map_shows_its_values_and_a_scale() {
        let svg = map().to_svg().unwrap();
        let words = texts(&svg);
        for word in ["need", "samples", "1", "10", "100", "1000"] {
            assert!(words.iter().any(|text| text == word), "{word} in {words:?}");
        }
        assert!(svg.contains("data:image/png;base64,"));
        let nothing = HeatMap {
            values: vec![0.0; 3],
            ..map()
        };
        assert_eq!(nothing.to_svg(), Err(ChartError::Empty("need".into())));
    }

    #[test]
    fn the_middle_of_a_log_scale_has_the_middle_colour() {
        let map = HeatMap {
            values: vec![1.0, 100.0, 10.0, 0.0, 1e9, f64::NAN],
            ..map()
        };
        let laid = Laid {
            scale: Scale::between(Axis::Log, 1.0, 100.0, 5),
            ..map.laid(FULL).unwrap()
        };
        let colours = laid.colours().into_raw();
        let [low, high, middle] = [0, 1, 2].map(|i| &colours[3 * i..3 * i + 3]);
        assert_eq!((low, high), (&[20, 14, 54][..], &[252, 240, 150][..]));
        // Half of the way from the third to the fourth colour.
        assert_eq!(middle, [43, 130, 148]);
        assert_eq!(&colours[9..], [20, 14, 54, 252, 240, 150, 220, 30, 30]);
    }

    #[test]
    fn a_png_shows_the_colours_where_the_map_lies() {
        let [x, y, width, height] = map().laid(FULL).unwrap().window();
        let (wide, pixels) = decoded(&map().to_png().unwrap());
        assert_eq!(wide, 2 * FULL as usize);
        let at = |column: f64, row: f64| {
            let (x, y) = (
                2.0 * (x + column / 3.0 * width),
                2.0 * (y + row / 2.0 * height),
            );
            let from = 3 * (y as usize * wide + x as usize);
            pixels[from..from + 3].to_vec()
        };
        assert_eq!(at(0.5, 0.5), [20, 14, 54]);
        assert_eq!(at(2.5, 1.5), NOT_FINITE);
    }
}
