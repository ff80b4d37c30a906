//! How far apart the numbers of single precision are.

use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, Style};

/// Draws it.
pub fn chart(desk: &mut Desk) -> Result<(), DeskError> {
    // Between two powers of two the spacing is the same: a stair.
    let power = |k: i32| libm::exp2(f64::from(k));
    let stair = (-10..20).flat_map(|k| [k, k + 1].map(|end| (power(end), power(k - 23))));
    let chart = CurveChart {
        title: "The spacing of single precision".to_owned(),
        x_label: "a coordinate".to_owned(),
        y_label: "distance to the next number".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves: vec![
            Curve::new("spacing of f32", Style::Line, stair),
            Curve::new(
                "a fixed offset of 0.001",
                Style::Dashed,
                [-10, 20].map(|k| (power(k), 1e-3)),
            ),
        ],
    };
    let caption = "Numbers of single precision lie the farther apart the larger they are. Look where the lines \
                   cross: from 16384 on, adding 0.001 moves a coordinate by 0.002, and from 32768 on it changes nothing.";
    desk.figure("spacing.svg", caption, chart.to_svg()?)
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_fixed_offset_is_doubled_and_then_lost() {
        let moved = |x: f32| x + 0.001 - x;
        assert!((moved(10_000.0) - 0.001).abs() < 1e-4);
        assert!((moved(20_000.0) - 0.002).abs() < 1e-4);
        assert_eq!(moved(40_000.0), 0.0);
    }
}
