//! Chapter 5, exercise 3: directions of density proportional to a power of the cosine, and a test
//! that tells them from those of another power.
//!
//! On the hemisphere the angle from the normal has the distribution function `1 - cosⁿ⁺¹ θ`, which
//! can be inverted. In the half disk it has no elementary inverse, but a direction can be drawn and
//! then accepted with probability `cosⁿ θ`: slower, and as right.

#![allow(clippy::print_stdout)]

use glam::{Vec2, Vec3};
use halfdisk::numeric::sin_cos;
use halfdisk::sampling::stream::{Numbers, Purpose, Stream};
use halfdisk::stats::chi_square::chi_square;
use std::f32::consts::{PI, TAU};
use std::f64::consts::FRAC_PI_2;

const SAMPLES: u32 = 200_000;
const CELLS: usize = 32;

/// A direction of the hemisphere of density `(n + 1) cosⁿ θ / 2π`: `cos θ = (1 - u)^(1/(n + 1))`.
fn on_hemisphere(n: f32, u: &mut Numbers) -> Vec3 {
    let cos = libm::powf(1.0 - u.one(), 1.0 / (n + 1.0));
    let sin = (1.0 - cos * cos).sqrt();
    let (sin_phi, cos_phi) = sin_cos(TAU * u.one());
    Vec3::new(sin * cos_phi, sin * sin_phi, cos)
}

/// A direction of the half disk of density proportional to `cosⁿ θ`, by rejection.
fn in_half_disk(n: f32, u: &mut Numbers) -> Vec2 {
    loop {
        let (sin, cos) = sin_cos(PI * (u.one() - 0.5));
        if u.one() < libm::powf(cos.max(0.0), n) {
            return Vec2::new(sin, cos);
        }
    }
}

/// The angle from the normal that each world's sampler draws.
fn angle_on_hemisphere(n: f32, u: &mut Numbers) -> f64 {
    let w = on_hemisphere(n, u).as_dvec3();
    libm::atan2(libm::hypot(w.x, w.y), w.z)
}

fn angle_in_half_disk(n: f32, u: &mut Numbers) -> f64 {
    let w = in_half_disk(n, u);
    libm::atan2(w.x.abs().into(), w.y.into())
}

/// The angle's density in each world, but for its constant.
fn density_on_hemisphere(n: f64, angle: f64) -> f64 {
    libm::pow(libm::cos(angle), n) * libm::sin(angle)
}

fn density_in_half_disk(n: f64, angle: f64) -> f64 {
    libm::pow(libm::cos(angle), n)
}

/// The grade: the chance that right samples lie at least so far from the density.
fn grade(angle: impl Fn(&mut Numbers) -> f64, density: impl Fn(f64) -> f64) -> f64 {
    const STEPS: usize = 64;
    let mut counts = vec![0; CELLS];
    let mut numbers = Stream::new(6, 0, 0).at(0, Purpose::Direction);
    for _ in 0..SAMPLES {
        let cell = angle(&mut numbers) / FRAC_PI_2 * CELLS as f64;
        counts[(cell as usize).min(CELLS - 1)] += 1;
    }
    let middle = |i: usize| (i as f64 + 0.5) / (STEPS * CELLS) as f64 * FRAC_PI_2;
    let cell = |k: usize| (k * STEPS..(k + 1) * STEPS).map(|i| density(middle(i)));
    let shares: Vec<f64> = (0..CELLS).map(|k| cell(k).sum()).collect();
    let whole: f64 = shares.iter().sum();
    let expected: Vec<f64> = shares
        .iter()
        .map(|share| share / whole * f64::from(SAMPLES))
        .collect();
    chi_square(&counts, &expected).p
}

/// Samples of power `n`, graded against the density of power `m`: half disk, then hemisphere.
fn grades(n: f32, m: f32) -> [f64; 2] {
    let m = f64::from(m);
    [
        grade(|u| angle_in_half_disk(n, u), |t| density_in_half_disk(m, t)),
        grade(
            |u| angle_on_hemisphere(n, u),
            |t| density_on_hemisphere(m, t),
        ),
    ]
}

fn main() {
    for (n, m) in [
        (0.0, 0.0),
        (1.0, 1.0),
        (2.0, 2.0),
        (5.0, 5.0),
        (20.0, 20.0),
        (2.0, 2.2),
        (20.0, 21.0),
    ] {
        let [flat, solid] = grades(n, m).map(|p| {
            let verdict = if p > 1e-3 { "passes" } else { "fails" };
            format!("p {p:.4}, {verdict}")
        });
        println!("cosine^{n} tested as cosine^{m}: half disk {flat}; hemisphere {solid}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_powers_pass() {
        for n in [0.0, 0.5, 1.0, 2.0, 5.0, 20.0] {
            let p = grades(n, n);
            assert!(p.iter().all(|&p| p > 1e-3), "{n}: {p:?}");
        }
    }

    #[test]
    fn wrong_powers_fail() {
        for (n, m) in [(0.0, 1.0), (1.0, 2.0), (2.0, 2.2), (20.0, 21.0)] {
            let p = grades(n, m);
            assert!(p.iter().all(|&p| p < 1e-6), "{n} as {m}: {p:?}");
        }
    }

    #[test]
    fn they_lie_over_the_surface() {
        let mut u = Stream::new(7, 0, 0).at(0, Purpose::Direction);
        for _ in 0..10_000 {
            let (flat, solid) = (in_half_disk(3.0, &mut u), on_hemisphere(3.0, &mut u));
            assert!(flat.y > 0.0 && solid.z > 0.0, "{flat} {solid}");
            assert!((flat.length() - 1.0).abs() < 1e-6 && (solid.length() - 1.0).abs() < 1e-6);
        }
    }
}
