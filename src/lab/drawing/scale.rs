//! From values to places along an axis, linear or logarithmic: the coordinates of the drawing library,
//! chosen when the chart is drawn.

use super::ticks::{Tick, linear, logarithmic, number};
use libm::{exp10, log10};
use plotters::coord::combinators::{IntoLogRange, LogCoord};
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use std::ops::Range;

/// How values are spread along an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axis {
    /// Equal steps add.
    #[default]
    Linear,
    /// Equal steps multiply; only positive values have a place.
    Log,
}

impl Axis {
    /// Whether the axis has a place for the value.
    pub(super) fn admits(self, value: f64) -> bool {
        self == Self::Linear || value >= 1.0 / super::LARGEST
    }
}

/// An axis with its range and its ticks.
#[derive(Clone, Debug)]
pub(super) struct Scale {
    axis: Axis,
    range: Range<f64>,
    pub(super) ticks: Vec<Tick>,
    /// Values of the faint lines between the ticks.
    faint: Vec<f64>,
}

impl Scale {
    /// A scale from one value to another, widened where they fall together, with about so many ticks at
    /// most.
    pub(super) fn between(axis: Axis, low: f64, high: f64, most: usize) -> Self {
        let (low, high) = match axis {
            Axis::Linear => (low, high),
            // Margins are factors here, and must not lead to zero or to infinity.
            Axis::Log => (low.max(1e-307), high.min(1e307)),
        };
        let size = low.abs().max(high.abs());
        let range = match axis {
            _ if high - low > 1e-9 * size => low..high,
            Axis::Linear if size == 0.0 => -0.5..0.5,
            Axis::Linear => low - 0.1 * size..high + 0.1 * size,
            Axis::Log => low / 3.0..high * 3.0,
        };
        let (ticks, faint) = match axis {
            Axis::Linear => (linear(&range, most), Vec::new()),
            Axis::Log => logarithmic(&range, most),
        };
        Self {
            axis,
            range,
            ticks,
            faint,
        }
    }

    /// A scale that shows all the values for which there is a place, with a margin at both ends.
    pub(super) fn around(axis: Axis, values: impl IntoIterator<Item = f64>, most: usize) -> Self {
        const MARGIN: f64 = 0.04;
        let (low, high) = extent(values.into_iter().filter(|&value| axis.admits(value)));
        match axis {
            Axis::Linear => {
                let margin = MARGIN * (high - low);
                Self::between(axis, low - margin, high + margin, most)
            }
            Axis::Log => {
                let factor = exp10(MARGIN * (log10(high) - log10(low)));
                Self::between(axis, low / factor, high * factor, most)
            }
        }
    }

    /// A linear scale from 0 with names in place of numbers.
    pub(super) fn named(high: f64, names: impl IntoIterator<Item = (f64, String)>) -> Self {
        let tick = |(value, label)| Tick { value, label };
        Self {
            axis: Axis::Linear,
            range: 0.0..high,
            ticks: names.into_iter().map(tick).collect(),
            faint: Vec::new(),
        }
    }

    /// How far along the axis a value lies, from 0 at its lower end to 1 at its upper end. What a log
    /// axis has no place for goes to the lower end.
    pub(super) fn share(&self, value: f64) -> f64 {
        const FINE: i32 = 1 << 24;
        let value = value.clamp(self.range.start, self.range.end);
        f64::from(self.map(&value, (0, FINE))) / f64::from(FINE)
    }

    /// The value at a share of the way.
    pub(super) fn at(&self, share: f64) -> f64 {
        let Range { start, end } = self.range;
        match self.axis {
            Axis::Linear => start + share * (end - start),
            Axis::Log => start * libm::pow(end / start, share),
        }
    }
}

impl Ranged for Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        match self.axis {
            Axis::Linear => RangedCoordf64::from(self.range.clone()).map(value, limit),
            Axis::Log => LogCoord::from(self.range.clone().log_scale()).map(value, limit),
        }
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() {
            self.faint.clone()
        } else {
            self.ticks.iter().map(|tick| tick.value).collect()
        }
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

impl ValueFormatter<f64> for Scale {
    fn format(value: &f64) -> String {
        number(*value)
    }

    fn format_ext(&self, value: &f64) -> String {
        let tick = self.ticks.iter().find(|tick| tick.value == *value);
        tick.map_or_else(|| Self::format(value), |tick| tick.label.clone())
    }
}

/// The smallest and the largest of the values.
pub(super) fn extent(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let all = (f64::INFINITY, f64::NEG_INFINITY);
    values
        .into_iter()
        .fold(all, |(low, high), value| (low.min(value), high.max(value)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ten_stands_in_the_middle_between_one_and_a_hundred() {
        let scale = Scale::between(Axis::Log, 1.0, 100.0, 9);
        assert_eq!(scale.map(&10.0, (0, 1000)), 500);
        assert_eq!(scale.map(&1.0, (0, 1000)), 0);
        assert_eq!(scale.map(&100.0, (0, 1000)), 1000);
        // Upwards, paper counts the other way around.
        assert_eq!(scale.map(&10.0, (1000, 0)), 500);
        let scale = Scale::between(Axis::Linear, 1.0, 100.0, 9);
        assert_eq!(scale.map(&50.5, (0, 1000)), 500);
    }

    #[test]
    fn values_and_shares_belong_together() {
        for axis in [Axis::Linear, Axis::Log] {
            let scale = Scale::between(axis, 0.3, 7.0, 5);
            for i in 0..=20 {
                let share = f64::from(i) / 20.0;
                assert!(
                    (scale.share(scale.at(share)) - share).abs() < 1e-6,
                    "{axis:?} {share}"
                );
            }
            assert_eq!((scale.share(-3.0), scale.share(1e9)), (0.0, 1.0));
        }
    }

    #[test]
    fn a_margin_of_a_twenty_fifth_is_left_at_both_ends() {
        let linear = Scale::around(Axis::Linear, [0.0, 100.0], 5).range;
        assert!((linear.start + 4.0).abs() < 1e-9 && (linear.end - 104.0).abs() < 1e-9);
        let log = Scale::around(Axis::Log, [1.0, 1e25, -4.0], 5).range;
        assert!((log.start - 0.1).abs() < 1e-9 && (log.end / 1e26 - 1.0).abs() < 1e-9);
    }

    #[test]
    fn any_values_make_a_range_with_ticks() {
        for axis in [Axis::Linear, Axis::Log] {
            for values in [
                [3.0, 3.0],
                [1e-300, 1e300],
                [1e-300, 1.1e-300],
                [1e300, 1e300],
                [1e16, 1e16 + 2.0],
                [7.0, 7.0 + 1e-8],
            ] {
                let scale = Scale::around(axis, values, 6);
                assert!(scale.range.start < scale.range.end, "{axis:?} {values:?}");
                assert!(
                    scale.ticks.len() < 12,
                    "{axis:?} {values:?}: {:?}",
                    scale.ticks
                );
            }
        }
        assert!(!Scale::around(Axis::Linear, [0.0], 6).ticks.is_empty());
    }
}
