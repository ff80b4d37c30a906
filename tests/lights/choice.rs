//! One light among many.

use super::{CRITICAL, scene};
use halfdisk::integrators::{Integrator, Kajiya, NextEvent, Whitted};
use halfdisk::lights::{Light, LightChoice, PointLight};
use halfdisk::render::{Options, render};
use halfdisk::sampling::discrete::Discrete;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::Scene;
use halfdisk::stats::Estimate;
use halfdisk::stats::chi_square::chi_square;

fn uniforms(seed: u64) -> impl FnMut() -> f32 {
    let mut numbers = Stream::new(seed, 0, 0).at(0, Purpose::LightPoint);
    move || numbers.one()
}

/// Many lights, of which every hundredth shines, each another power.
fn many() -> Vec<Light> {
    let intensity = |i: u32| match i % 100 {
        42 => 1.0 + (i / 100 % 7) as f32,
        _ => 0.0,
    };
    (0..100_000)
        .map(|i| {
            Light::Point(PointLight {
                position: glam::Vec3::Y,
                intensity: halfdisk::color::Rgb::grey(intensity(i)),
            })
        })
        .collect()
}

#[test]
fn a27_a_hundred_thousand_lights() {
    let lights = many();
    let choice = LightChoice::by_power(&lights, 1.0);
    let probabilities: Vec<f64> = (0..lights.len())
        .map(|i| f64::from(choice.probability(i)))
        .collect();
    let total: f64 = probabilities.iter().sum();
    assert!((total - 1.0).abs() < 1e-5, "{total}");

    const SAMPLES: u32 = 1_000_000;
    let mut u = uniforms(1);
    let mut counts = vec![0; lights.len()];
    for _ in 0..SAMPLES {
        let (light, probability) = choice.choose(u()).unwrap();
        assert!(probability > 0.0 && probability == choice.probability(light));
        counts[light] += 1;
    }
    let dark = (0..lights.len()).filter(|i| i % 100 != 42);
    assert!(
        dark.into_iter().all(|i| counts[i] == 0),
        "a dark light was chosen"
    );
    let judge = |weight: &dyn Fn(usize) -> f64| {
        let expected: Vec<f64> = (0..lights.len())
            .map(|i| weight(i) * f64::from(SAMPLES))
            .collect();
        chi_square(&counts, &expected)
    };
    let right = judge(&|i| probabilities[i]);
    println!("{right:?}");
    assert!(right.p > 1e-3, "{right:?}");
    // The mistake of a probability that knows nothing of power.
    let uniform = judge(&|i| if i % 100 == 42 { 1e-3 } else { 0.0 });
    assert!(uniform.p < 1e-9, "{uniform:?}");

    // Each light's share of the samples over its probability is one.
    let shares: Estimate = (42..lights.len())
        .step_by(100)
        .map(|i| counts[i] as f64 / f64::from(SAMPLES) / probabilities[i])
        .collect();
    assert!(shares.z(1.0).abs() < CRITICAL, "{shares:?}");

    // The ends of the uniforms.
    for u in [0.0, f32::MIN_POSITIVE, 1.0 - f32::EPSILON / 2.0] {
        let (light, _) = choice.choose(u).unwrap();
        assert_eq!(light % 100, 42);
    }
}

#[test]
fn a27_sums_in_f32_would_lose_the_faint() {
    // One bright light before many faint ones: in f32 adding them changes nothing.
    let weights = || std::iter::once(1e8).chain(std::iter::repeat_n(1.0, 100_000));
    let discrete = Discrete::new(weights()).unwrap();
    let faint = (1..=100_000)
        .map(|i| f64::from(discrete.probability(i)))
        .sum::<f64>();
    assert!((faint - 1e5 / (1e8 + 1e5)).abs() < 1e-7, "{faint}");
    let single: f32 = weights().map(|w| w as f32).sum();
    assert_eq!(single, 1e8, "the plain twin");
}

#[test]
fn a27_what_is_left_of_a_uniform_is_uniform_and_independent() {
    // Two items of equal weight, and the position on the chosen one: the mean of item · rest is
    // a quarter; with the uniform used twice it is three eighths.
    let discrete = Discrete::new([1.0, 0.0, 1.0]).unwrap();
    let mut u = uniforms(2);
    let (mut rest, mut again) = (Estimate::default(), Estimate::default());
    for _ in 0..100_000 {
        let u = u();
        let choice = discrete.sample(u);
        let item = f64::from(u8::from(choice.index == 2));
        rest.add(item * f64::from(choice.rest));
        again.add(item * f64::from(u));
    }
    assert!(rest.z(0.25).abs() < CRITICAL, "{rest:?}");
    assert!(again.z(0.25).abs() > CRITICAL && again.z(0.375).abs() < CRITICAL);
}

/// True where a picture of the scene is black in every sample.
fn black(scene: &Scene, integrator: impl Integrator) -> bool {
    let options = Options {
        spp: 2,
        ..Options::default()
    };
    let rendered = render(scene, &integrator, &options, &());
    let mean = rendered.film.mean();
    rendered.non_finite == 0 && mean == (0.0, 0.0)
}

#[test]
fn a27_nothing_to_choose_from() {
    assert!(LightChoice::by_power(&[], 1.0).choose(0.5).is_none());
    assert!(Discrete::new([]).is_none() && Discrete::new([0.0, 0.0]).is_none());
    assert_eq!(LightChoice::by_power(&[], 1.0).probability(0), 0.0);

    let dark = scene("[[objects]]\nmaterial = 'half'\nsphere = { center = [0, 0, 5], radius = 1 }");
    assert!(dark.light_choice.choose(0.0).is_none());
    let max_depth = 5;
    assert!(black(&dark, Whitted { max_depth }));
    assert!(black(&dark, Kajiya { max_depth }));
    assert!(black(&dark, NextEvent { max_depth }));
}

#[test]
fn power_counts_what_is_sent() {
    use std::f32::consts::PI;
    let all = scene(
        "[[lights]]\npoint = { position = [0, 1, 0], intensity = [1, 2, 3] }\n\
         [[lights]]\ndirectional = { direction = [0, -1, 0], irradiance = 5 }\n\
         [[objects]]\nemits = 3\nquad = { corner = [0, 0, 0], u = [2, 0, 0], v = [0, 0, 4] }\n\
         [[objects]]\nemits = 2\nsphere = { center = [1, 0, 2], radius = 0.5 }\n\
         [[objects]]\nemits = 1\nbox = { min = [0, 1, 0], max = [2, 1.5, 4] }",
    );
    let power: Vec<f32> = all.lights.iter().map(|l| l.power(2.0)).collect();
    let expected = [8.0 * PI, 20.0 * PI, 24.0 * PI, 2.0 * PI * PI];
    for (power, expected) in power.iter().zip(expected) {
        assert!((power / expected - 1.0).abs() < 1e-6, "{power} {expected}");
    }
    // A box is a light for each of its faces.
    assert_eq!(power.len(), 4 + 6);
    let faces: f32 = power[4..].iter().sum();
    assert!((faces / (22.0 * PI) - 1.0).abs() < 1e-6, "{faces}");
}
