//! Bars: a few values side by side, in groups. Bars of the same name share a colour.

use super::font::{SMALL, text_width};
use super::palette::{INK, series};
use super::plot::{Chart, Data, Key, Plot, letters, most_ticks, px, stroke};
use super::scale::{Axis, Scale, extent};
use super::ticks::number;
use super::{ChartError, FULL, finite, placed};
use plotters::prelude::*;
use plotters::style::text_anchor::VPos;

/// Groups of bars over one value axis.
#[derive(Clone, Debug, Default)]
pub struct BarChart {
    /// Headline.
    pub title: String,
    /// What the groups are.
    pub x_label: String,
    /// Name of the value axis, with its unit.
    pub y_label: String,
    /// Spread of the value axis. Linear bars stand on zero, log bars on a power of ten.
    pub y_axis: Axis,
    /// The groups, from left to right.
    pub groups: Vec<BarGroup>,
}

/// Bars that belong together.
#[derive(Clone, Debug, Default)]
pub struct BarGroup {
    /// Name below the group.
    pub name: String,
    /// The bars, from left to right.
    pub bars: Vec<Bar>,
}

/// One bar.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bar {
    /// Name in the legend; bars of the same name have the same colour.
    pub label: String,
    /// Height.
    pub value: f64,
    /// One standard error, drawn to both sides of the top.
    pub error: Option<f64>,
}

impl Bar {
    /// A bar without an error.
    pub fn new(label: impl Into<String>, value: f64) -> Self {
        Self {
            label: label.into(),
            value,
            error: None,
        }
    }

    /// Both ends of the error bar, or twice the value itself.
    fn ends(&self) -> [f64; 2] {
        let error = self.error.unwrap_or(0.0);
        [self.value - error, self.value + error]
    }
}

impl BarChart {
    /// The chart as SVG text, as wide as a page.
    pub fn to_svg(&self) -> Result<String, ChartError> {
        self.chart(FULL)?.to_svg()
    }

    /// The chart as a PNG file, as wide as a page.
    pub fn to_png(&self) -> Result<Vec<u8>, ChartError> {
        self.chart(FULL)?.to_png()
    }

    fn chart(&self, width: u32) -> Result<Chart<'_, Self>, ChartError> {
        self.check()?;
        let width = f64::from(width);
        let names = self.names().into_iter().enumerate();
        let key = |(index, name): (usize, &str)| Key {
            name: name.to_owned(),
            colour: series(index),
            style: None,
        };
        let middles = self.groups.iter().scan(0.0, |left, group| {
            let span = group.bars.len() as f64 + 1.0;
            *left += span;
            Some((*left - 0.5 * span, group.name.clone()))
        });
        Ok(Chart {
            title: &self.title,
            labels: [&self.x_label, &self.y_label],
            x: Scale::named(self.slots(), middles),
            y: self.y_scale(most_ticks(width)[1]).0,
            keys: names
                .filter(|(_, name)| !name.is_empty())
                .map(key)
                .collect(),
            upright: false,
            width,
            data: self,
        })
    }

    fn check(&self) -> Result<(), ChartError> {
        if self.bars().next().is_none() {
            return Err(ChartError::Empty(self.title.clone()));
        }
        for BarGroup { name, bars } in &self.groups {
            let numbers = |bar: &Bar| [bar.value, bar.error.unwrap_or(0.0)];
            finite(&self.title, name, bars.iter().map(numbers))?;
            placed(
                &self.title,
                name,
                bars.iter().map(|bar| bar.value),
                self.y_axis,
            )?;
        }
        Ok(())
    }

    fn bars(&self) -> impl Iterator<Item = &Bar> {
        self.groups.iter().flat_map(|group| &group.bars)
    }

    /// The different names, in the order of their first bars.
    fn names(&self) -> Vec<&str> {
        let mut names = Vec::new();
        for bar in self.bars() {
            if !names.contains(&bar.label.as_str()) {
                names.push(bar.label.as_str());
            }
        }
        names
    }

    /// Places across the chart: one for each bar, and half an empty one at both ends of a group.
    fn slots(&self) -> f64 {
        (self.bars().count() + self.groups.len()) as f64
    }

    /// The value axis with its foot, and head room for the numbers over the bars.
    fn y_scale(&self, most: usize) -> (Scale, f64) {
        let ends = self
            .bars()
            .flat_map(|bar| [bar.value].into_iter().chain(bar.ends()));
        let (low, high) = extent(ends.filter(|&value| self.y_axis.admits(value)));
        let (bottom, top, foot) = match self.y_axis {
            Axis::Linear => {
                let room = 0.1 * (high.max(0.0) - low.min(0.0));
                let bottom = if low < 0.0 { low - room } else { 0.0 };
                (bottom, if high > 0.0 { high + room } else { 0.0 }, 0.0)
            }
            Axis::Log => {
                // A little below the smallest value, so that no bar has height zero.
                let foot = libm::exp10(libm::floor(libm::log10(0.8 * low)));
                (foot, high * libm::pow(high / foot, 0.1), foot)
            }
        };
        (Scale::between(self.y_axis, bottom, top, most), foot)
    }
}

impl Data for BarChart {
    fn draw<DB: DrawingBackend>(&self, plot: &mut Plot<'_, DB>) -> Result<(), ChartError> {
        const HALF_WIDTH: f64 = 0.42;
        let (names, foot) = (self.names(), self.y_scale(2).1);
        let colour = |bar: &Bar| {
            series(
                names
                    .iter()
                    .position(|&name| name == bar.label)
                    .unwrap_or(0),
            )
        };
        let slot = f64::from(plot.plotting_area().dim_in_pixel().0) / self.slots();
        let fits = |bar: &Bar| f64::from(px(text_width(&number(bar.value), SMALL))) <= slot;
        let numbered = self.bars().all(fits);
        let frame = plot.y_range();
        let mut middle = 0.0;
        for group in &self.groups {
            for bar in &group.bars {
                middle += 1.0;
                let corners = [
                    (middle - HALF_WIDTH, bar.value),
                    (middle + HALF_WIDTH, foot),
                ];
                plot.draw_series([Rectangle::new(corners, colour(bar).filled())])?;
                let [low, high] = bar.ends().map(|end| end.clamp(frame.start, frame.end));
                if bar.error.is_some() {
                    let pen = stroke(INK, 1.25);
                    plot.draw_series([ErrorBar::new_vertical(middle, low, high, high, pen, 0)])?;
                }
                if numbered {
                    let (end, side, off) = match bar.value < 0.0 {
                        true => (low, VPos::Top, px(4.0)),
                        false => (high, VPos::Bottom, px(-3.0)),
                    };
                    let text = Text::new(number(bar.value), (0, off), letters(SMALL, side));
                    plot.draw_series([EmptyElement::at((middle, end)) + text])?;
                }
            }
            middle += 1.0;
        }
        if self.bars().any(|bar| bar.value < 0.0) {
            let zero = vec![(0.0, foot), (self.slots(), foot)];
            plot.draw_series([PathElement::new(zero, stroke(INK, 1.0))])?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::drawing::plot::tests::{points_of, texts};

    fn chart(values: &[f64]) -> BarChart {
        let bars = |values: &[f64]| {
            let named = ["plain", "weighted"].into_iter().zip(values);
            named.map(|(name, &value)| Bar::new(name, value)).collect()
        };
        let groups = values.chunks(2).zip(["room", "hall", "yard"]);
        BarChart {
            title: "noise".into(),
            groups: groups
                .map(|(values, name)| BarGroup {
                    name: name.into(),
                    bars: bars(values),
                })
                .collect(),
            ..BarChart::default()
        }
    }

    #[test]
    fn bars_of_one_name_share_a_colour_and_a_place_in_the_legend() {
        let svg = chart(&[1.0, 2.0, 3.0, 4.0, 5.0]).to_svg().unwrap();
        assert_eq!(
            svg.matches("fill=\"#0072B2\" stroke=\"none\"").count(),
            3 + 1
        );
        assert_eq!(
            svg.matches("fill=\"#D55E00\" stroke=\"none\"").count(),
            2 + 1
        );
        let texts = texts(&svg);
        for word in ["noise", "room", "hall", "yard", "plain", "weighted", "5"] {
            assert!(texts.iter().any(|text| text == word), "{word} in {texts:?}");
        }
    }

    #[test]
    fn linear_bars_stand_on_zero_and_log_bars_below_the_smallest() {
        let mut chart = chart(&[0.9, 1.0, 250.0]);
        assert_eq!(chart.y_scale(5).1, 0.0);
        chart.y_axis = Axis::Log;
        assert_eq!(chart.y_scale(5).1, 0.1);
    }

    #[test]
    fn bars_are_as_high_as_their_values() {
        // Rectangles of the two bars and of their legend.
        let svg = chart(&[1.0, 2.0]).to_svg().unwrap();
        let height = |colour: &str| {
            let end = svg
                .find(&format!("fill=\"{colour}\" stroke=\"none\""))
                .unwrap();
            let tag = &svg[svg[..end].rfind('<').unwrap()..end];
            points_of(tag, "height")[0]
        };
        let [one, two] = ["#0072B2", "#D55E00"].map(height);
        assert!(
            (two - 2.0 * one).abs() <= 2.0,
            "{one} and {two} quarter pixels"
        );
    }

    #[test]
    fn empty_infinite_and_misplaced_bars_are_refused() {
        assert_eq!(chart(&[]).to_svg(), Err(ChartError::Empty("noise".into())));
        let place = || ("noise".into(), "hall".into(), 1);
        let (chart_name, series, index) = place();
        let expected = ChartError::NonFinite {
            chart: chart_name,
            series,
            index,
        };
        assert_eq!(chart(&[1.0, 2.0, 3.0, f64::NAN]).to_svg(), Err(expected));
        let mut low = chart(&[1.0, 2.0, 3.0, 0.0]);
        assert!(low.to_svg().is_ok());
        low.y_axis = Axis::Log;
        let (chart, series, index) = place();
        let expected = ChartError::NonPositive {
            chart,
            series,
            index,
        };
        assert_eq!(low.to_svg(), Err(expected));
    }
}
