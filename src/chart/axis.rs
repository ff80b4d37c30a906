//! From values to places and ticks, on linear and logarithmic axes alike.
//!
//! A [`Scale`] knows both kinds of axis, so that one kind of plane serves all four pairs of
//! them. Inside, it works with *positions* along the axis: the value itself, or its decimal
//! logarithm.

use std::ops::Range;

use libm::{exp10, log10};
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

use super::ticks::{Tick, linear_ticks, log_ticks, number};

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
        self == Self::Linear || value > 0.0
    }

    fn position(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Log => log10(value),
        }
    }

    fn value(self, position: f64) -> f64 {
        match self {
            Self::Linear => position,
            Self::Log => exp10(position),
        }
    }
}

/// An axis with its range and its ticks.
#[derive(Clone, Debug)]
pub(super) struct Scale {
    axis: Axis,
    /// Positions of both ends.
    low: f64,
    high: f64,
    pub(super) ticks: Vec<Tick>,
    /// Values of the faint lines between the ticks.
    minor: Vec<f64>,
}

impl Scale {
    /// A scale from one value to another, widened where they fall together.
    pub(super) fn between(axis: Axis, low: f64, high: f64) -> Self {
        Self::from_positions(axis, axis.position(low), axis.position(high))
    }

    /// A scale that shows all the values, with a margin at both ends.
    pub(super) fn around(axis: Axis, values: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) = extent(values.into_iter().map(|value| axis.position(value)));
        let margin = 0.05 * (high - low);
        Self::from_positions(axis, low - margin, high + margin)
    }

    /// A linear scale from 0 without ticks, for things that are counted off.
    pub(super) fn bare(high: f64) -> Self {
        Self {
            axis: Axis::Linear,
            low: 0.0,
            high,
            ticks: Vec::new(),
            minor: Vec::new(),
        }
    }

    fn from_positions(axis: Axis, low: f64, high: f64) -> Self {
        let size = low.abs().max(high.abs());
        let spare = if high - low > 1e-9 * size {
            0.0
        } else {
            (0.1 * size).max(0.5)
        };
        let (low, high) = (low - spare, high + spare);
        let (ticks, minor) = match axis {
            Axis::Linear => (linear_ticks(low, high), Vec::new()),
            Axis::Log => log_ticks(low, high),
        };
        Self {
            axis,
            low,
            high,
            ticks,
            minor,
        }
    }

    /// How far along the axis a value lies, from 0 at its lower end to 1 at its upper end.
    /// What a log axis has no place for goes to the lower end.
    pub(super) fn share(&self, value: f64) -> f64 {
        if self.axis.admits(value) {
            (self.axis.position(value) - self.low) / (self.high - self.low)
        } else {
            0.0
        }
    }
}

impl Ranged for Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        from + (self.share(*value) * f64::from(to - from)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() {
            self.minor.clone()
        } else {
            self.ticks.iter().map(|tick| tick.value).collect()
        }
    }

    fn range(&self) -> Range<f64> {
        self.axis.value(self.low)..self.axis.value(self.high)
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
    values
        .into_iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: Axis, low: f64, high: f64) -> Vec<String> {
        let scale = Scale::around(axis, [low, high]);
        scale.ticks.into_iter().map(|tick| tick.label).collect()
    }

    #[test]
    fn linear_ticks_are_round() {
        let expected = ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"];
        assert_eq!(labels(Axis::Linear, 0.0, 1.0)[1..], expected[1..]);
        assert_eq!(labels(Axis::Linear, 0.0, 3e6)[1], "0.5×10⁶");
    }

    #[test]
    fn log_ticks_follow_the_range() {
        assert_eq!(labels(Axis::Log, 1.0, 1000.0), ["1", "10", "100", "1000"]);
        assert_eq!(labels(Axis::Log, 1e-6, 1e-3)[0], "10⁻⁶");
        assert_eq!(labels(Axis::Log, 1.0, 20.0), ["1", "2", "5", "10", "20"]);
        assert!(labels(Axis::Log, 1.1, 1.4).len() >= 3);
    }

    #[test]
    fn a_wide_log_axis_keeps_few_ticks() {
        assert!(labels(Axis::Log, 1e-30, 1e30).len() <= 9);
    }

    #[test]
    fn a_single_value_gets_a_range() {
        for axis in [Axis::Linear, Axis::Log] {
            let scale = Scale::around(axis, [3.0]);
            assert!(scale.low < scale.high && !scale.ticks.is_empty());
        }
    }
}
