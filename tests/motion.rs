//! Scenes in motion: at each moment a scene that stands still, and lamps that are aimed at where
//! they are.

use crate::checks::CRITICAL;
use crate::checks::{alike, of, unlike};
use crate::cli::{complaint, folder, halfdisk};
use glam::Vec3;
use halfdisk::color::Rgb;
use halfdisk::geometry::{Ray, Surface};
use halfdisk::integrators::{Combine, Integrator, Kajiya, NextEvent, Path, Whitted};
use halfdisk::lights::Incident;
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::gallery::{self, GALLERY};
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, Tracer};
use halfdisk::stats::Estimate;
use halfdisk::stats::z_test::z_test;
use std::f64::consts::PI;
use std::path::Path as File;

/// A scene file: its shutter, and what is in it.
fn text(shutter: [f64; 2], objects: &str) -> String {
    format!(
        "name = 'test'\nfilm.size = [16, 12]\nmaterials.half.lambert.albedo = 0.5\n\
         camera = {{ from = [0, 1, 5], to = [0, 0.5, 0], fov = 45, shutter = {shutter:?} }}\n{objects}"
    )
}

fn scene(shutter: [f64; 2], objects: &str) -> Scene {
    let text = text(shutter, objects);
    let source = Source {
        file: "test.toml",
        text: &text,
    };
    gallery::from_text(source, None, |_| {}).unwrap()
}

/// A sphere, a mesh and a lamp, each with what is said about its motion, over a floor.
fn yard(sphere: &str, mesh: &str, lamp: &str) -> String {
    format!(
        "[[objects]]\nmaterial = 'half'\n{sphere}\n\
         sphere = {{ center = [-1, 0.5, 0], radius = 0.5 }}\n\
         [[objects]]\nmaterial = 'half'\n{mesh}\n\
         bumpy_sphere = {{ center = [1, 0.5, 0], radius = 0.5, columns = 8, rows = 6 }}\n\
         [[objects]]\nemits = 9\n{lamp}\n\
         sphere = {{ center = [0, 2, 1], radius = 0.25 }}\n\
         [[objects]]\nmaterial = 'half'\n\
         quad = {{ corner = [-4, 0, 4], u = [8, 0, 0], v = [0, 0, -8] }}\n"
    )
}

/// All of the yard moves.
fn in_motion() -> String {
    yard(
        "motion = [0.5, 0.25, 0]",
        "motion = [0, 0, -1.5]",
        "motion = [-1, 0.5, 0]",
    )
}

/// The yard standing still, shifted to where that in motion is at a time.
fn standing(time: f64) -> String {
    let shift = |[x, y, z]: [f64; 3]| {
        format!(
            "transform.translate = [{}, {}, {}]",
            x * time,
            y * time,
            z * time
        )
    };
    yard(
        &shift([0.5, 0.25, 0.0]),
        &shift([0.0, 0.0, -1.5]),
        &shift([-1.0, 0.5, 0.0]),
    )
}

#[test]
fn a_closed_shutter_and_a_motion_of_zero_change_no_byte() {
    let folder = folder();
    let exr = |text: &str| {
        std::fs::write(folder.path().join("scene.toml"), text).unwrap();
        let arguments = "render scene.toml --spp 5 --max-depth 4 --out p.exr";
        let output = halfdisk(folder.path(), &arguments.split(' ').collect::<Vec<_>>());
        assert!(output.status.success(), "{}", complaint(&output));
        let (_, state) = halfdisk::output::made(&folder.path().join("p.exr")).unwrap();
        state.unwrap()
    };
    for time in [0.0, 0.5, -2.0] {
        let still = exr(&text([0.0, 0.0], &standing(time)));
        assert!(exr(&text([time, time], &in_motion())) == still, "{time}");
        assert!(exr(&text([time, time + 0.25], &in_motion())) != still);
    }
    let zero = "motion = [0, 0, 0]";
    assert!(
        exr(&text([0.0, 1.0], &yard(zero, zero, zero)))
            == exr(&text([0.0, 0.0], &yard("", "", "")))
    );
    assert!(!scene([0.0, 1.0], &yard(zero, zero, zero)).moves());
    assert!(!scene([1.0, 1.0], &in_motion()).moves());
    assert!(scene([1.0, 1.5], &in_motion()).moves());
}

#[test]
fn at_each_moment_the_scene_is_one_that_stands_still() {
    // All coordinates are short binary fractions: nothing is rounded on the way.
    let moving = scene([0.0, 1.0], &in_motion());
    let (mut hits, mut elsewhere) = (0, 0);
    for time in [0.0_f32, 0.25, 0.5, 1.0] {
        let still = scene([0.0, 0.0], &standing(f64::from(time)));
        let [mut a, mut b] = [&moving, &still].map(Tracer::new);
        for i in 0..2000 {
            let mut numbers = Stream::new(1, i, 0).at(0, Purpose::Integrand);
            let ray = still.camera.ray(numbers.one(), numbers.one()).at_time(time);
            let answer = |tracer: &mut Tracer, ray: &Ray| {
                tracer.camera_ray(ray).map(|hit| {
                    let Surface { p, error, n, .. } = hit.surface;
                    (hit.t, p, error, n, hit.object.emission.brightest())
                })
            };
            let met = answer(&mut b, &ray);
            assert_eq!(answer(&mut a, &ray), met, "{ray:?} at {time}");
            elsewhere += usize::from(answer(&mut a, &ray.at_time(1.0 - time)) != met);
            let Some((_, p, error, n, _)) = met else {
                continue;
            };
            hits += 1;
            let from = Surface { p, error, n, time };
            let u = numbers.two();
            let aimed = |tracer: &mut Tracer| {
                tracer.light_sample(0, &from, 0.5, u).map(|s| {
                    let (wi, ray) = (s.wi, s.shadow_ray);
                    (wi, ray.origin, ray.t_max, tracer.unoccluded(&ray))
                })
            };
            assert_eq!(aimed(&mut a), aimed(&mut b));
        }
    }
    println!("{hits} hits alike, {elsewhere} of 8000 rays another at another time");
    assert!(hits > 4000 && elsewhere > 500);
}

/// Lamps of each kind, all of which shine at the floor below them.
const LAMPS: [(&str, &str); 6] = [
    (
        "rectangle",
        "quad = { corner = [-1.5, 1.5, 0.5], u = [1, 0, 0], v = [0, 0, 1] }",
    ),
    (
        "parallelogram",
        "quad = { corner = [-1.5, 1.5, 0.5], u = [1, 0.25, 0], v = [0.5, 0, 1] }",
    ),
    (
        "triangle",
        "triangle = { a = [-1.5, 1.5, 0.5], b = [-0.5, 1.5, 0.5], c = [-1, 1.5, 1.5] }",
    ),
    ("sphere", "sphere = { center = [-1, 1.5, 1], radius = 0.5 }"),
    (
        "mesh",
        "bumpy_sphere = { center = [-1, 1.5, 1], radius = 0.5, columns = 8, rows = 6 }",
    ),
    ("box", "box = { min = [-1.5, 1.5, 0.5], max = [-1, 2, 1] }"),
];

#[test]
fn the_density_of_a_moving_lamp_is_that_of_its_samples_at_each_moment() {
    for (name, lamp) in LAMPS {
        let text = format!("[[objects]]\nemits = 5\nmotion = [2, 0.5, -1]\n{lamp}\n");
        let scene = scene([0.0, 1.0], &text);
        let (mut met, mut worst, mut elsewhere) = (0, 0.0_f32, 0.0_f32);
        for i in 0..6000 {
            let mut numbers = Stream::new(4, i, 0).at(0, Purpose::Integrand);
            let mut tracer = Tracer::new(&scene);
            let time = numbers.one();
            let from = Surface {
                // Below the lamp's way, relative to the eye.
                p: Vec3::new(
                    3.0 * numbers.one() - 2.0,
                    1.4 * numbers.one() - 1.0,
                    3.0 * numbers.one() - 6.5,
                ),
                error: Vec3::ZERO,
                n: Vec3::Y,
                time,
            };
            let index = i as usize % scene.lights.len();
            let Some(sample) = tracer.light_sample(index, &from, 0.5, numbers.two()) else {
                continue;
            };
            let Incident::Radiance { pdf, .. } = sample.incident else {
                panic!("a lamp with extent")
            };
            // A sample at the rim may be missed by a rounding, and one behind another triangle is.
            let Some(hit) = tracer.secondary_ray(&from.spawn(sample.wi)) else {
                continue;
            };
            if hit.object.light != Some(index as u32) || !tracer.unoccluded(&sample.shadow_ray) {
                continue;
            }
            met += 1;
            let at = Some(&hit.surface);
            let known = tracer.light_pdf(index, &from, sample.wi, at);
            worst = worst.max((known / pdf - 1.0).abs());
            // Where the lamp was when the shutter opened.
            let opened = scene.lights[index].pdf(&from, sample.wi, at);
            elsewhere = elsewhere.max((opened / pdf - 1.0).abs());
        }
        println!("{name}: off by {worst:.1e} of {met}; at the start by up to {elsewhere:.2}");
        assert!(met > 300 && worst < 5e-3, "{name}: {met} {worst}");
        // That of points drawn by area depends on the point alone.
        let by_area = ["mesh", "parallelogram"].contains(&name);
        assert!(by_area || elsewhere > 0.05, "{name}: {elsewhere}");
    }
}

#[test]
fn of_two_shapes_at_one_place_the_first_in_the_file_is_met() {
    let plate = |emits: u8, motion: &str| {
        format!(
            "[[objects]]\nemits = {emits}\n{motion}\n\
             quad = {{ corner = [-1, -1, 0], u = [2, 0, 0], v = [0, 2, 0] }}\n"
        )
    };
    let aside = "motion = [0.5, 0, 0]";
    for (first, second) in [(aside, ""), ("", aside)] {
        let both = scene([0.0, 1.0], &(plate(1, first) + &plate(2, second)));
        let mut tracer = Tracer::new(&both);
        for time in [0.0, 0.5, 1.0] {
            let ray = both.camera.ray(0.5, 0.5).at_time(time);
            let hit = tracer.camera_ray(&ray).unwrap();
            assert_eq!(hit.emission, Rgb::WHITE, "{first} at {time}");
        }
    }
}

/// The radiance along one ray at random times, red channel.
fn radiance(integrator: &impl Integrator, scene: &Scene, ray: &Ray, walks: u32) -> Estimate {
    seeded(2, integrator, scene, ray, walks)
}

fn seeded(
    seed: u64,
    integrator: &impl Integrator,
    scene: &Scene,
    ray: &Ray,
    walks: u32,
) -> Estimate {
    let mut tracer = Tracer::new(scene);
    let one = |i| {
        let stream = Stream::new(seed, i, 0);
        let ray = ray.at_time(stream.at(0, Purpose::Time).one());
        f64::from(integrator.li(&mut tracer, &ray, &stream).r)
    };
    (0..walks).map(one).collect()
}

/// Aims at lamps where they were when the shutter opened.
struct AimsAtTheStart;

impl Integrator for AimsAtTheStart {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let Some(hit) = tracer.camera_ray(ray) else {
            return Rgb::BLACK;
        };
        let u = stream.at(1, Purpose::LightPoint).two();
        let Some(sample) = tracer.scene().lights[0].sample(&hit.surface, 0.5, u) else {
            return Rgb::BLACK;
        };
        let cos = hit.surface.n.dot(sample.wi).max(0.0);
        let albedo = hit.bsdf.map_or(Rgb::BLACK, |bsdf| bsdf.albedo());
        albedo * sample.incident.facing_irradiance() * (cos / std::f32::consts::PI)
    }
}

#[test]
fn a_round_lamp_that_flies_over_a_floor() {
    // At distance x along its way it gives `π L R² h / (h² + x²)^(3/2)`: over the way from a to b
    // the mean of that is `π L R² / h [x / √(h² + x²)] / (b - a)`.
    let flight = |shutter| {
        scene(
            shutter,
            "[[objects]]\nemits = 5\nmotion = [2, 0, 0]\n\
             sphere = { center = [-1, 2, 0], radius = 0.25 }\n\
             [[objects]]\nmaterial = 'half'\n\
             quad = { corner = [-4, 0, 4], u = [8, 0, 0], v = [0, 0, -8] }\n",
        )
    };
    // From the eye to the floor below the lamp's place at time 1/2.
    let ray = Ray::new(Vec3::ZERO, Vec3::new(0.0, -1.0, -5.0).normalize());
    for (open, close) in [(0.0, 1.0), (0.5, 2.0), (-1.0, 1.0)] {
        let lamp = flight([open, close]);
        let [a, b] = [open, close].map(|t| -1.0 + 2.0 * t);
        let whole = |x: f64| x / (4.0 + x * x).sqrt();
        let irradiance = PI * 5.0 * 0.0625 / 2.0 * (whole(b) - whole(a)) / (b - a);
        let truth = 0.5 / PI * irradiance;
        let check = |name: &str, estimate: Estimate| {
            let test = z_test(&estimate, truth, CRITICAL);
            println!("{name}, open from {open} to {close}: {test}");
            test
        };
        let accept = |name: &str, estimate: Estimate| {
            let test = check(name, estimate);
            assert!(test.passes() && test.detects < 0.1 * truth, "{name}");
        };
        let max_depth = 2;
        let heuristic = Heuristic::Balance;
        let mis = Combine {
            max_depth,
            heuristic,
        };
        accept(
            "kajiya",
            radiance(&Kajiya { max_depth }, &lamp, &ray, 400_000),
        );
        accept(
            "whitted",
            radiance(&Whitted { max_depth }, &lamp, &ray, 4000),
        );
        accept(
            "next-event",
            radiance(&NextEvent { max_depth }, &lamp, &ray, 4000),
        );
        accept("combine", radiance(&mis, &lamp, &ray, 4000));
        accept("path", radiance(&Path::new(max_depth), &lamp, &ray, 4000));
        let start = radiance(&AimsAtTheStart, &lamp, &ray, 4000);
        assert!(!check("aimed at the start", start).passes());
        let middle = 0.5 * (open + close);
        let still = flight([middle, middle]);
        let still = radiance(&NextEvent { max_depth }, &still, &ray, 4000);
        assert!(!check("still in the middle", still).passes());
    }
}

#[test]
fn moving_lamps_of_each_kind_by_all_integrators() {
    for (kind, lamp) in LAMPS {
        let with = |motion: &str| {
            scene(
                [0.0, 1.0],
                &format!(
                    "[[objects]]\nemits = 5\nmaterial = 'half'\n{motion}\n{lamp}\n\
                     [[objects]]\nmaterial = 'half'\nmotion = [0, 0.5, 0]\n\
                     sphere = {{ center = [0, 0.25, 0], radius = 0.5 }}\n\
                     [[objects]]\nmaterial = 'half'\n\
                     quad = {{ corner = [-4, 0, 4], u = [8, 0, 0], v = [0, 0, -8] }}\n"
                ),
            )
        };
        let scene = with("motion = [2, 0.5, -1]");
        // From the eye to the floor under the lamp's way.
        let ray = Ray::new(Vec3::ZERO, Vec3::new(-0.3, -1.0, -4.6).normalize());
        let combine = |max_depth| Combine {
            max_depth,
            heuristic: Heuristic::Power,
        };
        // By chance, straight from the lamp: the others agree with it and among themselves, and then
        // among themselves on longer paths.
        let chance = of(&radiance(&Kajiya { max_depth: 2 }, &scene, &ray, 1_000_000));
        for (max_depth, share) in [(2, 0.06), (4, 0.05)] {
            let asks = NextEvent { max_depth };
            let asking = of(&seeded(3, &asks, &scene, &ray, 400_000));
            let both = of(&seeded(4, &combine(max_depth), &scene, &ray, 400_000));
            let path = of(&seeded(5, &Path::new(max_depth), &scene, &ray, 400_000));
            let say = |name: &str| format!("{kind}, {name}, {max_depth} segments");
            let truth = if max_depth == 2 {
                alike(&say("next-event"), asking, chance, share);
                chance
            } else {
                asking
            };
            alike(&say("combine"), both, truth, share);
            alike(&say("path"), path, truth, share);
            // On its way down it would come closer to the floor.
            let down = with("motion = [2, -0.5, -1]");
            let down = radiance(&NextEvent { max_depth }, &down, &ray, 20_000);
            unlike("downwards", of(&down), truth);
        }
    }
}

#[test]
fn the_gallery_has_scenes_with_a_lens_and_in_motion() {
    for (name, _) in GALLERY {
        let scene = gallery::load(name).unwrap();
        assert_eq!(scene.moves(), ["motion", "six"].contains(name), "{name}");
        assert_eq!(
            scene.camera.lens().is_some(),
            ["lens", "six", "final"].contains(name)
        );
    }
    assert!(File::new("examples/scenes/motion.toml").exists());
}
