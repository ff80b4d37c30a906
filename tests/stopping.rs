//! Renders that end by the clock, and renders in which there is nothing to see: they end, without bias,
//! and say what is not known.

use crate::checks::CRITICAL;
use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Integrator, Kajiya, Passes, Path};
use halfdisk::render::stopping::{Goal, StoppedBy, render_to};
use halfdisk::render::{Film, Options, Progress, Session, render};
use halfdisk::sampling::stream::{Purpose, Sampler, Stream};
use halfdisk::scene::description::Material;
use halfdisk::scene::gallery::{load, load_with};
use halfdisk::scene::value::Albedo;
use halfdisk::scene::{Scene, Tracer};
use halfdisk::stats::Estimate;
use halfdisk::time::Moment;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

pub fn small(name: &str, size: [u32; 2]) -> Scene {
    load(name).expect("a scene of the gallery").sized(size)
}

pub fn options(seed: u64, sampler: Sampler) -> Options {
    Options {
        seed,
        sampler,
        ..Options::default()
    }
}

/// A clock that shows the work done, and nothing else.
#[derive(Default)]
pub struct Work(AtomicU64);

impl Work {
    fn add(&self, work: u64) {
        self.0.fetch_add(work, Ordering::Relaxed);
    }
}

impl Progress for Work {
    fn tell(&self, _: u64, _: u64) {}
    fn stop(&self) -> bool {
        false
    }
    fn elapsed(&self, _: Moment) -> Duration {
        Duration::from_millis(self.0.load(Ordering::Relaxed))
    }
}

/// Rare, bright and slow: 1/P with chance P, which takes forty times the work of nothing.
struct RareAndSlow<'a>(&'a Work);
const P: f32 = 0.125;
const SLOW: u64 = 40;

impl Integrator for RareAndSlow<'_> {
    fn li(&self, _: &mut Tracer, _: &Ray, stream: &Stream) -> Rgb {
        let hit = stream.at(0, Purpose::Integrand).one() < P;
        self.0.add(if hit { SLOW } else { 1 });
        Rgb::grey(if hit { 1.0 / P } else { 0.0 })
    }
}

/// An integrator whose work is its rays.
pub struct Counted<'a, I>(pub I, pub &'a Work);

impl<I: Integrator> Integrator for Counted<'_, I> {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let before = tracer.counts().total();
        let li = self.0.li(tracer, ray, stream);
        self.1.add(tracer.counts().total() - before);
        li
    }

    fn passes(&self, scene: &Scene) -> Option<&dyn Passes> {
        self.0.passes(scene)
    }
}

pub fn for_time(work: u64) -> Goal {
    Goal {
        time: Some(Duration::from_millis(work)),
        ..Goal::default()
    }
}

/// The mean of a picture that ends with `time`, and its samples.
fn in_time(scene: &Scene, seed: u64, sampler: Sampler, time: u64) -> (f64, u32) {
    let work = Work::default();
    let of = RareAndSlow(&work);
    let outcome = render_to(scene, &of, &options(seed, sampler), &for_time(time), &work);
    (outcome.rendered.film.mean().0, outcome.spp)
}

/// The same by a rule that keeps the pass that the clock cuts off, as it would be when finished.
fn with_the_last_pass(scene: &Scene, seed: u64, sampler: Sampler, time: u64) -> f64 {
    let work = Work::default();
    let of = RareAndSlow(&work);
    let mut session = Session::new(scene, &of, &options(seed, sampler));
    while work.0.load(Ordering::Relaxed) < time {
        session.advance(session.spp() + 1, &work);
    }
    session.film().mean().0
}

#[test]
fn the_clock_ends_a_render_without_bias_though_bright_samples_are_slow() {
    let mut least = f64::INFINITY;
    for (size, time) in [([1, 1], 60), ([2, 2], 200), ([3, 2], 900), ([2, 2], 10)] {
        let scene = small("lamp", size);
        let [mut ours, mut kept] = [Estimate::new(); 2];
        let mut spp = Estimate::new();
        for seed in 0..12_000 {
            let (mean, n) = in_time(&scene, seed, Sampler::Independent, time);
            ours.add(mean);
            spp.add(n.into());
            kept.add(with_the_last_pass(&scene, seed, Sampler::Independent, time));
        }
        let bias = |e: &Estimate| format!("{:+.4} ± {:.4}", e.mean() - 1.0, e.std_error());
        println!(
            "{size:?}, {time}: {:.1} samples, bias {}, with the last pass {}; the smallest bias seen is {:.3}",
            spp.mean(),
            bias(&ours),
            bias(&kept),
            CRITICAL * ours.std_error()
        );
        let z = ours.z(1.0);
        assert!(z.abs() <= CRITICAL, "{size:?}, {time}: {z}");
        if spp.mean() > 1.5 {
            let z = kept.z(1.0);
            assert!(z > CRITICAL, "the rule that is biased is seen to be: {z}");
        }
        least = least.min(CRITICAL * ours.std_error());
    }
    assert!(least < 0.05, "{least}");
}

#[test]
fn samples_that_lie_evenly_are_not_biased_by_the_clock_either() {
    // They end with 8, 16 and 64. To end after any number was 9 % too dark with 9 samples: where they lie
    // evenly, the clock knows when the next slow one comes.
    let scene = small("lamp", [2, 2]);
    for time in [200, 700, 2000] {
        let mut ours = Estimate::new();
        for seed in 0..12_000 {
            ours.add(in_time(&scene, seed, Sampler::Sobol, time).0);
        }
        println!(
            "{time}: bias {:+.5} ± {:.5}; the smallest seen is {:.4}",
            ours.mean() - 1.0,
            ours.std_error(),
            CRITICAL * ours.std_error()
        );
        let z = ours.z(1.0);
        assert!(z.abs() <= CRITICAL, "{time}: {z}");
    }
}

#[test]
fn a_picture_that_the_clock_ended_is_that_of_its_samples() {
    let scene = small("spheres", [20, 16]);
    for (sampler, time) in [(Sampler::Sobol, 60_000), (Sampler::Independent, 1)] {
        let work = Work::default();
        let path = Counted(Path::new(6), &work);
        let outcome = render_to(&scene, &path, &options(5, sampler), &for_time(time), &work);
        let spp = outcome.spp;
        assert_eq!(spp == 1, time == 1, "each pixel has a sample: {spp}");
        let whole = Options {
            spp,
            ..options(5, sampler)
        };
        let same = render(&scene, &Path::new(6), &whole, &());
        assert_eq!(same.film, outcome.rendered.film);
        assert_eq!(same.rays, outcome.rendered.rays);
        assert_eq!(outcome.seed, 5);
        if time > 1 {
            let said = outcome.prediction.expect("there was time to tell");
            let off = f64::from(said.spp) / f64::from(spp);
            assert!(
                (off - 1.0).abs() < 1.5,
                "a rate of the first tenth: {said:?} {spp}"
            );
        }
    }
}

#[test]
fn with_an_error_and_a_time_the_first_of_both_ends_the_render() {
    let scene = small("cornell", [12, 12]);
    let run = |error: f64, time: u64| {
        let work = Work::default();
        let path = Counted(Path::new(5), &work);
        let goal = Goal {
            error: Some(error),
            ..for_time(time)
        };
        let outcome = render_to(&scene, &path, &options(3, Sampler::Sobol), &goal, &work);
        (outcome, work.0.into_inner())
    };
    let (rich, work) = run(0.3, 100_000_000);
    assert_eq!(rich.stopped_by, StoppedBy::Error);
    // Too little for a pilot of 32 samples, then enough for one, but not for the error.
    for time in [20_000, 2_000_000] {
        let (poor, work) = run(0.0001, time);
        assert_eq!(poor.stopped_by, StoppedBy::Time);
        assert!(work < time + time / 8 + 20_000, "{work} of {time}");
        assert!(poor.spp >= 1 && poor.seed == 3);
        let pilot = poor.prediction.is_some_and(|said| said.separate);
        assert_eq!(pilot, time > 1_000_000);
    }
    assert!(work < 100_000_000);
}

/// The same light in all samples of a pixel.
struct Constant(f32);

impl Integrator for Constant {
    fn li(&self, _: &mut Tracer, _: &Ray, _: &Stream) -> Rgb {
        Rgb::grey(self.0)
    }
}

/// Light in one of a hundred million samples.
struct Needle;

impl Integrator for Needle {
    fn li(&self, _: &mut Tracer, _: &Ray, stream: &Stream) -> Rgb {
        let u = stream.at(0, Purpose::Integrand).two();
        let hit = u.iter().all(|&u| u < 1e-4);
        Rgb::grey(if hit { 1e8 } else { 0.0 })
    }
}

/// No number at all, but for the first sample.
struct Broken;

impl Integrator for Broken {
    fn li(&self, _: &mut Tracer, _: &Ray, stream: &Stream) -> Rgb {
        let hit = stream.at(0, Purpose::Integrand).one() < 0.03;
        Rgb::grey(if hit { 1.0 } else { f32::NAN })
    }
}

#[test]
fn where_no_noise_is_seen_the_render_ends_and_claims_nothing() {
    let scene = small("lamp", [6, 4]);
    let lamps: [&dyn Integrator; 4] = [&Constant(1.0), &Constant(0.0), &Needle, &Broken];
    for (i, integrator) in lamps.into_iter().enumerate() {
        for sampler in [Sampler::Independent, Sampler::Sobol] {
            for error in [1e-9, 0.02, 1.0] {
                for time in [None, Some(Duration::from_secs(60))] {
                    let goal = Goal {
                        error: Some(error),
                        time,
                        ..Goal::default()
                    };
                    let start = Instant::now();
                    let outcome = render_to(&scene, integrator, &options(1, sampler), &goal, &());
                    assert!(start.elapsed() < Duration::from_secs(20), "{i} {error}");
                    if i < 3 {
                        assert_eq!(outcome.stopped_by, StoppedBy::NoNoise, "{i} {sampler:?}");
                        assert!(outcome.spp >= 32, "{i}: {}", outcome.spp);
                    }
                    let error = outcome.reached.error;
                    assert!(error.is_infinite() || i == 3, "{i}: {error} is no error");
                }
            }
        }
    }
}

/// What every platform without a clock says of the time gone.
struct NoClock;

impl Progress for NoClock {
    fn tell(&self, _: u64, _: u64) {}
    fn stop(&self) -> bool {
        false
    }
    fn elapsed(&self, _: Moment) -> Duration {
        Duration::MAX
    }
}

#[test]
fn without_a_clock_time_is_up_after_one_sample() {
    let scene = small("cornell", [8, 8]);
    let time = Some(Duration::from_secs(3600));
    for error in [None, Some(0.01)] {
        for sampler in [Sampler::Independent, Sampler::Sobol] {
            let goal = Goal {
                error,
                time,
                ..Goal::default()
            };
            let outcome = render_to(&scene, &Path::new(5), &options(1, sampler), &goal, &NoClock);
            assert_eq!((outcome.stopped_by, outcome.spp), (StoppedBy::Time, 1));
        }
    }
}

#[test]
fn an_error_below_the_rounding_of_samples_is_not_claimed() {
    // Ten times the light of a furnace of albedo 0.9, whose samples differ by their last bits alone.
    for (depth, albedo) in [(512, 0.9), (512, 0.5), (64, 0.9), (1000, 0.98)] {
        let scene = load_with("furnace", |said| {
            said.film.size = [4, 4];
            for material in said.materials.values_mut() {
                *material = Material::Lambert {
                    albedo: Albedo([albedo; 3]).into(),
                };
            }
        })
        .expect("a scene of the gallery");
        let kajiya = Kajiya { max_depth: depth };
        for sampler in [Sampler::Independent, Sampler::Sobol] {
            let options = Options {
                spp: 64,
                ..options(1, sampler)
            };
            let rendered = render(&scene, &kajiya, &options, &());
            let (mean, error) = rendered.mean();
            let exact = (1.0 - libm::pow(albedo, depth.into())) / (1.0 - albedo);
            println!("{albedo} {depth} {sampler:?}: {mean} ± {error:.1e}, exact {exact}");
            assert!(error >= 5e-8 * mean, "{error} of {mean}");
            assert!(
                (mean - exact).abs() <= CRITICAL * error,
                "{mean} ± {error}, not {exact}"
            );
        }
    }
}

/// Never asked to stop, or from a certain question on.
struct StopAfter(AtomicU64);

impl Progress for StopAfter {
    fn tell(&self, _: u64, _: u64) {}
    fn stop(&self) -> bool {
        self.0.fetch_sub(1, Ordering::Relaxed) < 2
    }
}

#[test]
fn whoever_stops_a_pilot_or_a_step_is_heard() {
    let scene = small("cornell", [40, 40]);
    for (asked, time) in [
        (1, None),
        (60, None),
        (900, None),
        (1, Some(60)),
        (300, Some(60)),
    ] {
        for error in [None, Some(1e-7)] {
            let goal = Goal {
                error: error.filter(|_| time.is_none() || asked > 1),
                time: time.map(Duration::from_secs),
                ..Goal::default()
            };
            if goal.error.is_none() && goal.time.is_none() {
                continue;
            }
            let stop = StopAfter(AtomicU64::new(asked));
            let outcome = render_to(
                &scene,
                &Path::new(5),
                &options(1, Sampler::Sobol),
                &goal,
                &stop,
            );
            assert_eq!(outcome.stopped_by, StoppedBy::Interrupt);
            assert!(outcome.rendered.interrupted);
        }
    }
}

#[test]
fn a_film_knows_no_error_of_a_single_sample() {
    let scene = small("lamp", [4, 4]);
    let one = Options {
        spp: 1,
        ..Options::default()
    };
    let outcome = render_to(&scene, &Path::new(4), &one, &Goal::default(), &());
    assert!(outcome.reached.error.is_infinite());
    let film: &Film = &outcome.rendered.film;
    assert!(film.mean().1.is_infinite());
}
