//! Round lamps of any size, from any distance, and lamps that are none.

use super::{GROUND, irradiance, scene};
use crate::checks::CRITICAL;
use glam::{DVec3, Vec3};
use halfdisk::color::Rgb;
use halfdisk::geometry::{Sphere, Surface};
use halfdisk::integrators::NextEvent;
use halfdisk::lights::{Incident, Light, PointLight, SphereLight};
use halfdisk::numeric::gamma;
use halfdisk::render::{Options, render};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, gallery};
use halfdisk::stats::kolmogorov_smirnov::kolmogorov_smirnov;
use std::f64::consts::{PI, TAU};

fn lamp(center: Vec3, radius: f32) -> Light {
    Light::Sphere(SphereLight {
        sphere: Sphere::new(center, radius),
        radiance: Rgb::WHITE,
    })
}

#[test]
fn a23_density_times_solid_angle_is_one() {
    let (mut worst, mut plain_failures) = (0.0_f64, 0);
    for k in 0..=15 {
        let radius = (0.99 * libm::pow(10.0, -f64::from(k))) as f32;
        let light = lamp(Vec3::Y, radius);
        let sin2 = f64::from(radius).powi(2);
        let solid_angle = TAU * sin2 / (1.0 + (1.0 - sin2).sqrt());
        for i in 0..1000 {
            let u = Stream::new(1, i, 0).at(0, Purpose::LightPoint).two();
            let sample = light.sample(&GROUND, 0.5, u).unwrap();
            let Incident::Radiance { pdf, .. } = sample.incident else {
                panic!()
            };
            worst = worst.max((f64::from(pdf) * solid_angle - 1.0).abs());
            // The point aimed at lies on the sphere, on the near side.
            let end = sample.shadow_ray.at(sample.shadow_ray.t_max).as_dvec3();
            let off = (end - DVec3::Y).length() - f64::from(radius);
            assert!(off.abs() < 1e-6, "{off:e} off a sphere of {radius}");
            let at = Surface {
                p: end.as_vec3(),
                n: -sample.wi,
                error: Vec3::ZERO,
                time: 0.0,
            };
            assert_eq!(light.pdf(&GROUND, sample.wi, Some(&at)), pdf);
        }
        // The difference of one and the cosine, in f32.
        let plain = TAU as f32 * (1.0 - (1.0 - radius * radius).sqrt());
        plain_failures += u32::from((f64::from(plain) / solid_angle - 1.0).abs() > 0.01);
        // Light of small lamps has no variance to speak of.
        let e = irradiance(&light, &GROUND, 1000);
        let truth = PI * sin2;
        let slack = CRITICAL * e.std_error() + 1e-5 * truth;
        assert!((e.mean() - truth).abs() < slack, "{radius}: {e:?}");
    }
    println!("worst {worst:e}, the plain form fails {plain_failures} times");
    assert!(
        worst < 1e-6 && plain_failures >= 12,
        "{worst:e} {plain_failures}"
    );
}

/// Directions are uniform in solid angle also to a ball that is small or far, and lead to its near side.
#[test]
fn a23_directions_to_balls_of_any_size_are_uniform() {
    let from = Surface {
        p: Vec3::new(3.0, 4.0, -12.0),
        error: Vec3::ZERO,
        n: Vec3::Z,
        time: 0.0,
    };
    let axis = -from.p.as_dvec3() / 13.0;
    let (across, beside) = axis.any_orthonormal_pair();
    for k in 0..=4 {
        let radius = 10.0 * libm::pow(10.0, -f64::from(k));
        let light = lamp(Vec3::ZERO, radius as f32);
        let sin2_max = (radius / 13.0).powi(2);
        let one_minus_cos = |sin2: f64| sin2 / (1.0 + (1.0 - sin2).sqrt());
        let (mut shares, mut angles) = (Vec::new(), Vec::new());
        for i in 0..5000 {
            let u = Stream::new(6, i, k).at(0, Purpose::LightPoint).two();
            let sample = light.sample(&from, 0.5, u).unwrap();
            // The end of the ray, next to the world's origin, tells which point of the ball it goes
            // to, and that the direction.
            let ray = &sample.shadow_ray;
            let length = f64::from(ray.t_max / (1.0 - gamma(8)));
            let end = ray.origin.as_dvec3() + ray.direction.as_dvec3() * length;
            let n = end.normalize();
            let toward = (n * radius - from.p.as_dvec3()).normalize();
            let share =
                one_minus_cos(toward.cross(axis).length_squared()) / one_minus_cos(sin2_max);
            assert!(n.dot(toward) < 1e-2, "radius {radius}: {n} is behind");
            shares.push(share.min(1.0));
            angles.push(libm::atan2(n.dot(across), n.dot(beside)));
            let off = (sample.wi.as_dvec3() - toward).length();
            assert!(off < 4e-7, "radius {radius}: {off:e} off");
        }
        let of_shares = kolmogorov_smirnov(&mut shares, |share| share);
        let of_angles = kolmogorov_smirnov(&mut angles, |angle| 0.5 + angle / TAU);
        // Ten comparisons, each at a level of one in a hundred thousand: where more than 3.5 % lie
        // on the wrong side of some circle or line, that is seen.
        assert!(
            of_shares.p > 1e-5 && of_angles.p > 1e-5,
            "radius {radius}: {of_shares:?} {of_angles:?}"
        );
    }
}

#[test]
fn a23_on_and_inside_it_is_dark_and_finite() {
    let light = lamp(Vec3::ZERO, 1.0);
    let ulp = f32::EPSILON;
    for distance in [0.0, 1e-30, 0.5, 1.0 - 0.5 * ulp, 1.0, 1.0 + ulp, 1.1] {
        let from = Surface {
            p: Vec3::new(0.0, distance, 0.0),
            error: Vec3::splat(2.0 * ulp),
            n: Vec3::NEG_Y,
            time: 0.0,
        };
        let e = irradiance(&light, &from, 1000);
        let at = Surface {
            n: Vec3::Y,
            p: Vec3::Y,
            ..from
        };
        let pdf = light.pdf(&from, Vec3::NEG_Y, Some(&at));
        assert!(e.mean().is_finite() && pdf.is_finite());
        assert_eq!(e.mean() > 0.0, distance > 1.01, "{distance}");
        assert_eq!(pdf > 0.0, distance > 1.01, "{distance}");
    }
}

#[test]
fn a25_a_point_light_on_the_surface_is_no_light() {
    let light = |position| {
        Light::Point(PointLight {
            position,
            intensity: Rgb::WHITE,
        })
    };
    assert!(light(Vec3::ZERO).sample(&GROUND, 0.5, [0.5; 2]).is_none());
    // So near that the square of the distance vanishes.
    assert!(
        light(Vec3::Y * 1e-30)
            .sample(&GROUND, 0.5, [0.5; 2])
            .is_none()
    );
    let near = light(Vec3::Y * 1e-10)
        .sample(&GROUND, 0.5, [0.5; 2])
        .unwrap();
    assert!(near.incident.facing_irradiance().is_finite());
    // On a corner of a mesh: a finite picture.
    let on_corner = scene(
        "[[objects]]\nmaterial = 'half'\ntriangle = { a = [-1, -1, 3], b = [0, 1, 3], c = [1, -1, 3] }\n\
         [[lights]]\npoint = { position = [0, 1, 3], intensity = 1 }",
    );
    assert_eq!(picture(&on_corner).1, 0);
}

fn picture(scene: &Scene) -> (halfdisk::render::Film, u64) {
    let options = Options {
        spp: 2,
        ..Options::default()
    };
    let rendered = render(scene, &NextEvent { max_depth: 3 }, &options, &());
    (rendered.film, rendered.non_finite)
}

#[test]
fn a07_degenerate_lamps_are_refused_or_absent() {
    let head = "name = 'test'\ncamera = { from = [0, 0, 0], to = [0, 0, 1], fov = 40 }\n\
                film.size = [16, 16]\nmaterials.half.lambert.albedo = 0.5\n\
                [[objects]]\nmaterial = 'half'\nsphere = { center = [0, 0, 5], radius = 1 }\n\
                [[lights]]\npoint = { position = [0, 3, 3], intensity = 9 }\n";
    let folder = tempfile::tempdir().unwrap();
    // Corners that coincide, lie on a line, or are too close for an area.
    let obj = "v 0 2 4\nv 0 2 4\nv 1 2 4\nv 2 2 4\nv 0 2 4.000001\nf 1 2 3\nf 1 3 4\nf 1 1 1\n";
    std::fs::write(folder.path().join("nothing.obj"), obj).unwrap();
    let one = format!("{obj}v 0 9 4\nv 1 9 5\nf 1 6 7\n");
    std::fs::write(folder.path().join("one.obj"), one).unwrap();
    let load = |more: &str| {
        let text = format!("{head}{more}");
        let source = Source {
            file: "test.toml",
            text: &text,
        };
        gallery::from_text(source, Some(folder.path()), |_| {})
    };
    let nothing = load("[[objects]]\nemits = 5\nmesh.file = 'nothing.obj'\n").unwrap_err();
    let complaint = nothing.to_string();
    assert!(
        complaint.contains("no triangle with an area"),
        "{complaint}"
    );
    let one = load("[[objects]]\nemits = 5\nmesh.file = 'one.obj'\n").unwrap();
    assert_eq!((one.lights.len(), one.report.degenerate_triangles), (2, 3));
    for (lamp, complaint) in [
        (
            "emits = 1\nsphere = { center = [0, 2, 4], radius = 0 }",
            "must be greater than 0",
        ),
        (
            "emits = 1\nquad = { corner = [0, 2, 4], u = [1, 0, 0], v = [2, 0, 0] }",
            "has no area",
        ),
        (
            "emits = 1\ntriangle = { a = [0, 0, 0], b = [1, 0, 0], c = [2, 0, 0] }",
            "has no area",
        ),
        (
            "emits = 0\nsphere = { center = [0, 2, 4], radius = 1 }",
            "gives no light at all",
        ),
        (
            "emits = nan\nsphere = { center = [0, 2, 4], radius = 1 }",
            "0 or more",
        ),
    ] {
        let error = load(&format!("[[objects]]\n{lamp}\n"))
            .unwrap_err()
            .to_string();
        assert!(error.contains(complaint), "{error}");
    }
}
