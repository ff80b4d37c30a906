//! Mistakes that nobody has named: two at a time, a factor, a panic, a loop, numbers that are none.

use halfdisk::glam::{DVec2, Vec2, Vec3};
use halfdisk::lab::exercises::samplers::{FlatSampler, SolidSampler};
use halfdisk::lab::exercises::*;
use std::f32::consts::{FRAC_1_PI, PI, TAU};
use std::sync::atomic::{AtomicU32, Ordering};

/// Grades an answer that is wrong, and looks for words in what is said.
#[track_caller]
fn answered<A>(exam: Exam<A>, answer: A, verdict: Verdict, words: &[&str]) -> Report {
    let report = guarded(&exam, &answer, 1);
    println!("{report}");
    assert_eq!(report.verdict, verdict, "{report}");
    for word in words {
        assert!(report.said.contains(word), "no {word:?} in {report}");
    }
    report
}

/// The solutions, by other formulas.
const HALF_DISK: FlatSampler = FlatSampler {
    sample: |u| Vec2::from_angle(PI * u),
    pdf: |w| if w.y >= 0.0 { FRAC_1_PI } else { 0.0 },
};

const MALLEY: SolidSampler = SolidSampler {
    sample: |[u, v]| (u.sqrt() * Vec2::from_angle(TAU * v)).extend((1.0 - u).sqrt()),
    pdf: |w| w.z.max(0.0) * FRAC_1_PI,
};

#[test]
fn two_mistakes_at_once_are_told_as_two() {
    // The right half only, with the density of the whole circle.
    let both = FlatSampler {
        sample: |u| Vec2::from_angle(0.5 * PI * u),
        pdf: |w| if w.y >= 0.0 { 0.5 * FRAC_1_PI } else { 0.0 },
    };
    answered(
        half_disk::exam(),
        both,
        Verdict::Two,
        &["a quarter", "density of the whole circle", "two together"],
    );
    let both = SolidSampler {
        sample: |[u, v]| (u * Vec2::from_angle(TAU * v)).extend((1.0 - u * u).sqrt()),
        pdf: |w| 0.5 * w.z.max(0.0),
    };
    answered(
        malley::exam(),
        both,
        Verdict::Two,
        &["radius without a root", "density of the flat world"],
    );
    // Neither the shadow ray nor the area.
    let both: next_event::Direct = |lamp, p, n, u| {
        let q = lamp.corner + lamp.edges[0] * u[0] + lamp.edges[1] * u[1];
        let (way, wi) = (q - p, (q - p).normalize());
        let cosines = n.dot(wi).max(0.0) * lamp.normal.dot(-wi).max(0.0);
        lamp.radiance * cosines / way.length_squared()
    };
    answered(
        next_event::exam(),
        both,
        Verdict::Two,
        &["the shadow ray", "density of the point"],
    );
    // Neither halved nor over the right length.
    let both: form_factor::FormFactor = |a, b| {
        let strings = |i: usize, j: usize| a[i].distance(b[j]);
        (strings(0, 0) + strings(1, 1) - strings(0, 1) - strings(1, 0)) / b[0].distance(b[1])
    };
    answered(
        form_factor::exam(),
        both,
        Verdict::Two,
        &["the half", "which wall sends"],
    );
    // No part at the edge, and the radius for the diameter.
    let both: edge::Irradiance = |photons, flux, at, radius| {
        flux * photons.iter().filter(|x| (*x - at).abs() <= radius).count() as f64 / radius
    };
    answered(edge::exam(), both, Verdict::Two, &["beyond the end", "2 r"]);
}

#[test]
fn a_factor_is_named() {
    let answer = FlatSampler {
        pdf: |w| if w.y >= 0.0 { 4.0 * FRAC_1_PI } else { 0.0 },
        ..HALF_DISK
    };
    answered(
        half_disk::exam(),
        answer,
        Verdict::Factor,
        &["All 3 wrong readings are 4 times what is right."],
    );
    let answer: next_event::Direct = |lamp, p, n, u| {
        let q = lamp.corner + lamp.edges[0] * u[0] + lamp.edges[1] * u[1];
        let (way, wi) = (q - p, (q - p).normalize());
        let cosines = n.dot(wi).max(0.0) * lamp.normal.dot(-wi).max(0.0);
        let area = lamp.edges[0].cross(lamp.edges[1]).length();
        match lamp.is_visible(p, q) {
            true => 2.0 * PI * lamp.radiance * cosines * area / way.length_squared(),
            false => 0.0,
        }
    };
    answered(
        next_event::exam(),
        answer,
        Verdict::Factor,
        &["that is 2π", "All 4 wrong readings"],
    );
}

#[test]
fn what_no_mistake_explains_is_described() {
    // Angles that crowd at the tangent.
    let answer = FlatSampler {
        sample: |u| Vec2::from_angle(PI * u * u),
        ..HALF_DISK
    };
    let report = answered(
        half_disk::exam(),
        answer,
        Verdict::Unknown,
        &["The mean of y", "right is 0.63662", "None of 11"],
    );
    assert!(
        report
            .said
            .contains("The mean of x over your directions is wrong as well"),
        "{report}"
    );
    // The means of both coordinates are right, and the directions are not.
    let answer = SolidSampler {
        sample: |[u, v]| {
            let step = (4.0 * v).floor() / 4.0 + 0.125;
            (u.sqrt() * Vec2::from_angle(TAU * step)).extend((1.0 - u).sqrt())
        },
        ..MALLEY
    };
    answered(
        malley::exam(),
        answer,
        Verdict::Unknown,
        &["do not follow your density", "chi-square"],
    );
    let mirrored: fn() -> &'static str = || "LS+(DS+E";
    let answer = paths::Paths {
        whitted: || "LD?S*E",
        mirrored_caustic: mirrored,
    };
    answered(
        paths::exam(),
        answer,
        Verdict::Unknown,
        &["It is no expression"],
    );
    let answer = paths::Paths {
        whitted: || "LD?D?S*E",
        mirrored_caustic: || "LS+DS+E",
    };
    answered(
        paths::exam(),
        answer,
        Verdict::Unknown,
        &["The shortest is LDDE"],
    );
}

#[test]
fn numbers_that_are_none_are_counted_and_their_uniforms_told() {
    let answer = SolidSampler {
        // Of u = 0 there is no logarithm, and no sine of what is infinite.
        sample: |[u, v]| match u {
            0.0 => Vec3::splat(f32::NAN),
            _ => (MALLEY.sample)([u, v]),
        },
        ..MALLEY
    };
    answered(
        malley::exam(),
        answer,
        Verdict::Unknown,
        &[
            "Directions whose length is not 1: 2 of",
            "with the uniforms 0 and",
        ],
    );
    let answer: roulette::Path = |rho, q, random| match random.fine() < 0.001 {
        true => f64::INFINITY,
        false => 1.0 / (1.0 - rho) + q - q,
    };
    answered(
        roulette::exam(),
        answer,
        Verdict::Unknown,
        &["are not finite numbers, first with the uniforms"],
    );
}

#[test]
fn an_answer_with_randomness_of_its_own_is_told_so() {
    static CALLS: AtomicU32 = AtomicU32::new(0);
    let answer = FlatSampler {
        sample: |_| {
            let call = CALLS.fetch_add(1, Ordering::Relaxed);
            Vec2::from_angle(PI * (call as f32 * 0.618_034).fract())
        },
        ..HALF_DISK
    };
    answered(
        half_disk::exam(),
        answer,
        Verdict::Unknown,
        &["give another result when they come again"],
    );
}

#[test]
fn a_price_that_is_too_high_is_no_wrong_mean() {
    let report = answered(
        choose::exam(),
        // Probabilities by the squares of the shares, with the right weights.
        |k, u| {
            let squares = k.map(|k| k * k);
            let total: f64 = squares.iter().sum();
            let (mut below, mut found) = (0.0, 2);
            for i in (0..3).rev() {
                below += squares[i];
                if u * total < below && squares[i] > 0.0 {
                    found = i;
                    break;
                }
            }
            (found, k[found] * total / squares[found])
        },
        Verdict::Unknown,
        &["The probability of part 0"],
    );
    assert!(report.points > 0 && report.points < report.of);
    let half: mis::Both = |lamp, [u, v]| {
        let [a, b] = [lamp.sample_chance(u), lamp.sample_aim(v)];
        let by_aiming = lamp.integrand(b) / lamp.pdf(b)[1];
        0.3 * lamp.integrand(a) / lamp.pdf(a)[0] + 0.7 * by_aiming
    };
    answered(
        mis::exam(),
        half,
        Verdict::Unknown,
        &["right in the mean, but at a price", "times the samples"],
    );
}

#[test]
fn panics_and_holes_end_in_a_report() {
    let panics = FlatSampler {
        sample: |u| {
            assert!(u < 0.5, "a planted mistake");
            Vec2::Y
        },
        ..HALF_DISK
    };
    answered(
        half_disk::exam(),
        panics,
        Verdict::Panics,
        &["your answer panics: a planted mistake"],
    );
    let unwritten: form_factor::FormFactor = |_: [DVec2; 2], _| todo!("write this");
    let report = answered(
        form_factor::exam(),
        unwritten,
        Verdict::Unwritten,
        &["not written yet", "Hottel"],
    );
    assert_eq!((report.points, report.checks.len()), (0, 0));
}
