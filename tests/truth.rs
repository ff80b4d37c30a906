//! Closed forms, whatever the way to them.

use crate::checks::accept;
use crate::of_chapters::two_ways::TwoWays;
use glam::{DVec3, Vec3};
use halfdisk::color::Rgb;
use halfdisk::geometry::{Quad, Ray, Sphere, Surface};
use halfdisk::integrators::Whitted;
use halfdisk::lights::{Light, QuadLight, SphereLight};
use halfdisk::render::compare;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::{Tracer, gallery};
use halfdisk::stats::Estimate;
use std::f64::consts::PI;

/// The irradiance that `samples` samples of a light estimate at the origin, facing up.
fn irradiance(light: &Light, samples: u32) -> Estimate {
    let ground = Surface {
        p: Vec3::ZERO,
        error: Vec3::ZERO,
        n: Vec3::Y,
        time: 0.0,
    };
    let facing_up = |i: u32| {
        let u = Stream::new(9, i, 0).at(0, Purpose::LightPoint).two();
        light.sample(&ground, 0.5, u).map_or(0.0, |s| {
            f64::from(s.incident.facing_irradiance().r * s.wi.y.max(0.0))
        })
    };
    (0..samples).map(facing_up).collect()
}

#[test]
fn a_square_lamp_overhead() {
    // Corner formula for a / h = b / h = x, four times around the middle.
    let centred = |h: f64| {
        let x = 0.5 / h;
        let s = (1.0 + x * x).sqrt();
        4.0 * x / s * libm::atan(x / s)
    };
    for h in [10.0, 1.0, 0.5, 0.1] {
        let corner = DVec3::new(-0.5, h, -0.5);
        let quad = Quad::new(corner, DVec3::X, DVec3::Z).unwrap();
        assert!(quad.normal().y < 0.0, "it shines down");
        let light = Light::Quad(QuadLight::new(quad, Rgb::WHITE));
        let estimate = irradiance(&light, 400_000);
        accept(
            &format!("square lamp at {h}"),
            &estimate,
            centred(h),
            centred(h),
        );
        // The relative variance that sampling by solid angle has, far away and near.
        let relative = estimate.variance() / estimate.mean().powi(2);
        let expected = match h {
            1.0 => 0.0019,
            0.1 => 0.163,
            _ => continue,
        };
        assert!(
            (relative / expected - 1.0).abs() < 0.2,
            "h = {h}: {relative}"
        );
    }
    let dark = Quad::new(DVec3::new(-0.5, 1.0, -0.5), DVec3::Z, DVec3::X).unwrap();
    let light = Light::Quad(QuadLight::new(dark, Rgb::WHITE));
    assert_eq!(irradiance(&light, 100).mean(), 0.0, "its back is dark");
}

#[test]
fn a_round_lamp_overhead_of_any_smallness() {
    for k in 0..10 {
        let r = 0.5 * libm::pow(10.0, -f64::from(k));
        let sphere = Sphere::new(Vec3::Y, r as f32);
        let light = Light::Sphere(SphereLight {
            sphere,
            radiance: Rgb::WHITE,
        });
        let truth = PI * f64::from(r as f32).powi(2);
        let name = format!("round lamp of radius {r:.0e}");
        accept(&name, &irradiance(&light, 100_000), truth, truth);
    }
    let around = Sphere::new(Vec3::Y, 2.0);
    let light = Light::Sphere(SphereLight {
        sphere: around,
        radiance: Rgb::WHITE,
    });
    assert_eq!(irradiance(&light, 100).mean(), 0.0, "inside it is dark");
}

#[test]
fn a_round_lamp_half_below_the_horizon() {
    // Irradiance of a partly hidden sphere, sin s = r / d, b the angle of its centre: s = 0.4.
    for (b, truth) in [(1.4, 0.092_100_7), (1.6, 0.034_672_2), (1.9, 0.000_633_600)] {
        let (s, d) = (0.4, 2.0);
        let center = DVec3::new(d * libm::sin(b), d * libm::cos(b), 0.0).as_vec3();
        let sphere = Sphere::new(center, (d * libm::sin(s)) as f32);
        let light = Light::Sphere(SphereLight {
            sphere,
            radiance: Rgb::WHITE,
        });
        let name = format!("round lamp at angle {b}");
        accept(&name, &irradiance(&light, 2_500_000), truth, 2.0 * truth);
    }
}

/// The radiance along a ray through a gallery scene.
fn whitted(scene: &str, ray: impl Fn(&halfdisk::scene::Scene) -> Ray, max_depth: u32) -> Rgb {
    let scene = gallery::load(scene).unwrap();
    let ray = ray(&scene);
    let stream = Stream::new(0, 0, 0);
    Whitted { max_depth }.watch(&mut Tracer::new(&scene), &ray, &stream, &mut ())
}

#[test]
fn a_slab_lets_through_a_geometric_series() {
    let middle = |scene: &halfdisk::scene::Scene| scene.camera.ray(0.5, 0.5);
    let li = whitted("slab", middle, 32);
    assert!((li.r - 0.923_076_9).abs() < 1e-6, "{li:?}");
    assert!((li.g - 0.076_923_08).abs() < 1e-6, "{li:?}");
    // The mistake of a tree that is too short: after four segments the third pass is missing.
    let short = whitted("slab", middle, 4);
    assert!((short.r - 0.923_076_9).abs() > 1e-3, "{short:?}");
}

#[test]
fn a_corridor_of_mirrors_dims_by_its_reflectance() {
    for n in 0..=6 {
        let toward = Vec3::new(6.0, n as f32, 0.0).normalize();
        let li = whitted("tunnel", |_| Ray::new(Vec3::ZERO, toward), 16);
        assert!(
            (f64::from(li.r) - f64::powi(0.9, n)).abs() < 1e-6,
            "{n}: {li:?}"
        );
    }
}

#[test]
fn whitted_sees_no_light_between_diffuse_walls() {
    // The ceiling of the Cornell box is lit by other walls only.
    let up = |_: &halfdisk::scene::Scene| {
        Ray::new(Vec3::ZERO, Vec3::new(0.0, 270.0, 1000.0).normalize())
    };
    assert_eq!(whitted("cornell", up, 8), Rgb::BLACK);
}

#[test]
fn the_picture_from_the_light_is_the_picture_from_the_eye() {
    let mut scene = gallery::load("lamp").unwrap();
    scene.size = [4, 3];
    let view = TwoWays::new(&scene, 0.5).unwrap();
    let [light, eye] = view.both(160_000, 5);
    let z = compare::z_scores(&light.film.picture(), &eye.film.picture()).unwrap();
    assert!(z.largest <= 4.4, "{z:?}");
    let ((a, error_a), (b, error_b)) = (light.film.mean(), eye.film.mean());
    let error = (error_a * error_a + error_b * error_b).sqrt();
    println!(
        "means {a:.5} and {b:.5}, detects {:.2} %",
        400.0 * error / b
    );
    assert!((a - b).abs() <= 4.0 * error, "{a} {b} ± {error}");
    // The mistake of a pupil with another radius in the weight than in the test: four times.
    let wide = TwoWays { pupil: 1.0, ..view };
    let wide = wide.picture_by_light(2_000_000, 5).film.picture();
    assert!(
        compare::z_scores(&wide, &eye.film.picture())
            .unwrap()
            .largest
            > 4.4
    );
}
