//! Computations twice: in their plain form, and in the one that holds in hard cases; for what the care costs.

use crate::geometry::{Aabb, PreparedRay, Ray, Sphere, Surface, Triangle};
use crate::lab::naive;
use crate::numeric::{self, gamma};
use crate::sampling::mis::Heuristic;
use crate::sampling::stream::{Purpose, Stream};
use crate::sampling::warps;
use crate::stats::Estimate;
use glam::Vec3;
use std::hint::black_box;

/// A computation over all inputs, one after the other: each answer is looked at whole, so that none is left
/// out, and no eight of them are computed at once.
pub type Work = Box<dyn Fn() -> f64>;

/// A plain form, and one that holds. On these inputs nothing is hard, and both compute the same.
pub struct Pair {
    /// A word for it.
    pub key: &'static str,
    /// What is computed.
    pub name: &'static str,
    /// How the plain form does it.
    pub plain_form: &'static str,
    /// How ours does it.
    pub robust_form: &'static str,
    /// The plain form.
    pub plain: Work,
    /// Ours.
    pub robust: Work,
}

/// All pairs, each for so many inputs. A few thousand stay near the processor: of more, the time to fetch
/// them is measured.
pub fn pairs(inputs: usize) -> [Pair; 8] {
    let rays: Vec<Ray> = (0..inputs as u32).map(ray).collect();
    let sample = |i| Stream::new(2, i, 0).at(0, Purpose::Pixel).one();
    let samples: Vec<f32> = (0..inputs as u32).map(sample).collect();
    [
        sphere(&rays),
        triangle(&rays),
        slab(&rays),
        offset(&rays),
        cone(&samples),
        weights(&samples),
        sum(&samples),
        variance(&samples),
    ]
}

/// Rays from a sphere of radius 5 to points of a ball of radius 0.7 in its middle.
fn ray(i: u32) -> Ray {
    let mut u = Stream::new(1, i, 0).at(0, Purpose::Direction);
    let origin = 5.0 * warps::sample_sphere(u.two());
    let target = 0.7 * libm::cbrtf(u.one()) * warps::sample_sphere(u.two());
    Ray::new(origin, (target - origin).normalize())
}

fn prepared(rays: &[Ray]) -> Vec<PreparedRay> {
    rays.iter().map(PreparedRay::from).collect()
}

/// The answers to all inputs, each as a number, added up.
fn work<I: 'static, A>(
    inputs: Vec<I>,
    answer: impl Fn(&I) -> A + 'static,
    number: impl Fn(A) -> f64 + 'static,
) -> Work {
    let one = move |input: &I| number(black_box(answer(input)));
    Box::new(move || inputs.iter().map(&one).sum())
}

fn met<T>(hit: Option<T>) -> f64 {
    f64::from(u8::from(hit.is_some()))
}

fn sphere(rays: &[Ray]) -> Pair {
    let (center, radius) = black_box((Vec3::ZERO, 0.5));
    let ours = Sphere::new(center, radius);
    let plain = move |r: &Ray| naive::sphere_after(r.origin, r.direction, center, radius, 1e-3);
    Pair {
        key: "sphere",
        name: "ray and sphere",
        plain_form: "school formula in f32, from a fixed distance on",
        robust_form: "quadratic in f64",
        plain: work(rays.to_vec(), plain, met),
        robust: work(prepared(rays), move |r| ours.intersect(r, f32::MAX), met),
    }
}

fn triangle(rays: &[Ray]) -> Pair {
    let corners = black_box([
        Vec3::new(-0.4, -0.4, 0.0),
        Vec3::new(0.6, -0.3, 0.1),
        Vec3::new(-0.2, 0.6, 0.0),
    ]);
    let [a, b, c] = corners;
    let ours = Triangle { a, b, c };
    let plain = move |r: &Ray| naive::triangle(r.origin, r.direction, corners);
    Pair {
        key: "triangle",
        name: "ray and triangle",
        plain_form: "Möller and Trumbore",
        robust_form: "watertight",
        plain: work(rays.to_vec(), plain, met),
        robust: work(prepared(rays), move |r| ours.intersect(r, f32::MAX), met),
    }
}

fn slab(rays: &[Ray]) -> Pair {
    let [min, max] = black_box([Vec3::splat(-0.4), Vec3::new(0.5, 0.4, 0.3)]);
    let ours = Aabb { min, max };
    // Both forms are given the reciprocals, as in the hierarchy.
    let given = rays.iter().map(|r| (r.origin, r.direction.recip()));
    let plain = move |&(o, inverse): &(Vec3, Vec3)| {
        let (x, y) = ((min - o) * inverse, (max - o) * inverse);
        let (near, far) = (x.min(y), x.max(y));
        (near.max_element().max(0.0) <= far.min_element()).then_some(())
    };
    Pair {
        key: "slab",
        name: "ray and box",
        plain_form: "min and max",
        robust_form: "comparisons that pass over a NaN, and an early entry",
        plain: work(given.collect(), plain, met),
        robust: work(prepared(rays), move |r| ours.entry(r, f32::MAX), met),
    }
}

fn offset(rays: &[Ray]) -> Pair {
    let leaving = |r: &Ray| {
        let (p, n) = (r.origin, r.origin.normalize());
        let error = p.abs() * gamma(7);
        let time = 0.0;
        (Surface { p, error, n, time }, r.direction)
    };
    let given: Vec<(Surface, Vec3)> = rays.iter().map(leaving).collect();
    let distance = black_box(1e-3);
    let plain =
        move |&(s, d): &(Surface, Vec3)| Ray::new(naive::offset_by(distance, s.p, s.n, d), d);
    let number = |ray: Ray| f64::from(ray.origin.x.abs());
    Pair {
        key: "offset",
        name: "leaving a surface",
        plain_form: "a fixed distance along the normal",
        robust_form: "bounds on the rounding error",
        plain: work(given.clone(), plain, number),
        robust: work(given, |(s, d)| s.spawn(*d), number),
    }
}

fn cone(samples: &[f32]) -> Pair {
    Pair {
        key: "cone",
        name: "one minus a cosine",
        plain_form: "1 - sqrt(1 - sin²)",
        robust_form: "sin² over 1 + cos",
        plain: work(samples.to_vec(), |&x| naive::one_minus_cos(x), f64::from),
        robust: work(samples.to_vec(), |&x| numeric::one_minus_cos(x), f64::from),
    }
}

fn weights(samples: &[f32]) -> Pair {
    let other = black_box(0.5);
    let plain = move |&x: &f32| naive::power_weight(x, other);
    let robust = move |&x: &f32| Heuristic::Power.weight(x, other);
    Pair {
        key: "weights",
        name: "power heuristic",
        plain_form: "squares over their sum",
        robust_form: "by the ratio, which does not overflow",
        plain: work(samples.to_vec(), plain, f64::from),
        robust: work(samples.to_vec(), robust, f64::from),
    }
}

fn sum(samples: &[f32]) -> Pair {
    let (plain, robust) = (samples.to_vec(), samples.to_vec());
    Pair {
        key: "sum",
        name: "sum of samples",
        plain_form: "in f32",
        robust_form: "in f64",
        plain: Box::new(move || f64::from(naive::mean(plain.iter().copied()))),
        robust: Box::new(move || {
            robust.iter().map(|&x| f64::from(x)).sum::<f64>() / robust.len() as f64
        }),
    }
}

fn variance(samples: &[f32]) -> Pair {
    let (plain, robust) = (samples.to_vec(), samples.to_vec());
    Pair {
        key: "variance",
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

    fn near(a: f64, b: f64) -> bool {
        (a - b).abs() <= 2e-3 * b.abs()
    }

    #[test]
    fn where_nothing_is_hard_both_forms_compute_the_same() {
        for pair in pairs(4096) {
            let (plain, robust) = ((pair.plain)(), (pair.robust)());
            assert!(near(plain, robust), "{}: {plain} and {robust}", pair.name);
            assert!(!near(plain, 0.0), "{}: {plain}", pair.name);
        }
    }

    #[test]
    fn each_form_takes_all_inputs() {
        const FEW: usize = 1 << 14;
        for (few, more) in pairs(FEW).iter().zip(&pairs(4 * FEW)) {
            // Means and variances stay, sums and counts grow as the inputs do.
            let key = few.key;
            let expected = if ["sum", "variance"].contains(&key) {
                1.0
            } else {
                4.0
            };
            for (few, more) in [(&few.plain, &more.plain), (&few.robust, &more.robust)] {
                let grown = more() / few() / expected;
                // The scatter of a count whose share is a tenth or more is at most 2 % of it, that of
                // what else is added up less: 4.4 standard errors, and a tenth of the inputs missing
                // would be noticed.
                assert!((grown - 1.0).abs() < 0.09, "{key}: {grown}");
            }
        }
    }
}
