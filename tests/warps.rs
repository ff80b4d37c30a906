//! Samples against densities: each density integrates to one, and the samples follow it.

use crate::pairs::{Cap, Disk, deviates, follows};
use glam::{Vec2, Vec3};
use halfdisk::sampling::{hemisphere, warps};

/// A density of directions or points in `f64`.
fn wide<P>(pdf: impl Fn(P) -> f32) -> impl Fn(P) -> f64 {
    move |p| f64::from(pdf(p))
}

#[test]
fn cosine_hemisphere() {
    let pdf = wide(hemisphere::pdf_cosine);
    follows("cosine", &Cap(1.0), hemisphere::sample_cosine, pdf);
}

#[test]
fn sphere() {
    let pdf = wide(|_| warps::pdf_sphere());
    follows("sphere", &Cap(2.0), warps::sample_sphere, pdf);
}

#[test]
fn unit_disk() {
    for (name, sample) in [
        ("disk", warps::sample_disk as fn([f32; 2]) -> Vec2),
        ("concentric disk", warps::sample_disk_concentric),
    ] {
        follows(name, &Disk, sample, wide(warps::pdf_disk));
    }
    assert_eq!(warps::sample_disk_concentric([0.5; 2]), Vec2::ZERO);
}

#[test]
fn cones_from_the_hemisphere_down_to_a_distant_lamp() {
    for top in [1.0, 0.3, 1e-3, 1e-9] {
        let sample = |u| warps::sample_cone(u, top);
        let pdf = wide(|_| warps::pdf_cone(top));
        follows(&format!("cone {top:e}"), &Cap(top.into()), sample, pdf);
    }
}

#[test]
fn wrong_pairs_are_caught() {
    let uniform = |u| warps::sample_cone(u, 1.0);
    let cosine = wide(hemisphere::pdf_cosine);
    deviates("another density", "chi2", &Cap(1.0), uniform, &cosine);
    let third = |w: Vec3| f64::from(w.z) / 3.0;
    let sample = hemisphere::sample_cosine;
    deviates("a wrong constant", "integrates", &Cap(1.0), sample, third);
    let linear = |u: [f32; 2]| warps::sample_disk([u[0] * u[0], u[1]]);
    let pdf = wide(warps::pdf_disk);
    deviates("a radius without its root", "chi2", &Disk, linear, pdf);
    let twice = |u: [f32; 2]| hemisphere::sample_cosine([u[0], u[0]]);
    deviates("one uniform for both", "chi2", &Cap(1.0), twice, &cosine);
    let below = |u: [f32; 2]| hemisphere::sample_cosine(u) * if u[1] < 0.01 { -1.0 } else { 1.0 };
    deviates("some below", "integrates", &Cap(1.0), below, &cosine);
}

/// The smallest and largest uniforms and their middle.
fn corners() -> impl Iterator<Item = [f32; 2]> {
    const EDGES: [f32; 4] = [0.0, f32::EPSILON / 2.0, 0.5, 1.0 - f32::EPSILON / 2.0];
    (0..16).map(|i| [EDGES[i / 4], EDGES[i % 4]])
}

pub fn off_unit(w: Vec3) -> f64 {
    (w.as_dvec3().length() - 1.0).abs()
}

#[test]
fn a20_the_corners_of_the_unit_square_stay_in_their_domain() {
    let mut worst = 0.0_f64;
    for u in corners() {
        let w = hemisphere::sample_cosine(u);
        assert!(w.z > 0.0 && hemisphere::pdf_cosine(w) > 0.0, "{u:?}: {w}");
        worst = worst.max(off_unit(w));
        worst = worst.max(off_unit(warps::sample_sphere(u)));
        let p = warps::sample_disk(u);
        assert!(p.is_finite() && warps::pdf_disk(p) > 0.0, "{u:?}: {p}");
        for top in [1.0, 0.3, 1e-3, 1e-9, 1e-30] {
            let w = warps::sample_cone(u, top);
            worst = worst.max(off_unit(w));
            assert!(1.0 - w.z <= top + f32::EPSILON, "{u:?}: {w}");
            let pdf = warps::pdf_cone(top);
            assert!(pdf > 0.0 && pdf.is_finite());
        }
    }
    println!("worst distance from unit length {worst:e}");
    assert!(worst < 1e-6);
}

#[test]
fn a20_no_uniform_puts_a_cosine_sample_on_the_rim() {
    let (mut lowest, mut worst) = (f32::INFINITY, 0.0_f64);
    for mantissa in 0..1_u32 << 24 {
        let u = mantissa as f32 / 16_777_216.0;
        assert!(u < 1.0);
        let w = hemisphere::sample_cosine([u, 0.3]);
        lowest = lowest.min(w.z);
        worst = worst.max(off_unit(w));
    }
    println!("lowest z {lowest:e}, worst distance from unit length {worst:e}");
    assert!(lowest > 0.0 && worst < 1e-6);
}

#[test]
fn a20_no_turn_puts_a_disk_sample_outside_its_density() {
    for mantissa in 0..1_u32 << 24 {
        let u = [1.0 - f32::EPSILON / 2.0, mantissa as f32 / 16_777_216.0];
        let p = warps::sample_disk(u);
        assert!(warps::pdf_disk(p) > 0.0, "{u:?}: {p}");
    }
}
