//! What accuracy costs, as a chart.

use crate::lab::drawing::{Axis, Curve, CurveChart, Point, Style};
use crate::lab::experiment::cost::{PriceList, Priced, Size};
use crate::stats::slope::{Fit, Insufficient};

/// What error is drawn against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Against {
    /// Rays: the same on every machine.
    Rays,
    /// Seconds.
    Seconds,
}

/// Error against cost on logarithmic axes, a colour for each method: measured points with their error
/// bars, and the fitted line with its slope. What levels out is joined point by point and says where.
pub fn cost_chart(title: impl Into<String>, list: &PriceList, against: Against) -> CurveChart {
    let coloured = |(i, m): (usize, &Priced)| {
        curves(m, against)
            .into_iter()
            .map(move |c| c.coloured(i))
            .collect::<Vec<_>>()
    };
    CurveChart {
        title: title.into(),
        x_label: match against {
            Against::Rays => "rays of a picture".to_owned(),
            Against::Seconds => "seconds of a picture".to_owned(),
        },
        y_label: "relative error, %".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves: list.methods.iter().enumerate().flat_map(coloured).collect(),
    }
}

fn curves(method: &Priced, against: Against) -> Vec<Curve> {
    let place = |size: &Size| match against {
        Against::Rays => size.rays,
        Against::Seconds => size.mean_seconds,
    };
    // An error of zero has no place on a logarithmic axis.
    let shown: Vec<&Size> = method.sizes.iter().filter(|s| s.error > 0.0).collect();
    let marks = |name: String, style| Curve {
        name,
        points: shown
            .iter()
            .map(|size| Point {
                x: place(size),
                y: 100.0 * size.error,
                // One replicate has an error, but none of that error.
                error: Some(100.0 * size.error_error).filter(|e| e.is_finite()),
            })
            .collect(),
        style,
        colour: None,
    };
    let (Some(first), Some(last)) = (shown.first(), shown.last()) else {
        return Vec::new();
    };
    let fit = match against {
        Against::Rays => &method.against_rays,
        Against::Seconds => &method.against_seconds,
    };
    if let Some(floor) = method.levels_out {
        let name = format!("{}: levels out {floor}", method.name);
        return vec![marks(name, Style::MarksAndLine)];
    }
    match fit {
        Ok(fit) | Err(Insufficient::Wide(fit)) => {
            let ends = [place(first), place(last)].map(|x| (x, 100.0 * fit.line.at(x)));
            let name = format!("{}: {}", method.name, slope(fit));
            vec![
                marks(String::new(), Style::Marks),
                Curve::new(name, Style::Dashed, ends),
            ]
        }
        Err(_) => vec![marks(format!("{}: no slope", method.name), Style::Marks)],
    }
}

fn slope(fit: &Fit) -> String {
    format!("{:.3} ± {:.3}", fit.line.slope, fit.std_error)
}
