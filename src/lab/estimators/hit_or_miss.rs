//! π by throwing darts, and three ways to do better.
//!
//! The quarter disc has area π/4. Darts ask "inside?" and learn one bit each; the height of the
//! circle is worth more; a dart in every cell of a grid wastes none on crowding.
//!
//! Source: Hammersley, Handscomb, Monte Carlo Methods (1964), chapter 5, "Hit-or-miss Monte Carlo"
//! and "Crude Monte Carlo".

use crate::sampling::hemisphere;
use crate::sampling::stream::{Numbers, Purpose, Stream};
use crate::stats::Estimate;

// ANCHOR: darts
/// π by `n` darts thrown at the unit square: 4 for each that lands in the quarter disc.
///
/// Variance of one dart: `π (4 - π) = 2.6968`, a standard deviation of 1.64218.
pub fn darts(n: u32, seed: u64) -> Estimate {
    let mut u = numbers(seed);
    (0..n).map(|_| dart(u.two())).collect()
}
// ANCHOR_END: darts

/// Where the first `n` darts of [`darts`] land in the unit square, and what each scores: 4 or 0.
pub fn thrown(n: u32, seed: u64) -> impl Iterator<Item = ([f64; 2], f64)> {
    let mut u = numbers(seed);
    (0..n).map(move |_| {
        let at = u.two();
        (at.map(f64::from), dart(at))
    })
}

/// π as the mean of `4 √(1 - x²)`, the height of the disc over `n` random places.
///
/// Variance of one place: `32/3 - π² = 0.7971`; darts need 3.3834 times as many.
pub fn sample_mean(n: u32, seed: u64) -> Estimate {
    let mut u = numbers(seed);
    (0..n).map(|_| height(f64::from(u.one()))).collect()
}

/// π by `n` darts, one in each cell of a square grid; `n` is a square.
///
/// Only the cells on the rim are in doubt, about `√n` of them: the error falls as `n^(-3/4)`.
pub fn jittered_darts(n: u32, seed: u64) -> f64 {
    let mut u = numbers(seed);
    let sum: f64 = (0..n)
        .map(|i| dart(hemisphere::stratified(i, n, u.two())))
        .sum();
    sum / f64::from(n)
}

/// π by the heights at the middles of `n` equal steps: no randomness.
pub fn midpoints(n: u32) -> f64 {
    let middle = |i| (f64::from(i) + 0.5) / f64::from(n);
    (0..n).map(|i| height(middle(i))).sum::<f64>() / f64::from(n)
}

/// Where the step function of [`step`] jumps, and its integral.
pub const STEP: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// The integral over `[0, 1)` of a function that is 1 up to [`STEP`] and 0 beyond, by `n` samples.
/// A jump is no trouble: the error falls as for any other function.
pub fn step(n: u32, seed: u64) -> Estimate {
    let mut u = numbers(seed);
    (0..n)
        .map(|_| f64::from(u8::from(f64::from(u.one()) < STEP)))
        .collect()
}

// ANCHOR: dart
fn dart([x, y]: [f32; 2]) -> f64 {
    let (x, y) = (f64::from(x), f64::from(y));
    if x * x + y * y <= 1.0 { 4.0 } else { 0.0 }
}
// ANCHOR_END: dart

fn height(x: f64) -> f64 {
    4.0 * (1.0 - x * x).sqrt()
}

fn numbers(seed: u64) -> Numbers {
    Stream::new(seed, 0, 0).at(0, Purpose::Integrand)
}
