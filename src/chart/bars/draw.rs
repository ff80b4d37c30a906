//! How bars are drawn.
//!
//! Names stand below the bars where there is room for them; otherwise a legend at the right tells
//! which colour is which. Across the chart, places are counted in *slots*: one for each bar, and
//! half an empty one at both ends of a group.

use plotters::prelude::{Color, RGBColor, Rectangle};
use plotters::style::text_anchor::{HPos, VPos};

use super::{Bar, BarChart};
use crate::chart::ChartError;
use crate::chart::area::Area;
use crate::chart::axis::{Axis, Scale, extent};
use crate::chart::canvas::{INK, Letters, Page, Pen, SMALL, palette, px, text_width, wrap};
use crate::chart::legend::{Key, column_size, draw_column};
use crate::chart::plane::{Plane, Plot, draw_error};
use crate::chart::ticks::number;

/// From one row of names below the axis to the next.
const ROW: i32 = px(19);

impl BarChart {
    /// The value axis with its foot, and head room for the numbers over the bars.
    pub(super) fn y_scale(&self) -> (Scale, f64) {
        let reaches = self
            .bars()
            .flat_map(|bar| [bar.value].into_iter().chain(bar.reach()));
        let (low, high) = extent(reaches.filter(|&value| self.y_axis.admits(value)));
        match self.y_axis {
            Axis::Linear => {
                let room = 0.1 * (high.max(0.0) - low.min(0.0));
                let bottom = if low < 0.0 { low - room } else { 0.0 };
                let top = if high > 0.0 { high + room } else { 0.0 };
                (Scale::between(self.y_axis, bottom, top), 0.0)
            }
            Axis::Log => {
                // A little below the smallest value, so that no bar has height zero.
                let foot = libm::exp10(libm::floor(libm::log10(0.8 * low)));
                let top = high * libm::pow(high / foot, 0.1);
                (Scale::between(self.y_axis, foot, top), foot)
            }
        }
    }

    /// Slots across the chart.
    fn slots(&self) -> f64 {
        (self.bars().count() + self.groups.len()) as f64
    }

    pub(super) fn draw(&self, page: &Page<'_>) -> Result<(), ChartError> {
        let (y, foot) = self.y_scale();
        let mut plane = Plane {
            x: &Scale::bare(self.slots()),
            y: &y,
            x_label: &self.x_label,
            y_label: &self.y_label,
            right: 0,
            below: 0,
        };
        let slot = f64::from(plane.plot_area(page).width) / self.slots();
        let fits = |name: &str| f64::from(text_width(name, SMALL) + px(4)) <= slot;
        let named_below = self.names().into_iter().all(fits);
        let keys = self.keys();
        let (width, height) = column_size(&keys);
        if !named_below {
            plane.right = width;
        }
        let captions = self.captions(plane.plot_area(page), named_below);
        let rows = captions.iter().map(|caption| caption.row).max();
        plane.below = rows.unwrap_or(0) * ROW;

        let area = plane.plot_area(page);
        let plot = plane.draw(page)?;
        self.draw_bars(page, &plot, foot)?;
        for caption in captions {
            caption.write(page, area.bottom() + px(8))?;
        }
        if !named_below {
            let (left, top) = (area.right() + px(12), area.top);
            let legend = Area {
                left,
                top,
                width,
                height,
            };
            draw_column(page, legend, &keys)?;
        }
        Ok(())
    }

    fn keys(&self) -> Vec<Key> {
        let names = self.names().into_iter().enumerate();
        names
            .map(|(index, name)| Key::line(name, Pen::solid(palette(index), 12)))
            .collect()
    }

    /// The words below the axis: bar names where they fit, and group names in a row of their own.
    fn captions(&self, area: Area, named_below: bool) -> Vec<Caption> {
        let slot = f64::from(area.width) / self.slots();
        let across = |slots: f64| area.left + (slots * slot).round() as i32;
        let names = named_below && self.bars().any(|bar| !bar.label.is_empty());
        let mut captions = Vec::new();
        let mut left = 0.0;
        for group in &self.groups {
            let span = group.bars.len() as f64 + 1.0;
            for (index, bar) in group.bars.iter().enumerate().filter(|_| names) {
                captions.push(Caption {
                    text: bar.label.clone(),
                    middle: across(left + index as f64 + 1.0),
                    row: 0,
                });
            }
            let lines = wrap(&group.name, SMALL, (span * slot) as i32 - px(8));
            for (row, text) in (i32::from(names)..).zip(lines) {
                let middle = across(left + span / 2.0);
                captions.push(Caption { text, middle, row });
            }
            left += span;
        }
        captions
    }

    fn draw_bars(&self, page: &Page<'_>, plot: &Plot<'_>, foot: f64) -> Result<(), ChartError> {
        let names = self.names();
        let slot = f64::from(plot.dim_in_pixel().0) / self.slots();
        let fits = |bar: &Bar| f64::from(text_width(&number(bar.value), SMALL)) <= slot;
        let numbered = self.bars().all(fits);
        let mut middle = 1.0;
        for group in &self.groups {
            for bar in &group.bars {
                let name = names.iter().position(|&name| name == bar.label);
                bar.draw(plot, middle, foot, palette(name.unwrap_or(0)))?;
                if numbered {
                    bar.write_value(page, plot, middle)?;
                }
                middle += 1.0;
            }
            middle += 1.0;
        }
        if self.bars().any(|bar| bar.value < 0.0) {
            let zero = vec![(0.0, foot), (self.slots(), foot)];
            Pen::solid(INK, 1).trace(plot, zero)?;
        }
        Ok(())
    }
}

/// A word below the axis, centred on a place across the page.
struct Caption {
    text: String,
    middle: i32,
    row: i32,
}

impl Caption {
    fn write(&self, page: &Page<'_>, top: i32) -> Result<(), ChartError> {
        let letters = Letters::new(SMALL).anchored(HPos::Center, VPos::Top);
        letters.write(page, (self.middle, top + self.row * ROW), &self.text)
    }
}

impl Bar {
    fn draw(
        &self,
        plot: &Plot<'_>,
        middle: f64,
        foot: f64,
        colour: RGBColor,
    ) -> Result<(), ChartError> {
        const HALF_WIDTH: f64 = 0.42;
        let corners = [
            (middle - HALF_WIDTH, self.value),
            (middle + HALF_WIDTH, foot),
        ];
        plot.draw(&Rectangle::new(corners, colour.filled()))?;
        match self.error {
            Some(_) => draw_error(plot, middle, self.reach(), Pen::solid(INK, 2)),
            None => Ok(()),
        }
    }

    /// Writes the value beyond the end of the bar and of its error.
    fn write_value(&self, page: &Page<'_>, plot: &Plot<'_>, middle: f64) -> Result<(), ChartError> {
        let [low, high] = self.reach();
        let (end, side, off) = if self.value < 0.0 {
            (low.min(high), VPos::Top, px(4))
        } else {
            (high.max(low), VPos::Bottom, px(-2))
        };
        let (x, y) = plot.map_coordinate(&(middle, end));
        let letters = Letters::new(SMALL).anchored(HPos::Center, side);
        letters.write(page, (x, y + off), &number(self.value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::BarGroup;

    #[test]
    fn long_group_names_break_into_rows_below_the_bar_names() {
        let chart = BarChart {
            groups: vec![BarGroup {
                name: "a glossy floor below a window".into(),
                bars: vec![Bar::new("one", 1.0), Bar::new("two", 2.0)],
            }],
            ..BarChart::default()
        };
        let narrow = Area {
            left: 0,
            top: 0,
            width: px(160),
            height: px(100),
        };
        let rows = |named| {
            let captions = chart.captions(narrow, named);
            captions
                .iter()
                .map(|caption| caption.row)
                .collect::<Vec<_>>()
        };
        assert_eq!(rows(true), [0, 0, 1, 2]);
        assert_eq!(rows(false), [0, 1]);
    }
}
