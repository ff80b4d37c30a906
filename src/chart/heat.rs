//! A picture of numbers: the value of each pixel as a colour, and the scale beside it.

use super::area::Area;
use super::axis::{Axis, Scale};
use super::canvas::{INK, Letters, NORMAL, Page, Pen, SMALL, TITLE_BAND, paint, px};
use super::{ChartError, SIZE};
use crate::render::accuracy::quantile;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use plotters::prelude::{Color, RGBColor, Rectangle};
use plotters::style::text_anchor::{HPos, VPos};

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
const RIGHT: i32 = px(150);
const MARGIN: i32 = px(22);
/// The share of the values that the scale leaves out at either end.
const TAIL: f64 = 0.002;
const STEPS: i32 = 128;

impl HeatMap {
    /// The map as SVG text, the pixels within as a PNG.
    pub fn to_svg(&self) -> Result<String, ChartError> {
        let scale = self.scale()?;
        let height = self.values.len() as u32 / self.width;
        let page_width = px(SIZE.0 as i32);
        let across = page_width - MARGIN - RIGHT;
        let down = (f64::from(across) * f64::from(height) / f64::from(self.width)) as i32;
        let area = Area {
            left: MARGIN,
            top: TITLE_BAND,
            width: across,
            height: down.max(px(160)),
        };
        let page = (page_width, area.bottom() + MARGIN);
        let svg = paint(page, &self.title, |page| {
            draw_scale(page, area, &scale, &self.label)
        })?;
        let image = format!(
            "<image x=\"{}\" y=\"{}\" width=\"{across}\" height=\"{down}\" \
             preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\" \
             href=\"data:image/png;base64,{}\"/>\n</svg>",
            area.left,
            area.top,
            STANDARD.encode(self.png(&scale)?)
        );
        Ok(svg.replacen("</svg>", &image, 1))
    }

    fn scale(&self) -> Result<Scale, ChartError> {
        let has_place = |x: &f64| x.is_finite() && self.axis.admits(*x);
        let values: Vec<f64> = self.values.iter().copied().filter(has_place).collect();
        if values.is_empty() {
            return Err(ChartError::Empty(self.title.clone()));
        }
        let [low, high] = [TAIL, 1.0 - TAIL].map(|share| quantile(values.clone(), share));
        Ok(Scale::between(self.axis, low, high))
    }

    fn png(&self, scale: &Scale) -> Result<Vec<u8>, ChartError> {
        let shade = |&x: &f64| {
            if x.is_finite() {
                colour(scale.share(x))
            } else {
                NOT_FINITE
            }
        };
        let pixels: Vec<u8> = self.values.iter().flat_map(shade).collect();
        let height = self.values.len() as u32 / self.width;
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, self.width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let failure = |e: png::EncodingError| ChartError::Drawing(e.to_string());
        let mut writer = encoder.write_header().map_err(failure)?;
        writer.write_image_data(&pixels).map_err(failure)?;
        writer.finish().map_err(failure)?;
        Ok(bytes)
    }
}

/// The colour at a share of the way along the ramp.
fn colour(share: f64) -> [u8; 3] {
    let place = share.clamp(0.0, 1.0) * (RAMP.len() - 1) as f64;
    let step = (place as usize).min(RAMP.len() - 2);
    let rest = place - step as f64;
    [0, 1, 2].map(|i| (RAMP[step][i] * (1.0 - rest) + RAMP[step + 1][i] * rest).round() as u8)
}

/// A column of all colours with ticks, at the right of the map.
fn draw_scale(page: &Page<'_>, map: Area, scale: &Scale, label: &str) -> Result<(), ChartError> {
    let column = Area {
        left: map.right() + px(24),
        top: map.top + px(28),
        width: px(22),
        height: map.height - px(28),
    };
    let words = Letters::new(NORMAL).anchored(HPos::Left, VPos::Top);
    words.write(page, (map.right() + px(16), map.top), label)?;
    for step in 0..STEPS {
        // Each reaches to the top, so that no seam shows between it and the next.
        let low = f64::from(step) / f64::from(STEPS);
        let [r, g, b] = colour(low + 0.5 / f64::from(STEPS));
        let corners = [column.pixel(0.0, low), column.pixel(1.0, 1.0)];
        page.draw(&Rectangle::new(corners, RGBColor(r, g, b).filled()))?;
    }
    Pen::solid(INK, 1).trace(page, column.outline())?;
    for tick in &scale.ticks {
        let (x, y) = column.pixel(1.0, scale.share(tick.value));
        Pen::solid(INK, 1).trace(page, vec![(x, y), (x + px(5), y)])?;
        let letters = Letters::new(SMALL).anchored(HPos::Left, VPos::Center);
        letters.write(page, (x + px(9), y), &tick.label)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_map_shows_its_values_and_a_scale() {
        let map = HeatMap {
            title: "need".into(),
            label: "samples".into(),
            width: 3,
            values: vec![1.0, 10.0, 100.0, 1000.0, 0.0, f64::INFINITY],
            axis: Axis::Log,
        };
        let svg = map.to_svg().unwrap();
        for part in [
            "samples",
            "\n1000\n",
            "\n10\n",
            "data:image/png;base64,",
            "</svg>",
        ] {
            assert!(svg.contains(part), "{part}");
        }
        let scale = map.scale().unwrap();
        assert_eq!(colour(scale.share(1.0)), [20, 14, 54]);
        assert_eq!(colour(scale.share(0.0)), [20, 14, 54]);
        assert_eq!(colour(scale.share(1e9)), [252, 240, 150]);
        let nothing = HeatMap {
            values: vec![0.0; 3],
            ..map
        };
        assert_eq!(nothing.to_svg(), Err(ChartError::Empty("need".into())));
    }
}
