//! Rays that leave a light bring as much to a receiver as the light gives where it is sampled from there.

use super::environment::{image, light};
use super::{GROUND, scene};
use crate::checks::{alike, of, unlike};
use glam::{Vec2, Vec3};
use halfdisk::geometry::{Aabb, Ray, Surface};
use halfdisk::lights::{BoundingSphere, EmissionSample, EmissionUniforms, Light, Targets};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::stats::Estimate;

/// The receiver: a square of this side around the origin, facing up.
const SIDE: f32 = 2.0;
const AWAY: Vec3 = Vec3::new(0.3, 0.4, -0.2);

fn around() -> BoundingSphere {
    BoundingSphere::of(Aabb::of([Vec3::splat(-1.5), Vec3::splat(1.5)]))
}

fn uniforms(index: u32) -> EmissionUniforms {
    let mut u = Stream::new(12, index, 0).at(0, Purpose::Emission);
    let pick = Stream::new(12, index, 0).at(0, Purpose::Branch).fine();
    let (place, direction) = (u.two(), u.two());
    EmissionUniforms {
        pick,
        place,
        direction,
    }
}

/// Where a ray falls on the receiver.
fn falls(ray: &Ray) -> Option<Vec2> {
    let t = -ray.origin.y / ray.direction.y;
    let p = ray.at(t);
    let inside = 0.5 * SIDE >= p.x.abs() && 0.5 * SIDE >= p.z.abs();
    (ray.direction.y < 0.0 && t > 0.0 && inside).then_some(Vec2::new(p.x, p.z))
}

/// The mean irradiance of the receiver, weighted by `1 + x`, by rays that leave the light.
fn emitted(light: &Light, rays: u32, power: impl Fn(&EmissionSample) -> f32) -> Estimate {
    let one = |i| {
        let sample = light.sample_emission(&around(), AWAY, uniforms(i));
        let reached = sample.and_then(|sample| Some((falls(&sample.ray)?, power(&sample))));
        reached.map_or(0.0, |(p, power)| {
            f64::from((1.0 + p.x) * power / (SIDE * SIDE))
        })
    };
    (0..rays).map(one).collect()
}

/// The same by sampling the light from uniform points of the receiver.
fn sampled(light: &Light, points: u32) -> Estimate {
    let one = |i| {
        let stream = Stream::new(13, i, 0);
        let [x, z] = stream
            .at(0, Purpose::Integrand)
            .two()
            .map(|u| SIDE * (u - 0.5));
        let from = Surface {
            p: Vec3::new(x, 0.0, z),
            ..GROUND
        };
        let mut numbers = stream.at(0, Purpose::LightPoint);
        let (u, pick) = (numbers.two(), numbers.fine());
        let sample = light.sample_moved(AWAY, &from, pick, u);
        let irradiance = sample.map_or(0.0, |s| s.incident.facing_irradiance().g * s.wi.y.max(0.0));
        f64::from((1.0 + x) * irradiance)
    };
    (0..points).map(one).collect()
}

fn lights() -> Vec<(&'static str, Light)> {
    let mut all: Vec<(&str, Light)> = [
        ("point", "[[lights]]\npoint = { position = [0.2, 1, 0], intensity = 3 }"),
        ("direction", "[[lights]]\ndirectional = { direction = [0.3, -1, 0.2], irradiance = 5 }"),
        ("sky", "[environment]\nradiance = 2"),
        ("sphere", "[[objects]]\nemits = 2\nsphere = { center = [0, 1.4, 0], radius = 0.4 }"),
        ("room", "[[objects]]\nemits = 2\nsphere = { center = [0, 0, 0], radius = 3, inward = true }"),
        ("quad", "[[objects]]\nemits = 2\nquad = { corner = [-0.5, 1, 0], u = [1, 0, 0], v = [0, 0, 1] }"),
        ("two sides", "[[objects]]\nemits = 2\ntwo_sided = true\nquad = { corner = [-0.5, 1, 0], u = [1, 0.5, 0], v = [0.2, 0, 1] }"),
        ("triangle", "[[objects]]\nemits = 2\ntriangle = { a = [-0.5, 1, 0], b = [1, 1.2, 0], c = [0, 0.9, 1] }"),
        ("both of a triangle", "[[objects]]\nemits = 2\ntwo_sided = true\ntriangle = { a = [-0.5, 1, 0], c = [1, 1.2, 0], b = [0, 0.9, 1] }"),
        ("mesh", "[[objects]]\nemits = 2\nbumpy_sphere = { center = [0, 1.5, 0], radius = 0.5, columns = 8, rows = 6 }"),
    ]
    .map(|(name, text)| (name, scene(text).lights[0].clone()))
    .into();
    let pixels = image(8, 4, |row, column| {
        if row < 2 {
            (1 + column * 3 % 5) as f32
        } else {
            0.5
        }
    });
    all.push(("image", Light::Environment(light(8, pixels, 0.3))));
    all
}

#[test]
fn rays_that_leave_bring_what_sampling_finds() {
    for (name, light) in lights() {
        let found = sampled(&light, 400_000);
        let brought = emitted(&light, 2_000_000, |sample| sample.power().g);
        alike(name, of(&brought), of(&found), 0.03);
        // The mistakes: one side for two, a uniform instead of a cosine's density.
        let half = emitted(&light, 2_000_000, |sample| 0.5 * sample.power().g);
        unlike(name, of(&half), of(&found));
        let flat = emitted(&light, 2_000_000, |sample| {
            2.0 * sample.power().g * sample.n.dot(sample.ray.direction)
        });
        unlike(
            &format!("{name}, by another density"),
            of(&flat),
            of(&found),
        );
    }
}

#[test]
fn the_power_of_a_light_is_the_mean_of_its_rays() {
    for (name, light) in lights() {
        let power: Estimate = (0..200_000)
            .map(|i| {
                let sample = light.sample_emission(&around(), Vec3::ZERO, uniforms(i));
                let channels = sample.map_or([0.0; 3], |s| s.power().channels());
                channels.map(f64::from).iter().sum::<f64>() / 3.0
            })
            .collect();
        let told = light.power(&around());
        alike(name, of(&power), (told, 0.0), 0.02);
    }
}

#[test]
fn every_ray_leaves_on_a_side_that_shines_and_towards_the_scene() {
    for (name, light) in lights() {
        for i in 0..10_000 {
            let Some(sample) = light.sample_emission(&around(), Vec3::ZERO, uniforms(i)) else {
                panic!("{name}: nothing");
            };
            assert!(
                sample.ray.is_valid() && sample.power().is_finite(),
                "{name}"
            );
            assert!((sample.ray.direction.length() - 1.0).abs() < 1e-6, "{name}");
            assert!(
                sample.n.dot(sample.ray.direction) >= 0.0,
                "{name}: {sample:?}"
            );
            if light.fluence_from_afar() > 0.0 {
                let ball = around();
                let nearest = sample
                    .ray
                    .at((ball.center - sample.ray.origin).dot(sample.ray.direction));
                assert!(
                    (nearest - ball.center).length() <= ball.radius * 1.0001,
                    "{name}"
                );
                assert!(
                    (sample.ray.origin - ball.center).length() >= ball.radius * 0.9999,
                    "{name}"
                );
            }
        }
    }
}

/// The power that passes balls, weighted by where: `1 + x` of the point of the ray that is nearest to the origin.
fn passing(balls: &[BoundingSphere], sample: &EmissionSample) -> f64 {
    let ray = &sample.ray;
    let meets = |ball: &BoundingSphere| {
        let t = (ball.center - ray.origin).dot(ray.direction);
        let near = (ray.at(t) - ball.center).length() < ball.radius;
        near && t > 0.0 || (ray.origin - ball.center).length() < ball.radius
    };
    let nearest = ray.at(-ray.origin.dot(ray.direction));
    match balls.iter().any(meets) {
        true => f64::from(sample.power().g * (1.0 + 0.2 * nearest.x)),
        false => 0.0,
    }
}

/// Balls that are apart, that overlap, and one around everything.
fn targets() -> [(&'static str, Vec<BoundingSphere>); 3] {
    let ball = |x, y, z, radius| BoundingSphere {
        center: Vec3::new(x, y, z),
        radius,
    };
    let apart = vec![ball(-0.4, -0.9, 0.3, 0.3), ball(0.9, -0.5, -0.8, 0.1)];
    let [over, under] = [ball(-0.4, -0.9, 0.3, 0.5), ball(0.1, -0.8, 0.2, 0.4)];
    [
        ("apart", apart),
        ("one over the other", vec![over, under]),
        ("around all", vec![over, around()]),
    ]
}

#[test]
fn rays_that_are_aimed_bring_what_those_bring_that_are_not() {
    for (name, light) in lights() {
        for (where_, balls) in targets() {
            let name = format!("{name}, {where_}");
            let plain: Estimate = (0..900_000)
                .map(|i| {
                    let sample = light.sample_emission(&around(), AWAY, uniforms(i));
                    sample.map_or(0.0, |sample| passing(&balls, &sample))
                })
                .collect();
            let aims = Targets::new(balls.clone());
            let aimed = |weight: &dyn Fn(&EmissionSample) -> f64| -> Estimate {
                let one = |i: u32| {
                    let aim = Stream::new(14, i, 0).at(0, Purpose::Direction).one();
                    let u = uniforms(i);
                    let sample = light.sample_emission_towards(&aims, &around(), AWAY, u, aim);
                    sample.map_or(0.0, |sample| passing(&balls, &sample) * weight(&sample))
                };
                (0..200_000).map(one).collect()
            };
            let found = aimed(&|_| 1.0);
            alike(&name, of(&found), of(&plain), 0.15);
            if where_ == "apart" {
                assert!(found.variance() < plain.variance(), "{name}");
            }
            // The mistake: what both balls hold is counted for each.
            if where_ == "one over the other" {
                let twice = aimed(&|sample| {
                    let each = balls.iter().filter(|&&ball| passing(&[ball], sample) > 0.0);
                    each.count() as f64
                });
                unlike(&format!("{name}, twice"), of(&twice), of(&plain));
            }
        }
    }
}

#[test]
fn nothing_is_aimed_at_where_there_is_nothing() {
    for (name, light) in lights() {
        let none = Targets::default();
        let sample = light.sample_emission_towards(&none, &around(), AWAY, uniforms(0), 0.5);
        assert!(sample.is_none(), "{name}");
    }
}
