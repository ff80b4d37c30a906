//! The system and its solvers, where the solution is known.

use super::closed::{Rectangle, form_factor};
use super::{bare, cube, worst};
use halfdisk::flatland::exact;
use halfdisk::radiosity::{Channels, Matrix, Patch, System};
use halfdisk::sampling::stream::{Purpose, Stream};

/// Random numbers for the patches of a room.
fn numbers(seed: u64, low: f64, high: f64, count: usize) -> Vec<Channels> {
    let mut numbers = Stream::new(seed, 0, 0).at(0, Purpose::Integrand);
    let mut number = || low + (high - low) * numbers.fine();
    (0..count).map(|_| [number(), number(), number()]).collect()
}

#[test]
fn a_sphere_lights_itself_evenly() {
    // Any two patches of a sphere see each other by the share of its area.
    let count = 40;
    let areas: Vec<f64> = numbers(1, 0.5, 2.0, count).iter().map(|a| a[0]).collect();
    let whole: f64 = areas.iter().sum();
    let entries = (0..count)
        .flat_map(|_| areas.iter().map(|a| a / whole))
        .collect();
    let system = System {
        emission: numbers(2, 0.0, 1.0, count),
        albedo: numbers(3, 0.1, 0.9, count),
        factors: Matrix::new(count, entries),
    };
    let mean = |of: &[Channels], c: usize| -> f64 {
        of.iter().zip(&areas).map(|(x, a)| x[c] * a).sum::<f64>() / whole
    };
    let exact = |factor: f64| -> Vec<Channels> {
        let one = |i: usize, c: usize| {
            let arrives = mean(&system.emission, c) / (1.0 - mean(&system.albedo, c));
            system.emission[i][c] + factor * system.albedo[i][c] * arrives
        };
        (0..count).map(|i| [0, 1, 2].map(|c| one(i, c))).collect()
    };
    let solved = system.gauss_seidel(1e-15);
    assert!(worst(&solved.radiance, &exact(1.0)) < 1e-13);
    assert!(worst(&system.jacobi(600), &exact(1.0)) < 1e-13);
    assert!(worst(&system.southwell(&areas, 8000).0, &exact(1.0)) < 1e-12);
    assert!(
        worst(&solved.radiance, &exact(0.99)) > 1e-3,
        "a per cent is noticed"
    );
    // The mistake: a column in place of a row. In a furnace nobody notices.
    let transposed = |system: &System<f64>| {
        let at = |k: usize| system.factors.at(k % count, k / count);
        System {
            factors: Matrix::new(count, (0..count * count).map(at).collect()),
            ..system.clone()
        }
    };
    let wrong = transposed(&system).gauss_seidel(1e-12).radiance;
    assert!(worst(&wrong, &exact(1.0)) > 0.05);
}

#[test]
fn a_furnace_reads_le_over_one_minus_rho() {
    let patches = cube(2);
    let factors = bare(&patches, 2);
    let entries: Vec<f64> = (0..patches.len()).flat_map(|i| factors.row(i)).collect();
    let all = |x: f64| vec![[x; 3]; patches.len()];
    for albedo in [0.0, 0.2, 0.5, 0.9, 0.99] {
        let mut system = System {
            emission: all(1.0),
            albedo: all(albedo),
            factors: Matrix::new(patches.len(), entries.clone()),
        };
        let exact = all(1.0 / (1.0 - albedo));
        let off = worst(&system.gauss_seidel(1e-16).radiance, &exact) * (1.0 - albedo);
        assert!(off < 1e-12, "{albedo}: {off:e}");
        // The mistake: π in the wrong place.
        system.albedo = all(albedo / std::f64::consts::PI);
        assert!(albedo == 0.0 || worst(&system.gauss_seidel(1e-12).radiance, &exact) > 0.05);
    }
}

#[test]
fn s0_06_two_plates_bleed() {
    // Two facing squares in the dark: 2 x 2, solved by hand.
    let f = 0.199_824_895_7;
    let system = System {
        emission: vec![[1.0; 3], [0.0; 3]],
        albedo: vec![[0.8, 0.1, 0.0], [0.5; 3]],
        factors: Matrix::new(2, vec![0.0, f, f, 0.0]),
    };
    let solved = system.gauss_seidel(1e-16).radiance;
    for (c, rho) in system.albedo[0].into_iter().enumerate() {
        let second = 0.5 * f / (1.0 - rho * 0.5 * f * f);
        assert!((solved[1][c] - second).abs() < 1e-15);
        assert!((solved[0][c] - (1.0 + rho * f * second)).abs() < 1e-15);
    }
    let ends = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(glam::DVec2::from);
    let wall = |i: usize| [ends[i], ends[(i + 1) % 4]];
    let flat = [2, 1].map(|i| exact::form_factor(wall(0), wall(i)));
    assert!((flat[0] - (2.0_f64.sqrt() - 1.0)).abs() < 1e-15);
    assert!((flat[1] - (1.0 - 0.5 * 2.0_f64.sqrt())).abs() < 1e-15);
}

/// The closed form of two patches of the cube.
fn exact_factor(a: &Patch, b: &Patch) -> f64 {
    let [i, j] = [a, b].map(|patch| {
        let low = patch
            .polygon
            .iter()
            .copied()
            .reduce(glam::DVec3::min)
            .expect("corners");
        let high = patch
            .polygon
            .iter()
            .copied()
            .reduce(glam::DVec3::max)
            .expect("corners");
        let axis = (0..3)
            .find(|&d| patch.normal[d].abs() > 0.5)
            .expect("an axis");
        Rectangle {
            axis,
            low: low.into(),
            high: high.into(),
        }
    });
    form_factor(&i, &j)
}

/// The share of the emitted light that is not absorbed, in a room whose walls grow darker.
fn imbalance(patches: &[Patch], entries: Vec<f64>) -> f64 {
    let count = patches.len();
    let shade = |i: usize| 0.1 + 0.8 * i as f64 / count as f64;
    let system = System {
        emission: patches.iter().map(|patch| patch.emission).collect(),
        albedo: (0..count).map(|i| [shade(i); 3]).collect(),
        factors: Matrix::new(count, entries),
    };
    let radiance = system.gauss_seidel(1e-16).radiance;
    let [mut emitted, mut absorbed] = [0.0; 2];
    for (i, patch) in patches.iter().enumerate() {
        emitted += patch.area * patch.emission[0];
        absorbed += patch.area * (1.0 - shade(i)) * system.arriving(i, &radiance)[0];
    }
    (absorbed / emitted - 1.0).abs()
}

#[test]
fn what_is_emitted_is_absorbed() {
    let patches = cube(4);
    let count = patches.len();
    let exact = |k: usize| {
        let (a, b) = (&patches[k / count], &patches[k % count]);
        if a.normal == b.normal {
            0.0
        } else {
            exact_factor(a, b)
        }
    };
    let off = imbalance(&patches, (0..count * count).map(exact).collect());
    assert!(off < 1e-12, "reciprocal factors: {off:e}");
    let by = |points: usize| {
        let factors = bare(&patches, points);
        imbalance(&patches, (0..count).flat_map(|i| factors.row(i)).collect())
    };
    let [one, two, four] = [1, 2, 4].map(by);
    println!(
        "not absorbed of what is emitted: {off:.0e} by closed forms; {one:.1e}, {two:.1e}, {four:.1e} by \
         1, 2, 4 points a side"
    );
    assert!(one > 1e-4, "one point loses balance: {one:e}");
    assert!(two < 0.3 * one && four < 0.1 * two, "{two:e} {four:e}");
}
