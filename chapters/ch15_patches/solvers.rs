//! Sweeps and shots.

use super::room::Room;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, HALF, Style};
use halfdisk::radiosity::Channels;

const SWEEPS: u32 = 16;

pub fn work(desk: &mut Desk) -> Result<(), DeskError> {
    let room = Room::new(4)?;
    let exact = room.system.gauss_seidel(1e-15).radiance;
    let off = |radiance: &[Channels]| {
        let pairs = radiance.iter().zip(&exact);
        pairs.map(|(x, y)| (x[0] - y[0]).abs()).fold(0.0, f64::max)
    };
    let jacobi: Vec<f64> = (0..=SWEEPS).map(|k| off(&room.system.jacobi(k))).collect();
    let rates = jacobi.windows(2).map(|w| w[1] / w[0]);
    let worst = rates.fold(0.0, f64::max);
    desk.known(
        "jacobi",
        "Jacobi's error shrinks in each sweep at least to",
        worst,
        0.5,
    );
    let sweeps = room.system.gauss_seidel(1e-12).sweeps;
    desk.value(
        "sweeps",
        "sweeps of Gauss and Seidel to 1e-12",
        f64::from(sweeps),
    );
    let numbered = |values: &[f64]| -> Vec<(f64, f64)> {
        (0..).zip(values).map(|(k, &y)| (f64::from(k), y)).collect()
    };
    let seidel: Vec<f64> = (1..=14)
        .map(|k| {
            off(&room
                .system
                .gauss_seidel(libm::pow(10.0, -f64::from(k)))
                .radiance)
        })
        .collect();
    let places = (1..=14).map(|k| {
        room.system
            .gauss_seidel(libm::pow(10.0, -f64::from(k)))
            .sweeps
    });
    let places: Vec<f64> = places.map(f64::from).collect();
    let of_seidel = places.into_iter().zip(seidel).filter(|(_, y)| *y > 1e-14);
    let law = (0..=SWEEPS).map(|k| (f64::from(k), jacobi[0] * libm::pow(0.5, f64::from(k))));
    let chart = CurveChart {
        title: "Each sweep adds a bounce".to_owned(),
        x_label: "sweeps".to_owned(),
        y_label: "largest error".to_owned(),
        x_axis: Axis::Linear,
        y_axis: Axis::Log,
        curves: vec![
            Curve::new("Jacobi", Style::MarksAndLine, numbered(&jacobi)),
            Curve::new("Gauss-Seidel", Style::MarksAndLine, of_seidel),
            Curve::new("halves", Style::Dashed, law),
        ],
    };
    let caption = "The largest error after so many sweeps, in the cube whose walls reflect half. Jacobi's iteration adds \
                   exactly one bounce in each; Gauss-Seidel uses what is new at once.";
    desk.figure("sweeps.svg", caption, chart.to_svg_at(HALF)?)?;

    let areas: Vec<f64> = room.patches.iter().map(|patch| patch.area).collect();
    let count = room.patches.len();
    let (_, left) = room.system.southwell(&areas, 4 * count + 1);
    let at = |shots: usize| 100.0 * left[shots];
    desk.value(
        "unshot_ceiling",
        "power unshot after the 16 patches of the ceiling, %",
        at(16),
    );
    desk.value(
        "unshot_once",
        "power unshot after as many shots as patches, %",
        at(count),
    );
    let chart = CurveChart {
        title: "The brightest shoots first".to_owned(),
        x_label: "shots, each a column of form factors".to_owned(),
        y_label: "power not yet shot, of what is emitted".to_owned(),
        x_axis: Axis::Linear,
        y_axis: Axis::Log,
        curves: vec![Curve::new("Southwell", Style::Line, numbered(&left))],
    };
    let caption = "Progressive refinement: after each shot, the power that waits. The first sixteen shots are the \
                   ceiling's patches.";
    desk.figure("unshot.svg", caption, chart.to_svg_at(HALF)?)?;
    Ok(())
}
