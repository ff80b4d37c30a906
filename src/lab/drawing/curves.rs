//! Curves: measurements with their error bars, and the laws they should follow.

use super::palette::{Colour, series};
use super::plot::{Chart, Data, Key, Plot, most_ticks, px, stroke};
use super::scale::{Axis, Scale};
use super::{ChartError, FULL, finite, placed};
use plotters::prelude::*;

/// Several curves over one pair of axes.
#[derive(Clone, Debug, Default)]
pub struct CurveChart {
    /// Headline.
    pub title: String,
    /// Name of the x axis, with its unit.
    pub x_label: String,
    /// Name of the y axis, with its unit.
    pub y_label: String,
    /// Spread of the x axis.
    pub x_axis: Axis,
    /// Spread of the y axis.
    pub y_axis: Axis,
    /// The curves; their order picks their colours.
    pub curves: Vec<Curve>,
}

/// A named row of points.
#[derive(Clone, Debug, Default)]
pub struct Curve {
    /// Name in the legend; a nameless curve stays out of it.
    pub name: String,
    /// The points, in drawing order.
    pub points: Vec<Point>,
    /// How they are drawn.
    pub style: Style,
    /// Place of its colour in the palette; its own place among the curves where there is none.
    pub colour: Option<usize>,
}

/// A point of a curve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// Where.
    pub x: f64,
    /// How much.
    pub y: f64,
    /// One standard error of `y`, drawn as a bar to both sides.
    pub error: Option<f64>,
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Style {
    /// Separate dots: measurements.
    Marks,
    /// A solid line.
    #[default]
    Line,
    /// Dots joined by a line.
    MarksAndLine,
    /// A dashed line beneath the others: a law to compare with.
    Dashed,
}

impl Curve {
    /// A curve from places, values and standard errors.
    pub fn measured(
        name: impl Into<String>,
        style: Style,
        points: impl IntoIterator<Item = (f64, f64, f64)>,
    ) -> Self {
        let measured = |(x, y, error)| Point {
            x,
            y,
            error: Some(error),
        };
        Self {
            points: points.into_iter().map(measured).collect(),
            ..Self::new(name, style, [])
        }
    }

    /// A curve without error bars.
    pub fn new(
        name: impl Into<String>,
        style: Style,
        points: impl IntoIterator<Item = (f64, f64)>,
    ) -> Self {
        let exact = |(x, y)| Point { x, y, error: None };
        Self {
            name: name.into(),
            points: points.into_iter().map(exact).collect(),
            style,
            colour: None,
        }
    }

    /// The same in the colour that has this place in the palette.
    #[must_use]
    pub fn coloured(self, place: usize) -> Self {
        Self {
            colour: Some(place),
            ..self
        }
    }
}

impl Point {
    /// Both ends of the error bar, or twice the value itself.
    fn ends(&self) -> [f64; 2] {
        let error = self.error.unwrap_or(0.0);
        [self.y - error, self.y + error]
    }
}

impl CurveChart {
    /// The chart as SVG text, as wide as a page.
    pub fn to_svg(&self) -> Result<String, ChartError> {
        self.to_svg_at(FULL)
    }

    /// The chart as SVG text, of a width in pixels.
    pub fn to_svg_at(&self, width: u32) -> Result<String, ChartError> {
        self.chart(width)?.to_svg()
    }

    /// The chart as a PNG file, as wide as a page.
    pub fn to_png(&self) -> Result<Vec<u8>, ChartError> {
        self.chart(FULL)?.to_png()
    }

    fn chart(&self, width: u32) -> Result<Chart<'_, Self>, ChartError> {
        self.check()?;
        let width = f64::from(width);
        let [across, up] = most_ticks(width);
        let points = || self.curves.iter().flat_map(|curve| &curve.points);
        // The lower end of an error bar may leave a log axis; the bar then ends at the frame.
        let heights = points().flat_map(|point| [point.y].into_iter().chain(point.ends()));
        let named = self
            .curves
            .iter()
            .enumerate()
            .filter(|(_, curve)| !curve.name.is_empty());
        let key = |(index, curve): (usize, &Curve)| Key {
            name: curve.name.clone(),
            colour: self.colour(index),
            style: Some(curve.style),
        };
        Ok(Chart {
            title: &self.title,
            labels: [&self.x_label, &self.y_label],
            x: Scale::around(self.x_axis, points().map(|point| point.x), across),
            y: Scale::around(self.y_axis, heights, up),
            keys: named.map(key).collect(),
            upright: true,
            width,
            data: self,
        })
    }

    fn colour(&self, index: usize) -> Colour {
        series(self.curves[index].colour.unwrap_or(index))
    }

    /// Refuses what has no place in the chart.
    fn check(&self) -> Result<(), ChartError> {
        if self.curves.is_empty() {
            return Err(ChartError::Empty(self.title.clone()));
        }
        for Curve { name, points, .. } in &self.curves {
            if points.is_empty() {
                return Err(ChartError::Empty(format!("{}: {name}", self.title)));
            }
            let numbers = |p: &Point| [p.x, p.y, p.error.unwrap_or(0.0)];
            finite(&self.title, name, points.iter().map(numbers))?;
            placed(&self.title, name, points.iter().map(|p| p.x), self.x_axis)?;
            placed(&self.title, name, points.iter().map(|p| p.y), self.y_axis)?;
        }
        Ok(())
    }
}

impl Data for CurveChart {
    /// Laws first, so that measurements lie on top.
    fn draw<DB: DrawingBackend>(&self, plot: &mut Plot<'_, DB>) -> Result<(), ChartError> {
        let mut order: Vec<usize> = (0..self.curves.len()).collect();
        order.sort_by_key(|&index| self.curves[index].style != Style::Dashed);
        for index in order {
            self.curves[index].draw(plot, self.colour(index))?;
        }
        Ok(())
    }
}

impl Curve {
    fn draw<DB: DrawingBackend>(
        &self,
        plot: &mut Plot<'_, DB>,
        colour: Colour,
    ) -> Result<(), ChartError> {
        let places = || self.points.iter().map(|p| (p.x, p.y));
        match self.style {
            Style::Marks => {}
            Style::Line | Style::MarksAndLine => {
                plot.draw_series(LineSeries::new(places(), stroke(colour, 2.0)))?;
            }
            Style::Dashed => {
                let pen = stroke(colour, 1.6);
                plot.draw_series(DashedLineSeries::new(places(), px(6.0), px(4.0), pen))?;
            }
        }
        let frame = plot.y_range();
        let bars: Vec<_> = self
            .points
            .iter()
            .filter(|point| point.error.is_some())
            .map(|point| {
                let [low, high] = point.ends().map(|end| end.clamp(frame.start, frame.end));
                let cap = px(6.0).unsigned_abs();
                ErrorBar::new_vertical(point.x, low, point.y, high, stroke(colour, 1.25), cap)
            })
            .collect();
        plot.draw_series(bars)?;
        if matches!(self.style, Style::Marks | Style::MarksAndLine) {
            plot.draw_series(places().map(|at| Circle::new(at, px(3.5), colour.filled())))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::drawing::HALF;
    use crate::lab::drawing::plot::tests::{decoded, plot_window, points_of, texts};

    fn chart(curves: Vec<Curve>) -> CurveChart {
        CurveChart {
            title: "noise".into(),
            x_label: "samples".into(),
            y_label: "error".into(),
            x_axis: Axis::Log,
            y_axis: Axis::Log,
            curves,
        }
    }

    fn falling(style: Style) -> Curve {
        let points = [(1.0, 1.0), (10.0, 0.1), (100.0, 0.01)];
        Curve::new("falling", style, points)
    }

    #[test]
    fn points_lie_at_their_values() {
        let chart = chart(vec![falling(Style::Line)]);
        for width in [FULL, HALF] {
            let svg = chart.to_svg_at(width).unwrap();
            let [left, top, right, bottom] = plot_window(&svg);
            let is_curve = |line: &&str| line.starts_with("<polyline") && line.contains("#0072B2");
            let line = svg.lines().find(is_curve).unwrap();
            let points = points_of(line, "points");
            // A margin of 4 % of the range is left at both ends, so 1/27 of the axis.
            let [across, down] = [right - left, bottom - top];
            for (i, place) in points.chunks(2).enumerate() {
                let share = (0.04 + 0.5 * i as f64) / 1.08;
                let expected = [left + share * across, top + share * down];
                for axis in 0..2 {
                    let off = (place[axis] - expected[axis]).abs();
                    assert!(off <= 2.0, "point {i}: {place:?} for {expected:?}");
                }
            }
        }
    }

    #[test]
    fn error_bars_end_where_they_should_and_at_the_frame() {
        let mut measured = chart(vec![Curve::measured(
            "",
            Style::Marks,
            [(1.0, 2.0, 1.0), (10.0, 2.0, 5.0), (100.0, 1000.0, 0.0)],
        )]);
        let bars = |chart: &CurveChart| -> (Vec<[f64; 2]>, [f64; 4]) {
            let svg = chart.to_svg().unwrap();
            let upright = svg
                .lines()
                .filter(|l| l.starts_with("<line") && l.contains("#0072B2"));
            let ends = upright.filter_map(|line| {
                let x = [points_of(line, "x1")[0], points_of(line, "x2")[0]];
                let y = [points_of(line, "y1")[0], points_of(line, "y2")[0]];
                (x[0] == x[1]).then_some(y)
            });
            (ends.collect(), plot_window(&svg))
        };
        let (ends, [_, top, _, bottom]) = bars(&measured);
        // The axis goes from 1 to 1000, and a margin on both sides.
        let height = |value: f64| {
            let share = (libm::log10(value) / 3.0 + 0.04) / 1.08;
            bottom - share * (bottom - top)
        };
        assert!((ends[0][0] - height(1.0)).abs() <= 2.0, "{ends:?}");
        assert!((ends[0][1] - height(3.0)).abs() <= 2.0, "{ends:?}");
        assert!(
            (ends[1][0] - bottom).abs() <= 2.0,
            "cut at the frame: {ends:?}"
        );
        assert!((ends[1][1] - height(7.0)).abs() <= 2.0, "{ends:?}");
        measured.y_axis = Axis::Linear;
        let (ends, [.., bottom]) = bars(&measured);
        assert!(ends[1][0] < bottom, "a linear axis has room below zero");
    }

    #[test]
    fn a_chart_says_its_title_axes_and_names() {
        for width in [FULL, HALF] {
            let long = Curve::new(
                "a name that is far too long to stand beside the plot",
                Style::Dashed,
                [(1.0, 1.0)],
            );
            for curves in [
                vec![falling(Style::Line)],
                vec![falling(Style::MarksAndLine), long],
            ] {
                let names: Vec<String> = curves.iter().map(|curve| curve.name.clone()).collect();
                let texts = texts(&chart(curves).to_svg_at(width).unwrap());
                let said = ["noise", "samples", "error", "10", "0.1"].map(str::to_owned);
                for word in said.into_iter().chain(names) {
                    assert!(texts.contains(&word), "{word} in {texts:?}");
                }
            }
        }
    }

    #[test]
    fn curves_of_one_colour_and_nameless_ones() {
        let nameless = Curve::new("", Style::Line, [(1.0, 1.0), (2.0, 2.0)]);
        let svg = chart(vec![falling(Style::Line), nameless.coloured(0)])
            .to_svg()
            .unwrap();
        // Both curves, and one piece in the legend.
        let lines = svg
            .lines()
            .filter(|line| line.starts_with('<') && line.contains("#0072B2"));
        assert_eq!(lines.count(), 3);
    }

    #[test]
    fn a_png_has_the_same_chart_twice_as_fine() {
        let png = chart(vec![falling(Style::Line)]).to_png().unwrap();
        let (width, pixels) = decoded(&png);
        assert_eq!(width, 2 * FULL as usize);
        let count = |colour: [u8; 3]| pixels.chunks(3).filter(|pixel| *pixel == colour).count();
        assert!(count([0, 114, 178]) > 1000, "the curve");
        assert!(count([34, 34, 34]) > 1000, "axes and letters");
        assert!(count([255; 3]) > pixels.len() / 6, "paper");
    }

    #[test]
    fn without_points_there_is_no_chart() {
        assert_eq!(
            chart(vec![]).to_svg(),
            Err(ChartError::Empty("noise".into()))
        );
        let empty = Curve::new("hollow", Style::Line, []);
        let refusal = chart(vec![falling(Style::Line), empty]).to_svg();
        assert_eq!(refusal, Err(ChartError::Empty("noise: hollow".into())));
    }

    #[test]
    fn a_number_that_is_none_is_refused_by_name_and_index() {
        for bad in [f64::NAN, f64::INFINITY, f64::MAX] {
            let errors = [0.1, 0.1, 0.1, bad];
            let curve = Curve::measured("error", Style::Line, errors.map(|e| (1.0, 1.0, e)));
            let expected = ChartError::NonFinite {
                chart: "noise".into(),
                series: "error".into(),
                index: 3,
            };
            assert_eq!(chart(vec![curve]).to_svg(), Err(expected));
        }
    }

    #[test]
    fn a_log_axis_refuses_zero_but_not_a_long_error_bar() {
        let mut curve = falling(Style::Marks);
        curve.points[2].error = Some(5.0);
        assert!(chart(vec![curve.clone()]).to_svg().is_ok());
        curve.points[2].y = 0.0;
        let expected = ChartError::NonPositive {
            chart: "noise".into(),
            series: "falling".into(),
            index: 2,
        };
        assert_eq!(chart(vec![curve]).to_svg(), Err(expected));
    }
}
