//! The charts of this chapter: variances against the size of a lamp.

use crate::sweep::{Size, Sweep, WAYS};
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, Style};
use halfdisk::lab::estimators::overhead::Overhead;

/// The whole sweep, and its wide end.
pub fn sweep(desk: &mut Desk, sweep: &Sweep) -> Result<(), DeskError> {
    let all: Vec<&Size> = sweep.sizes.iter().collect();
    let caption = "Variances over the squared mean, measured (dots) and by quadrature (lines), \
                   against the lamp's half angle. Both together stay far below the worse technique \
                   and below the bound.";
    let chart = chart("One lamp, four ways to find it", &all, 0.01, Axis::Log);
    desk.figure("chart.svg", caption, chart.to_svg()?)?;
    let wide: Vec<&Size> = all
        .into_iter()
        .filter(|s| s.lamp.half_angle >= 0.9)
        .collect();
    let caption = "The same for large lamps, on axes without logarithms. Where neither technique \
                   is good, both together are better than each; where one is nearly perfect, the \
                   second is a premium paid.";
    let chart = self::chart("Large lamps", &wide, 0.9, Axis::Linear);
    desk.figure("wide.svg", caption, chart.to_svg()?)
}

fn chart(title: &str, sizes: &[&Size], from: f64, axis: Axis) -> CurveChart {
    // Evenly on the axis, from the smallest lamp to the largest.
    let place = |k: u32| {
        let share = f64::from(k) / 60.0;
        match axis {
            Axis::Linear => from + (1.5 - from) * share,
            Axis::Log => from * libm::pow(1.5 / from, share),
        }
    };
    let law = |name: &str, style, of: &dyn Fn(&Overhead) -> f64| {
        let points = (0..=60).map(|k| {
            let lamp = Overhead::new(place(k).min(1.5));
            (lamp.half_angle, of(&lamp) / lamp.mean().powi(2))
        });
        Curve::new(name, style, points.collect::<Vec<_>>())
    };
    let mut curves = vec![law("an oracle", Style::Dashed, &Overhead::oracle).coloured(4)];
    if axis == Axis::Log {
        curves.push(law("the bound", Style::Dashed, &Overhead::bound).coloured(6));
    }
    for (i, (name, technique)) in WAYS.into_iter().enumerate() {
        curves.push(law(name, Style::Line, &|lamp| lamp.variance(technique)).coloured(i));
        let measured = sizes.iter().map(|size| {
            let mu2 = size.lamp.mean().powi(2);
            let square = &size.squares[i];
            (
                size.lamp.half_angle,
                square.mean() / mu2,
                square.std_error() / mu2,
            )
        });
        curves.push(Curve::measured("", Style::Marks, measured).coloured(i));
    }
    CurveChart {
        title: title.to_owned(),
        x_label: "half angle of the lamp, radians".to_owned(),
        y_label: "variance of one estimate / squared mean".to_owned(),
        x_axis: axis,
        y_axis: axis,
        curves,
    }
}
