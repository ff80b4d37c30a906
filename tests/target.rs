//! What accuracy costs: errors that can be trusted, and renders that end at one.

use crate::checks::CRITICAL;
use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Integrator, Path};
use halfdisk::render::accuracy::{Accuracy, Measure, brightness, true_error};
use halfdisk::render::stopping::{Goal, StoppedBy, pilot_seed, predict, render_to};
use halfdisk::render::{Film, Options, Pixel, Session, render};
use halfdisk::sampling::stream::{Purpose, Sampler, Stream};
use halfdisk::scene::gallery::load;
use halfdisk::scene::{Scene, Tracer};
use halfdisk::stats::Estimate;

const RMS: Measure = Measure::RootMeanSquare;

fn small(name: &str, size: [u32; 2]) -> Scene {
    load(name).expect("a scene of the gallery").sized(size)
}

fn options(spp: u32, seed: u64, sampler: Sampler) -> Options {
    Options {
        spp,
        seed,
        sampler,
        ..Options::default()
    }
}

/// How many standard errors the squared differences of two pictures, relative to the brightness
/// around, are above what both say of theirs, over all pixels.
fn excess(a: &Film, b: &Film, error: fn(&Pixel, usize) -> f64) -> f64 {
    let pixels = a.pixels().iter().zip(b.pixels());
    let brightness = brightness(&a.picture());
    let excess = |((a, b), l): ((&Pixel, &Pixel), f64)| {
        let of = |i: usize| {
            let difference = a.channels[i].mean() - b.channels[i].mean();
            difference.powi(2) - error(a, i).powi(2) - error(b, i).powi(2)
        };
        (of(0) + of(1) + of(2)) / (l * l)
    };
    pixels
        .zip(brightness)
        .map(excess)
        .collect::<Estimate>()
        .z(0.0)
}

#[test]
fn even_samples_know_their_error_and_their_scatter_does_not() {
    let honest = |p: &Pixel, i: usize| p.std_errors()[i];
    let as_if_independent = |p: &Pixel, i: usize| p.channels[i].std_error();
    for (name, spp) in [
        ("cornell", 32),
        ("six", 64),
        ("cornell", 64),
        ("cornell", 200),
    ] {
        let scene = small(name, [40, 40]);
        let film =
            |seed, sampler| render(&scene, &Path::new(6), &options(spp, seed, sampler), &()).film;
        let [a, b] = [1, 2].map(|seed| film(seed, Sampler::Sobol));
        let z = excess(&a, &b, honest);
        assert!(z.abs() <= CRITICAL, "{name} {spp}: {z}");
        let z = excess(&a, &b, as_if_independent);
        assert!(z < -CRITICAL, "{name} {spp}: {z}");
        let [a, b] = [1, 2].map(|seed| film(seed, Sampler::Independent));
        let z = excess(&a, &b, honest);
        assert!(z.abs() <= CRITICAL, "{name} {spp}, independent: {z}");
    }
}

#[test]
fn the_error_bar_of_the_mean_is_that_of_many_renders() {
    let scene = small("cornell", [12, 12]);
    for (sampler, spp) in [(Sampler::Sobol, 64), (Sampler::Independent, 24)] {
        let (mut means, mut stated) = (Estimate::new(), Estimate::new());
        for seed in 0..300 {
            let film = render(&scene, &Path::new(5), &options(spp, seed, sampler), &()).film;
            let (mean, error) = film.mean();
            means.add(mean);
            stated.add(error * error);
        }
        // A variance from n values of a normal law has the relative error √(2 / (n - 1)). Channels
        // count as fully correlated, which overstates by a little.
        let ratio = means.variance() / stated.mean();
        let error = (2.0_f64 / 299.0).sqrt();
        assert!(ratio < 1.0 + CRITICAL * error, "{sampler:?}: {ratio}");
        assert!(
            ratio > 0.85 * (1.0 - CRITICAL * error),
            "{sampler:?}: {ratio}"
        );
    }
}

#[test]
fn a_film_is_the_same_wherever_it_paused() {
    let scene = small("spheres", [10, 8]);
    for sampler in [Sampler::Sobol, Sampler::Independent] {
        let options = options(300, 5, sampler);
        let integrator = Path::new(6);
        let mut session = Session::new(&scene, &integrator, &options);
        for spp in [3, 16, 20, 45, 64, 100, 130, 300] {
            session.advance(spp, &());
            let whole = render(&scene, &integrator, &Options { spp, ..options }, &());
            assert_eq!(session.film(), whole.film, "{sampler:?} {spp}");
        }
        assert_eq!(session.spp(), 300);
        let runs = session.film().pixels()[0].runs[0].count();
        assert_eq!(runs, if sampler == Sampler::Sobol { 4 } else { 0 });
    }
}

#[test]
fn a_constant_has_no_error() {
    let mut pixel = Pixel::default();
    for n in 1..=192_u32 {
        pixel.add(Rgb::grey(0.1));
        if [16, 32, 64, 128, 192].contains(&n) {
            pixel.end_run(n.is_power_of_two());
        }
    }
    assert_eq!(pixel.runs[0].count(), 3);
    assert_eq!(pixel.std_errors(), [0.0; 3]);
}

#[test]
fn the_error_is_that_against_a_reference() {
    for (name, spp) in [("cornell", 64), ("six", 128), ("lens", 192)] {
        let scene = small(name, [32, 32]);
        let film = |spp, seed| {
            render(
                &scene,
                &Path::new(6),
                &options(spp, seed, Sampler::Sobol),
                &(),
            )
            .film
        };
        let reference = film(40 * spp, 99);
        let (mut own, mut found) = (Estimate::new(), Estimate::new());
        for seed in 0..4 {
            let film = film(spp, seed);
            own.add(Accuracy::of(&film).error(RMS).powi(2));
            found.add(true_error(&film.picture(), &reference.picture(), RMS).powi(2));
        }
        let ratio = (own.mean() / (found.mean() * 40.0 / 41.0)).sqrt();
        assert!((ratio - 1.0).abs() < 0.1, "{name}: {ratio}");
    }
}

#[test]
fn errors_are_relative_to_the_brightness_around() {
    // Grey with two samples each, one of which is off by a share of it.
    let film = |scale: f32, firefly: f32| {
        let mut pixels = vec![Pixel::default(); 40 * 30];
        for (i, pixel) in pixels.iter_mut().enumerate() {
            let high = if i == 620 { firefly } else { 1.1 };
            pixel.add(Rgb::grey(scale * high));
            pixel.add(Rgb::grey(scale * 0.9));
        }
        Film::new(40, pixels)
    };
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-6 * b, "{a} {b}");
    let plain = Accuracy::of(&film(1.0, 1.1));
    near(plain.error(RMS), 0.1);
    near(plain.error(Measure::Quantile(0.95)), 0.1);
    near(plain.required(0.02)[7], 50.0);
    near(plain.variances()[7], 0.02);
    near(plain.top_share(), 2.0 / 1200.0);
    assert_eq!(plain.share_within(0.0999), 0.0);
    assert_eq!(plain.share_within(0.1001), 1.0);
    near(Accuracy::of(&film(1024.0, 1.1)).error(RMS), 0.1);

    // A firefly counts against its surroundings, not against itself: 299 / (1 + its share of 81).
    let hit = film(1.0, 600.0);
    let around = brightness(&hit.picture());
    let accuracy = Accuracy::of(&hit);
    let expected = (300.0 - 0.45) / (1.0 + (300.45 - 1.0) / 81.0);
    let found = (accuracy.required(1.0)[620] / 2.0).sqrt();
    assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
    let itself = hit.pixels()[620].std_errors()[0] / hit.pixels()[620].channels[0].mean();
    assert!(itself < 1.0 && accuracy.top_share() > 0.99 && around[620] > 4.0);
}

/// Rare and bright: 1/P with chance P.
struct Rare;
const P: f32 = 0.02;

impl Integrator for Rare {
    fn li(&self, _: &mut Tracer, _: &Ray, stream: &Stream) -> Rgb {
        let hit = stream.at(0, Purpose::Integrand).one() < P;
        Rgb::grey(if hit { 1.0 / P } else { 0.0 })
    }
}

/// The mean of a picture that stops as soon as its own error looks small.
fn stopped_by_itself(scene: &Scene, seed: u64, target: f64) -> f64 {
    let most = options(1 << 16, seed, Sampler::Independent);
    let mut session = Session::new(scene, &Rare, &most);
    loop {
        session.advance(session.spp() + 16, &());
        let film = session.film();
        let error = Accuracy::of(&film).error(RMS);
        if session.spp() >= 32 && error <= target {
            return film.mean().0;
        }
    }
}

#[test]
fn a_pilot_stops_without_bias_and_a_rule_on_its_own_samples_does_not() {
    let scene = small("lamp", [3, 3]);
    let goal = Goal {
        error: Some(0.5),
        ..Goal::default()
    };
    let [mut pilot, mut extended, mut own] = [Estimate::new(); 3];
    for seed in 0..1500 {
        let options = options(1, seed, Sampler::Independent);
        let said = predict(&scene, &Rare, &options, &goal, &()).expect("nobody interrupts");
        let spp = said.spp;
        pilot.add(
            render(&scene, &Rare, &Options { spp, ..options }, &())
                .film
                .mean()
                .0,
        );
        let outcome = render_to(&scene, &Rare, &options, &goal, &());
        extended.add(outcome.rendered.film.mean().0);
        own.add(stopped_by_itself(&scene, seed, 0.5));
    }
    // The chance is a multiple of 2^-24.
    let z = pilot.z(1.0);
    println!(
        "the smallest bias seen: {:.4}",
        CRITICAL * pilot.std_error()
    );
    assert!(z.abs() <= CRITICAL, "{z}: {}", pilot.mean());
    let z = own.z(1.0);
    assert!(z > CRITICAL, "{z}: {}", own.mean());
    let [bias, bias_of_own] = [&extended, &own].map(|e| e.mean() - 1.0);
    println!(
        "bias: {bias:.4} ± {:.4}, of a rule on its own samples {bias_of_own:.4}",
        extended.std_error()
    );
    // Both are of the order of the squared error of the mean, a ninth of a pixel's.
    assert!(bias.abs() < 1.5 * 0.5 * 0.5 / 9.0, "{bias} {bias_of_own}");
}

#[test]
fn a_target_is_met_and_its_samples_are_told_before() {
    let scene = small("cornell", [48, 48]);
    let path = Path::new(6);
    for (error, sampler) in [
        (0.06, Sampler::Sobol),
        (0.03, Sampler::Sobol),
        (0.05, Sampler::Independent),
    ] {
        let goal = Goal {
            error: Some(error),
            ..Goal::default()
        };
        let outcome = render_to(&scene, &path, &options(1, 4, sampler), &goal, &());
        assert_eq!(outcome.stopped_by, StoppedBy::Error);
        let said = outcome.prediction.expect("nobody interrupts");
        assert!((said.error / error - 1.0).abs() < 0.1, "{said:?}");
        let reached = outcome.reached.error / error;
        assert!(
            (reached - 1.0).abs() < 0.12,
            "{sampler:?} {error}: {reached}"
        );
        if outcome.extensions == 0 {
            assert_eq!(outcome.spp, said.spp);
        }
        let again = predict(&scene, &path, &options(1, 4, sampler), &goal, &());
        let again = again.expect("nobody interrupts");
        assert_eq!(
            (again.spp, again.error),
            (said.spp, said.error),
            "no clock in it"
        );
        // The same picture by its number of samples; the pilot's samples are not in it.
        let same = render(&scene, &path, &options(outcome.spp, 4, sampler), &());
        assert_eq!(same.film, outcome.rendered.film);
        assert_ne!(pilot_seed(4), 4);
    }
}

#[test]
fn most_pixels_can_be_the_goal() {
    let scene = small("six", [32, 24]);
    let goal = Goal {
        error: Some(0.03),
        measure: Measure::Quantile(0.9),
        ..Goal::default()
    };
    let outcome = render_to(
        &scene,
        &Path::new(4),
        &options(1, 4, Sampler::Sobol),
        &goal,
        &(),
    );
    assert_eq!(outcome.stopped_by, StoppedBy::Error);
    let accuracy = Accuracy::of(&outcome.rendered.film);
    let share = accuracy.share_within(1.05 * 0.03);
    assert!((0.87..0.97).contains(&share), "{share}");
    let rms = Goal {
        measure: RMS,
        ..goal
    };
    let fewer = render_to(
        &scene,
        &Path::new(4),
        &options(1, 4, Sampler::Sobol),
        &rms,
        &(),
    );
    assert!(fewer.spp < outcome.spp, "{} {}", fewer.spp, outcome.spp);
}
