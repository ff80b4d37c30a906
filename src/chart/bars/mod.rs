//! Bars: a few values side by side, in groups. Bars of the same name share a colour.

mod draw;

use super::ChartError;
use super::axis::Axis;
use super::canvas::{PAGE, paint};

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
    /// Name; bars of the same name have the same colour.
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
    fn reach(&self) -> [f64; 2] {
        let error = self.error.unwrap_or(0.0);
        [self.value - error, self.value + error]
    }
}

impl BarChart {
    /// The chart as SVG text.
    pub fn to_svg(&self) -> Result<String, ChartError> {
        self.check()?;
        paint(PAGE, &self.title, |page| self.draw(page))
    }

    fn check(&self) -> Result<(), ChartError> {
        if self.groups.iter().all(|group| group.bars.is_empty()) {
            return Err(ChartError::Empty(self.title.clone()));
        }
        for group in &self.groups {
            for (index, bar) in group.bars.iter().enumerate() {
                let (chart, series) = (self.title.clone(), group.name.clone());
                if !bar.value.is_finite() || !bar.error.unwrap_or(0.0).is_finite() {
                    return Err(ChartError::NonFinite {
                        chart,
                        series,
                        index,
                    });
                }
                if !self.y_axis.admits(bar.value) {
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
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn the_same_chart_gives_the_same_bytes() {
        let chart = chart(&[1.0, 2.0, 3.0, 4.0]);
        assert_eq!(chart.to_svg(), chart.to_svg());
    }

    #[test]
    fn bars_of_one_name_share_a_colour() {
        let svg = chart(&[1.0, 2.0, 3.0, 4.0, 5.0]).to_svg().unwrap();
        assert_eq!(svg.matches("fill=\"#0072B2\"").count(), 3);
        assert_eq!(svg.matches("fill=\"#D55E00\"").count(), 2);
    }

    #[test]
    fn linear_bars_stand_on_zero_and_log_bars_below_the_smallest() {
        let mut chart = chart(&[0.9, 1.0, 250.0]);
        assert_eq!(chart.y_scale().1, 0.0);
        chart.y_axis = Axis::Log;
        assert_eq!(chart.y_scale().1, 0.1);
    }

    #[test]
    fn names_without_room_move_into_a_legend() {
        let swatches = |chart: &BarChart| {
            chart
                .to_svg()
                .unwrap()
                .matches("stroke-width=\"48\"")
                .count()
        };
        let mut chart = chart(&[1.0, 2.0, 3.0, 4.0]);
        assert_eq!(swatches(&chart), 0);
        chart.groups[0].bars[0].label = "a name much longer than any bar is wide".into();
        assert_eq!(swatches(&chart), 3);
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
