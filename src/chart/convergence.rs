//! Convergence as a chart.

use super::{Axis, Curve, CurveChart, Point, Style};
use crate::experiment::convergence::Convergence;
use crate::stats::slope::{Fit, Insufficient};

/// Error against samples on logarithmic axes: measured points with their error bars, and in the
/// same colour the fitted line, whose slope stands in the legend.
pub fn convergence_chart(title: impl Into<String>, runs: &[Convergence]) -> CurveChart {
    let curves = runs
        .iter()
        .enumerate()
        .flat_map(|(i, run)| curves(run).into_iter().map(move |c| c.coloured(i)));
    CurveChart {
        title: title.into(),
        x_label: "samples N".into(),
        y_label: "root mean squared error".into(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves: curves.collect(),
    }
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
    let name = format!("{}: {}", run.name, run.slope_text());
    let marks = |name| Curve {
        name,
        points: measured.collect(),
        style: Style::Marks,
        colour: None,
    };
    if let Ok(Fit { line, .. }) | Err(Insufficient::Wide(Fit { line, .. })) = run.fit {
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
    use crate::experiment::convergence::{Design, converge};
    use crate::experiment::named;

    #[test]
    fn points_and_line_share_a_colour_and_the_legend_says_the_slope() {
        let design = Design {
            replicates: 32,
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
