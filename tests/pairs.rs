//! One check for every `sample` and `pdf` that belong together, whatever they are defined over.

use glam::{DVec2, DVec3, Vec2, Vec3};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::stats::chi_square::chi_square;
use halfdisk::stats::z_test::sidak;
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};

/// The probability that any chi-square test rejects a right pair, and how many tests there are at most.
const SIGNIFICANCE: f64 = 1e-3;
const TESTS: u32 = 150;
/// The largest error of the integral of a density, those with jumps included.
const QUADRATURE: f64 = 4e-4;

/// What is sampled, as the image of the unit square.
pub trait Domain: Sync {
    type Point: Copy;
    /// Rows and columns of cells: many of them see a local error.
    const CELLS: [usize; 2] = [20, 40];
    /// How many are joined in a second test: few of them see a smooth error.
    const JOINED: [usize; 2] = [5, 5];

    fn point(&self, square: [f64; 2]) -> Self::Point;
    fn square(&self, point: Self::Point) -> [f64; 2];
    /// Measure of the domain per measure of the square.
    fn stretch(&self, square: [f64; 2]) -> f64;
}

/// `x` of a turn as a number of `[0, 1)`.
fn turn(y: f64, x: f64) -> f64 {
    (libm::atan2(y, x) / TAU).rem_euclid(1.0)
}

/// Unit directions of the flat world above the ground, by their angle.
pub struct HalfDisk;

impl Domain for HalfDisk {
    type Point = Vec2;
    const CELLS: [usize; 2] = [1, 800];
    const JOINED: [usize; 2] = [1, 25];

    fn point(&self, [_, b]: [f64; 2]) -> Vec2 {
        let (sin, cos) = libm::sincos(PI * b);
        DVec2::new(cos, sin).as_vec2()
    }

    fn square(&self, w: Vec2) -> [f64; 2] {
        [0.0, libm::atan2(f64::from(w.y), f64::from(w.x)) / PI]
    }

    fn stretch(&self, _: [f64; 2]) -> f64 {
        PI
    }
}

/// Unit directions `ω` with `1 - ω.z` up to this.
pub struct Cap(pub f64);

impl Domain for Cap {
    type Point = Vec3;

    fn point(&self, [a, b]: [f64; 2]) -> Vec3 {
        let (sin, cos) = libm::sincos(TAU * b);
        let down = a * self.0;
        let r = (down * (2.0 - down)).sqrt();
        DVec3::new(r * cos, r * sin, 1.0 - down).as_vec3()
    }

    fn square(&self, w: Vec3) -> [f64; 2] {
        let w = w.as_dvec3();
        let r2 = w.x * w.x + w.y * w.y;
        // The difference from the squares near the pole, where `1 - z` has lost its digits.
        let down = match w.z > 0.0 {
            true => r2 / (1.0 + (1.0 - r2).max(0.0).sqrt()),
            false => 1.0 - w.z,
        };
        [down / self.0, turn(w.y, w.x)]
    }

    fn stretch(&self, _: [f64; 2]) -> f64 {
        TAU * self.0
    }
}

/// Unit directions on both sides of a surface. With `a` from -1 to 1, `a⁴` is `1 - |z|`: cells around
/// the poles are small, and the measure is smooth there.
pub struct BothSides;

impl Domain for BothSides {
    type Point = Vec3;

    fn point(&self, [a, b]: [f64; 2]) -> Vec3 {
        let a = 2.0 * a - 1.0;
        let down = 1.0 - a.powi(4);
        let (sin, cos) = libm::sincos(TAU * b);
        let r = a * a * (1.0 + down).sqrt();
        DVec3::new(r * cos, r * sin, down.copysign(a)).as_vec3()
    }

    fn square(&self, w: Vec3) -> [f64; 2] {
        let w = w.as_dvec3();
        let r2 = w.x * w.x + w.y * w.y;
        let a = (r2 / (1.0 + w.z.abs())).sqrt().sqrt().copysign(w.z);
        [0.5 * (a + 1.0), turn(w.y, w.x)]
    }

    fn stretch(&self, [a, _]: [f64; 2]) -> f64 {
        // dω = 4 |a|³ da dφ
        8.0 * (2.0 * a - 1.0).abs().powi(3) * TAU
    }
}

/// The unit disc in the plane.
pub struct Disk;

impl Domain for Disk {
    type Point = Vec2;

    fn point(&self, [a, b]: [f64; 2]) -> Vec2 {
        let (sin, cos) = libm::sincos(TAU * b);
        DVec2::new(a * cos, a * sin).as_vec2()
    }

    fn square(&self, p: Vec2) -> [f64; 2] {
        let p = p.as_dvec2();
        [p.length(), turn(p.y, p.x)]
    }

    fn stretch(&self, [a, _]: [f64; 2]) -> f64 {
        TAU * a
    }
}

/// A rectangle of the plane, by the ends of its sides.
pub struct Rectangle(pub [[f64; 2]; 2]);

impl Domain for Rectangle {
    type Point = [f64; 2];

    fn point(&self, square: [f64; 2]) -> [f64; 2] {
        let Rectangle(sides) = self;
        [0, 1].map(|k| sides[k][0] + square[k] * (sides[k][1] - sides[k][0]))
    }

    fn square(&self, point: [f64; 2]) -> [f64; 2] {
        let Rectangle(sides) = self;
        [0, 1].map(|k| (point[k] - sides[k][0]) / (sides[k][1] - sides[k][0]))
    }

    fn stretch(&self, _: [f64; 2]) -> f64 {
        let Rectangle([x, y]) = self;
        (x[1] - x[0]) * (y[1] - y[0])
    }
}

/// The weights of the second and third corner of a triangle: `b, c >= 0`, `b + c <= 1`.
pub struct Weights;

impl Domain for Weights {
    type Point = [f64; 2];

    fn point(&self, [s, t]: [f64; 2]) -> [f64; 2] {
        [s * (1.0 - t), s * t]
    }

    fn square(&self, [b, c]: [f64; 2]) -> [f64; 2] {
        let s = b + c;
        [s, if s > 0.0 { c / s } else { 0.0 }]
    }

    fn stretch(&self, [s, _]: [f64; 2]) -> f64 {
        s
    }
}

/// The integral of `f` over each cell, by a Fibonacci lattice in each: as even as a grid for what is
/// smooth, and no row of points lies along an edge where `f` jumps.
pub fn integrals<D: Domain>(domain: &D, f: impl Fn(D::Point) -> f64 + Sync) -> Vec<f64> {
    const POINTS: u32 = 2584;
    const BEFORE: u32 = 1597;
    let [rows, columns] = D::CELLS;
    let place = |k: u32| (f64::from(k % POINTS) + 0.5) / f64::from(POINTS);
    let integral = |i: usize| {
        let (row, column) = ((i / columns) as f64, (i % columns) as f64);
        let mut sum = 0.0;
        for j in 0..POINTS {
            let a = (row + place(j)) / rows as f64;
            let b = (column + place(j * BEFORE)) / columns as f64;
            sum += f(domain.point([a, b])) * domain.stretch([a, b]);
        }
        sum / (rows * columns) as f64 / f64::from(POINTS)
    };
    (0..rows * columns).into_par_iter().map(integral).collect()
}

/// Cells joined; what stands behind them stays.
fn joined<D: Domain, T: Copy + std::iter::Sum>(cells: &[T]) -> Vec<T> {
    let ([rows, columns], [down, across]) = (D::CELLS, D::JOINED);
    let (fine, rest) = cells.split_at(rows * columns);
    let coarse = |i: usize| i / columns / down * (columns / across) + i % columns / across;
    let of = |k: usize| {
        let own = (0..fine.len()).filter(move |i| coarse(*i) == k);
        own.map(|i| fine[i]).sum()
    };
    let joined = (0..fine.len() / (down * across)).map(of);
    joined.chain(rest.iter().copied()).collect()
}

/// Why a million samples, the `index`-th of each kind, do not follow a density, if they do not. Samples
/// that are `None` have a cell of their own, which expects what the density leaves.
pub fn fault<D: Domain>(
    domain: &D,
    sample: impl Fn(u32) -> Option<D::Point>,
    pdf: impl Fn(D::Point) -> f64 + Sync,
) -> Option<String> {
    const SAMPLES: u32 = 1_000_000;
    let [rows, columns] = D::CELLS;
    let nowhere = rows * columns;
    let mut expected = integrals(domain, pdf);
    let total: f64 = expected.iter().sum();
    if total > 1.0 + QUADRATURE {
        return Some(format!("integrates to {total}"));
    }
    expected.push((1.0 - total).max(0.0));
    let mut counts = vec![0_u64; expected.len()];
    for index in 0..SAMPLES {
        let cell = sample(index).map_or(nowhere, |point| {
            let square = domain.square(point);
            // Rounding may lead out of the square by a hair, and no further.
            if !square.iter().all(|x| (-1e-6..=1.0 + 1e-6).contains(x)) {
                return nowhere;
            }
            let [row, column] = [0, 1].map(|k| (square[k] * D::CELLS[k] as f64) as usize);
            row.min(rows - 1) * columns + column.min(columns - 1)
        });
        counts[cell] += 1;
    }
    let share = 1.0 - counts[nowhere] as f64 / f64::from(SAMPLES);
    let error = (share * (1.0 - share) / f64::from(SAMPLES)).sqrt();
    if (share - total).abs() > crate::checks::CRITICAL * error + QUADRATURE {
        return Some(format!("integrates to {total}, but {share} were drawn"));
    }
    // Where the density fills everything up to the error of the integral, none may be missing.
    if error == 0.0 {
        expected[nowhere] = 0.0;
    }
    expected.iter_mut().for_each(|e| *e *= f64::from(SAMPLES));
    let coarse = (joined::<D, _>(&counts), joined::<D, _>(&expected));
    for (counts, expected) in [(counts, expected), coarse] {
        let test = chi_square(&counts, &expected);
        if test.p < sidak(SIGNIFICANCE, TESTS) {
            return Some(format!("chi2 {:.1}, p {:e}", test.statistic, test.p));
        }
    }
    None
}

/// The same where each sample is made of two uniforms and none fails, with numbers of its own for each
/// name.
pub fn fault_of<D: Domain>(
    name: &str,
    domain: &D,
    sample: impl Fn([f32; 2]) -> D::Point,
    pdf: impl Fn(D::Point) -> f64 + Sync,
) -> Option<String> {
    let seed = name.bytes().map(u64::from).sum();
    let uniforms = |index| Stream::new(seed, index, 0).at(0, Purpose::Direction).two();
    fault(domain, |index| Some(sample(uniforms(index))), pdf)
}

/// Accepts a right pair of `sample` and `pdf`.
#[track_caller]
pub fn follows<D: Domain>(
    name: &str,
    domain: &D,
    sample: impl Fn([f32; 2]) -> D::Point,
    pdf: impl Fn(D::Point) -> f64 + Sync,
) {
    let fault = fault_of(name, domain, sample, pdf);
    assert_eq!(fault, None, "{name}");
}

/// The same check with a wrong pair, which it must refuse for a reason that begins so.
#[track_caller]
pub fn deviates<D: Domain>(
    name: &str,
    reason: &str,
    domain: &D,
    sample: impl Fn([f32; 2]) -> D::Point,
    pdf: impl Fn(D::Point) -> f64 + Sync,
) {
    let fault = fault_of(name, domain, sample, pdf).unwrap_or_default();
    println!("{name}: {fault}");
    assert!(fault.starts_with(reason), "{name}: {fault:?}");
}
