//! Whatever the numbers are, answers are sound: shapes, warps, materials, lights, cameras, trees.
//!
//! The tests draw some thousands of cases each, from fixed seeds. Those named `long_` draw as many as
//! one waits an hour for, and are asked for by name: `cargo test --release -- --ignored long_`.

use super::hierarchy::{compare, garbage};
use glam::{DVec3, Vec3};
use halfdisk::camera::{Camera, Lens};
use halfdisk::color::Rgb;
use halfdisk::geometry::{PreparedRay, Quad, Ray, Shape, Sphere, Surface, Triangle};
use halfdisk::lights::{
    DirectionalLight, Incident, Light, PointLight, QuadLight, SphereLight, TriangleLight,
};
use halfdisk::materials::{Bsdf, Glass, Lambert, Mirror, Mixture};
use halfdisk::sampling::{LAST_UNIFORM, half_disk, hemisphere, stream::Stream, warps};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use rayon::prelude::*;

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        rng_seed: RngSeed::Fixed(7),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

/// A finite number of nearly any size, zeros and the smallest included. Beyond 1e30 sums of points
/// leave the numbers.
fn number() -> impl Strategy<Value = f32> {
    prop_oneof![
        8 => (-1.0..1.0_f32, -12.0..12.0_f32).prop_map(|(x, e)| x * libm::powf(10.0, e)),
        4 => -2.0..2.0_f32,
        1 => any::<f32>().prop_map(|x| if x.abs() < 1e30 { x } else { 0.0 }),
        1 => prop::sample::select(vec![0.0, -0.0, 1.0, -1.0, 1e-45, 1e-38, 1e19, 1e30]),
    ]
}

fn vector() -> impl Strategy<Value = Vec3> {
    [number(), number(), number()].prop_map(Vec3::from_array)
}

fn uniform() -> impl Strategy<Value = f32> {
    prop_oneof![
        6 => (0..1_u32 << 24).prop_map(|k| k as f32 / 16_777_216.0),
        1 => prop::sample::select(vec![0.0, 0.5, LAST_UNIFORM, f32::EPSILON / 2.0]),
    ]
}

fn unit() -> impl Strategy<Value = Vec3> {
    [uniform(), uniform()].prop_map(warps::sample_sphere)
}

fn shape() -> impl Strategy<Value = Option<Shape>> {
    (0..3, vector(), vector(), vector()).prop_map(|(kind, a, b, c)| match kind {
        0 => {
            let sphere = Sphere::new(a, b.x.abs());
            let proper = sphere.radius > 0.0 && sphere.bounds().is_finite();
            proper.then_some(Shape::Sphere(sphere))
        }
        1 => Quad::new(a.as_dvec3(), b.as_dvec3(), c.as_dvec3()).map(Shape::Quad),
        _ => {
            let triangle = Triangle { a, b, c };
            triangle.is_proper().then_some(Shape::Triangle(triangle))
        }
    })
}

/// Where a shape is crossed, its point is in its box, as nearly as `f32` can tell.
fn sound_shape(shape: &Shape, ray: &Ray) -> Result<(), TestCaseError> {
    let Some(x) = shape.intersect(&PreparedRay::from(ray), f32::MAX) else {
        return Ok(());
    };
    prop_assert!(ray.is_valid() && x.t > 0.0 && x.t < f32::INFINITY, "{x:?}");
    let at = shape.surface(ray, x);
    prop_assert!((at.n.length() - 1.0).abs() < 1e-5, "{at:?}");
    if at.error.is_finite() {
        prop_assert!(at.p.is_finite(), "{at:?}");
        let bounds = shape.bounds();
        // Along a triangle its weights are as coarse as numbers near 1.
        let slack = at.error * 1.01 + (bounds.max - bounds.min) * 1e-6 + Vec3::splat(1e-44);
        let inside = at.p.cmpge(bounds.min - slack) & at.p.cmple(bounds.max + slack);
        prop_assert!(inside.all(), "{at:?} {bounds:?}");
    }
    Ok(())
}

/// What a light sends is finite, of the right sign, and has the density it says.
fn sound_light(light: &Light, from: &Surface, u: [f32; 2]) -> Result<(), TestCaseError> {
    let Some(sample) = light.sample(from, 0.5, u) else {
        return Ok(());
    };
    prop_assert!((sample.wi.length() - 1.0).abs() < 1e-4, "{sample:?}");
    if let Incident::Radiance { pdf, .. } = sample.incident {
        prop_assert!(pdf > 0.0 && pdf < f32::INFINITY, "{sample:?}");
    }
    let facing = sample.incident.facing_irradiance();
    prop_assert!(facing.r >= 0.0 && !facing.r.is_nan(), "{sample:?}");
    Ok(())
}

proptest! {
    #![proptest_config(config(20_000))]

    #[test]
    fn shapes(shape in shape(), origin in vector(), aim in vector(), k in uniform()) {
        if let Some(shape) = shape {
            let b = shape.bounds();
            let target = b.min * (1.0 - k) + b.max * k;
            let towards = (target.as_dvec3() - origin.as_dvec3()).normalize_or(DVec3::X);
            for direction in [aim, towards.as_vec3()] {
                sound_shape(&shape, &Ray::new(origin, direction))?;
            }
        }
    }

    #[test]
    fn warps_of_all_uniforms(u in [uniform(), uniform()], cone in 0.0..1.0_f32, n in 0.5..1e4_f32) {
        for w in [
            warps::sample_sphere(u),
            hemisphere::sample_uniform(u),
            hemisphere::sample_cosine(u),
            hemisphere::sample_cos_n(u, n),
            warps::sample_cone(u, cone.max(1e-30)),
        ] {
            prop_assert!((w.length() - 1.0).abs() < 1e-5, "{w}");
        }
        prop_assert!(hemisphere::pdf_cosine(hemisphere::sample_cosine(u)) > 0.0);
        for w in [half_disk::sample_uniform(u[0]), half_disk::sample_cosine(u[0])] {
            prop_assert!(w.y >= 0.0 && (w.length() - 1.0).abs() < 1e-6, "{w}");
        }
        for p in [warps::sample_disk(u), warps::sample_disk_concentric(u)] {
            prop_assert!(warps::pdf_disk(p) > 0.0, "{p}");
        }
        let [b, c] = warps::sample_triangle(u);
        prop_assert!(b >= 0.0 && c >= 0.0 && b + c <= 1.0 + 1e-6);
    }

    #[test]
    fn materials(wo in unit(), wi in unit(), choice in uniform(), u in [uniform(), uniform()],
                 k in [0.0..1.0_f32, 0.0..1.0_f32, 0.0..1.0_f32], ior in 0.1..10.0_f32) {
        let [kd, ks, kt] = k.map(|k| Rgb::grey(k / k.max(1.0) / 3.0));
        for material in [
            Bsdf::Lambert(Lambert { albedo: kd }),
            Bsdf::Mirror(Mirror { reflectance: ks }),
            Bsdf::Glass(Glass { ior }),
            Bsdf::Mixture(Mixture { kd, ks, kt, ior }),
        ] {
            prop_assert!(material.f(wo, wi).is_finite() && material.pdf(wo, wi) >= 0.0);
            if let Some(next) = material.scatter(wo, choice, u) {
                prop_assert!((next.wi.length() - 1.0).abs() < 1e-5, "{material:?} {next:?}");
                prop_assert!(next.weight.max_channel() <= 1.0 + 1e-6, "{material:?} {next:?}");
                prop_assert!(next.pdf.is_none_or(|p| p > 0.0), "{material:?} {next:?}");
            }
        }
    }

    #[test]
    fn lights(shape in shape(), p in vector(), n in unit(), u in [uniform(), uniform()]) {
        let from = Surface { p, error: p.abs() * 1e-6, n, time: 0.0 };
        let radiance = Rgb::WHITE;
        let light = match shape {
            Some(Shape::Sphere(sphere)) => Light::Sphere(SphereLight { sphere, radiance }),
            Some(Shape::Quad(quad)) => Light::Quad(QuadLight::new(quad, radiance)),
            Some(Shape::Triangle(triangle)) => Light::Triangle(TriangleLight { triangle, radiance, two_sided: false }),
            None if u[0] < 0.5 => Light::Point(PointLight { position: n, intensity: radiance }),
            None => Light::Directional(DirectionalLight { from: n, irradiance: radiance }),
        };
        sound_light(&light, &from, u)?;
    }

    #[test]
    fn cameras(forward in vector(), up in vector(), fov in 1e-3..3.1_f64, aspect in 1e-3..1e3_f64,
               radius in 0.0..1e3_f32, focus in 1e-6..1e30_f32, film in [uniform(), uniform()], i in 0..9_u32) {
        let [forward, up] = [forward, up].map(Vec3::as_dvec3);
        if let Some(camera) = Camera::new(Vec3::ZERO, forward, up, fov, aspect) {
            let lens = (radius > 0.0).then_some(Lens { radius, focus });
            let ray = camera.with_lens(lens).sample_ray(film[0], film[1], &Stream::new(1, 2, i));
            prop_assert!(ray.is_valid(), "{camera:?} {ray:?}");
            prop_assert!((ray.direction.length() - 1.0).abs() < 1e-5, "{camera:?} {ray:?}");
        }
    }
}

#[test]
fn trees_of_garbage() {
    let hits: usize = (0..100).map(|seed| garbage(seed, 200)).sum();
    println!("100 scenes of random bits: {hits} of 20 000 rays hit, the tree as the loop");
    assert!(hits > 1000);
}

#[test]
#[ignore = "takes minutes: ask for it by name"]
fn long_a_hundred_million_rays_through_garbage() {
    let start = std::time::Instant::now();
    for pass in 0..10 {
        let scenes = (1000 * pass..1000 * (pass + 1)).into_par_iter();
        let hits: usize = scenes.map(|seed| garbage(seed, 10_000)).sum();
        println!(
            "10^7 rays through scenes of random bits {} to {}: {hits} hits, the tree as the loop, {:?}",
            1000 * pass,
            1000 * pass + 999,
            start.elapsed()
        );
        assert!(hits > 1_000_000);
    }
}

#[test]
fn a_tree_that_is_wrong_is_noticed() {
    let ball = |x: f32| Shape::Sphere(Sphere::new(Vec3::X * x, 1.0));
    let ray = Ray::new(Vec3::Z * 5.0, Vec3::NEG_Z);
    let caught = std::panic::catch_unwind(|| {
        super::hierarchy::compare_with("wrong", &[ball(0.0)], &[ball(9.0)], [ray])
    });
    assert!(caught.is_err());
    assert_eq!(compare("right", &[ball(0.0)], [ray]), 1);
}
