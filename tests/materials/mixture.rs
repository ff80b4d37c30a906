//! The choice between diffuse, specular and transmitted light.

use super::{direction, numbers};
use crate::checks::CRITICAL;
use halfdisk::color::Rgb;
use halfdisk::materials::{Bsdf, BsdfSample, Choice, Event, Mixture};
use halfdisk::stats::Estimate;
use halfdisk::stats::chi_square::chi_square;
use halfdisk::stats::z_test::z_test;

const RULES: [Choice; 4] = [
    Choice::Equal,
    Choice::ByMean,
    Choice::ByLuminance,
    Choice::Analog,
];

fn mixture(kd: [f32; 3], ks: [f32; 3], kt: [f32; 3]) -> Mixture {
    let [kd, ks, kt] = [kd, ks, kt].map(Rgb::from);
    let ior = 1.5;
    Mixture { kd, ks, kt, ior }
}

fn grey([kd, ks, kt]: [f32; 3]) -> Mixture {
    mixture([kd; 3], [ks; 3], [kt; 3])
}

/// 0 where light was scattered, 1 where it was mirrored, 2 where it went through.
fn part(next: &BsdfSample) -> usize {
    match next.event {
        Event::Diffuse => 0,
        _ if next.wi.z > 0.0 => 1,
        _ => 2,
    }
}

fn scattered(m: &Mixture, rule: Choice, cos: f32, n: u32) -> Vec<Option<BsdfSample>> {
    let one = |i| {
        let (choice, u) = numbers(i);
        m.scatter_by(rule, direction(cos), choice, u)
    };
    (0..n).map(one).collect()
}

#[test]
fn parts_are_chosen_as_often_as_they_weigh() {
    let mut counts = [0_u64; 3];
    for next in scattered(&grey([0.5, 0.3, 0.2]), Choice::ByMean, 0.8, 1_000_000) {
        counts[part(&next.unwrap())] += 1;
    }
    let p = |expected: [f64; 3]| chi_square(&counts, &expected.map(|e| e * 1e6)).p;
    println!("{counts:?}, p {}", p([0.5, 0.3, 0.2]));
    assert!(p([0.5, 0.3, 0.2]) > 1e-4);
    assert!(p([0.497, 0.303, 0.2]) < 1e-6, "half a percent off");
    assert!(p([1.0 / 3.0; 3]) < 1e-6);
}

#[test]
fn a_furnace_reads_what_is_not_absorbed() {
    for k in [
        [0.5, 0.3, 0.1],
        [0.2, 0.2, 0.2],
        [0.0, 0.4, 0.3],
        [0.6, 0.0, 0.0],
    ] {
        let m = grey(k);
        let truth: f64 = k.iter().copied().map(f64::from).sum();
        for rule in RULES {
            for cos in [0.8, -0.8, -0.3] {
                let walks = scattered(&m, rule, cos, 20_000);
                let weight = |s: &Option<BsdfSample>| s.map_or(0.0, |s| f64::from(s.weight.g));
                let read: Estimate = walks.iter().map(weight).collect();
                let test = z_test(&read, truth, CRITICAL);
                assert!(test.passes(), "{k:?} {rule:?} {cos}: {test}");
                if rule == Choice::ByMean {
                    // Each way weighs all of k_tot.
                    assert!(read.variance() < 1e-12, "{k:?}: {}", read.variance());
                }
                if rule == Choice::Analog {
                    // One or nothing, as often as k_tot says.
                    let law = truth * (1.0 - truth);
                    assert!((read.variance() - law).abs() < 0.02, "{k:?}");
                    let all = walks
                        .iter()
                        .flatten()
                        .all(|s| (s.weight.g - 1.0).abs() < 1e-6);
                    assert!(all);
                }
            }
        }
        // Without the probability in the weight every surface would reflect everything.
        let forgotten: Estimate = scattered(&m, Choice::ByMean, 0.8, 20_000)
            .iter()
            .map(|s| f64::from(u8::from(s.is_some())))
            .collect();
        assert_eq!(forgotten.mean(), 1.0);
        assert!(!z_test(&forgotten, truth, CRITICAL).passes());
    }
}

#[test]
fn colours_come_out_channel_by_channel() {
    let (kd, ks, kt) = ([0.6, 0.1, 0.05], [0.1, 0.7, 0.0], [0.0, 0.1, 0.8]);
    let m = mixture(kd, ks, kt);
    let mut noise = Vec::new();
    for rule in RULES {
        let walks = scattered(&m, rule, 0.8, 200_000);
        let mut variance = 0.0;
        for (wanted, k) in [kd, ks, kt].into_iter().enumerate() {
            for (channel, truth) in k.into_iter().enumerate() {
                let of = |s: &Option<BsdfSample>| {
                    let s = s.filter(|s| part(s) == wanted);
                    s.map_or(0.0, |s| f64::from(s.weight.channels()[channel]))
                };
                let read: Estimate = walks.iter().map(of).collect();
                let test = z_test(&read, f64::from(truth), CRITICAL);
                assert!(test.passes(), "{rule:?} {wanted} {channel}: {test}");
                variance += read.variance();
            }
        }
        noise.push(variance);
    }
    println!("variances by {RULES:?}: {noise:?}");
    // One weight for all channels, that of the luminances, would be wrong.
    let p = |k| Rgb::from(k).luminance() / m.k_tot().luminance();
    let red = p(ks) * m.k_tot().luminance();
    assert!((red - ks[0]).abs() > 0.1);
}

#[test]
fn what_weighs_nothing_is_never_chosen_and_nothing_is_lost_at_the_ends() {
    let last = 1.0_f32.next_down();
    for rule in RULES {
        // Not even where rounding lets the shares add up to a little more than one.
        let full = grey([0.7, 0.2, 0.1]);
        assert!(
            full.scatter_by(rule, direction(0.8), last, [0.5; 2])
                .is_some()
        );
        for cos in [0.8, -0.3] {
            let wo = direction(cos);
            let at = |m: &Mixture, choice| m.scatter_by(rule, wo, choice, [0.3, 0.6]);
            assert!(at(&grey([0.0; 3]), 0.0).is_none());
            assert!(at(&grey([0.0; 3]), last).is_none());
            // At its first number nobody but the first part that weighs something.
            let no_diffuse = at(&grey([0.0, 0.5, 0.5]), 0.0).unwrap();
            assert_eq!(no_diffuse.event, Event::Specular);
            for k in [[0.7, 0.0, 0.0], [0.3, 0.0, 0.0], [1e-30, 0.0, 0.0]] {
                for choice in [0.0, 0.5, last] {
                    let Some(only) = at(&grey(k), choice) else {
                        // Absorbed, where nothing else happens to light.
                        assert!(rule == Choice::Analog && choice >= k[0]);
                        continue;
                    };
                    let weight = if rule == Choice::Analog { 1.0 } else { k[0] };
                    assert_eq!((only.event, only.weight.r), (Event::Diffuse, weight));
                    assert_eq!(only.pdf, Some(grey(k).pdf_by(rule, wo, only.wi)));
                }
            }
            let mirror = at(&grey([0.1, 0.9, 0.0]), last).unwrap();
            assert_eq!(mirror.wi.z, wo.z);
        }
    }
    let smooth = |k| Bsdf::Mixture(grey(k)).is_smooth();
    assert!(smooth([0.1, 0.5, 0.1]) && !smooth([0.0, 0.5, 0.5]));
}

#[test]
fn what_cannot_be_refracted_is_mirrored() {
    // From inside at cos 0.3, beyond the critical angle of 1.5.
    let (m, wo) = (grey([0.2, 0.3, 0.4]), direction(-0.3));
    let tree = m.specular(wo);
    assert!(tree.transmitted.is_none());
    assert!((tree.reflected.unwrap().weight.r - 0.7).abs() < 1e-6);
    let next = m.scatter(wo, 0.999, [0.5, 0.5]).unwrap();
    assert_eq!((next.wi.z, next.event), (wo.z, Event::Specular));
    // Otherwise the tree has both branches, and choosing one gives their shares in the mean.
    let tree = m.specular(direction(0.8));
    let shares = [tree.reflected, tree.transmitted].map(|b| b.unwrap().weight.r);
    assert_eq!(shares, [0.3, 0.4]);
    // A refracted direction is the one of glass.
    let glass = halfdisk::materials::Glass { ior: 1.5 }.specular(direction(0.8));
    let through = |s: &halfdisk::materials::Specular| s.transmitted.unwrap().wi;
    assert_eq!(through(&tree), through(&glass));
}
