//! What robustness costs: the plain form of each computation, and ours, on the same input.
#![allow(missing_docs)]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use glam::Vec3;
use halfdisk::geometry::{Aabb, PreparedRay, Ray, Sphere, Triangle};
use halfdisk::numeric::{gamma, naive, offset_origin};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::sampling::warps;
use halfdisk::stats::Estimate;

/// How often each form is computed in one go.
const CALLS: usize = 4096;

/// One computation, over [`CALLS`] inputs; what it returns keeps it from being left out.
type Work = Box<dyn Fn() -> f64>;

/// A plain form, and one that holds.
struct Pair {
    name: &'static str,
    plain_form: &'static str,
    robust_form: &'static str,
    plain: Work,
    robust: Work,
}

fn forms(c: &mut Criterion) {
    for pair in [sphere(), triangle(), slab(), offset(), sum(), variance()] {
        // Where nothing is hard, both compute the same.
        let (a, b) = ((pair.plain)(), (pair.robust)());
        assert!(
            (a - b).abs() <= 2e-3 * b.abs(),
            "{}: {a} and {b}",
            pair.name
        );
        let mut group = c.benchmark_group(pair.name);
        group.throughput(Throughput::Elements(CALLS as u64));
        group.bench_function(format!("plain: {}", pair.plain_form), |b| {
            b.iter(&pair.plain)
        });
        group.bench_function(format!("ours: {}", pair.robust_form), |b| {
            b.iter(&pair.robust)
        });
        group.finish();
    }
}

/// Rays from a sphere of radius 5 to points of a ball of radius 0.7 in its middle.
fn rays() -> Vec<Ray> {
    let ray = |i| {
        let mut u = Stream::new(1, i, 0).at(0, Purpose::Direction);
        let origin = 5.0 * warps::sample_sphere(u.two());
        let target = 0.7 * libm::cbrtf(u.one()) * warps::sample_sphere(u.two());
        Ray::new(origin, (target - origin).normalize())
    };
    (0..CALLS as u32).map(ray).collect()
}

fn prepared() -> Vec<PreparedRay> {
    rays().iter().map(PreparedRay::from).collect()
}

fn count(hits: impl Iterator<Item = bool>) -> f64 {
    hits.filter(|hit| *hit).count() as f64
}

fn sphere() -> Pair {
    let (center, radius) = (Vec3::ZERO, 0.5);
    let (plain, robust, ours) = (rays(), prepared(), Sphere::new(center, radius));
    Pair {
        name: "ray and sphere",
        plain_form: "school formula in f32, from a fixed distance on",
        robust_form: "quadratic in f64",
        plain: Box::new(move || {
            let hit = |r: &Ray| naive::sphere_after(r.origin, r.direction, center, radius, 1e-3);
            count(plain.iter().map(|r| hit(r).is_some()))
        }),
        robust: Box::new(move || count(robust.iter().map(|r| ours.cross(r, f32::MAX).is_some()))),
    }
}

fn triangle() -> Pair {
    let corners = [
        Vec3::new(-0.4, -0.4, 0.0),
        Vec3::new(0.6, -0.3, 0.1),
        Vec3::new(-0.2, 0.6, 0.0),
    ];
    let [a, b, c] = corners;
    let (plain, robust, ours) = (rays(), prepared(), Triangle { a, b, c });
    Pair {
        name: "ray and triangle",
        plain_form: "Möller and Trumbore",
        robust_form: "watertight",
        plain: Box::new(move || {
            let hit = |r: &Ray| naive::triangle(r.origin, r.direction, corners);
            count(plain.iter().map(|r| hit(r).is_some()))
        }),
        robust: Box::new(move || count(robust.iter().map(|r| ours.cross(r, f32::MAX).is_some()))),
    }
}

fn slab() -> Pair {
    let [min, max] = [Vec3::splat(-0.4), Vec3::new(0.5, 0.4, 0.3)];
    let ours = Aabb { min, max };
    // Both forms are given the reciprocals, as in the hierarchy.
    let plain: Vec<(Vec3, Vec3)> = rays()
        .iter()
        .map(|r| (r.origin, r.direction.recip()))
        .collect();
    let robust = prepared();
    Pair {
        name: "ray and box",
        plain_form: "min and max",
        robust_form: "comparisons that pass over a NaN, and an early entry",
        plain: Box::new(move || {
            let meets = |&(o, inverse): &(Vec3, Vec3)| {
                let (x, y) = ((min - o) * inverse, (max - o) * inverse);
                let (near, far) = (x.min(y), x.max(y));
                near.max_element().max(0.0) <= far.min_element()
            };
            count(plain.iter().map(meets))
        }),
        robust: Box::new(move || count(robust.iter().map(|r| ours.entry(r, f32::MAX).is_some()))),
    }
}

fn offset() -> Pair {
    let (plain, robust) = (rays(), rays());
    let n = Vec3::new(1.0, 2.0, -2.0) / 3.0;
    let sum = |points: &mut dyn Iterator<Item = Vec3>| points.map(|p| f64::from(p.x)).sum::<f64>();
    Pair {
        name: "leaving a surface",
        plain_form: "a fixed distance along the normal",
        robust_form: "bounds on the rounding error",
        plain: Box::new(move || {
            sum(&mut plain
                .iter()
                .map(|r| naive::offset_by(1e-3, r.origin, n, r.direction)))
        }),
        robust: Box::new(move || {
            let moved =
                |r: &Ray| offset_origin(r.origin, r.origin.abs() * gamma(7), n, r.direction);
            sum(&mut robust.iter().map(moved))
        }),
    }
}

fn samples() -> Vec<f32> {
    let sample = |i| Stream::new(2, i, 0).at(0, Purpose::Pixel).one();
    (0..CALLS as u32).map(sample).collect()
}

fn sum() -> Pair {
    let (plain, robust) = (samples(), samples());
    Pair {
        name: "sum of samples",
        plain_form: "in f32",
        robust_form: "in f64",
        plain: Box::new(move || f64::from(naive::mean(plain.iter().copied()))),
        robust: Box::new(move || robust.iter().map(|&x| f64::from(x)).sum::<f64>() / CALLS as f64),
    }
}

fn variance() -> Pair {
    let (plain, robust) = (samples(), samples());
    Pair {
        name: "variance of samples",
        plain_form: "sums of squares in f32",
        robust_form: "Welford's recurrence in f64",
        plain: Box::new(move || f64::from(naive::variance(plain.iter().copied()))),
        robust: Box::new(move || {
            let all: Estimate = robust.iter().map(|&x| f64::from(x)).collect();
            all.variance()
        }),
    }
}

criterion_group!(all, forms);
criterion_main!(all);
