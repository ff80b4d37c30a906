//! Rectangles by solid angle: closed forms, variances, and cells of equal size on the lamp.

use super::{GROUND, irradiance, irradiance_by, polygon, scene};
use crate::checks::CRITICAL;
use crate::pairs::{Domain, Rectangle, deviates, follows};
use glam::{DVec3, Vec3};
use halfdisk::color::Rgb;
use halfdisk::geometry::{Quad, Surface};
use halfdisk::lights::{Incident, Light, QuadLight};
use halfdisk::sampling::spherical_rectangle::SphericalRectangle;
use halfdisk::stats::Estimate;
use std::f64::consts::PI;

fn lamp(corner: [f64; 3], u: DVec3, v: DVec3) -> QuadLight {
    QuadLight::new(Quad::new(DVec3::from(corner), u, v).unwrap(), Rgb::WHITE)
}

/// The unit square, centred above the ground, facing down.
fn square(h: f64) -> QuadLight {
    lamp([-0.5, h, -0.5], DVec3::X, DVec3::Z)
}

fn by_area(light: &QuadLight, from: &Surface, samples: u32) -> Estimate {
    irradiance_by(from, samples, |u| {
        let sample = light.sample_area(from, u)?;
        Some((sample.wi, sample.incident))
    })
}

fn relative_variance(e: &Estimate) -> f64 {
    e.variance() / e.mean().powi(2)
}

#[test]
fn a24_a_square_at_any_height() {
    // The corner formula, four times around the middle; below, the relative variances by solid
    // angle and by area. By area it is A / (3π h²) - 1 close to the lamp, by solid angle at most
    // 1/3.
    for (h, by_angle, by_points) in [
        (10.0, None, None),
        (1.0, Some(0.0019), Some(0.0303)),
        (0.1, Some(0.163), Some(10.3)),
        (0.01, Some(0.310), None),
        (1e-3, Some(1.0 / 3.0), None),
    ] {
        let x = 0.5 / f64::from(h as f32);
        let r = (1.0 + x * x).sqrt();
        let truth = 4.0 * x / r * libm::atan(x / r);
        let light = Light::Quad(square(h));
        let e = irradiance(&light, &GROUND, 400_000);
        let points = by_area(&square(h), &GROUND, 400_000);
        println!(
            "h = {h}: E {:.6}, exact {truth:.6}, z {:+.2}, relative variance {:.2e}, by area {:.2e}",
            e.mean(),
            e.z(truth),
            relative_variance(&e),
            relative_variance(&points)
        );
        assert!(e.z(truth).abs() <= CRITICAL, "h = {h}: {e:?} for {truth}");
        for (e, expected) in [(&e, by_angle), (&points, by_points)] {
            let Some(expected) = expected else { continue };
            let ratio = relative_variance(e) / expected;
            assert!((ratio - 1.0).abs() < 0.2, "h = {h}: {ratio}");
        }
        // The mistake of a density that is 7 % off.
        let wrong = irradiance_by(&GROUND, 400_000, |u| {
            let sample = light.sample(&GROUND, 0.5, u)?;
            let Incident::Radiance { li, pdf } = sample.incident else {
                return None;
            };
            let incident = Incident::Radiance {
                li,
                pdf: 1.07 * pdf,
            };
            Some((sample.wi, incident))
        });
        assert!(wrong.z(truth).abs() > CRITICAL);
    }
}

#[test]
fn points_follow_the_solid_angle() {
    for (name, x, y, z) in [
        ("overhead", [-0.5, 0.5], [-0.5, 0.5], 0.3),
        ("aside", [0.2, 1.2], [-2.0, -0.4], 0.5),
        ("an edge above the foot", [0.0, 1.0], [0.0, 2.0], 0.2),
        ("grazing", [1.0, 2.0], [0.5, 2.5], 1e-3),
        ("long", [-30.0, 30.0], [0.1, 0.3], 1.0),
        ("far", [700.0, 701.0], [300.0, 302.0], 100.0),
    ] {
        let seen = SphericalRectangle::new(x, y, z);
        let domain = Rectangle([x, y]);
        let density = |[p, q]: [f64; 2]| seen.pdf() * z / libm::pow(p * p + q * q + z * z, 1.5);
        follows(name, &domain, |u| seen.sample(u), density);
        // Uniform in area; from far away there is no difference.
        if name != "far" {
            let by_area = |u: [f32; 2]| domain.point(u.map(f64::from));
            deviates(name, "chi2", &domain, by_area, density);
        }
    }
}

#[test]
fn no_light_edge_on_behind_and_on_the_lamp() {
    let tilted = |h: f32| Surface {
        p: Vec3::new(0.1, h, 0.2),
        error: Vec3::splat(1e-7),
        n: Vec3::Y,
        time: 0.0,
    };
    let light = Light::Quad(square(1.0));
    let aside = Surface {
        p: Vec3::new(3.0, 1.0, 0.2),
        ..tilted(0.0)
    };
    for from in [tilted(1.0), tilted(1.0 - 1e-7), tilted(1.5), aside] {
        assert_eq!(irradiance(&light, &from, 1000).mean(), 0.0);
        let at = square(1.0).quad().surface_at(0.5, 0.5);
        let wi = (at.p - from.p).try_normalize().unwrap_or(Vec3::Y);
        assert_eq!(light.pdf(&from, wi, Some(&at)), 0.0);
    }
    // As close as it gets before it, and nearly edge-on: finite, and at most the half sphere.
    for (h, off) in [
        (0.999, 0.005),
        (0.999_9, 0.01),
        (0.999_99, 0.02),
        (0.999_999, 0.3),
    ] {
        let e = irradiance(&light, &tilted(h), 10_000);
        let slack = CRITICAL * e.std_error() + off * PI;
        assert!((e.mean() - PI).abs() < slack, "{h}: {e:?}");
        let low = Surface {
            p: Vec3::new(3.0, h, 0.2),
            ..tilted(0.0)
        };
        let e = irradiance(&light, &low, 10_000);
        assert!(e.mean() >= 0.0 && e.mean() < 0.01, "{h}: {e:?}");
    }
}

#[test]
fn other_parallelograms_by_area() {
    let (u, v) = (DVec3::new(1.0, 0.2, 0.0), DVec3::new(0.4, 0.1, 1.0));
    let sheared = lamp([-0.4, 0.7, -0.3], u, v);
    let corners = sheared.quad().corners().map(|c| c.as_dvec3());
    let truth = polygon(&corners, DVec3::Y);
    let e = irradiance(&Light::Quad(sheared), &GROUND, 400_000);
    println!(
        "parallelogram: {} for {truth}, z {:+.2}",
        e.mean(),
        e.z(truth)
    );
    assert!(e.z(truth).abs() <= CRITICAL, "{e:?} for {truth}");
    assert_eq!(e, by_area(&sheared, &GROUND, 400_000));
    // The mistake of a density per solid angle without the cosine at the lamp.
    let wrong = irradiance_by(&GROUND, 400_000, |u| {
        let sample = sheared.sample_area(&GROUND, u)?;
        let Incident::Radiance { li, pdf } = sample.incident else {
            return None;
        };
        let pdf = pdf * -sheared.quad().normal().dot(sample.wi);
        Some((sample.wi, Incident::Radiance { li, pdf }))
    });
    assert!(wrong.z(truth).abs() > CRITICAL, "{wrong:?}");
    // A twisted point of view makes no rectangle of it, nor does it unmake one.
    let square = lamp([-0.4, 0.7, -0.3], DVec3::new(0.6, 0.8, 0.0), DVec3::Z);
    let truth = polygon(&square.quad().corners().map(|c| c.as_dvec3()), DVec3::Y);
    let e = irradiance(&Light::Quad(square), &GROUND, 400_000);
    assert!(e.z(truth).abs() <= CRITICAL, "{e:?} for {truth}");
    assert_ne!(e, by_area(&square, &GROUND, 400_000));
}

#[test]
fn both_ways_meet_where_the_lamp_is_tiny() {
    // 1e-6 sr is a unit square at 1000: on either side of that distance the same light.
    for distance in [300.0, 990.0, 1010.0, 1e5] {
        let light = Light::Quad(square(distance));
        let e = irradiance(&light, &GROUND, 1000);
        let truth = polygon(
            &square(distance).quad().corners().map(|c| c.as_dvec3()),
            DVec3::Y,
        );
        assert!((e.mean() / truth - 1.0).abs() < 1e-5, "{distance}: {e:?}");
    }
}

#[test]
fn a_lamp_in_a_scene_is_aimed_at_by_solid_angle() {
    let room = scene(
        "[[objects]]\nemits = 1\nquad = { corner = [-0.5, 0.01, -0.5], u = [1, 0, 0], v = [0, 0, 1] }",
    );
    let e = irradiance(&room.lights[0], &GROUND, 10_000);
    assert!(relative_variance(&e) < 0.4, "{e:?}");
}
