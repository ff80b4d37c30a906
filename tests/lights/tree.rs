//! Choosing among many lights by the point that is lit.

use super::scene;
use crate::checks::CRITICAL;
use glam::Vec3;
use halfdisk::color::Rgb;
use halfdisk::geometry::{Sphere, Triangle};
use halfdisk::integrators::{Combine, Integrator, Path, rarely_asked};
use halfdisk::lights::{
    DirectionalLight, EnvironmentLight, Light, LightBounds, LightChoice, MeshLight, PointLight,
    SphereLight, TriangleLight,
};
use halfdisk::render::{Options, render};
use halfdisk::sampling::discrete::Discrete;
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::stream::{Numbers, Purpose, Stream};
use halfdisk::scene::Scene;
use halfdisk::stats::chi_square::chi_square;

fn choice_of(lights: &[Light]) -> LightChoice {
    LightChoice::new(lights, |_| Vec3::ZERO)
}

fn point(position: Vec3, intensity: f32) -> Light {
    Light::Point(PointLight {
        position,
        intensity: Rgb::grey(intensity),
    })
}

fn sun(irradiance: f32) -> Light {
    Light::Directional(DirectionalLight {
        from: Vec3::Y,
        irradiance: Rgb::grey(irradiance),
    })
}

/// Lights of all kinds whose strength and place differ by powers of ten.
fn lights(numbers: &mut Numbers, count: usize) -> Vec<Light> {
    let one = |numbers: &mut Numbers| {
        let scale = libm::pow(10.0, f64::from(4.0 * numbers.one() - 2.0)) as f32;
        let mut place = || (Vec3::from([(); 3].map(|()| numbers.one())) - 0.5) * scale;
        let [a, b, c] = [place(), place(), place()];
        let strength = libm::pow(10.0, f64::from(6.0 * numbers.one() - 3.0)) as f32;
        match (numbers.one() * 4.0) as u32 {
            0 => point(a, strength),
            1 => sun(strength),
            2 => Light::Sphere(SphereLight {
                sphere: Sphere::new(a, 0.1 * b.length()),
                radiance: Rgb::grey(strength),
            }),
            _ => Light::Triangle(TriangleLight {
                triangle: Triangle { a, b, c },
                radiance: Rgb::grey(strength),
                two_sided: numbers.one() < 0.5,
            }),
        }
    };
    (0..count).map(|_| one(numbers)).collect()
}

#[test]
fn lights_are_drawn_with_their_probability() {
    // Chi-square at level 1e-4 for each of 24 pairs of lights and a point.
    const SAMPLES: usize = 100_000;
    for seed in 0..24 {
        let mut numbers = Stream::new(seed, 0, 0).at(0, Purpose::Integrand);
        let count = 1 + (numbers.one() * 40.0) as usize;
        let lights = lights(&mut numbers, count);
        let choice = choice_of(&lights);
        let p = Vec3::from([(); 3].map(|()| 4.0 * numbers.one() - 2.0));
        let probabilities: Vec<f64> = (0..count)
            .map(|i| f64::from(choice.probability(p, i)))
            .collect();
        // What is lost is drawn where the branch of a tree shines away from the point.
        let total: f64 = probabilities.iter().sum();
        assert!(total <= 1.0 + 1e-6, "{seed}: {total}");
        let least = 0.25 * 0.1 / count as f64;
        assert!(probabilities.iter().all(|p| *p >= least - 1e-9), "{seed}");

        let (mut counts, mut none) = (vec![0; count], 0);
        for _ in 0..SAMPLES {
            match choice.choose(p, numbers.fine()) {
                Some(chosen) => {
                    counts[chosen.index] += 1;
                    assert!((0.0..1.0).contains(&chosen.rest));
                    let again = choice.probability(p, chosen.index);
                    let ratio = f64::from(chosen.probability / again);
                    assert!((ratio - 1.0).abs() < 1e-6, "{seed}: {ratio}");
                }
                None => none += 1,
            }
        }
        counts.push(none);
        let expected = probabilities
            .iter()
            .copied()
            .chain([(1.0 - total).max(0.0)]);
        let expected: Vec<f64> = expected.map(|p| p * SAMPLES as f64).collect();
        let judged = chi_square(&counts, &expected);
        assert!(judged.p > 1e-4, "{seed}: {judged:?}");
    }
}

#[test]
fn the_tree_tells_near_from_far() {
    let lamps: Vec<Light> = (0..100).map(|i| point(Vec3::X * i as f32, 1.0)).collect();
    let choice = choice_of(&lamps);
    for at in [0, 17, 99] {
        let p = Vec3::new(at as f32, 0.5, 0.0);
        // Of a hundred lamps in a row, the one half a metre away.
        let here = choice.probability(p, at);
        assert!(here > 0.1, "{at}: {here}");
        let far = choice.probability(p, (at + 50) % 100);
        assert!((0.0009..0.01).contains(&far), "{at}: {far}");
    }
}

#[test]
fn a_bound_is_dark_only_where_all_its_lights_are() {
    let (mut dark, mut lit) = (0, 0);
    for seed in 0..4000 {
        let mut numbers = Stream::new(seed, 1, 0).at(0, Purpose::Integrand);
        let pair = lights(&mut numbers, 3);
        let p = Vec3::from([(); 3].map(|()| 20.0 * numbers.one() - 10.0));
        let Some(both) = pair
            .iter()
            .filter_map(LightBounds::of)
            .reduce(LightBounds::union)
        else {
            continue;
        };
        let faces = |light: &Light| match light {
            Light::Point(_) | Light::Sphere(_) => true,
            Light::Triangle(l) if l.two_sided => true,
            Light::Triangle(l) => l.triangle.normal().dot(p - l.triangle.a) > 1e-5,
            _ => false,
        };
        let any = pair.iter().any(faces);
        assert!(!any || both.fluence(p) > 0.0, "{seed}");
        dark += u32::from(both.fluence(p) == 0.0);
        lit += u32::from(any);
    }
    assert!(dark > 20 && lit > 1000, "{dark} {lit}");
}

#[test]
fn a_share_below_the_step_of_coarse_uniforms_is_drawn() {
    let discrete = Discrete::new([1.0, 1e-9]).unwrap();
    assert_eq!(discrete.sample(1.0 - 1e-10).index, 1);
    // The mistake: no uniform of 24 bits lies in it.
    let last = 1.0 - f32::EPSILON / 2.0;
    assert_eq!(discrete.sample(f64::from(last)).index, 0);
    // A uniform of 53 bits begins like one of 24.
    let of = || Stream::new(3, 5, 7).at(1, Purpose::LightPoint);
    let (coarse, fine) = (f64::from(of().one()), of().fine());
    assert!(fine > coarse && fine < coarse + f64::from(f32::EPSILON / 2.0));
}

/// A floor lit from nearby, and a pebble as far away as told.
fn pebble(distance: f64, lights: &str) -> Scene {
    scene(&format!(
        "[[objects]]\nmaterial = 'half'\nquad = {{ corner = [-3, -1, 1], u = [0, 0, 6], v = [6, 0, 0] }}\n\
         [[objects]]\nmaterial = 'half'\nsphere = {{ center = [0, 0, {distance}], radius = 1 }}\n{lights}"
    ))
}

fn mean_and_error(scene: &Scene, integrator: &impl Integrator, spp: u32) -> (f64, f64) {
    let options = Options {
        spp,
        ..Options::default()
    };
    render(scene, integrator, &options, &()).film.mean()
}

#[test]
fn a_near_lamp_is_asked_however_large_the_scene() {
    // Level: |z| <= 4.4; the smallest bias it would see is 1 %.
    const LAMP: &str = "[[lights]]\npoint = { position = [0, 0.5, 4], intensity = 3 }\n";
    let sky = "[[lights]]\ndirectional = { direction = [1, -1, 0], irradiance = 0.5 }\n";
    let image = "[environment]\nradiance = 0.2\n";
    let strong = "[[lights]]\npoint = { position = [0, 9e3, 9e3], intensity = 1e7 }\n";
    for (distance, other) in [
        (1e4, sky),
        (1e7, sky),
        (1e4, strong),
        (1e6, image),
        (30.0, sky),
    ] {
        let mut scene = pebble(distance, &format!("{LAMP}{other}"));
        scene.size = [24, 24];
        let (path, path_error) = mean_and_error(&scene, &Path::new(4), 256);
        let combine = Combine {
            max_depth: 4,
            heuristic: Heuristic::Power,
        };
        let (all, all_error) = mean_and_error(&scene, &combine, 256);
        let error = path_error.hypot(all_error);
        let z = (path - all) / error;
        println!("{distance:e}: path {path:.5}, combine {all:.5}, z {z:.2}");
        assert!(z.abs() < CRITICAL, "{distance}: {path} {all}");
        assert!(CRITICAL * error < 0.01 * all, "too noisy to see 1 %");
    }
}

#[test]
fn lights_that_a_small_picture_hardly_asks_are_known() {
    // A hundred lamps in a row over one floor, and one far away.
    let row: String = (0..100)
        .map(|i| {
            let x = 0.1 * f64::from(i) - 5.0;
            format!("[[lights]]\npoint = {{ position = [{x}, 1, 3], intensity = 1 }}\n")
        })
        .collect();
    let far = "[[lights]]\npoint = { position = [0, 1e4, 0], intensity = 1 }\n";
    let scene = pebble(1e3, &(row + far));
    let few = rarely_asked(&scene, 4, 24 * 24).unwrap();
    assert_eq!(few.least, 100, "{few:?}");
    // A tenth of the choices is shared by all alike, at one surface or two of each path.
    let share = few.times / (24.0 * 24.0);
    assert!((0.0001..0.002).contains(&share), "{few:?}");
    let more = rarely_asked(&scene, 4, 24 * 24 * 10).unwrap();
    assert!((more.times / few.times - 10.0).abs() < 1e-6);
    let many = rarely_asked(&scene, 4, 24 * 24 * 1000);
    assert!(
        many.is_none_or(|many| many.lights < few.lights),
        "{few:?} {many:?}"
    );
    assert!(rarely_asked(&scene, 4, 1 << 24).is_none());
    let alone = pebble(
        1e3,
        "[[lights]]\npoint = { position = [0, 1, 3], intensity = 1 }\n",
    );
    assert!(rarely_asked(&alone, 4, 1).is_none());
}

#[test]
fn where_no_surface_is_rough_no_light_is_rarely_asked() {
    let ball = |material: &str| {
        scene(&format!(
            "[materials.ball]\n{material}\n[[objects]]\nmaterial = 'ball'\nsphere = {{ center = [0, 0, 4], radius = 1 }}\n\
             [[objects]]\nemits = 1\nsphere = {{ center = [3, 0, 4], radius = 0.5 }}\n\
             [[objects]]\nemits = 1\nsphere = {{ center = [-3, 0, 4], radius = 0.5 }}\n"
        ))
    };
    assert!(rarely_asked(&ball("glass = { ior = 1.5 }"), 4, 1).is_none());
    // One rough surface suffices for the warning.
    assert!(rarely_asked(&ball("lambert = { albedo = 0.5 }"), 4, 1).is_some());
    assert!(
        rarely_asked(
            &ball("glossy = { reflectance = 0.5, roughness = 0.2 }"),
            4,
            1
        )
        .is_some()
    );
}

#[test]
fn no_triangle_and_no_pixel_is_too_faint_to_be_drawn() {
    let tiny = |size: f32| Triangle {
        a: Vec3::Y,
        b: Vec3::Y + Vec3::X * size,
        c: Vec3::Y - Vec3::Z * size,
    };
    let down = |t: Triangle| Triangle {
        b: t.c,
        c: t.b,
        ..t
    };
    let mesh = MeshLight::new(vec![down(tiny(1.0)), down(tiny(1e-5))], Rgb::WHITE).unwrap();
    let last = 1.0 - f32::EPSILON / 2.0;
    let part = |pick| mesh.sample(&super::GROUND, pick, [last, 0.3]).unwrap().part;
    assert_eq!((part(0.0), part(1.0 - 1e-6)), (0, 1));
    // A faint pixel beside one that is a billion times as bright.
    let mut pixels = vec![Rgb::BLACK; 8];
    (pixels[1], pixels[2]) = (Rgb::grey(1e9), Rgb::WHITE);
    let sky = EnvironmentLight::new(4, pixels, 0.0).unwrap();
    let drawn = |pick| {
        let sample = sky.sample(&super::GROUND, pick, [0.5, last]).unwrap();
        sky.radiance(sample.wi)
    };
    assert_eq!(drawn(0.0), Rgb::grey(1e9));
    assert_eq!(drawn(1.0 - f64::EPSILON), Rgb::WHITE);
}
