//! The variance of a mean against the number of its samples.

use crate::lab::drawing::{Axis, Curve, CurveChart, Style};
use crate::lab::experiment::convergence::Convergence;

/// Variance of the mean of `N` samples against `N`, on logarithmic axes: measured points with bars of
/// one standard error, and dashed the law `σ²/N` in the same colour.
///
/// Each run comes with the variance `σ²` of one of its samples where that is known; where it is not, the
/// dashed line is the best law of this form.
pub fn variance_chart(title: impl Into<String>, runs: &[(Convergence, Option<f64>)]) -> CurveChart {
    let both = |(i, (run, known)): (usize, &(Convergence, Option<f64>))| {
        // The error that a normal law gives a variance from this many runs.
        let relative = (2.0 / (f64::from(run.replicates) - 1.0)).sqrt();
        let measured: Vec<(f64, f64, f64)> = (run.sizes.iter())
            .filter_map(|size| Some((f64::from(size.samples), size.variance?)))
            .filter(|(_, variance)| *variance > 0.0)
            .map(|(n, variance)| (n, variance, relative * variance))
            .collect();
        let sum: f64 = measured.iter().map(|(n, variance, _)| n * variance).sum();
        let one = known.unwrap_or(sum / measured.len() as f64);
        let ends = [measured.first(), measured.last()];
        let law = ends.into_iter().flatten().map(|(n, ..)| (*n, one / n));
        let law: Vec<(f64, f64)> = law.collect();
        let name = run.name.clone();
        [
            Curve::measured(name, Style::Marks, measured).coloured(i),
            Curve::new("", Style::Dashed, law).coloured(i),
        ]
    };
    CurveChart {
        title: title.into(),
        x_label: "samples N; bars: one standard error; dashed: σ²/N".into(),
        y_label: "variance of the mean of N samples".into(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves: runs.iter().enumerate().flat_map(both).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::experiment::convergence::{Design, converge};
    use crate::lab::experiment::named;

    #[test]
    fn measured_variances_lie_on_their_law_and_on_no_other() {
        let design = Design {
            replicates: 400,
            doublings: 6,
            ..Design::default()
        };
        let run = converge(&named::find("darts").unwrap(), &design);
        let exact = std::f64::consts::PI * (4.0 - std::f64::consts::PI);
        for (known, near) in [
            (Some(exact), true),
            (None, true),
            (Some(1.2 * exact), false),
        ] {
            let chart = variance_chart("darts", &[(run.clone(), known)]);
            let [marks, law] = &chart.curves[..] else {
                panic!("two curves");
            };
            assert_eq!(law.points.len(), 2);
            // Both ends of the law, in the errors of the points there; all points together decide.
            let ratio = law.points[0].y * law.points[0].x;
            let z: f64 = (marks.points.iter())
                .map(|p| (p.y - ratio / p.x) / p.error.unwrap())
                .sum::<f64>()
                / (marks.points.len() as f64).sqrt();
            assert_eq!(z.abs() < 4.0, near, "{known:?}: {z}");
            assert!(chart.to_svg().is_ok());
        }
    }
}
