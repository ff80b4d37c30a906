//! One light among many.

use super::scene;
use crate::checks::CRITICAL;
use halfdisk::integrators::{Integrator, Kajiya, NextEvent, Whitted};
use halfdisk::lights::{Light, LightChoice, PointLight};
use halfdisk::render::{Options, render};
use halfdisk::sampling::discrete::Discrete;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::Scene;
use halfdisk::stats::Estimate;
use halfdisk::stats::chi_square::chi_square;

use glam::Vec3;

fn uniforms(seed: u64) -> impl FnMut() -> f64 {
    let mut numbers = Stream::new(seed, 0, 0).at(0, Purpose::LightPoint);
    move || numbers.fine()
}

/// The choice among lights that stand still.
fn choice_of(lights: &[Light]) -> LightChoice {
    LightChoice::new(lights, |_| Vec3::ZERO)
}

const HERE: Vec3 = Vec3::ZERO;

/// Many lights, of which every hundredth shines, each another power.
fn many() -> Vec<Light> {
    let intensity = |i: u32| match i % 100 {
        42 => 1.0 + (i / 100 % 7) as f32,
        _ => 0.0,
    };
    (0..100_000)
        .map(|i| {
            Light::Point(PointLight {
                position: Vec3::Y,
                intensity: halfdisk::color::Rgb::grey(intensity(i)),
            })
        })
        .collect()
}

#[test]
fn a27_a_hundred_thousand_lights() {
    let lights = many();
    let choice = choice_of(&lights);
    let probabilities: Vec<f64> = (0..lights.len())
        .map(|i| f64::from(choice.probability(HERE, i)))
        .collect();
    let total: f64 = probabilities.iter().sum();
    assert!((total - 1.0).abs() < 1e-5, "{total}");

    const SAMPLES: u32 = 1_000_000;
    let mut u = uniforms(1);
    let mut counts = vec![0; lights.len()];
    for _ in 0..SAMPLES {
        let chosen = choice.choose(HERE, u()).unwrap();
        let again = choice.probability(HERE, chosen.index);
        assert!(chosen.probability > 0.0 && chosen.probability == again);
        counts[chosen.index] += 1;
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
    for u in [0.0, f64::MIN_POSITIVE, 1.0 - f64::EPSILON / 2.0] {
        assert_eq!(choice.choose(HERE, u).unwrap().index % 100, 42);
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
        rest.add(item * choice.rest);
        again.add(item * u);
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
    assert!(choice_of(&[]).choose(HERE, 0.5).is_none());
    assert!(Discrete::new([]).is_none() && Discrete::new([0.0, 0.0]).is_none());
    assert_eq!(choice_of(&[]).probability(HERE, 0), 0.0);

    let dark = scene("[[objects]]\nmaterial = 'half'\nsphere = { center = [0, 0, 5], radius = 1 }");
    assert!(dark.light_choice.choose(HERE, 0.0).is_none());
    let max_depth = 5;
    assert!(black(&dark, Whitted { max_depth }));
    assert!(black(&dark, Kajiya { max_depth }));
    assert!(black(&dark, NextEvent { max_depth }));
}
