//! How many samples the pixels of a picture need, as a chart.

use crate::lab::drawing::{Axis, Curve, CurveChart, Style};
use crate::render::stopping::percent;
use crate::stats::quantile;

/// Bins for each doubling of the samples.
const BINS: f64 = 2.0;

/// The samples that pixels need for a relative error of `target`, one curve for each named picture: the
/// share of its pixels in bins of half a doubling, and dashed the number that serves 95 % of them.
/// Pixels that need one sample or none are in the lowest bin; those whose error is unknown in none.
pub fn required_chart(
    title: impl Into<String>,
    target: f64,
    pictures: &[(&str, Vec<f64>)],
) -> CurveChart {
    let mut curves = Vec::new();
    for (i, (name, required)) in pictures.iter().enumerate() {
        let stairs = stairs(required);
        let top = stairs.iter().map(|&(_, share)| share).fold(0.0, f64::max);
        curves.push(Curve::new(*name, Style::Line, stairs).coloured(i));
        if let Some(most) = Some(quantile(required.clone(), 0.95)).filter(|n| n.is_finite()) {
            let most = most.max(1.0);
            let name = format!("95 %: {most:.0} or fewer");
            curves.push(Curve::new(name, Style::Dashed, [(most, 0.0), (most, top)]).coloured(i));
        }
    }
    CurveChart {
        title: title.into(),
        x_label: format!("samples N for an error of {}", percent(target)),
        y_label: "share of the pixels".into(),
        x_axis: Axis::Log,
        y_axis: Axis::Linear,
        curves,
    }
}

/// The outline of the histogram.
fn stairs(required: &[f64]) -> Vec<(f64, f64)> {
    let bin = |n: f64| (BINS * libm::log2(n.max(1.0))) as usize;
    let known = || required.iter().copied().filter(|n| n.is_finite());
    let last = known().map(bin).max().unwrap_or(0);
    let mut counts = vec![0_usize; last + 1];
    known().for_each(|n| counts[bin(n)] += 1);
    let edge = |i: usize| libm::exp2(i as f64 / BINS);
    let share = |count: usize| count as f64 / required.len().max(1) as f64;
    let mut points = vec![(1.0, 0.0)];
    for (i, &count) in counts.iter().enumerate() {
        points.push((edge(i), share(count)));
        points.push((edge(i + 1), share(count)));
    }
    points.push((edge(last + 1), 0.0));
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_that_is_known_is_in_one_bin() {
        let points = stairs(&[0.0, 0.5, 1.0, 1.5, 4.0, f64::INFINITY, 4.1, 5.5]);
        // Bins from 1, √2, 2, 2√2, 4.
        let shares: Vec<f64> = points[1..].chunks(2).map(|p| 8.0 * p[0].1).collect();
        assert_eq!(shares, [3.0, 1.0, 0.0, 0.0, 3.0, 0.0]);
        let svg = required_chart("need", 0.02, &[("box", vec![4.0, 5.0, 600.0])]).to_svg();
        assert!(svg.unwrap().contains("95 %: 600 or fewer"));
    }
}
