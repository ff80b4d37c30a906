//! The charts of this chapter: errors that stay, variances that never settle, and a wall.

use crate::furnace::{ALBEDO, game};
use crate::survival::Game;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, Style};
use halfdisk::sampling::stream::Stream;
use halfdisk::stats::Estimate;
use rayon::prelude::*;

/// Error against rays of two cuts and of roulette; the rays.
pub fn plateau(desk: &mut Desk) -> Result<u64, DeskError> {
    let (runs, doublings) = desk.choose((64, 8), (32, 6));
    let (game, seed) = (game(90), desk.options.seed);
    let measured: Vec<(f64, f64, f64)> = (0..doublings)
        .into_par_iter()
        .map(|k| {
            let walks = 1 << (2 * k);
            let mut rays = 0;
            let mut squares = Estimate::new();
            for run in 0..runs {
                let mut mean = Estimate::new();
                for i in 0..walks {
                    let stream = Stream::new(seed ^ 0xa5, i, 100 * k + 10_000 * run);
                    let (value, segments) = game.walk(&stream);
                    rays += segments;
                    mean.add(value);
                }
                squares.add((mean.mean() / game.mean() - 1.0).powi(2));
            }
            let error = squares.mean().sqrt();
            let bar = 0.5 * squares.std_error() / error;
            (rays as f64 / f64::from(runs), error, bar)
        })
        .collect();
    let spent = measured.iter().map(|m| m.0 * f64::from(runs)).sum::<f64>();
    let ends = [1.0, measured.last().map_or(1.0, |m| m.0)];
    let cut = |bounces: i32| {
        let lost = ALBEDO.powi(bounces + 1);
        let name = format!("cut after {bounces} bounces");
        let from = f64::from(bounces + 1);
        Curve::new(name, Style::Line, [from, ends[1]].map(|x| (x, lost)))
    };
    let law = |rays: f64| (game.price() / rays).sqrt() / game.mean();
    let from = game.rays();
    let curves = vec![
        cut(2),
        cut(5),
        cut(20),
        Curve::measured("roulette, survival 0.9", Style::Marks, measured).coloured(3),
        Curve::new("", Style::Dashed, [from, ends[1]].map(|x| (x, law(x)))).coloured(3),
    ];
    let chart = CurveChart {
        title: "Error in the furnace of albedo 0.8".to_owned(),
        x_label: "rays".to_owned(),
        y_label: "root mean squared error / truth".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves,
    };
    let caption = "The error of a cut is a bias, and stays. That of roulette is chance, and falls.";
    desk.figure("chart.svg", caption, chart.to_svg()?)?;
    Ok(spent as u64)
}

/// The variance as it looks after so many walks; the rays.
pub fn running(desk: &mut Desk) -> Result<u64, DeskError> {
    let (doublings, seed) = (desk.choose(17, 15), desk.options.seed);
    let played: Vec<_> = [50, 65, 80, 95]
        .into_par_iter()
        .map(|percent| {
            let game = game(percent);
            let (mut seen, mut rays, mut points) = (Estimate::new(), 0, Vec::new());
            for i in 0..1_u32 << doublings {
                let (value, segments) = game.walk(&Stream::new(seed, i, 200 + percent));
                rays += segments;
                seen.add(value);
                if i >= 31 && (i + 1).is_power_of_two() {
                    points.push((f64::from(i + 1), seen.variance()));
                }
            }
            (game, points, rays)
        })
        .collect();
    let mut curves = Vec::new();
    for (k, (game, points, _)) in played.iter().enumerate() {
        let name = format!("survival {}", game.survival);
        let ends = [32.0, f64::from(1_u32 << doublings)];
        curves.push(Curve::new(name, Style::MarksAndLine, points.clone()).coloured(k));
        if game.variance().is_finite() {
            let law = Curve::new("", Style::Dashed, ends.map(|n| (n, game.variance())));
            curves.push(law.coloured(k));
        }
    }
    let chart = CurveChart {
        title: "The variance as it looks so far, albedo 0.8".to_owned(),
        x_label: "walks".to_owned(),
        y_label: "variance of those walks".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves,
    };
    let caption = "Dashed: the true variances. At 0.5 there is none, and each long walk lifts the \
                   estimate again; at 0.65 it is finite, and far above what most runs would say.";
    desk.figure("running.svg", caption, chart.to_svg()?)?;
    Ok(played.iter().map(|p| p.2).sum())
}

/// Variance times rays against survival, with its walls.
pub fn wall(desk: &mut Desk, measured: Vec<(f64, f64, f64)>) -> Result<(), DeskError> {
    let mut curves = Vec::new();
    for (k, albedo) in [0.5_f64, 0.8, 0.9].into_iter().enumerate() {
        let wall = albedo * albedo;
        let relative = |survival: f64| {
            let game = Game { albedo, survival };
            (survival, game.price() / (game.mean() * game.mean()))
        };
        // Closer together near the wall, where the curve is steep.
        let place = |i: u32| wall + (0.985 - wall) * libm::pow(f64::from(i) / 80.0, 2.0);
        let points = (1..=80).map(place).map(relative);
        let points: Vec<_> = points.filter(|p| p.1 < 1000.0).collect();
        let name = format!("albedo {albedo}, its wall at {wall:.2}");
        curves.push(Curve::new(name, Style::Line, points).coloured(k));
        let upright = [(wall, 0.1), (wall, 1000.0)];
        curves.push(Curve::new("", Style::Dashed, upright).coloured(k));
    }
    curves.push(Curve::measured("", Style::Marks, measured).coloured(1));
    let chart = CurveChart {
        title: "What certainty costs".to_owned(),
        x_label: "chance to survive a surface".to_owned(),
        y_label: "variance times rays / squared mean".to_owned(),
        x_axis: Axis::Linear,
        y_axis: Axis::Log,
        curves,
    };
    let caption = "Lines: closed forms; dots: measured. Dashed: the square of the albedo. There and to the left of it, no number of rays \
                   is enough.";
    desk.figure("wall.svg", caption, chart.to_svg()?)
}
