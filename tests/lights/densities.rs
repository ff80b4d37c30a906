//! `pdf` is the density that `sample` has.

use super::environment::{image, light};
use super::{GROUND, scene};
use glam::{DVec3, Vec3};
use halfdisk::geometry::{Ray, Surface};
use halfdisk::integrators::{Integrator, Kajiya};
use halfdisk::lights::Incident;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::{Scene, Tracer};
use std::f64::consts::{PI, TAU};

/// The largest relative difference between the density of a sample and that of its direction, over
/// samples of the only light of a scene whose point a ray along them meets first.
pub fn worst_difference(scene: &Scene, from: &Surface, samples: u32) -> f32 {
    let light = &scene.lights[0];
    let (mut worst, mut met, mut drawn) = (0.0_f32, 0, 0);
    for i in 0..samples {
        let u = Stream::new(5, i, 0).at(0, Purpose::LightPoint).two();
        let Some(sample) = light.sample(from, 0.5, u) else {
            continue;
        };
        let Incident::Radiance { pdf, .. } = sample.incident else {
            panic!("a light without extent");
        };
        drawn += 1;
        let mut tracer = Tracer::new(scene);
        // A sample at the rim may be missed by a rounding.
        let Some(hit) = tracer.secondary_ray(&from.spawn(sample.wi)) else {
            continue;
        };
        assert_eq!(hit.object.light, Some(0));
        met += 1;
        // Another triangle of the mesh is nearer.
        if !tracer.unoccluded(&sample.shadow_ray) {
            continue;
        }
        worst = worst.max((light.pdf(from, sample.wi, Some(&hit.surface)) / pdf - 1.0).abs());
    }
    assert!(met * 100 > drawn * 99, "{met} of {drawn} were met");
    worst
}

#[test]
fn of_a_sample_and_of_its_direction_are_one() {
    for (name, light) in [
        (
            "quad",
            "quad = { corner = [-0.5, 1, 0], u = [1, 0, 0], v = [0, 0, 1] }",
        ),
        (
            "near quad",
            "quad = { corner = [-0.5, 0.01, -0.2], u = [1, 0, 0], v = [0, 0, 1] }",
        ),
        (
            "parallelogram",
            "quad = { corner = [-0.5, 1, 0], u = [1, 0.3, 0], v = [0.5, 0, 1] }",
        ),
        (
            "far quad",
            "quad = { corner = [900, 3000, 0], u = [1, 0, 0], v = [0, 0, 1] }",
        ),
        (
            "triangle",
            "triangle = { a = [-0.5, 1, 0], b = [1, 1.2, 0], c = [0, 0.9, 1] }",
        ),
        (
            "mesh",
            "bumpy_sphere = { center = [1, 2, 0], radius = 1, columns = 8, rows = 6 }",
        ),
        ("sphere", "sphere = { center = [2, 1, 1], radius = 0.8 }"),
        (
            "small sphere",
            "sphere = { center = [2, 1, 1], radius = 1e-3 }",
        ),
    ] {
        let scene = scene(&format!("[[objects]]\nemits = 1\n{light}"));
        let worst = worst_difference(&scene, &GROUND, 10_000);
        println!("{name}: {worst:e}");
        assert!(worst < 1e-4, "{name}: {worst}");
    }
}

#[test]
fn both_sides_are_aimed_at() {
    for shape in [
        "quad = { corner = [-0.5, 1, 0], u = [1, 0, 0], v = [0, 0, 1] }",
        "quad = { corner = [-0.5, 1, 0], u = [1, 0.3, 0], v = [0.5, 0, 1] }",
        "quad = { corner = [900, 3000, 0], u = [1, 0, 0], v = [0, 0, 1] }",
        "triangle = { a = [-0.5, 1, 0], b = [1, 1.2, 0], c = [0, 0.9, 1] }",
        "bumpy_sphere = { center = [0, 0, 0], radius = 3, columns = 8, rows = 6 }",
    ] {
        // The same surface shows one side to what is below it and the other to what is above.
        let scene = scene(&format!(
            "[[objects]]\nemits = 1\ntwo_sided = true\n{shape}"
        ));
        let above = Surface {
            p: Vec3::new(500.0, 9000.0, 0.3),
            error: Vec3::ZERO,
            n: Vec3::NEG_Y,
            time: 0.0,
        };
        for from in [&GROUND, &above] {
            let aimed = (0..1000).filter(|i| {
                let u = Stream::new(5, *i, 0).at(0, Purpose::LightPoint).two();
                scene.lights[0].sample(from, 0.5, u).is_some()
            });
            let aimed = aimed.count();
            assert!(aimed > 990, "{shape}: {aimed} of 1000");
            assert!(worst_difference(&scene, from, 1000) < 1e-3, "{shape}");
        }
    }
}

#[test]
fn where_nothing_is_drawn_there_is_none() {
    let lamps = scene(
        "[[objects]]\nemits = 1\nquad = { corner = [-0.5, 1, 0], u = [0, 0, 1], v = [1, 0, 0] }\n\
         [[objects]]\nemits = 1\nsphere = { center = [0, 0, 0], radius = 3 }\n\
         [[lights]]\npoint = { position = [0, 1, 0], intensity = 1 }\n\
         [[lights]]\ndirectional = { direction = [0, -1, 0], irradiance = 5 }",
    );
    let at = Surface {
        p: Vec3::Y,
        n: Vec3::Y,
        ..GROUND
    };
    for light in &lamps.lights {
        assert_eq!(light.pdf(&GROUND, Vec3::Y, Some(&at)), 0.0, "{light:?}");
        assert_eq!(light.pdf(&GROUND, Vec3::Y, None), 0.0, "{light:?}");
    }
    // From a quad's back and from inside a sphere no light is seen, either.
    let ray = Ray::new(Vec3::ZERO, Vec3::new(0.1, 1.0, 0.2).normalize());
    let walk = Kajiya { max_depth: 3 };
    let li = walk.li(&mut Tracer::new(&lamps), &ray, &Stream::new(0, 0, 0));
    assert!(li.is_black());
}

#[test]
fn that_of_an_image_is_the_share_of_the_luminance_in_every_pixel() {
    for [width, height] in [[1, 2], [8, 4], [40, 20], [16, 64]] {
        let pixels = image(width, height, |row, column| {
            ((row * 7 + column * 3) % 5 + row) as f32
        });
        let environment = light(width, pixels, 0.3);
        let edge = |row: usize| libm::cos(PI * row as f64 / height as f64);
        let mut luminances = Vec::new();
        let mut whole = 0.0;
        for row in 0..height {
            for column in 0..width {
                // The middle of the pixel.
                let theta = PI * (row as f64 + 0.5) / height as f64;
                let phi = TAU * ((column as f64 + 0.5) / width as f64 - 0.5) - 0.3;
                let (sin, cos) = libm::sincos(theta);
                let (sin_phi, cos_phi) = libm::sincos(phi);
                let w = DVec3::new(sin * sin_phi, cos, -sin * cos_phi).as_vec3();
                let l = f64::from(environment.radiance(w).g);
                whole += l * TAU / width as f64 * (edge(row) - edge(row + 1));
                luminances.push((w, l));
            }
        }
        for (w, l) in luminances {
            let (pdf, exact) = (f64::from(environment.pdf(w)), l / whole);
            assert!(
                (pdf - exact).abs() <= 1e-5 * exact,
                "{width} x {height}, {w}: {pdf} for {exact}"
            );
        }
    }
}
