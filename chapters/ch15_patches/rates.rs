//! How fast the error falls as patches get smaller.

use super::room::{CENTRE, MEAN, Room};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, Style};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::stats::slope::fit;

const POINTS: u32 = 64;
const REPLICATES: u32 = 8;

pub fn work(desk: &mut Desk) -> Result<(), DeskError> {
    desk.say("\nthe cube whose ceiling shines");
    let sides: &[u32] = desk.choose(&[1, 2, 4, 8, 16], &[1, 2, 4, 8]);
    let rooms = sides
        .iter()
        .map(|&side| Room::new(side))
        .collect::<Result<Vec<_>, _>>()?;
    let Some((truth, rooms)) = rooms.split_last() else {
        return Ok(());
    };
    desk.known(
        "centre",
        "floor's centre, gathered from the finest patches",
        truth.gathered([0.5; 2]),
        CENTRE,
    );
    desk.known(
        "mean",
        "floor's mean on the finest patches",
        truth.mean(),
        MEAN,
    );
    let counts: Vec<f64> = rooms.iter().map(|room| room.patches.len() as f64).collect();
    let [mut constant, mut gathered] = [Vec::new(), Vec::new()];
    for replicate in 0..REPLICATES {
        let mut squares = vec![[0.0; 2]; rooms.len()];
        for i in 0..POINTS {
            let p = Stream::new(desk.options.seed, replicate, i)
                .at(0, Purpose::Integrand)
                .two();
            let p = p.map(f64::from);
            let exact = truth.gathered(p);
            for (room, squares) in rooms.iter().zip(&mut squares) {
                for (square, read) in squares.iter_mut().zip([room.constant(p), room.gathered(p)]) {
                    let off = (read - exact) / MEAN;
                    *square += off * off / f64::from(POINTS);
                }
            }
        }
        constant.push(squares.iter().map(|s| s[0]).collect::<Vec<f64>>());
        gathered.push(squares.iter().map(|s| s[1]).collect::<Vec<f64>>());
    }
    let root = |squares: &[Vec<f64>], k: usize| {
        let sum: f64 = squares.iter().map(|row| row[k]).sum();
        (sum / squares.len() as f64).sqrt()
    };
    for (k, &count) in counts.iter().enumerate() {
        let name = count as u32;
        for (how, squares) in [("constant", &constant), ("gathered", &gathered)] {
            let says = format!("{name} patches, {how}: relative error in per cent");
            desk.value(
                &format!("error_{how}_{name}"),
                &says,
                100.0 * root(squares, k),
            );
        }
        let says = format!("{name} patches, floor's mean: relative error in per cent");
        let off = 100.0 * (rooms[k].mean() / MEAN - 1.0).abs();
        desk.value(&format!("error_mean_{name}"), &says, off);
    }
    // The coarsest mesh is no part of the law.
    let fine = |squares: &[Vec<f64>]| {
        squares
            .iter()
            .map(|row| row[1..].to_vec())
            .collect::<Vec<_>>()
    };
    let paid = vec![counts[1..].to_vec(); REPLICATES as usize];
    for (how, squares, exact) in [
        ("constant", &constant, Some(-0.5)),
        ("gathered", &gathered, None),
    ] {
        let Ok(fit) = fit(&paid, &fine(squares)) else {
            continue;
        };
        let number = Number {
            error: Some(fit.std_error),
            exact,
            ..Number::new(&format!("slope against patches, {how}"), fit.line.slope)
        };
        desk.number(&format!("slope_{how}"), number);
    }
    let curve = |name: &str, squares: &[Vec<f64>]| {
        let points = counts
            .iter()
            .enumerate()
            .map(|(k, &n)| (n, root(squares, k)));
        Curve::new(name, Style::MarksAndLine, points)
    };
    let mean = rooms
        .iter()
        .zip(&counts)
        .map(|(room, &n)| (n, (room.mean() / MEAN - 1.0).abs()));
    let law = |name: &str, at: f64, power: f64| {
        let points = counts
            .iter()
            .map(|&n| (n, at * libm::pow(n / counts[0], power)));
        Curve::new(name, Style::Dashed, points)
    };
    let chart = CurveChart {
        title: "The error that patches leave".to_owned(),
        x_label: "patches".to_owned(),
        y_label: "relative error of the floor".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves: vec![
            curve("constant", &constant),
            curve("gathered", &gathered),
            Curve::new("mean", Style::MarksAndLine, mean),
            law("slope -1/2", 0.2, -0.5),
            law("slope -1", 0.05, -1.0),
        ],
    };
    let caption = "Error of points of the floor against the number of patches: constant on each patch, gathered once \
                   more, and the mean over the floor. The side of a patch is one over the root of their number.";
    desk.figure("rates.svg", caption, chart.to_svg()?)?;
    Ok(())
}
