//! What robustness costs: each computation done with care beside the plain form of it, timed in
//! turns on the same input.

use crate::geometry::{Aabb, PreparedRay, Ray, Sphere, Triangle};
use crate::numeric::{gamma, naive, offset_origin};
use crate::sampling::stream::{Purpose, Stream};
use crate::sampling::warps;
use crate::stats::Estimate;
use glam::Vec3;
use std::hint::black_box;
use std::time::Instant;

/// How often each form is computed in one go.
pub const CALLS: usize = 4096;

/// One computation, over [`CALLS`] inputs; what it returns keeps it from being left out.
type Work = Box<dyn Fn() -> f64>;

/// A plain form, and one that holds.
pub struct Pair {
    /// What is computed.
    pub name: &'static str,
    /// How the plain form does it.
    pub plain_form: &'static str,
    /// How ours does.
    pub robust_form: &'static str,
    /// The plain form.
    pub plain: Work,
    /// Ours.
    pub robust: Work,
}

/// What a pair costs.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Timed {
    /// What is computed.
    pub name: &'static str,
    /// Nanoseconds of the plain form, median.
    pub plain: f64,
    /// Nanoseconds of ours, median.
    pub robust: f64,
    /// What ours takes more, as a share of the plain form: the median over turns ...
    pub more: f64,
    /// ... and its quartiles.
    pub quartiles: [f64; 2],
}

/// All pairs, with their inputs.
pub fn pairs() -> Vec<Pair> {
    vec![sphere(), triangle(), slab(), offset(), sum(), variance()]
}

/// Times both forms of a pair, `rounds` times each in the order plain, ours, ours, plain.
pub fn time(pair: &Pair, rounds: u32) -> Timed {
    let clock = |work: &Work| {
        let start = Instant::now();
        black_box(work());
        1e9 * start.elapsed().as_secs_f64() / CALLS as f64
    };
    // Caches and branch predictors learn first.
    (0..3).for_each(|_| {
        clock(&pair.plain);
        clock(&pair.robust);
    });
    let (mut plain, mut robust, mut more) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..rounds {
        let [a, b, c, d] = [&pair.plain, &pair.robust, &pair.robust, &pair.plain].map(clock);
        plain.extend([a, d]);
        robust.extend([b, c]);
        more.push((b + c) / (a + d) - 1.0);
    }
    let at = |values: &mut Vec<f64>, share: f64| {
        values.sort_by(f64::total_cmp);
        values[(share * (values.len() - 1) as f64) as usize]
    };
    Timed {
        name: pair.name,
        plain: at(&mut plain, 0.5),
        robust: at(&mut robust, 0.5),
        more: at(&mut more, 0.5),
        quartiles: [0.25, 0.75].map(|share| at(&mut more, share)),
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_forms_of_a_pair_compute_the_same_where_nothing_is_hard() {
        for pair in pairs() {
            let (a, b) = ((pair.plain)(), (pair.robust)());
            assert!(
                (a - b).abs() <= 2e-3 * b.abs(),
                "{}: {a} and {b}",
                pair.name
            );
        }
    }

    #[test]
    fn a_form_that_does_more_takes_longer() {
        let work = |rounds: u32| -> Work {
            let samples = samples();
            Box::new(move || {
                (0..rounds)
                    .map(|_| {
                        black_box(&samples)
                            .iter()
                            .map(|&x| f64::from(x))
                            .sum::<f64>()
                    })
                    .sum()
            })
        };
        let pair = Pair {
            name: "",
            plain_form: "",
            robust_form: "",
            plain: work(2),
            robust: work(8),
        };
        let timed = time(&pair, 15);
        assert!(timed.more > 1.0, "{timed:?}");
    }
}
