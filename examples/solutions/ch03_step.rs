//! Chapter 3, exercise 2: a function with a jump, by random points and by a grid.
//!
//! The error of random points falls with the power -1/2, jump or not. A grid only errs in the step
//! that holds the jump, by less than that step: its power is -1, where it is -2 for smooth
//! functions.

#![allow(clippy::print_stdout)]

use halfdisk::lab::estimators::many_dimensions;
use halfdisk::lab::experiment::convergence::{Convergence, Design, Estimator, Sizes, converge};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::stats::Estimate;
use halfdisk::stats::slope::Line;

/// Where the function falls from 1 to 0, and its integral.
const JUMP: f64 = 1.0 / std::f64::consts::E;

fn step(x: f64) -> f64 {
    if x < JUMP { 1.0 } else { 0.0 }
}

/// The mean over `n` random points.
fn by_chance(n: u32, seed: u64) -> f64 {
    let mut u = Stream::new(seed, 0, 0).at(0, Purpose::Integrand);
    let mean: Estimate = (0..n).map(|_| step(f64::from(u.one()))).collect();
    mean.mean()
}

/// The mean over the middles of `n` equal steps.
fn by_grid(n: u32) -> f64 {
    let middle = |i| (f64::from(i) + 0.5) / f64::from(n);
    (0..n).map(|i| step(middle(i))).sum::<f64>() / f64::from(n)
}

fn chance() -> Convergence {
    let estimator = Estimator {
        name: "step",
        about: "a step by random points",
        truth: JUMP,
        rays_per_sample: 1,
        sizes: Sizes::Doublings,
        run: by_chance,
    };
    converge(&estimator, &Design::default())
}

/// The power of a grid's error. It jumps about from one `n` to the next, so each size stands for
/// all grids up to twice as fine.
fn slope_of_grid(error: fn(u32) -> f64) -> Option<f64> {
    let sizes = (4..11).map(|k| 1_u32 << k);
    let points: Vec<(f64, f64)> = sizes
        .map(|n| {
            let squares: Estimate = (n..2 * n).map(|m| error(m) * error(m)).collect();
            (f64::from(n), squares.mean().sqrt())
        })
        .collect();
    Line::through(&points).map(|line| line.slope)
}

fn grid_at_step(n: u32) -> f64 {
    by_grid(n) - JUMP
}

fn grid_at_sine(n: u32) -> f64 {
    many_dimensions::grid(1, n) - 1.0
}

fn main() {
    println!("random points at the step: {}", chance().slope_text());
    for (function, error) in [
        ("the step", grid_at_step as fn(u32) -> f64),
        ("a smooth sine", grid_at_sine),
    ] {
        if let Some(slope) = slope_of_grid(error) {
            println!("grids at {function}: slope {slope:.3}");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_jump_changes_the_rate_of_grids_and_not_that_of_chance() {
        let fit = chance().fit.expect("a slope");
        assert!((fit.line.slope + 0.5).abs() <= 4.0 * fit.std_error);
        assert!(fit.std_error < 0.01);
        // Half a step at most: the middle next to the jump decides.
        for n in 1..2000 {
            assert!(grid_at_step(n).abs() <= 0.5 / f64::from(n) + 1e-12, "{n}");
        }
        let slope = slope_of_grid(grid_at_step).expect("a slope");
        assert!((slope + 1.0).abs() < 0.05, "step: {slope}");
        let slope = slope_of_grid(grid_at_sine).expect("a slope");
        assert!((slope + 2.0).abs() < 0.02, "sine: {slope}");
    }
}
