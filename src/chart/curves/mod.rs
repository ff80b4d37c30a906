//! Curves: measurements with their error bars, and the laws they should follow.

mod draw;

use super::ChartError;
use super::axis::{Axis, Scale};
use super::canvas::{PAGE, Pen, paint};

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
            name: name.into(),
            points: points.into_iter().map(measured).collect(),
            style,
            colour: None,
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

    fn pen(&self, index: usize) -> Pen {
        self.style.pen(self.colour.unwrap_or(index))
    }
}

impl Point {
    /// Both ends of the error bar, or twice the value itself.
    fn reach(&self) -> [f64; 2] {
        let error = self.error.unwrap_or(0.0);
        [self.y - error, self.y + error]
    }
}

impl CurveChart {
    /// The chart as SVG text.
    pub fn to_svg(&self) -> Result<String, ChartError> {
        self.check()?;
        let points = || self.curves.iter().flat_map(|curve| &curve.points);
        let x = Scale::around(self.x_axis, points().map(|point| point.x));
        // The lower end of an error bar may leave a log axis; the bar then runs off the plot.
        let reaches = points().flat_map(|point| [point.y].into_iter().chain(point.reach()));
        let y = Scale::around(self.y_axis, reaches.filter(|&y| self.y_axis.admits(y)));
        paint(PAGE, &self.title, |page| self.draw(page, &x, &y))
    }

    /// Refuses what has no place in the chart.
    fn check(&self) -> Result<(), ChartError> {
        if self.curves.is_empty() {
            return Err(ChartError::Empty(self.title.clone()));
        }
        for curve in &self.curves {
            if curve.points.is_empty() {
                return Err(ChartError::Empty(format!("{}: {}", self.title, curve.name)));
            }
            for (index, point) in curve.points.iter().enumerate() {
                let (chart, series) = (self.title.clone(), curve.name.clone());
                let numbers = [point.x, point.y, point.error.unwrap_or(0.0)];
                if numbers.iter().any(|number| !number.is_finite()) {
                    return Err(ChartError::NonFinite {
                        chart,
                        series,
                        index,
                    });
                }
                if !self.x_axis.admits(point.x) || !self.y_axis.admits(point.y) {
                    return Err(ChartError::NonPositive {
                        chart,
                        series,
                        index,
                    });
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(curves: Vec<Curve>) -> CurveChart {
        CurveChart {
            title: "noise".into(),
            x_axis: Axis::Log,
            y_axis: Axis::Log,
            curves,
            ..CurveChart::default()
        }
    }

    fn falling(style: Style) -> Curve {
        let points = (0..6).map(|i| f64::from(1 << i)).map(|n| (n, 1.0 / n));
        Curve::new("error", style, points)
    }

    #[test]
    fn the_same_chart_gives_the_same_bytes() {
        let chart = chart(vec![falling(Style::MarksAndLine)]);
        assert_eq!(chart.to_svg(), chart.to_svg());
    }

    #[test]
    fn every_point_gets_a_mark_and_the_legend_one_more() {
        let svg = chart(vec![falling(Style::Marks)]).to_svg().unwrap();
        assert_eq!(svg.matches("<circle").count(), 6 + 1);
        let svg = chart(vec![falling(Style::Dashed)]).to_svg().unwrap();
        assert_eq!(svg.matches("<circle").count(), 0);
    }

    #[test]
    fn charts_and_curves_without_points_are_refused() {
        let empty = Curve::new("hollow", Style::Line, []);
        assert_eq!(
            chart(vec![]).to_svg(),
            Err(ChartError::Empty("noise".into()))
        );
        let refusal = chart(vec![falling(Style::Line), empty]).to_svg();
        assert_eq!(refusal, Err(ChartError::Empty("noise: hollow".into())));
    }

    #[test]
    fn a_number_that_is_none_is_refused_by_name_and_index() {
        let errors = [0.1, 0.1, 0.1, f64::NAN];
        let curve = Curve::measured("error", Style::Line, errors.map(|e| (1.0, 1.0, e)));
        let expected = ChartError::NonFinite {
            chart: "noise".into(),
            series: "error".into(),
            index: 3,
        };
        assert_eq!(chart(vec![curve]).to_svg(), Err(expected));
    }

    #[test]
    fn a_log_axis_refuses_zero_but_not_a_long_error_bar() {
        let mut curve = falling(Style::Marks);
        curve.points[2].error = Some(5.0);
        assert!(chart(vec![curve.clone()]).to_svg().is_ok());
        curve.points[2].y = 0.0;
        let expected = ChartError::NonPositive {
            chart: "noise".into(),
            series: "error".into(),
            index: 2,
        };
        assert_eq!(chart(vec![curve]).to_svg(), Err(expected));
    }
}
