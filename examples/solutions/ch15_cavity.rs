//! Chapter 15, exercise 3: the inside of a sphere lights itself evenly.
//!
//! Two points of a sphere of radius R see each other at equal angles, and their distance is 2 R cos θ. So
//! the kernel cos²θ / π r² is 1 / 4π R² for any two of them: every patch sees patch j by the share of its
//! area. What arrives is the same everywhere, H = Ē + ρ̄ H with means over the area, or rather the mean of
//! E + ρ H, and so B = E + ρ Ē / (1 - ρ̄).

#![allow(clippy::print_stdout)]

use halfdisk::radiosity::{Matrix, System};

/// Albedo, emission and area of each patch.
const PATCHES: [[f64; 3]; 4] = [
    [0.9, 0.0, 3.0],
    [0.2, 2.0, 1.0],
    [0.5, 0.0, 5.0],
    [0.0, 0.5, 2.0],
];

/// What the patches of a sphere send out, by the solver.
fn solved() -> Vec<f64> {
    let whole: f64 = PATCHES.iter().map(|[_, _, area]| area).sum();
    let row = || PATCHES.iter().map(|[_, _, area]| area / whole);
    let system = System {
        emission: PATCHES.iter().map(|[_, e, _]| [*e; 3]).collect(),
        albedo: PATCHES.iter().map(|[rho, _, _]| [*rho; 3]).collect(),
        factors: Matrix::<f64>::new(4, (0..4).flat_map(|_| row()).collect()),
    };
    let radiance = system.gauss_seidel(1e-15).radiance;
    radiance.iter().map(|of| of[0]).collect()
}

/// The same in closed form.
fn exact() -> Vec<f64> {
    let whole: f64 = PATCHES.iter().map(|[_, _, area]| area).sum();
    let mean = |k: usize| PATCHES.iter().map(|p| p[k] * p[2]).sum::<f64>() / whole;
    let arrives = mean(1) / (1.0 - mean(0));
    PATCHES
        .iter()
        .map(|[rho, e, _]| e + rho * arrives)
        .collect()
}

fn main() {
    for (i, (found, exact)) in solved().iter().zip(exact()).enumerate() {
        println!("patch {i}: {found:.6}, in closed form {exact:.6}");
    }
}

#[test]
fn the_cavity_is_its_closed_form() {
    for (found, exact) in solved().iter().zip(exact()) {
        assert!((found - exact).abs() < 1e-13, "{found} {exact}");
    }
}
