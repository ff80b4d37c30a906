//! The figures of this chapter: darts, a run with its band, rates, dimensions.

use super::checks::checked;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::{
    Arc, Axis, Bounds, ChartError, Curve, CurveChart, RayDrawing, Stroke, StrokeKind, Style,
};
use halfdisk::lab::estimators::{hit_or_miss, many_dimensions};
use halfdisk::lab::experiment::convergence::{Convergence, Design, converge};
use halfdisk::lab::experiment::named;
use halfdisk::lab::figures::convergence_chart;
use halfdisk::stats::z_test::Largest;
use std::f64::consts::{FRAC_PI_2, PI};

/// A few hundred darts and the quarter circle.
pub fn darts(desk: &mut Desk) -> Result<(), DeskError> {
    let (svg, hits) = board(desk.options.seed)?;
    desk.value("board_darts", "darts in the drawing", f64::from(THROWN));
    desk.value("board_hits", "  of which hit", f64::from(hits));
    let caption = format!(
        "Of {THROWN} darts at a square {hits} fall within the quarter circle. Four times their share, {:.2}, \
         estimates pi.",
        4.0 * f64::from(hits) / f64::from(THROWN)
    );
    desk.figure("darts.svg", &caption, svg)
}

/// The darts of the drawing.
pub const THROWN: u32 = 400;

fn board(seed: u64) -> Result<(String, u32), ChartError> {
    let mut hits = 0;
    let edge = |from, to| Stroke::new(StrokeKind::Outline, from, to);
    let [o, a, b, c] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let mut strokes = vec![edge(o, a), edge(a, b), edge(b, c), edge(c, o)];
    for ([x, y], score) in hit_or_miss::thrown(THROWN, seed) {
        let hit = score > 0.0;
        hits += u32::from(hit);
        let kind = if hit {
            StrokeKind::Hit
        } else {
            StrokeKind::Miss
        };
        // A small cross.
        for [dx, dy] in [[0.006, 0.006], [0.006, -0.006]] {
            strokes.push(Stroke::new(kind, [x - dx, y - dy], [x + dx, y + dy]));
        }
    }
    let drawing = RayDrawing {
        title: format!("{hits} of {THROWN} darts hit"),
        view: Bounds {
            min: [-0.02, -0.02],
            max: [1.02, 1.02],
        },
        strokes,
        arcs: vec![Arc {
            center: o,
            radius: 1.0,
            start: 0.0,
            turn: FRAC_PI_2,
            kind: StrokeKind::Outline,
        }],
        ..RayDrawing::default()
    };
    Ok((drawing.to_svg_at(432)?, hits))
}

/// One run that goes on and on, with its band.
pub fn running(desk: &mut Desk) -> Result<(), DeskError> {
    // The same seed throws the same darts: each of these is the beginning of the next.
    let sizes = (0..=144).map(|k| libm::exp2(5.0 + f64::from(k) / 12.0).round());
    let run: Vec<(f64, f64, f64)> = sizes
        .map(|n| (n, hit_or_miss::darts(n as u32, desk.options.seed)))
        .map(|(n, darts)| (n, darts.mean(), 2.0 * darts.std_error()))
        .collect();
    let [first, last] = [32.0, libm::exp2(17.0)];
    let side = |name: &str, sign: f64| {
        let points = run.iter().map(|(n, mean, half)| (*n, mean + sign * half));
        Curve::new(name, Style::Line, points).coloured(5)
    };
    let mean = run.iter().map(|(n, mean, _)| (*n, *mean));
    let chart = CurveChart {
        title: "One run of darts".to_owned(),
        x_label: "darts".to_owned(),
        y_label: "estimate of pi".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Linear,
        curves: vec![
            Curve::new("pi", Style::Dashed, [(first, PI), (last, PI)]).coloured(6),
            side("mean ± two standard errors", 1.0),
            side("", -1.0),
            Curve::new("mean so far", Style::Line, mean).coloured(0),
        ],
    };
    let caption =
        "For four times the darts the band is half as wide; most of the time it holds pi.";
    desk.figure("running.svg", caption, chart.to_svg()?)
}

/// Error against samples.
pub fn chart(desk: &mut Desk, curves: &[Convergence]) -> Result<(), DeskError> {
    let chart = convergence_chart("Error against samples", curves);
    let caption = "Error against the number of samples. Three of four lines have the slope -1/2, from different heights; darts \
                   in cells of a grid fall faster.";
    desk.figure("chart.svg", caption, chart.to_svg()?)
}

/// The error of as many points on a grid and by chance, in 1 to 8 dimensions; how far from the truth,
/// and the points spent.
pub fn dimensions(
    desk: &mut Desk,
    points: u32,
    replicates: u32,
) -> Result<(Largest, u64), DeskError> {
    let design = Design {
        replicates,
        doublings: 1,
        first: points,
        seed: desk.options.seed,
    };
    desk.value("grid_points", "points to spend", points.into());
    let (mut compared, mut intersection) = (Largest::default(), None);
    let (mut grids, mut chances) = (Vec::new(), Vec::new());
    for d in 1..=8 {
        let whole = whole_grid(points, d).map(|steps| many_dimensions::grid(d, steps) - 1.0);
        if let Some(error) = whole {
            let says = format!("error in d = {d} dimensions, on a grid");
            let law = law(points, d.into());
            desk.known(&format!("grid_{d}"), &says, error, law);
            grids.push((f64::from(d), error));
        }
        let Some(estimator) = named::find(&format!("product-{d}")) else {
            continue;
        };
        let run = converge(&estimator, &design);
        let Some(size) = run.sizes.first() else {
            continue;
        };
        let says = format!("error in d = {d} dimensions, by chance");
        let exact = many_dimensions::deviation(d) / f64::from(points).sqrt();
        let found = [size.rmse, size.rmse_error, exact];
        compared.add(checked(desk, &format!("chance_{d}"), &says, found));
        chances.push((f64::from(d), size.rmse, size.rmse_error));
        if whole.is_some_and(|error| error > size.rmse) {
            intersection = intersection.or(Some(d));
        }
    }
    if let Some(d) = intersection {
        let says = "dimensions from which chance errs less than a grid";
        desk.value("crossing", says, d.into());
    }
    let between = || (0..=140).map(|k| 1.0 + 0.05 * f64::from(k));
    let axes = (1..=8).map(f64::from);
    let deviation = |d: f64| (libm::pow(PI * PI / 8.0, d) - 1.0).sqrt() / f64::from(points).sqrt();
    let chart = CurveChart {
        title: format!("The error of {points} points"),
        x_label: "dimensions".to_owned(),
        y_label: "error, of an integral that is 1".to_owned(),
        x_axis: Axis::Linear,
        y_axis: Axis::Log,
        curves: vec![
            Curve::new("a grid", Style::Marks, grids).coloured(1),
            Curve::new(
                "its formula",
                Style::Dashed,
                between().map(|d| (d, law(points, d))),
            )
            .coloured(1),
            Curve::measured("chance (root mean square)", Style::Marks, chances).coloured(0),
            Curve::new(
                "its formula",
                Style::Dashed,
                axes.map(|d| (d, deviation(d))),
            )
            .coloured(0),
        ],
    };
    let caption = "A grid is hard to beat in one dimension; from four on chance does better.";
    desk.figure("dimensions.svg", caption, chart.to_svg()?)?;
    let spent = 8 * u64::from(replicates) * u64::from(points);
    Ok((compared, spent))
}

/// The steps along each of `d` axes where so many points fill a grid.
fn whole_grid(points: u32, d: u32) -> Option<u32> {
    (2..=points).find(|steps| steps.checked_pow(d) == Some(points))
}

/// The grid's error with `points^(1/d)` steps along each axis, also where that is no whole number:
/// the sines at the middles of `m` steps add up to `1 / sin(π / 2m)`.
fn law(points: u32, d: f64) -> f64 {
    let angle = FRAC_PI_2 / libm::pow(points.into(), 1.0 / d);
    libm::pow(angle / libm::sin(angle), d) - 1.0
}
