//! What accuracy costs, as a chart.

use crate::lab::drawing::{Axis, Curve, CurveChart, Point, Style};
use crate::lab::experiment::cost::{BASE, PriceList, Priced, Size};
use crate::stats::slope::{Fit, Insufficient};

/// What error is drawn against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Against {
    /// Rays: the same on every machine.
    Rays,
    /// Seconds.
    Seconds,
}

/// What a certain error costs, relative to [`BASE`], against the rays of a picture, on logarithmic axes: squared
/// error times rays, over the same of the largest pictures of [`BASE`]. Independent samples make a line that
/// is level, and that of a method which needs twice the rays lies twice as high; a bias makes it rise.
///
/// Without [`BASE`] in the list, 1 is a squared error of 1 for one ray.
pub fn price_chart(title: impl Into<String>, list: &PriceList) -> CurveChart {
    let price = |size: &Size| size.error * size.error * size.rays;
    let base = list.find(BASE).and_then(|method| method.sizes.last());
    let unit = base.map_or(1.0, price);
    let curve = |(i, method): (usize, &Priced)| {
        let shown = method.sizes.iter().filter(|size| size.error > 0.0);
        let points = shown.map(|size| {
            let value = price(size) / unit;
            // The square of an error is off by twice its share.
            let error = 2.0 * value * size.error_error / size.error;
            Point {
                x: size.rays,
                y: value,
                error: Some(error).filter(|e| e.is_finite()),
            }
        });
        Curve {
            name: method.name.to_owned(),
            points: points.collect(),
            style: Style::MarksAndLine,
            colour: Some(i),
        }
    };
    let curves = list.methods.iter().enumerate().map(curve);
    CurveChart {
        title: title.into(),
        x_label: "rays of a picture; bars: one standard error".to_owned(),
        y_label: format!("price relative to {BASE}"),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves: curves.filter(|curve| !curve.points.is_empty()).collect(),
    }
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
            Against::Rays => "rays of a picture; bars: one standard error".to_owned(),
            Against::Seconds => "seconds of a picture; bars: one standard error".to_owned(),
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::experiment::cost::{ALL, Budget, Design, measure};
    use crate::scene::gallery;

    #[test]
    fn a_price_is_that_of_the_table_and_a_level_line_where_samples_are_independent() {
        let scene = gallery::load("cornell").unwrap().sized([12, 12]);
        let design = Design {
            replicates: 6,
            sizes: 3,
            budget: Budget::Rays(20_000),
            reference: 8,
            threads: None,
            seed: 1,
        };
        let chosen: Vec<_> = ALL
            .into_iter()
            .filter(|method| [BASE, "kajiya"].contains(&method.name))
            .collect();
        let measured = measure(&scene, &chosen, &design, &()).ok().unwrap();
        let list = PriceList::new(&scene, &measured);
        let chart = price_chart("price", &list);
        for curve in &chart.curves {
            let method = list.find(&curve.name).unwrap();
            let last = curve.points.last().unwrap();
            match list.against_base(method) {
                Some([_, rays]) => assert!((last.y / rays.ratio - 1.0).abs() < 1e-9, "{last:?}"),
                None => assert_eq!((curve.name.as_str(), last.y), (BASE, 1.0)),
            }
            // Sixteen times the samples, and neither 4 nor 1/4 times the price: the error alone would
            // fall to a quarter, its square to a sixteenth.
            let first = &curve.points[0];
            let ratio = first.y / last.y;
            assert!((0.3..3.3).contains(&ratio), "{}: {ratio}", curve.name);
        }
        assert!(chart.to_svg().is_ok());
    }
}
