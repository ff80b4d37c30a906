//! Form factors: Lambert's formula at Gauss points against closed forms.

use super::closed::{Rectangle, form_factor};
use super::{bare, cube, rectangle, scene};
use halfdisk::radiosity::{
    self, FormFactors, Patch, PatchSize, Patches, gauss_legendre, point_to_polygon, points_on,
};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::Scene;
use halfdisk::stats::Estimate;
use std::f64::consts::PI;

fn factor(pair: &[Patch; 2], points: usize) -> f64 {
    bare(pair, points).row(0)[1]
}

/// The slides' formula with one point for each patch.
fn centre_to_centre(pair: &[Patch; 2]) -> f64 {
    let rule = gauss_legendre(1);
    let [p, q] = [0, 1].map(|i| points_on(&pair[i].polygon, &rule)[0].0);
    kernel(pair, p, q) * pair[1].area
}

/// Gauss points on both patches.
fn area_to_area(pair: &[Patch; 2], points: usize) -> f64 {
    let rule = gauss_legendre(points);
    let [a, b] = [0, 1].map(|i| points_on(&pair[i].polygon, &rule));
    let terms = a.iter().flat_map(|p| b.iter().map(move |q| (p, q)));
    terms
        .map(|(p, q)| p.1 * q.1 * kernel(pair, p.0, q.0) * pair[1].area)
        .sum()
}

fn kernel(pair: &[Patch; 2], p: glam::DVec3, q: glam::DVec3) -> f64 {
    let way = q - p;
    let cosines = pair[0].normal.dot(way) * -pair[1].normal.dot(way);
    cosines.max(0.0) / (PI * way.length_squared() * way.length_squared())
}

fn pair(i: &Rectangle, up_i: bool, j: &Rectangle, up_j: bool) -> [Patch; 2] {
    [(i, up_i), (j, up_j)].map(|(r, up)| rectangle(r.axis, r.low, r.high, up))
}

#[test]
fn s0_24_squares_by_gauss_points() {
    let floor = Rectangle {
        axis: 2,
        low: [0.0; 3],
        high: [1.0, 1.0, 0.0],
    };
    let ceiling = Rectangle {
        axis: 2,
        low: [0.0, 0.0, 1.0],
        high: [1.0; 3],
    };
    let wall = Rectangle {
        axis: 0,
        low: [0.0; 3],
        high: [0.0, 1.0, 1.0],
    };
    let facing = pair(&floor, true, &ceiling, false);
    let touching = pair(&floor, true, &wall, true);
    for (name, pair, known) in [
        ("facing", &facing, 0.199_824_895_7),
        ("touching", &touching, 0.200_043_776_1),
    ] {
        let found = factor(pair, 8);
        assert!((found - known).abs() < 1e-10, "{name}: {found}");
        println!(
            "{name}: 8 x 8 points {found:.10}; centre to centre {:.4}, 8 points on each {:.4}",
            centre_to_centre(pair),
            area_to_area(pair, 8)
        );
    }
    // The mistakes: one point for each patch, and points on both where they touch.
    assert!((centre_to_centre(&touching) - 1.0 / PI).abs() < 1e-5);
    assert!(area_to_area(&touching, 8) > 1.25 * 0.200_04);
    assert!((area_to_area(&facing, 8) - 0.199_824_895_7).abs() < 1e-10);
}

/// Two random rectangles that face each other wholly, and whether they share an edge.
fn random_pair(k: u32) -> ([Rectangle; 2], [bool; 2], bool) {
    let mut numbers = Stream::new(24, k, 0).at(0, Purpose::Integrand);
    let mut number = |low: f64, high: f64| low + (high - low) * numbers.fine();
    let mut range = |low: f64| {
        let from = number(low, low + 2.0);
        [from, from + number(0.2, 1.5)]
    };
    let [x, y, z] = [range(-1.0), range(-1.0), range(0.0)];
    let [s, t] = [range(-1.0), range(-1.0)];
    let floor = |z: f64| Rectangle {
        axis: 2,
        low: [x[0], y[0], z],
        high: [x[1], y[1], z],
    };
    match k % 3 {
        0 => {
            let height = 0.05 + z[0];
            let above = Rectangle {
                axis: 2,
                low: [s[0], t[0], height],
                high: [s[1], t[1], height],
            };
            ([floor(0.0), above], [true, false], false)
        }
        1 => {
            // A wall behind the floor, somewhere above it.
            let at = x[0] - 0.3 * z[0];
            let wall = Rectangle {
                axis: 0,
                low: [at, t[0], z[0]],
                high: [at, t[1], z[1]],
            };
            ([floor(0.0), wall], [true, true], false)
        }
        _ => {
            let wall = Rectangle {
                axis: 0,
                low: [x[0], y[0], 0.0],
                high: [x[0], y[1], z[1] - z[0]],
            };
            ([floor(0.0), wall], [true, true], true)
        }
    }
}

#[test]
fn a_thousand_pairs_of_rectangles() {
    let [mut near, mut far, mut edges, mut even] = [0.0_f64; 4];
    let mut wrong = 0;
    for k in 0..1000 {
        let ([i, j], [up_i, up_j], shares_edge) = random_pair(k);
        let exact = form_factor(&i, &j);
        let pair = pair(&i, up_i, &j, up_j);
        let gap = |d: usize| (i.low[d] - j.high[d]).max(j.low[d] - i.high[d]).max(0.0);
        let distance = libm::sqrt((0..3).map(|d| gap(d) * gap(d)).sum());
        let size = (0..3).map(|d| i.high[d] - i.low[d]).fold(0.0, f64::max);
        let is_far = distance >= size;
        let tolerance = if is_far || shares_edge { 1e-11 } else { 1e-8 };
        let [found, apart] = radiosity::form_factor(&pair[0], &pair[1], tolerance);
        let off = (found - exact).abs();
        assert!(off < 10.0 * apart.max(1e-13), "{k}: {off:e} {apart:e}");
        let worst = match (is_far, shares_edge) {
            (true, _) => &mut far,
            (_, true) => &mut edges,
            _ => &mut near,
        };
        *worst = worst.max(off);
        if shares_edge {
            even = even.max((factor(&pair, 32) - exact).abs());
        }
        wrong += usize::from((centre_to_centre(&pair) - exact).abs() > 0.01 * exact);
    }
    println!(
        "off by at most {far:.0e} far away, {edges:.0e} at edges, {near:.0e} nearby; with 32 x 32 points that do \
         not crowd towards edges {even:.0e} there; centre to centre is off by more than 1 % in {wrong} of \
         1000 pairs"
    );
    assert!(far < 1e-10 && edges < 1e-10, "{far:e} {edges:e}");
    assert!(near < 1e-8, "{near:e}");
    assert!(even > 1e-8, "the mistake, evenly laid points: {even:e}");
    assert!(wrong > 700, "{wrong}");
}

#[test]
fn rows_of_a_closed_room_add_up_to_one_whatever_the_points() {
    let patches = cube(3);
    let off = |row: Vec<f64>| (row.iter().sum::<f64>() - 1.0).abs();
    for points in [1, 2, 4] {
        let factors = bare(&patches, points);
        let worst = (0..patches.len())
            .map(|i| off(factors.row(i)))
            .fold(0.0, f64::max);
        assert!(worst < 1e-12, "{points} points: {worst:e}");
    }
    // The mistake: from centre to centre light is created.
    let sum = |i: usize| -> f64 {
        let others = patches.iter().filter(|p| p.polygon != patches[i].polygon);
        others
            .map(|p| centre_to_centre(&[patches[i].clone(), p.clone()]))
            .sum()
    };
    let worst = (0..patches.len())
        .map(|i| (sum(i) - 1.0).abs())
        .fold(0.0, f64::max);
    println!("centre to centre: a row sums to 1 within {worst:.2} at worst");
    assert!(worst > 0.1);
}

/// Level: five standard errors of 32 replicates for each row, one in 50 000; 120 rows.
#[test]
fn rows_of_a_closed_room_with_blocks_add_up_to_one_within_the_error_of_their_rays() {
    let scene = scene(&(super::CUBE.to_owned() + super::BLOCKS));
    let patches = Patches::new(&scene, PatchSize::Number(480))
        .expect("patches")
        .all;
    let rows = |scene: Option<&Scene>| -> Vec<Estimate> {
        let factors = FormFactors {
            patches: &patches,
            scene,
            points: 2,
        };
        let each = (0..patches.len()).step_by(4);
        each.map(|i| factors.row_sum(i, 32)).collect()
    };
    let found = rows(Some(&scene));
    let z = |row: &Estimate| (row.mean() - 1.0) / row.std_error().max(1e-12);
    let worst = found.iter().map(|row| z(row).abs()).fold(0.0, f64::max);
    let all: Estimate = found.iter().map(|row| row.mean() - 1.0).collect();
    let one = found.iter().map(|row| row.variance()).sum::<f64>() / found.len() as f64;
    println!(
        "{} rows of a room with blocks: 1 within {worst:.1} standard errors; a row has {:.3} with one ray for each \
         point, and all are off by {:.1e} ± {:.1e} in the mean",
        found.len(),
        one.sqrt(),
        all.mean(),
        (one / 32.0 / found.len() as f64).sqrt()
    );
    assert!(worst < 5.0, "{worst}");
    // The mistake: patches that nothing hides.
    let bare = rows(None);
    let seen = bare.iter().filter(|row| row.mean() > 1.05).count();
    assert!(3 * seen > found.len(), "{seen} of {}", found.len());
}

#[test]
fn reciprocity_holds_as_far_as_the_points_integrate() {
    let patches = cube(2);
    let apart = |points: usize| {
        let factors = bare(&patches, points);
        let rows: Vec<Vec<f64>> = (0..patches.len()).map(|i| factors.row(i)).collect();
        let pairs = (0..rows.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
        let apart = pairs.map(|(i, j)| (rows[i][j] - rows[j][i]).abs() / rows[i][j].max(1e-3));
        apart.fold(0.0, f64::max)
    };
    // Equal areas on unequal places: one point favours neither side only by symmetry.
    let [one, two, eight] = [1, 2, 8].map(apart);
    println!("A F = A F is off by {one:.1e}, {two:.1e}, {eight:.1e} with 1, 2, 8 points a side");
    assert!(
        one > 1e-3,
        "collocation at one point is not reciprocal: {one:e}"
    );
    assert!(two < one && eight < 1e-9, "{two:e} {eight:e}");
}

#[test]
fn what_lies_between_hides_and_a_partition_parts() {
    let text = super::CUBE.to_owned()
        + "[[objects]]\nmaterial = 'red'\n\
           quad = { corner = [0.5, 0, 0], u = [0, 1, 0], v = [0, 0, 1] }\n";
    let scene = scene(&text);
    let patches = Patches::new(&scene, PatchSize::Length(0.25))
        .expect("patches")
        .all;
    let factors = FormFactors {
        patches: &patches,
        scene: Some(&scene),
        points: 2,
    };
    let x = |patch: &Patch| patch.polygon.iter().map(|p| p.x).sum::<f64>() / 4.0;
    // Seen from the camera at 0.5 the partition is at 0; its two sides belong to either half.
    let half = |patch: &Patch| match x(patch) {
        x if x.abs() < 1e-6 => patch.normal.x.signum(),
        x => x.signum(),
    };
    let [mut plain, mut worst] = [0.0_f64; 2];
    for (i, own) in patches.iter().enumerate() {
        let row = factors.row(i);
        let bare = bare(&patches, 2).row(i);
        let others = (0..patches.len()).filter(|&j| half(&patches[j]) != half(own));
        for j in others {
            assert!(row[j] == 0.0, "{i} {j}: {}", row[j]);
            plain += bare[j];
        }
        worst = worst.max((row.iter().sum::<f64>() - 1.0).abs());
    }
    assert!(worst < 1e-12, "each half is a closed room: {worst:e}");
    assert!(plain > 1.0, "the mistake, without shadow rays: {plain}");
}

#[test]
fn the_point_formula_takes_part_of_the_view() {
    let floor = rectangle(2, [0.0; 3], [1.0, 1.0, 0.0], true);
    let p = glam::DVec3::new(0.5, 0.5, -0.3);
    assert_eq!(point_to_polygon(p, -glam::DVec3::Z, &floor.polygon), 0.0);
    assert!(point_to_polygon(p, glam::DVec3::Z, &floor.polygon) > 0.5);
}
