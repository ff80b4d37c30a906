//! The half disk and the hemisphere: twins under the same tests.
//!
//! Pairs of sample and density by quadrature and chi-square at 32 and 800 cells, wrong pairs that
//! must fail, and every value a uniform can take where a function has one.

use crate::pairs::{Cap, HalfDisk, deviates, follows};
use crate::warps::off_unit;
use glam::{Vec2, Vec3};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::sampling::{LAST_UNIFORM, half_disk, hemisphere};
use halfdisk::stats::Estimate;
use halfdisk::stats::kolmogorov_smirnov::kolmogorov_smirnov;
use std::f64::consts::{FRAC_PI_4, PI};

fn numbers(name: &str) -> halfdisk::sampling::stream::Numbers {
    let seed = name.bytes().map(u64::from).sum();
    Stream::new(seed, 1, 0).at(0, Purpose::Direction)
}

/// Samples of the half disk follow their density.
fn follows_flat(name: &str, sample: impl Fn([f32; 2]) -> Vec2, pdf: impl Fn(Vec2) -> f32 + Sync) {
    follows(name, &HalfDisk, sample, |w| f64::from(pdf(w)));
}

/// Samples of the hemisphere follow their density.
fn follows_solid(name: &str, sample: impl Fn([f32; 2]) -> Vec3, pdf: impl Fn(Vec3) -> f32 + Sync) {
    follows(name, &Cap(1.0), sample, |w| f64::from(pdf(w)));
}

fn one(sample: impl Fn(f32) -> Vec2) -> impl Fn([f32; 2]) -> Vec2 {
    move |u| sample(u[0])
}

#[test]
fn s1_15_uniform() {
    follows_flat(
        "half disk, uniform",
        one(half_disk::sample_uniform),
        half_disk::pdf_uniform,
    );
    let (sample, pdf) = (hemisphere::sample_uniform, hemisphere::pdf_uniform);
    follows_solid("hemisphere, uniform", sample, pdf);
}

#[test]
fn s0_21_cosine() {
    follows_flat(
        "half disk, cosine",
        one(half_disk::sample_cosine),
        half_disk::pdf_cosine,
    );
    // The hemisphere's is in `warps`; here the first moments and the law of the angle itself.
    let mut u = numbers("cosine");
    let (mut flat, mut solid) = (Vec::new(), Vec::new());
    for _ in 0..100_000 {
        let w = half_disk::sample_cosine(u.one());
        flat.push(libm::acos(f64::from(w.x)));
        solid.push(libm::acos(f64::from(hemisphere::sample_cosine(u.two()).z)));
    }
    let cosines: Estimate = solid.iter().map(|&t| libm::cos(t)).collect();
    crate::checks::accept("E[cos] on the hemisphere", &cosines, 2.0 / 3.0, 2.0 / 3.0);
    let cosines: Estimate = flat.iter().map(|&t| libm::sin(t)).collect();
    crate::checks::accept("E[cos] in the half disk", &cosines, FRAC_PI_4, FRAC_PI_4);
    crate::checks::reject("uniform in angle", &cosines, 2.0 / PI);
    let sine2 = |t: f64| libm::sin(t).powi(2);
    let (flat_law, solid_law) = (
        kolmogorov_smirnov(&mut flat, |t| 0.5 * (1.0 - libm::cos(t))),
        kolmogorov_smirnov(&mut solid, sine2),
    );
    println!("Kolmogorov-Smirnov: {:.4} {:.4}", flat_law.p, solid_law.p);
    assert!(flat_law.p > 1e-3 && solid_law.p > 1e-3);
    assert!(kolmogorov_smirnov(&mut solid, |t| 2.0 * t / PI).p < 1e-3);
}

#[test]
fn powers_of_the_cosine() {
    for exponent in [0.0, 0.5, 1.0, 2.0, 12.0] {
        let flat = |u| half_disk::sample_cos_n(u, exponent);
        let pdf = |w| half_disk::pdf_cos_n(w, exponent);
        follows_flat(&format!("half disk, power {exponent}"), flat, pdf);
        let solid = |u| hemisphere::sample_cos_n(u, exponent);
        let pdf = |w| hemisphere::pdf_cos_n(w, exponent);
        follows_solid(&format!("hemisphere, power {exponent}"), solid, pdf);
    }
}

#[test]
fn the_powers_zero_and_one_are_the_uniform_and_the_cosine_densities() {
    for k in 1..100 {
        let (sin, cos) = libm::sincosf(k as f32 * 0.031);
        let (flat, solid) = (Vec2::new(cos, sin), Vec3::new(cos, 0.0, sin));
        let same = |a: f32, b: f32| assert!((a - b).abs() < 1e-6, "{a} {b}");
        same(
            half_disk::pdf_cos_n(flat, 0.0),
            half_disk::pdf_uniform(flat),
        );
        same(half_disk::pdf_cos_n(flat, 1.0), half_disk::pdf_cosine(flat));
        same(
            hemisphere::pdf_cos_n(solid, 0.0),
            hemisphere::pdf_uniform(solid),
        );
        same(
            hemisphere::pdf_cos_n(solid, 1.0),
            hemisphere::pdf_cosine(solid),
        );
    }
}

#[test]
fn wrong_pairs_are_caught() {
    let flat = |what: &str,
                reason: &str,
                sample: &dyn Fn(f32) -> Vec2,
                pdf: &(dyn Fn(Vec2) -> f32 + Sync)| {
        deviates(
            what,
            reason,
            &HalfDisk,
            |u| sample(u[0]),
            |w| f64::from(pdf(w)),
        );
    };
    let (uniform, cosine) = (half_disk::sample_uniform, half_disk::sample_cosine);
    flat("another density", "chi2", &uniform, &half_disk::pdf_cosine);
    flat("a wrong constant", "integrates", &cosine, &|w| w.y / 3.0);
    let squared = |u| half_disk::sample_cos_n([u, 0.0], 2.0);
    flat("a wrong power", "chi2", &squared, &|w| {
        half_disk::pdf_cos_n(w, 2.1)
    });
    let polar = |u: [f32; 2]| {
        let (sin, cos) = libm::sincosf(std::f32::consts::FRAC_PI_2 * u[0]);
        let (sin_phi, cos_phi) = libm::sincosf(std::f32::consts::TAU * u[1]);
        Vec3::new(sin * cos_phi, sin * sin_phi, cos)
    };
    let pdf = |w| f64::from(hemisphere::pdf_uniform(w));
    deviates("a uniform polar angle", "chi2", &Cap(1.0), polar, pdf);
}

/// Every value a uniform can take.
fn all_uniforms() -> impl Iterator<Item = f32> {
    (0..1_u32 << 24).map(|mantissa| mantissa as f32 / 16_777_216.0)
}

#[test]
fn a22_no_uniform_puts_a_direction_below_the_half_disk() {
    let (mut worst, mut rim, mut there_and_back) = (0.0_f64, 0.0_f64, 0.0_f32);
    for u in all_uniforms() {
        let (a, b) = (half_disk::sample_uniform(u), half_disk::sample_cosine(u));
        assert!(a.y >= 0.0 && half_disk::pdf_uniform(a) > 0.0, "{u}: {a}");
        assert!(b.y > 0.0 && half_disk::pdf_cosine(b) > 0.0, "{u}: {b}");
        for w in [a, b] {
            worst = worst.max(off_unit(w.extend(0.0)));
        }
        // The weight of a diffuse surface is exactly one.
        assert_eq!(0.5 * b.y / half_disk::pdf_cosine(b), 1.0);
        let v = f64::from(u);
        if u > 0.0 {
            let exact = 2.0 * (v * (1.0 - v)).sqrt();
            rim = rim.max((f64::from(b.y) / exact - 1.0).abs());
        }
        let back = [half_disk::invert_uniform(a), half_disk::invert_cosine(b)];
        for v in back {
            assert!((0.0..1.0).contains(&v), "{u}: {v}");
            there_and_back = there_and_back.max((u - v).abs());
        }
    }
    println!("off unit {worst:e}, sine off by {rim:e} relative, inverse {there_and_back:e}");
    assert!(worst < 2e-7 && rim < 2e-7 && there_and_back < 1e-5);
}

#[test]
fn a22_the_plain_forms_do_fall_below() {
    let plain_uniform = libm::cosf(std::f32::consts::PI * (0.0_f32 - 0.5));
    let plain_cosine = libm::cosf(libm::asinf(2.0 * 0.0 - 1.0));
    assert!(
        plain_uniform < 0.0 && plain_cosine < 0.0,
        "{plain_uniform} {plain_cosine}"
    );
}

#[test]
fn a20_no_uniform_puts_a_direction_below_the_hemisphere() {
    let (mut worst, mut there_and_back) = (0.0_f64, 0.0_f32);
    for u in all_uniforms() {
        let w = hemisphere::sample_uniform([u, 0.3]);
        assert!(w.z > 0.0 && hemisphere::pdf_uniform(w) > 0.0, "{u}: {w}");
        let power = hemisphere::sample_cos_n([u, 0.3], 5.0);
        assert!(
            power.z > 0.0 && hemisphere::pdf_cos_n(power, 5.0) > 0.0,
            "{u}: {power}"
        );
        worst = worst.max(off_unit(w)).max(off_unit(power));
        let back = hemisphere::invert_uniform(w);
        let cosine = hemisphere::invert_cosine(hemisphere::sample_cosine([u, 0.3]));
        for [a, b] in [back, cosine] {
            assert!((0.0..1.0).contains(&a) && (0.0..1.0).contains(&b));
            // At the pole itself every azimuth is the same direction.
            let azimuth = if u > 0.0 { (b - 0.3).abs() } else { 0.0 };
            there_and_back = there_and_back.max((u - a).abs()).max(azimuth);
        }
    }
    println!("off unit {worst:e}, inverse {there_and_back:e}");
    assert!(worst < 1e-6 && there_and_back < 1e-5);
}

#[test]
fn a20_the_corners_of_powers_stay_in_their_domain() {
    const EDGES: [f32; 4] = [0.0, f32::EPSILON / 2.0, 0.5, LAST_UNIFORM];
    for exponent in [0.0, 0.5, 1.0, 7.0, 1e4] {
        for u in (0..16).map(|i| [EDGES[i / 4], EDGES[i % 4]]) {
            let (flat, solid) = (
                half_disk::sample_cos_n(u, exponent),
                hemisphere::sample_cos_n(u, exponent),
            );
            assert!(
                flat.y >= 0.0 && solid.z > 0.0,
                "{exponent} {u:?}: {flat} {solid}"
            );
            assert!(exponent == 0.0 || flat.y > 0.0, "{exponent} {u:?}: {flat}");
            assert!(off_unit(flat.extend(0.0)) < 1e-6 && off_unit(solid) < 1e-6);
        }
    }
}

#[test]
fn strata_are_hit_once_each_and_stay_below_one() {
    for count in [1, 4, 9, 1024, 3000] {
        for (index, u) in (0..count).flat_map(|i| [(i, 0.0), (i, LAST_UNIFORM)]) {
            let flat = half_disk::stratified(index, count, u);
            assert!(flat < 1.0 && (f64::from(flat) * f64::from(count) - f64::from(index)) < 1.001);
            let side = count.isqrt();
            let [a, b] = hemisphere::stratified(index, count, [u, u]);
            assert!(a < 1.0 && b < 1.0);
            if u == 0.0 && index < side * side {
                let cell = |x: f32| (f64::from(x) * f64::from(side)).round() as u32;
                assert_eq!(cell(a) * side + cell(b), index);
            }
        }
    }
    // Where the count is no square, the mean is right all the same.
    let mut u = numbers("strata");
    let means: Estimate = (0..20_000)
        .map(|_| {
            let sum: f32 = (0..7)
                .map(|i| hemisphere::stratified(i, 7, u.two())[0])
                .sum();
            f64::from(sum) / 7.0
        })
        .collect();
    crate::checks::accept("mean of 7 strata", &means, 0.5, 1.0);
}
