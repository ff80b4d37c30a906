//! Wrong is recognised: the readings of the mistakes, and the doctor who names them.

use crate::checks::accept;
use glam::Vec2;
use halfdisk::lab::doctor::{Patient, Reading, diagnose, examine, question, questions};
use halfdisk::lab::experiment::convergence::{Design, converge};
use halfdisk::lab::experiment::named;
use halfdisk::lab::mistakes::{Exam, Variant, all, right, variants};
use halfdisk::sampling::flat_frame::FlatFrame;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::sampling::{half_disk, hemisphere};
use halfdisk::space::{Dimension, Flat, Solid, Space};
use halfdisk::stats::z_test::{FOUR, z_test};
use std::f64::consts::{FRAC_1_PI, FRAC_PI_4, PI};

const WORLDS: [Dimension; 2] = [Dimension::Flat, Dimension::Solid];
const GATHERS: u32 = 120_000;

fn named_variant(dimension: Dimension, name: &str) -> Variant {
    all(dimension)
        .into_iter()
        .find(|v| v.name == name)
        .expect(name)
}

#[test]
fn every_variant_reads_what_it_should() {
    for dimension in WORLDS {
        for variant in [vec![right(dimension)], all(dimension)].concat() {
            for exam in questions() {
                let reading = variant.measure(&exam, GATHERS, 11);
                let exact = variant.reading(&exam);
                let name = format!("{dimension:?}, {}, {exam:?}", variant.name);
                accept(&name, &reading, exact, exact.max(f64::from(exam.albedo)));
            }
        }
    }
}

#[test]
fn s1_12_the_readings_are_those_of_the_table() {
    let tilted = Exam {
        tilt: 0.4,
        ..Exam::default()
    };
    let table = [
        (Dimension::Flat, "formula as printed", 2.0 * FRAC_1_PI),
        (Dimension::Flat, "1/pi of space", 2.0 * FRAC_1_PI),
        (
            Dimension::Flat,
            "printed formula over pi",
            2.0 * FRAC_1_PI * FRAC_1_PI,
        ),
        (Dimension::Flat, "cosine twice", FRAC_PI_4),
        (Dimension::Flat, "cosine of the sampled angle", 0.0),
        (Dimension::Flat, "one term too many", 1.0625),
        (
            Dimension::Flat,
            "matrix transposed, cosine clamped",
            libm::cos(0.4).powi(2),
        ),
        (Dimension::Flat, "matrix transposed", libm::cos(0.8)),
        (Dimension::Flat, "light counted twice", 2.0),
        (Dimension::Solid, "formula as printed", 0.5),
        (Dimension::Solid, "density forgotten", 0.5 * FRAC_1_PI),
        (Dimension::Solid, "cosine twice", 2.0 / 3.0),
        (Dimension::Solid, "Lambert constant forgotten", PI),
        (Dimension::Solid, "no 1/pi, and twice", 2.0 * PI),
        (Dimension::Solid, "polar angle uniform", 4.0 * FRAC_1_PI),
        (Dimension::Solid, "coefficients above one", 1.2),
    ];
    for (dimension, name, reading) in table {
        let exact = named_variant(dimension, name).reading(&tilted);
        assert!((exact - reading).abs() < 1e-6, "{name}: {exact}");
    }
    let twice = Exam {
        bounces: 10,
        ..Exam::default()
    };
    let growing = named_variant(Dimension::Solid, "coefficients above one").reading(&twice);
    assert!((growing - 6.1917).abs() < 1e-3, "{growing}");
}

#[test]
fn the_check_that_accepts_the_right_one_rejects_each_mistake() {
    for dimension in WORLDS {
        for exam in questions() {
            let measured = right(dimension).measure(&exam, GATHERS, 12);
            let truth = right(dimension).reading(&exam);
            accept("right", &measured, truth, truth);
        }
        for mistake in all(dimension) {
            let rejected = questions().iter().any(|exam| {
                let truth = right(dimension).reading(exam);
                !z_test(&mistake.measure(exam, GATHERS, 12), truth, FOUR).passes()
            });
            assert!(rejected, "{dimension:?}: {} passes", mistake.name);
        }
    }
}

#[test]
fn s1_16_the_transposed_matrix_sends_rays_below_the_surface() {
    for tilt in [0.0_f32, 0.2, std::f32::consts::FRAC_PI_6, 0.8, 1.5] {
        let n = Flat::tilted(tilt);
        let frame = FlatFrame::new(n);
        let count = 200_000;
        let below = |turn: &dyn Fn(Vec2) -> Vec2| {
            let mut u = Stream::new(1, 0, 0).at(0, Purpose::Direction);
            let hits = (0..count)
                .filter(|_| turn(half_disk::sample_uniform(u.one())).dot(n) < -1e-6)
                .count();
            halfdisk::stats::Estimate::from_hits(hits as u64, count)
        };
        let wrong = below(&|w| variants::turn_transposed::<Flat>(&frame, w));
        let exact = 2.0 * f64::from(tilt) * FRAC_1_PI;
        accept(&format!("tilt {tilt}"), &wrong, exact, 1.0);
        assert_eq!(below(&|w| frame.to_world(w)).mean(), 0.0);
    }
}

#[test]
fn s1_12_the_literal_formula_levels_out_and_the_corrected_one_falls() {
    for (name, expected, within) in [
        ("half-disk", -0.5, 0.02),
        ("half-disk-stratified", -1.5, 0.02),
        ("half-disk-literal", 0.0, 0.02),
        ("hemisphere", -0.5, 0.02),
        ("hemisphere-stratified", -1.0, 0.03),
        ("hemisphere-literal", 0.0, 0.02),
        ("half-disk-lamp-cosine", -0.5, 0.02),
        ("hemisphere-lamp-stratified", -0.75, 0.03),
    ] {
        let run = converge(&named::find(name).expect(name), &Design::default());
        println!("{name}: {}", run.slope_text());
        let slope = run.fit.expect(name).line.slope;
        assert!((slope - expected).abs() < within, "{name}: {slope}");
        // Each check refuses the other's slope.
        assert!((slope - if expected == 0.0 { -0.5 } else { 0.0 }).abs() > within);
    }
}

#[test]
fn s0_13_the_doctor_names_each_mistake_through_the_noise() {
    for dimension in WORLDS {
        for variant in [vec![right(dimension)], all(dimension)].concat() {
            for seed in 0..20 {
                // 250 gathers: errors of about 1 %.
                let readings = questions().map(|exam| {
                    let measured = variant.measure(&exam, 250, seed);
                    Reading {
                        value: measured.mean(),
                        error: measured.std_error(),
                        exam,
                    }
                });
                let diagnosis = diagnose(dimension, &readings);
                // Identical estimators cannot be told apart, and both must be named.
                let named = diagnosis
                    .matches()
                    .iter()
                    .any(|found| found.variant.name == variant.name);
                assert!(
                    named,
                    "{dimension:?}, {}: {}",
                    variant.name,
                    diagnosis.explain()
                );
                for found in diagnosis.matches() {
                    let twin = question(&variant, &found.variant).is_none();
                    assert!(
                        twin,
                        "{dimension:?}: {} for {}",
                        found.variant.name, variant.name
                    );
                }
                assert_eq!(diagnosis.healthy(), variant.name == "right");
            }
        }
    }
}

#[test]
fn s0_13_one_typed_reading_is_enough_where_it_is_unlike_all_others() {
    let name = |dimension, value| {
        let reading = Reading {
            value,
            error: 5e-5,
            exam: Exam::default(),
        };
        let diagnosis = diagnose(dimension, &[reading]);
        diagnosis
            .matches()
            .iter()
            .map(|f| f.variant.name)
            .collect::<Vec<_>>()
    };
    let twins = vec!["formula as printed", "1/pi of space"];
    assert_eq!(name(Dimension::Flat, 0.636_64), twins);
    assert_eq!(name(Dimension::Flat, 0.2026), ["printed formula over pi"]);
    assert_eq!(name(Dimension::Solid, 0.6667), ["cosine twice"]);
    assert_eq!(name(Dimension::Solid, 6.283_25), ["no 1/pi, and twice"]);
    assert!(name(Dimension::Solid, 0.9).is_empty());
    assert!(name(Dimension::Solid, f64::NAN).is_empty());
    // Among the many that a white, upright surface cannot tell from the right one, it comes first.
    assert_eq!(name(Dimension::Flat, 1.0)[0], "right");
    let reading = Reading {
        value: 0.636_64,
        error: 5e-5,
        exam: Exam::default(),
    };
    let text = diagnose(Dimension::Flat, &[reading]).explain();
    assert!(text.contains("No reading tells them apart"), "{text}");
    let reading = Reading {
        value: 1.0,
        ..reading
    };
    let text = diagnose(Dimension::Flat, &[reading]).explain();
    assert!(text.contains("a tilt of 30 degrees"), "{text}");
}

#[test]
fn a_learners_estimator_is_examined() {
    let healthy = examine(|p: &mut Patient<Solid>| {
        let mut sum = 0.0;
        for _ in 0..p.samples {
            let w = hemisphere::sample_cosine(p.random());
            sum += p.cast_ray(Solid::to_world(&Solid::frame(p.normal), w));
        }
        p.albedo * sum / p.samples as f32
    });
    assert!(healthy.healthy(), "{}", healthy.explain());
    let transposed = examine(|p: &mut Patient<Flat>| {
        let n = p.normal;
        let mut sum = 0.0;
        for _ in 0..p.samples {
            let w = half_disk::sample_uniform(p.random());
            let wi = Vec2::new(n.y * w.x - n.x * w.y, n.x * w.x + n.y * w.y);
            sum += p.cast_ray(wi) * n.dot(wi).max(0.0) / half_disk::pdf_uniform(w);
        }
        0.5 * p.albedo * sum / p.samples as f32
    });
    let first = transposed.matches()[0];
    assert_eq!(first.variant.name, "matrix transposed, cosine clamped");
    let twice = examine(|p: &mut Patient<Flat>| {
        let mut sum = 0.0;
        for _ in 0..p.samples {
            let w = half_disk::sample_uniform(p.random());
            sum += p.cast_ray(w) * w.y / half_disk::pdf_uniform(w);
        }
        0.5 * p.albedo * (p.shadow_rays() + sum / p.samples as f32)
    });
    assert_eq!(twice.matches()[0].variant.name, "light counted twice");
    let broken = examine(|_: &mut Patient<Flat>| f32::NAN);
    assert!(broken.matches().is_empty());
    assert!(!broken.explain().is_empty());
}
