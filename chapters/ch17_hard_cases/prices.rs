//! How long ours takes, for the time of the plain form.

use crate::cases::numbers;
use glam::Vec3;
use halfdisk::experiment::stopwatch::in_turns;
use halfdisk::geometry::{Aabb, PreparedRay, Ray, Sphere, Triangle};
use halfdisk::numeric::{self, naive};
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::warps;
use halfdisk::stats::Estimate;

/// A routine, and the time of ours over that of the plain form.
pub struct Price {
    pub name: &'static str,
    pub says: &'static str,
    pub ratio: Estimate,
}

/// The prices of all routines, each called `n` times in each of so many rounds.
pub fn all(n: usize, rounds: u32, seed: u64) -> Vec<Price> {
    let mut numbers = numbers(seed, 4);
    let mut point = || warps::sample_sphere(numbers.two());
    let rays: Vec<(Ray, PreparedRay)> = (0..n)
        .map(|_| {
            let (from, aim) = (point() * 3.0, point() * 1.1);
            let ray = Ray::new(from, (aim - from).normalize());
            (ray, PreparedRay::from(&ray))
        })
        .collect();
    let xs: Vec<f32> = rays.iter().map(|(ray, _)| ray.direction.x.abs()).collect();
    let sphere = Sphere::new(Vec3::ZERO, 1.0);
    let [a, b, c] = [Vec3::X, Vec3::Y, Vec3::new(-1.0, -1.0, 0.5)];
    let triangle = Triangle { a, b, c };
    let unit = Aabb::of([a, b, c]);
    let sum = |f: &dyn Fn(&(Ray, PreparedRay)) -> f32| rays.iter().map(f).sum::<f32>();
    let of = |name, says, plain: &dyn Fn() -> f32, ours: &dyn Fn() -> f32| Price {
        name,
        says,
        ratio: in_turns(rounds, plain, ours),
    };
    vec![
        of(
            "sphere",
            "a ray and a sphere",
            &|| {
                sum(&|(r, _)| {
                    naive::sphere_after(r.origin, r.direction, Vec3::ZERO, 1.0, 0.0).unwrap_or(0.0)
                })
            },
            &|| sum(&|(_, p)| sphere.cross(p, f32::MAX).map_or(0.0, |x| x.t)),
        ),
        of(
            "triangle",
            "a ray and a triangle",
            &|| sum(&|(r, _)| naive::triangle(r.origin, r.direction, [a, b, c]).unwrap_or(0.0)),
            &|| sum(&|(_, p)| triangle.cross(p, f32::MAX).map_or(0.0, |x| x.t)),
        ),
        of(
            "slab",
            "a ray and a box",
            &|| {
                sum(&|(r, _)| {
                    f32::from(u8::from(naive::slab(
                        r.origin,
                        r.direction,
                        unit.min,
                        unit.max,
                    )))
                })
            },
            &|| sum(&|(_, p)| unit.entry(p, f32::MAX).unwrap_or(0.0)),
        ),
        of(
            "cone",
            "one minus a cosine",
            &|| xs.iter().map(|x| naive::one_minus_cos(*x)).sum(),
            &|| xs.iter().map(|x| numeric::one_minus_cos(*x)).sum(),
        ),
        of(
            "weights",
            "the power heuristic",
            &|| xs.iter().map(|x| naive::power_weight(*x, 0.5)).sum(),
            &|| xs.iter().map(|x| Heuristic::Power.weight(*x, 0.5)).sum(),
        ),
        of(
            "variance",
            "a sample into mean and variance",
            &|| naive::variance(xs.iter().copied()),
            &|| {
                let all: Estimate = xs.iter().map(|x| f64::from(*x)).collect();
                all.variance() as f32
            },
        ),
    ]
}
