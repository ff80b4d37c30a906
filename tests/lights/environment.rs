//! Images around the scene: convention, density, irradiance, and files that are wrong.

use super::{GROUND, irradiance};
use crate::checks::CRITICAL;
use crate::checks::{alike, of, unlike};
use crate::pairs::{BothSides, deviates, follows};
use glam::Vec3;
use halfdisk::color::Rgb;
use halfdisk::geometry::{Ray, Surface};
use halfdisk::integrators::{Integrator, Kajiya, NextEvent, Whitted, direct_light};
use halfdisk::lights::{EnvironmentLight, Light};
use halfdisk::sampling::hemisphere;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, SceneError, Tracer, gallery};
use halfdisk::stats::Estimate;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::path::Path;

/// An image whose pixels have a value by row and column.
pub fn image(width: usize, height: usize, value: impl Fn(usize, usize) -> f32) -> Vec<Rgb> {
    (0..width * height)
        .map(|i| Rgb::grey(value(i / width, i % width)))
        .collect()
}

pub fn light(width: usize, pixels: Vec<Rgb>, turn: f64) -> EnvironmentLight {
    EnvironmentLight::new(width, pixels, turn).unwrap()
}

fn facing(n: Vec3) -> Surface {
    Surface { n, ..GROUND }
}

#[test]
fn the_convention_and_two_tones() {
    let looks = |w: &EnvironmentLight, d: [f32; 3]| w.radiance(Vec3::from(d).normalize()).g;
    // Four columns; the middle of the image is ahead of who looks along -z, the right half is on
    // the right.
    let four = light(
        4,
        image(4, 2, |row, column| (10 * row + column + 1) as f32),
        0.0,
    );
    assert_eq!(looks(&four, [-0.1, 0.5, -1.0]), 2.0);
    assert_eq!(looks(&four, [0.1, 0.5, -1.0]), 3.0);
    assert_eq!(looks(&four, [1.0, 0.5, 0.1]), 4.0);
    assert_eq!(looks(&four, [-1.0, -0.5, 0.1]), 11.0);
    // Turned by a quarter, counter-clockwise seen from above: what was ahead is on the left.
    let turned = light(
        4,
        image(4, 2, |row, column| (10 * row + column + 1) as f32),
        FRAC_PI_2,
    );
    assert_eq!(looks(&turned, [-1.0, 0.5, -0.1]), 3.0);
    assert_eq!(looks(&turned, [-1.0, 0.5, 0.1]), 2.0);

    // Two tones, above and below, and right and left: a surface that faces a half sees only that.
    let vertical = light(
        4,
        image(4, 6, |row, _| if row < 3 { 2.0 } else { 0.5 }),
        0.0,
    );
    let sides = light(
        6,
        image(6, 2, |_, column| if column < 3 { 2.0 } else { 0.5 }),
        0.0,
    );
    let rotated = light(
        6,
        image(6, 2, |_, column| if column < 3 { 2.0 } else { 0.5 }),
        FRAC_PI_2,
    );
    for (environment, n, truth) in [
        (&vertical, Vec3::Y, 2.0 * PI),
        (&vertical, Vec3::NEG_Y, 0.5 * PI),
        (&vertical, Vec3::X, 1.25 * PI),
        (&sides, Vec3::NEG_X, 2.0 * PI),
        (&sides, Vec3::X, 0.5 * PI),
        (&sides, Vec3::Y, 1.25 * PI),
        (&rotated, Vec3::Z, 2.0 * PI),
        (&rotated, Vec3::NEG_Z, 0.5 * PI),
    ] {
        let from = facing(n);
        let e = irradiance(&Light::Environment(environment.clone()), &from, 200_000);
        println!(
            "towards {n}: {} for {truth}, z {:+.2}",
            e.mean(),
            e.z(truth)
        );
        assert!(e.z(truth).abs() <= CRITICAL, "{n}: {e:?} for {truth}");
    }
    // All it sends, by the sum over its pixels and by closed form.
    assert!((vertical.fluence() - 2.5 * TAU).abs() < 1e-6);
}

/// An image with a dark part, a bright pixel and all tones between.
fn uneven(width: usize, height: usize) -> Vec<Rgb> {
    image(width, height, |row, column| match (row, column) {
        (1, 2) => 40.0,
        (row, _) if row == height - 1 => 0.0,
        _ => ((row * 7 + column * 3) % 5) as f32,
    })
}

#[test]
fn samples_follow_the_density() {
    for [width, height] in [[8, 4], [40, 20]] {
        let environment = light(width, uneven(width, height), 0.3);
        // The cells are those of another axis, so that no edge of theirs is one of the pixels.
        let pdf = |w: Vec3| f64::from(environment.pdf(w));
        let drawn = |light: &EnvironmentLight, u| {
            let sample = light.sample(&GROUND, 0.5, u);
            sample.map_or(Vec3::ZERO, |sample| sample.wi)
        };
        let name = format!("{width} x {height}");
        follows(&name, &BothSides, |u| drawn(&environment, u), pdf);
        let turned = light(width, uneven(width, height), -0.3);
        deviates(
            "turned the other way",
            "chi2",
            &BothSides,
            |u| drawn(&turned, u),
            pdf,
        );
        let twice = |[a, _]: [f32; 2]| drawn(&environment, [a, a]);
        deviates("one uniform for both", "chi2", &BothSides, twice, pdf);
    }
}

#[test]
fn poles_and_seams_are_finite() {
    let environment = light(8, image(8, 4, |_, _| 1.0), 0.0);
    let all = Light::Environment(environment.clone());
    for w in [
        Vec3::Y,
        Vec3::NEG_Y,
        Vec3::X,
        Vec3::Z,
        Vec3::NEG_Z,
        Vec3::new(-0.0, 0.0, 1.0),
        Vec3::new(1e-30, 1.0, -1e-30),
    ] {
        let pdf = all.pdf(&GROUND, w, None);
        assert!((0.05..0.2).contains(&pdf), "{w}: {pdf}");
        assert_eq!(environment.radiance(w), Rgb::WHITE);
        // Something is in the way.
        assert_eq!(all.pdf(&GROUND, w, Some(&GROUND)), 0.0);
    }
    let last = 1.0 - f32::EPSILON / 2.0;
    for u in [[0.0, 0.0], [last, 0.0], [0.0, last], [last, last]] {
        let sample = all.sample(&GROUND, 0.5, u).unwrap();
        assert!((sample.wi.length() - 1.0).abs() < 1e-6);
        assert!(sample.incident.facing_irradiance().is_finite());
    }
    assert!(EnvironmentLight::new(2, vec![Rgb::BLACK; 8], 0.0).is_none());
}

#[test]
fn a_bright_sun_is_found() {
    // A pixel of 1/3200 of the sphere, a hundred thousand times as bright as the sky.
    let (width, height) = (80, 40);
    let sun = |row, column| if (row, column) == (10, 20) { 1e5 } else { 1.0 };
    let environment = light(width, image(width, height, sun), 0.0);
    let all = Light::Environment(environment.clone());
    let asked = irradiance(&all, &GROUND, 100_000);
    // Inside a row the mean of cos θ over the solid angle of a pixel is closed.
    let edge = |row: f64| libm::cos(PI * row / height as f64);
    let pixel = TAU / width as f64 * 0.5 * (edge(10.0).powi(2) - edge(11.0).powi(2));
    let truth = PI + (1e5 - 1.0) * pixel;
    let by_chance: Estimate = (0..100_000)
        .map(|i| {
            let u = Stream::new(2, i, 0).at(0, Purpose::Direction).two();
            let local = hemisphere::sample_cosine(u);
            PI * f64::from(environment.radiance(Vec3::new(local.x, local.z, local.y)).g)
        })
        .collect();
    println!(
        "E {} for {truth}, z {:+.2}; relative variance {:.3} against {:.0} by cosine",
        asked.mean(),
        asked.z(truth),
        asked.variance() / truth.powi(2),
        by_chance.variance() / truth.powi(2)
    );
    assert!(asked.z(truth).abs() <= CRITICAL);
    assert!(by_chance.variance() > 1000.0 * asked.variance());
}

/// A scene with such an environment beside its file.
fn load(folder: &Path, environment: &str, objects: &str) -> Result<Scene, SceneError> {
    let text = format!(
        "name = 'test'\ncamera = {{ from = [0, 0, 0], to = [0, 0, 1], fov = 40 }}\n\
         materials.half.lambert.albedo = 0.5\nmaterials.clear.glass.ior = 1.5\n\
         [environment]\n{environment}\n{objects}"
    );
    let source = Source {
        file: "test.toml",
        text: &text,
    };
    gallery::from_text(source, Some(folder), |_| {})
}

const FLOOR: &str = "[[objects]]\nmaterial = 'half'\n\
                     quad = { corner = [-9, -1, 9], u = [18, 0, 0], v = [0, 0, -18] }\n";

fn write_exr(path: &Path, width: usize, pixels: &[Rgb]) {
    let height = pixels.len() / width;
    exr::prelude::write_rgb_file(path, width, height, |x, y| {
        let Rgb { r, g, b } = pixels[y * width + x];
        (r, g, b)
    })
    .unwrap();
}

#[test]
fn images_of_each_kind_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let pixels: Vec<Rgb> = (0..32)
        .map(|i| Rgb::new(0.25 * i as f32, 1.0, 0.5))
        .collect();
    write_exr(&folder.path().join("sky.exr"), 8, &pixels);
    let bytes: Vec<image::Rgb<f32>> = pixels.iter().map(|p| image::Rgb(p.channels())).collect();
    let hdr = std::fs::File::create(folder.path().join("sky.hdr")).unwrap();
    image::codecs::hdr::HdrEncoder::new(hdr)
        .encode(&bytes, 8, 4)
        .unwrap();
    let png = image::RgbImage::from_fn(8, 4, |x, y| image::Rgb([(8 * y + x) as u8, 255, 188]));
    png.save(folder.path().join("sky.png")).unwrap();

    let ahead = |scene: &Scene| scene.background(Vec3::new(0.1, -0.9, -1.0).normalize());
    for (file, more, expected) in [
        ("sky.exr", "", [5.0, 1.0, 0.5]),
        ("sky.hdr", "scale = 2", [10.0, 2.0, 1.0]),
        ("sky.png", "", [0.006_99, 1.0, 0.502_9]),
        ("sky.exr", "rotate = -45", [4.75, 1.0, 0.5]),
    ] {
        let scene = load(folder.path(), &format!("image = '{file}'\n{more}"), "").unwrap();
        assert_eq!((scene.lights.len(), scene.environment_light), (1, Some(0)));
        let found = ahead(&scene).channels();
        for (x, expected) in found.into_iter().zip(expected) {
            assert!((x - expected).abs() < 0.01 * expected, "{file}: {found:?}");
        }
    }
    let constant = load(folder.path(), "radiance = [1, 2, 3]", FLOOR).unwrap();
    assert_eq!(ahead(&constant), Rgb::new(1.0, 2.0, 3.0));
    // A sky of one colour is aimed at by who chooses one light.
    assert!(constant.environment_light.is_none() && constant.sampled_lights() == 0);
    assert_eq!(constant.sky_light, Some(0));
}

#[test]
fn integrators_count_the_sky_once() {
    let folder = tempfile::tempdir().unwrap();
    let sky = image(8, 4, |row, column| match (row, column) {
        (1, 2) => 8.0,
        _ => ((row * 7 + column * 3) % 5) as f32,
    });
    write_exr(&folder.path().join("sky.exr"), 8, &sky);
    let objects = format!(
        "{FLOOR}[[objects]]\nmaterial = 'clear'\nsphere = {{ center = [0, 0.5, 3], radius = 1 }}\n"
    );
    let scene = load(folder.path(), "image = 'sky.exr'", &objects).unwrap();
    let Light::Environment(environment) = &scene.lights[0] else {
        panic!()
    };
    let run = |integrator: &dyn Fn(&mut Tracer, &Ray, &Stream) -> Rgb, toward: Vec3, seed| {
        let ray = Ray::new(Vec3::ZERO, toward.normalize());
        let mut tracer = Tracer::new(&scene);
        (0..800_000)
            .map(|i| f64::from(integrator(&mut tracer, &ray, &Stream::new(seed, i, 0)).g))
            .collect::<Estimate>()
    };
    // The sky itself, the floor, and the sky and the floor through glass.
    for toward in [
        Vec3::new(1.0, 1.0, -1.0),
        Vec3::new(-1.0, -0.6, -1.0),
        Vec3::new(0.1, 0.2, 1.0),
    ] {
        let max_depth = 9;
        let walk = run(&|t, r, s| Kajiya { max_depth }.li(t, r, s), toward, 1);
        let asking = run(&|t, r, s| NextEvent { max_depth }.li(t, r, s), toward, 2);
        let name = format!("kajiya and next-event, {toward}");
        alike(&name, of(&asking), of(&walk), 0.012);
    }
    let down = Vec3::new(-1.0, -0.6, -1.0);
    let walk = run(&|t, r, s| Kajiya { max_depth: 2 }.li(t, r, s), down, 1);
    let tree = run(&|t, r, s| Whitted { max_depth: 2 }.li(t, r, s), down, 2);
    alike("kajiya and whitted", of(&tree), of(&walk), 0.012);
    // The mistake of counting it where it is asked for and where it is met.
    let twice = run(
        &|t, r, s| {
            let asked = t.camera_ray(r).map(|hit| direct_light(t, &hit, 1, s));
            Kajiya { max_depth: 2 }.li(t, r, s) + asked.unwrap_or_default()
        },
        down,
        3,
    );
    unlike("counted twice", of(&twice), of(&walk));
    // What it is worth in a choice.
    assert_eq!(scene.lights[0].fluence_from_afar(), environment.fluence());
}

#[test]
fn images_that_are_no_sky_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let with = |value: f32| {
        let mut pixels = vec![Rgb::WHITE; 8];
        pixels[5].g = value;
        pixels
    };
    write_exr(&path("nan.exr"), 4, &with(f32::NAN));
    write_exr(&path("infinite.exr"), 4, &with(f32::INFINITY));
    write_exr(&path("negative.exr"), 4, &with(-1.0));
    write_exr(&path("huge.exr"), 4, &with(1e38));
    write_exr(&path("black.exr"), 4, &[Rgb::BLACK; 8]);
    for name in ["empty.exr", "empty.hdr", "empty.png"] {
        std::fs::write(path(name), "").unwrap();
    }
    std::fs::write(path("text.hdr"), "no image at all").unwrap();
    let whole = std::fs::read(path("black.exr")).unwrap();
    std::fs::write(path("half.exr"), &whole[..whole.len() / 2]).unwrap();
    for (file, more, what) in [
        ("nan.exr", "", "has [1, NaN, 1] in column 1 of row 1"),
        ("infinite.exr", "", "finite numbers of 0 or more"),
        ("negative.exr", "", "has [1, -1, 1]"),
        ("huge.exr", "scale = 100", "finite numbers"),
        ("missing.exr", "", "cannot be opened"),
        ("empty.exr", "", "is not a proper image"),
        ("empty.hdr", "", "is not a proper image"),
        ("empty.png", "", "is not a proper image"),
        ("text.hdr", "", "is not a proper image"),
        ("half.exr", "", "is not a proper image"),
    ] {
        let error = load(folder.path(), &format!("image = '{file}'\n{more}"), "").unwrap_err();
        let error = error.to_string();
        println!("{error}");
        assert!(
            error.starts_with("test.toml:6: `environment.image` names "),
            "{error}"
        );
        assert!(error.contains(file) && error.contains(what), "{error}");
        assert_eq!(error.lines().count(), 1);
    }
}
