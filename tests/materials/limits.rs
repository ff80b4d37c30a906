//! Rough surfaces at their ends: almost smooth, seen almost edge-on, and any numbers at all.

use super::{direction, numbers};
use glam::Vec3;
use halfdisk::color::Rgb;
use halfdisk::materials::{Bsdf, SMOOTH};
use halfdisk::sampling::warps;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// Everything that may come of a material is a finite number of the right sign.
fn sound(material: &Bsdf, wo: Vec3, wi: Vec3, choice: f32, u: [f32; 2]) {
    let say = || format!("{material:?} {wo} {wi} {choice} {u:?}");
    let f = material.f(wo, wi);
    assert!(f.is_finite() && f.r >= 0.0, "{}: {f:?}", say());
    let pdf = material.pdf(wo, wi);
    assert!(pdf.is_finite() && pdf >= 0.0, "{}: {pdf}", say());
    if let Some(next) = material.scatter(wo, choice, u) {
        let off = (next.wi.length() - 1.0).abs();
        assert!(off < 1e-5, "{}: {off:e}", say());
        let share = next.weight.channels();
        assert!(
            share.iter().all(|x| (0.0..=1.0 + 1e-5).contains(x)),
            "{}",
            say()
        );
        let positive = next.pdf.is_none_or(|p| p > 0.0 && p.is_finite());
        assert!(positive, "{}: {next:?}", say());
    }
}

#[test]
fn a35_finite_from_almost_smooth_to_rough_and_down_to_grazing() {
    for alpha in [1e-6, 1e-4, 1e-3, 0.01, 0.1, 1.0] {
        let mirror = Bsdf::glossy(Rgb::WHITE, alpha);
        let glass = Bsdf::rough_glass(1.5, alpha);
        assert_eq!(mirror.is_smooth(), alpha >= SMOOTH);
        assert_eq!(glass.is_smooth(), alpha >= SMOOTH);
        for cos in [1.0, 0.5, 1e-2, 1e-4, 1e-20, 0.0] {
            for wo in [direction(cos), direction(-cos)] {
                for index in 0..500 {
                    let (choice, u) = numbers(index);
                    let wi = warps::sample_sphere(u);
                    for material in [mirror, glass] {
                        sound(&material, wo, wi, choice, u);
                        // Its own mirror direction is the peak.
                        sound(
                            &material,
                            wo,
                            Vec3::new(-wo.x, -wo.y, wo.z),
                            choice,
                            [0.0; 2],
                        );
                        sound(&material, wo, -wo, choice, u);
                    }
                }
            }
        }
    }
}

#[test]
fn towards_no_roughness_it_is_the_mirror_and_the_glass() {
    // Light that depends on the direction, smoothly.
    let light = |w: Vec3| f64::from(2.0 + w.x - 0.5 * w.y * w.z + w.z);
    let mean = |material: &Bsdf, wo: Vec3| {
        let n = 100_000;
        let one = |i| {
            let (choice, u) = numbers(i);
            let next = material.scatter(wo, choice, u);
            next.map_or(0.0, |s| f64::from(s.weight.r) * light(s.wi))
        };
        (0..n).map(one).sum::<f64>() / f64::from(n)
    };
    let white = Rgb::WHITE;
    for cos in [1.0, 0.5, 0.1, -1.0, -0.8, -0.5] {
        let wo = direction(cos);
        for (rough, twin, blunt) in [
            (
                Bsdf::glossy(white, SMOOTH),
                Bsdf::glossy(white, 0.5 * SMOOTH),
                Bsdf::glossy(white, 0.5),
            ),
            (
                Bsdf::rough_glass(1.5, SMOOTH),
                Bsdf::rough_glass(1.5, 0.5 * SMOOTH),
                Bsdf::rough_glass(1.5, 0.5),
            ),
        ] {
            let [rough, twin, blunt] = [rough, twin, blunt].map(|m| mean(&m, wo));
            println!("{cos}: {rough:.5}, specular {twin:.5}, very rough {blunt:.5}");
            assert!((rough / twin - 1.0).abs() < 0.01, "{cos}: {rough} {twin}");
            assert!((blunt / twin - 1.0).abs() > 0.01, "{cos}: {blunt} {twin}");
        }
    }
}

proptest! {
    // The same cases in every run, and no file is written where one fails: its numbers are said.
    #![proptest_config(ProptestConfig {
        cases: 4000,
        rng_seed: RngSeed::Fixed(35),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]
    #[test]
    fn any_numbers_give_sound_answers(
        (a, b, c) in (0..1_u32 << 24, 0..1_u32 << 24, 0..1_u32 << 24),
        (d, e, f) in (0..1_u32 << 24, 0..1_u32 << 24, 0..1_u32 << 24),
        choice in 0..1_u32 << 24,
        exponent in -3.0..0.0_f32,
        ior in 0.1..10.0_f32,
        flat in -12.0..0.0_f32,
    ) {
        let u = |x: u32| x as f32 / 16_777_216.0;
        let sphere = |x, y| warps::sample_sphere([u(x), u(y)]);
        let alpha = libm::powf(10.0, exponent).clamp(1e-3, 1.0);
        let (mut wo, wi) = (sphere(a, b), sphere(c, d));
        if e % 2 == 0 {
            // Half of all directions come in close to the surface.
            wo = Vec3::new(wo.x, wo.y, wo.z * libm::powf(10.0, flat)).normalize();
        }
        for material in [
            Bsdf::glossy(Rgb::WHITE, alpha),
            Bsdf::rough_glass(ior, alpha),
            Bsdf::rough_glass(1.0, alpha),
        ] {
            sound(&material, wo, wi, u(choice), [u(e), u(f)]);
        }
    }
}
