//! Closed forms, scene by scene, for every integrator that claims to be unbiased.
//!
//! |z| ≤ 4.4 passes (one right estimate in 92 000 does not), where a bias of the given share would
//! have been noticed.

use crate::checks::CRITICAL;
use glam::{Vec2, Vec3};
use halfdisk::color::Rgb;
use halfdisk::flatland;
use halfdisk::geometry::Ray;
use halfdisk::integrators::world::FlatTracer;
use halfdisk::integrators::{
    Combine, Integrator, Kajiya, NextEvent, Path, Roulette, Shares, Survival,
};
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::stream::{Sampler, Stream};
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, Tracer, gallery};
use halfdisk::space;
use halfdisk::stats::Estimate;
use halfdisk::stats::z_test::z_test;
use rayon::prelude::*;
use std::f64::consts::PI;

/// A scene, a ray, and the radiance along it.
struct Row {
    name: &'static str,
    scene: Scene,
    ray: Ray,
    /// The longest path in segments.
    max_depth: u32,
    /// The answer with that depth cut.
    truth: f64,
    /// The answer of paths of any length, where there is one in closed form.
    uncut: Option<f64>,
    /// The share of the truth by which walks that aim at lamps may be off unnoticed.
    aiming: f64,
    /// The same for walks that meet lamps by chance; none where they hardly ever would.
    chance: Option<f64>,
}

fn scene(objects: &str) -> Scene {
    let head = "name = 'test'\ncamera = { from = [0, 0, 0], to = [0, 0, 1], fov = 40 }\n\
                materials.half.lambert.albedo = 0.5\nmaterials.most.lambert.albedo = 0.8\n\
                materials.silver.mirror.reflectance = 0.9\nmaterials.glass.glass.ior = 1.5\n\
                materials.mixed.mixture = { kd = 0.3, ks = 0.2, kt = 0.1 }\n";
    let text = head.to_owned() + objects;
    let source = Source {
        file: "test.toml",
        text: &text,
    };
    gallery::from_text(source, None, |_| {}).unwrap()
}

fn toward(from: Vec3, to: Vec3) -> Ray {
    Ray::new(from, (to - from).normalize())
}

/// Inside a sphere that emits 1/2 and reflects half: 1/2 (1 + 1/2 + 1/4 + …).
fn emitting_sphere(max_depth: u32) -> Row {
    let room = "[[objects]]\nmaterial = 'half'\nemits = 0.5\n\
                sphere = { center = [0.2, -0.1, 0.3], radius = 1.5, inward = true }";
    Row {
        name: "inside an emitting sphere",
        scene: scene(room),
        ray: toward(Vec3::ZERO, Vec3::new(0.3, 0.2, 1.0)),
        max_depth,
        truth: 1.0 - f64::powi(0.5, max_depth as i32),
        uncut: Some(1.0),
        aiming: 0.01,
        chance: Some(0.01),
    }
}

/// A sphere of albedo 4/5 around a small ball that emits 1 and reflects half: what leaves either by
/// one segment more.
fn integrating_sphere() -> Row {
    let room = "[[objects]]\nmaterial = 'most'\nsphere = { center = [-0.5, 0, 0], radius = 1 }\n\
                [[objects]]\nmaterial = 'half'\nemits = 1\n\
                sphere = { center = [-0.5, 0, 0], radius = 0.3 }";
    let share = 0.09;
    let step = |(wall, lamp): (f64, f64)| {
        let wall_next = 0.8 * (share * lamp + (1.0 - share) * wall);
        (wall_next, 1.0 + 0.5 * wall)
    };
    let after = |n| (1..=n).fold((0.0, 0.0), |b, _| step(b)).0;
    Row {
        name: "an integrating sphere",
        scene: scene(room),
        ray: toward(Vec3::ZERO, Vec3::new(0.6, 0.0, 0.8)),
        max_depth: 8,
        truth: after(8),
        uncut: Some(after(1000)),
        aiming: 0.02,
        chance: Some(0.05),
    }
}

/// A floor of albedo 1/2, seen from the side, and something above the middle of it.
fn floor(lamp: &str) -> Scene {
    scene(&format!(
        "[[objects]]\nmaterial = 'half'\n\
         quad = {{ corner = [-9, -1, 9], u = [18, 0, 0], v = [0, 0, -18] }}\n[[objects]]\n{lamp}"
    ))
}

fn floor_row(name: &'static str, lamp: &str, irradiance: f64, chance: Option<f64>) -> Row {
    let truth = 0.5 / PI * irradiance;
    Row {
        name,
        scene: floor(lamp),
        ray: toward(Vec3::new(-0.9, -0.9996, 0.0), Vec3::new(0.0, -1.0, 0.0)),
        max_depth: 2,
        truth,
        uncut: Some(truth),
        aiming: 0.02,
        chance,
    }
}

/// The unit square at height `h`, centred.
fn square(h: f64, chance: Option<f64>) -> Row {
    let lamp = format!(
        "emits = 3\nquad = {{ corner = [-0.5, {}, -0.5], u = [1, 0, 0], v = [0, 0, 1] }}",
        h - 1.0
    );
    // The corner formula, four times around the middle.
    let x = 0.5 / h;
    let r = (1.0 + x * x).sqrt();
    floor_row(
        "a square lamp",
        &lamp,
        12.0 * x / r * libm::atan(x / r),
        chance,
    )
}

/// A ball of radius r at the distance 1 above.
fn ball(r: f64, chance: Option<f64>) -> Row {
    let lamp = format!(
        "emits = {}\nsphere = {{ center = [0, 0, 0], radius = {r} }}",
        1.0 / (r * r)
    );
    floor_row("a ball lamp", &lamp, PI, chance)
}

/// Lambert's polygon formula for a triangle above the horizon.
fn triangle() -> Row {
    let lamp =
        "emits = 1\ntriangle = { a = [-0.5, 0, -0.5], b = [0.5, 0, -0.5], c = [0, 0.5, 0.5] }";
    floor_row("a triangular lamp", lamp, 0.334_977_138, Some(0.06))
}

/// Nothing to aim at: the light of the sky, for all of it found by chance.
fn constant_sky() -> Row {
    let truth = 0.5;
    let scene = scene(
        "background = 1\n[[objects]]\nmaterial = 'half'\n\
         quad = { corner = [-9, -1, 9], u = [18, 0, 0], v = [0, 0, -18] }",
    );
    Row {
        name: "a floor under a constant sky",
        scene,
        ray: toward(Vec3::ZERO, Vec3::new(0.3, -1.0, 0.1)),
        max_depth: 2,
        truth,
        uncut: Some(truth),
        aiming: 1e-4,
        chance: Some(0.02),
    }
}

/// A ball and its image in a plane mirror, which is as far behind the mirror: both light the floor.
fn mirrored() -> Row {
    let lamp = "emits = 100\nsphere = { center = [0, 0, 0], radius = 0.1 }\n\
                [[objects]]\nmaterial = 'silver'\n\
                quad = { corner = [1, -1, -9], u = [0, 0, 18], v = [0, 10, 0] }";
    let image = 0.9 / (5.0 * f64::sqrt(5.0));
    Row {
        name: "a lamp and its image in a mirror",
        max_depth: 3,
        uncut: None,
        aiming: 0.2,
        ..floor_row("", lamp, PI * (1.0 + image), None)
    }
}

/// White light through a slab of glass at a right angle: 12/13 of it, bounce by bounce.
fn slab() -> Row {
    let scene = gallery::load("slab").unwrap();
    let truth = 12.0 / 13.0;
    Row {
        name: "through a slab of glass",
        ray: scene.camera.ray(0.5, 0.5),
        scene,
        max_depth: 32,
        truth,
        uncut: Some(truth),
        aiming: 0.01,
        chance: Some(0.01),
    }
}

fn rows() -> Vec<Row> {
    vec![
        emitting_sphere(2),
        emitting_sphere(12),
        integrating_sphere(),
        square(1.0, Some(0.05)),
        square(0.1, Some(0.02)),
        square(0.01, Some(0.02)),
        // From so close everybody meets the lamp: chance has no variance left to test with.
        square(0.001, None),
        ball(0.5, Some(0.05)),
        ball(1e-2, None),
        ball(1e-4, None),
        ball(1e-6, None),
        triangle(),
        constant_sky(),
        mirrored(),
        slab(),
    ]
}

fn radiance(integrator: &dyn Fn(&mut Tracer, &Ray, &Stream) -> Rgb, row: &Row) -> Estimate {
    const WALKS: u32 = 200_000;
    let mut tracer = Tracer::new(&row.scene);
    let one = |i| f64::from(integrator(&mut tracer, &row.ray, &Stream::new(1, i, 0)).r);
    (0..WALKS).map(one).collect()
}

#[test]
fn every_integrator_meets_every_closed_form() {
    let failures: Vec<String> = rows().par_iter().flat_map(check).collect();
    assert!(failures.is_empty(), "{failures:#?}");
}

/// An integrator by name, its answer, and the share of it that may go unnoticed.
type Entry<'a> = (&'a str, &'a dyn Integrator, Option<f64>, Option<f64>);

fn check(row: &Row) -> Vec<String> {
    let max_depth = row.max_depth;
    let combine = |heuristic| Combine {
        max_depth,
        heuristic,
    };
    let (balance, power) = (combine(Heuristic::Balance), combine(Heuristic::Power));
    let path = Path {
        roulette_from: 2,
        ..Path::from_eye(max_depth)
    };
    let survival = Survival::Throughput(0.5);
    let cut = Some(row.truth);
    let aiming = Some(row.aiming);
    let all: [Entry; 6] = [
        ("kajiya", &Kajiya { max_depth }, cut, row.chance),
        ("roulette", &Roulette { survival }, row.uncut, row.chance),
        ("next-event", &NextEvent { max_depth }, cut, aiming),
        ("balance", &balance, cut, aiming),
        ("power", &power, cut, aiming),
        ("path", &path, cut, aiming),
    ];
    let mut failures = Vec::new();
    for (name, integrator, truth, unnoticed) in all {
        let (Some(truth), Some(unnoticed)) = (truth, unnoticed) else {
            continue;
        };
        let estimate = radiance(&|t, r, s| integrator.li(t, r, s), row);
        let test = z_test(&estimate, truth, CRITICAL);
        let line = format!(
            "{} ({truth:.6}), {name}: {:.6}, {test}",
            row.name,
            estimate.mean()
        );
        println!("{line}");
        if !test.passes() || test.detects > unnoticed * truth {
            failures.push(line);
        }
    }
    failures
}

#[test]
fn even_points_change_no_mean() {
    // Replicates of 256 even points each, in runs of up to 64: their means are independent.
    for row in [integrating_sphere(), square(0.1, None)] {
        let integrator = Path::new(row.max_depth);
        let replicate = |pixel| -> f64 {
            let mut tracer = Tracer::new(&row.scene);
            let one = |i| {
                let stream = Stream::with(Sampler::Sobol, 5, pixel, i);
                f64::from(integrator.li(&mut tracer, &row.ray, &stream).r)
            };
            (0..256).map(one).collect::<Estimate>().mean()
        };
        let means: Vec<f64> = (0..400).into_par_iter().map(replicate).collect();
        let even: Estimate = means.into_iter().collect();
        let test = z_test(&even, row.truth, CRITICAL);
        println!(
            "{}: {:.6} for {:.6}, {test}",
            row.name,
            even.mean(),
            row.truth
        );
        assert!(test.passes() && test.detects < 0.01 * row.truth);

        // The scatter within a pixel promises less than even points keep.
        let independent = radiance(&|t, r, s| integrator.li(t, r, s), &row);
        let promised = independent.variance() / 256.0;
        println!(
            "variance of a mean of 256: {:.3e} for {promised:.3e}",
            even.variance()
        );
        assert!(even.variance() < 0.85 * promised);
    }
}

#[test]
fn walks_in_the_flat_world_meet_its_closed_forms() {
    let lamp = 0.8 / 2.0 * 2.0 / f64::sqrt(5.0);
    for (name, from, max_depth, truth) in [
        ("lamp", Vec2::new(0.0, 0.5), 2, lamp),
        // The solution of the integral equation; fewer than one part in 10⁹ comes by longer paths.
        ("room", Vec2::new(0.5, 0.5), 32, 0.330_679_4),
        // Two endless plates that light each other: a geometric series.
        (
            "plates",
            Vec2::new(0.0, 0.5),
            40,
            flatland::exact::plates(1.0, 0.9, 0.5),
        ),
    ] {
        let world = flatland::load(name).unwrap();
        let down = space::Ray::new(from, Vec2::NEG_Y);
        let red = |walk: &(dyn Fn(&mut FlatTracer, &Stream) -> Rgb + Sync)| -> Estimate {
            let one = |i| f64::from(walk(&mut FlatTracer::new(&world), &Stream::new(2, i, 0)).r);
            let samples: Vec<f64> = (0..200_000).into_par_iter().map(one).collect();
            samples.into_iter().collect()
        };
        let heuristic = Heuristic::Power;
        let survival = Survival::Constant(0.7);
        let combine = Combine {
            max_depth,
            heuristic,
        };
        let both = |s: Shares| s.by_chance + s.by_aiming;
        for (walk, estimate) in [
            (
                "kajiya",
                red(&|w, s| Kajiya { max_depth }.walk(w, &down, s)),
            ),
            (
                "roulette",
                red(&|w, s| Roulette { survival }.walk(w, &down, s)),
            ),
            (
                "next-event",
                red(&|w, s| NextEvent { max_depth }.walk(w, &down, s)),
            ),
            ("combine", red(&|w, s| both(combine.walk(w, &down, s)))),
        ] {
            let test = z_test(&estimate, truth, CRITICAL);
            println!(
                "{name}, {walk}: {:.6} for {truth:.6}, {test}",
                estimate.mean()
            );
            assert!(
                test.passes() && test.detects < 0.05 * truth,
                "{name}, {walk}"
            );
        }
        // Weights of one for both count the lamp twice.
        let twice = red(&|w, s| {
            Kajiya { max_depth }.walk(w, &down, s) + NextEvent { max_depth }.walk(w, &down, s)
        });
        assert!(!z_test(&twice, truth, CRITICAL).passes());
    }
}
