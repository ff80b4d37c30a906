//! Convergence as a chart.

use crate::lab::drawing::{Axis, Curve, CurveChart, Point, Style};
use crate::lab::experiment::convergence::Convergence;
use crate::numeric::fixed;
use crate::stats::slope::{Fit, Line};

/// Error against samples on logarithmic axes: measured points with their error bars, and in the
/// same colour the fitted line, whose slope stands in the legend with its standard error. A run that is
/// alone shows its variance, too.
pub fn convergence_chart(title: impl Into<String>, runs: &[Convergence]) -> CurveChart {
    let mut groups: Vec<Vec<Curve>> = runs.iter().map(curves).collect();
    let mut y_label = "root mean squared error";
    if let [run] = runs {
        groups.push(variance_curves(run));
        y_label = "root mean squared error; variance";
    }
    let coloured = |(i, group): (usize, Vec<Curve>)| group.into_iter().map(move |c| c.coloured(i));
    CurveChart {
        title: title.into(),
        x_label: "samples N; bars and ±: one standard error".into(),
        y_label: y_label.into(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves: groups.into_iter().enumerate().flat_map(coloured).collect(),
    }
}

/// The variance of the estimates, with the line through it; nothing where there is none.
fn variance_curves(run: &Convergence) -> Vec<Curve> {
    // The error that a normal law gives a variance from this many runs.
    let relative = (2.0 / (f64::from(run.replicates) - 1.0)).sqrt();
    let measured: Vec<(f64, f64)> = run
        .sizes
        .iter()
        .filter_map(|size| Some((f64::from(size.samples), size.variance?)))
        .filter(|(_, variance)| *variance > 0.0)
        .collect();
    let (Some(line), Some(first), Some(last)) =
        (Line::through(&measured), measured.first(), measured.last())
    else {
        return Vec::new();
    };
    let ends = [first, last].map(|(n, _)| (*n, line.at(*n)));
    let name = format!("variance: slope {}", fixed(line.slope, 3));
    let points = measured.iter().map(|&(n, v)| (n, v, relative * v));
    vec![
        Curve::measured("", Style::Marks, points),
        Curve::new(name, Style::Dashed, ends),
    ]
}

fn curves(run: &Convergence) -> Vec<Curve> {
    // A size without any error has no place on a logarithmic axis.
    let measured = run
        .sizes
        .iter()
        .filter(|size| size.rmse > 0.0)
        .map(|size| Point {
            x: f64::from(size.samples),
            y: size.rmse,
            // One replicate has an error, but none of that error.
            error: Some(size.rmse_error).filter(|error| error.is_finite()),
        });
    let slope = run.line().map(|fit| {
        let slope = fixed(fit.line.slope, 3);
        format!("slope {slope} ± {}", fixed(fit.std_error, 3))
    });
    let slope = slope.unwrap_or_else(|| run.slope_text());
    let name = format!("{}: {slope}", run.name);
    let marks = |name| Curve {
        name,
        points: measured.collect(),
        style: Style::Marks,
        colour: None,
    };
    if let Some(Fit { line, .. }) = run.line() {
        let ends = [run.sizes.first(), run.sizes.last()];
        let points = ends.into_iter().flatten().map(|size| {
            let n = f64::from(size.samples);
            (n, line.at(n))
        });
        // The line speaks for its points, too.
        vec![
            marks(String::new()),
            Curve::new(name, Style::Dashed, points),
        ]
    } else {
        let marks = marks(name);
        (!marks.points.is_empty())
            .then_some(marks)
            .into_iter()
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::experiment::convergence::{Design, converge};
    use crate::lab::experiment::named;

    #[test]
    fn points_and_line_share_a_colour_and_the_legend_says_the_slope() {
        // The half width of the slope's interval is 0.035 of the 0.1 it may be.
        let design = Design {
            replicates: 128,
            doublings: 6,
            ..Design::default()
        };
        let runs: Vec<_> = ["half-disk", "half-disk-literal"]
            .into_iter()
            .filter_map(named::find)
            .map(|estimator| converge(&estimator, &design))
            .collect();
        let chart = convergence_chart("two gathers", &runs);
        let colours: Vec<_> = chart.curves.iter().map(|c| c.colour).collect();
        assert_eq!(colours, [Some(0), Some(0), Some(1), Some(1)]);
        assert!(chart.curves[1].name.starts_with("half-disk: slope -0."));
        assert!(chart.to_svg().is_ok());
    }
}
