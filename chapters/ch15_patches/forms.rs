//! Form factors of two squares, by three methods; and a whole matrix as a picture.

use super::room::Room;
use glam::DVec3;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::{Axis, HeatMap};
use halfdisk::radiosity::{FormFactors, Patch, form_factor, gauss_legendre, points_on};
use std::f64::consts::PI;

/// Facing squares at distance 1, and squares that share an edge.
const FACING: f64 = 0.199_824_895_7;
const TOUCHING: f64 = 0.200_043_776_1;

pub fn work(desk: &mut Desk) -> Result<(), DeskError> {
    let square =
        |corners: [[f64; 3]; 4]| Patch::new(corners.map(DVec3::from).to_vec(), [0.5; 3], [0.0; 3]);
    let floor = square([[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]])?;
    let ceiling = square([[0., 0., 1.], [0., 1., 1.], [1., 1., 1.], [1., 0., 1.]])?;
    let wall = square([[0., 0., 0.], [0., 1., 0.], [0., 1., 1.], [0., 0., 1.]])?;
    desk.say("two squares");
    for (name, says, other, exact) in [
        ("facing", "facing squares", ceiling, FACING),
        ("touching", "squares that share an edge", wall, TOUCHING),
    ] {
        let pair = [floor.clone(), other];
        desk.known(
            &format!("{name}_centres"),
            &format!("{says}, centre to centre"),
            areas(&pair, 1),
            exact,
        );
        desk.known(
            &format!("{name}_areas"),
            &format!("{says}, 8 x 8 points on both"),
            areas(&pair, 8),
            exact,
        );
        for points in [1, 2, 4, 8] {
            let says = format!("{says}, Lambert at {points} x {points} points");
            desk.known(
                &format!("{name}_lambert_{points}"),
                &says,
                lambert(&pair, points),
                exact,
            );
        }
        let says = format!("{says}, points doubled until two answers agree");
        let [found, _] = form_factor(&pair[0], &pair[1], 1e-12);
        desk.known(&format!("{name}_doubled"), &says, found, exact);
    }
    matrix(desk)
}

fn lambert(pair: &[Patch; 2], points: usize) -> f64 {
    let factors = FormFactors {
        patches: pair,
        scene: None,
        points,
    };
    factors.row(0)[1]
}

// ANCHOR: areas
/// The integrand of the definition, at Gauss points on both patches.
fn areas([a, b]: &[Patch; 2], points: usize) -> f64 {
    let rule = gauss_legendre(points);
    let mut sum = 0.0;
    for (p, wp) in points_on(&a.polygon, &rule) {
        for (q, wq) in points_on(&b.polygon, &rule) {
            let way = q - p;
            let cosines = a.normal.dot(way) * -b.normal.dot(way);
            sum += wp * wq * cosines.max(0.0) / (PI * way.length_squared().powi(2));
        }
    }
    sum * b.area
}
// ANCHOR_END: areas

/// The matrix of the cube, four patches along each edge.
fn matrix(desk: &mut Desk) -> Result<(), DeskError> {
    let room = Room::new(4)?;
    let size = room.patches.len();
    let entries = (0..size).flat_map(|i| room.system.factors.row(i).to_vec());
    let map = HeatMap {
        title: "Who sees whom: 96 patches of the cube".to_owned(),
        label: "form factor".to_owned(),
        width: size as u32,
        values: entries.collect(),
        axis: Axis::Linear,
    };
    let caption = "The matrix of form factors of a cube with 4 x 4 patches on each wall: a row for each patch that \
                   looks, a column for each that is seen. The blocks on the diagonal are black, for no patch of a \
                   flat wall sees that wall; bright dots are neighbours across an edge.";
    desk.figure("matrix.svg", caption, map.to_svg()?)?;
    let off = |sum: f64| (sum - 1.0).abs();
    let worst = (0..size)
        .map(|i| off(room.system.factors.row_sum(i)))
        .fold(0.0, f64::max);
    // Below this is rounding, which is different on each machine.
    let says = "rows of that matrix sum to 1 within 1e-12";
    desk.known("rows", says, f64::from(u8::from(worst < 1e-12)), 1.0);
    let apart = |i: usize, j: usize| {
        let f = &room.system.factors;
        (f.at(i, j) - f.at(j, i)).abs()
    };
    let pairs = (0..size).flat_map(|i| (0..i).map(move |j| (i, j)));
    let worst = pairs.map(|(i, j)| apart(i, j)).fold(0.0, f64::max);
    desk.value(
        "reciprocity",
        "A F is the same in both directions within",
        worst,
    );
    Ok(())
}
