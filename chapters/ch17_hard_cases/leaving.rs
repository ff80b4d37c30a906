//! Rays that leave a triangle by three rules, in worlds of every size.

use crate::cases::numbers;
use glam::Vec3;
use halfdisk::geometry::{Intersection, PreparedRay, Ray, Triangle};
use halfdisk::lab::naive;
use halfdisk::sampling::stream::Numbers;
use halfdisk::sampling::{frame::Frame, hemisphere, warps};

/// How a ray leaves: short name, and what is drawn.
pub const RULES: [(&str, &str); 3] = [
    ("fixed", "0.001 along the normal"),
    ("scaled", "a share of the coordinates"),
    ("bounded", "the bound on the error"),
];

/// Sizes of worlds: powers of ten, from 10⁻⁶ on.
pub const SCALES: u32 = 13;

/// What became of rays in a world of this size.
pub struct Rate {
    pub scale: f64,
    /// The share that started wrongly, by each rule.
    pub failed: [f64; 3],
}

/// The rates of all worlds, by `n` rays each.
pub fn rates(n: u32, seed: u64) -> Vec<Rate> {
    let rate = |k: u32| {
        let scale = libm::exp10(f64::from(k) - 6.0);
        let mut numbers = numbers(seed, 100 + k);
        let mut failed = [0.0; 3];
        for _ in 0..n {
            let wrong = one(scale as f32, &mut numbers);
            (0..3).for_each(|i| failed[i] += f64::from(u8::from(wrong[i])));
        }
        Rate {
            scale,
            failed: failed.map(|count| count / f64::from(n)),
        }
    };
    (0..SCALES).map(rate).collect()
}

// ANCHOR: one
/// True for each rule by which a ray that leaves a random triangle is wrong: it meets the triangle
/// again, or starts beyond a neighbour at a hundredth of the triangle's size.
fn one(scale: f32, numbers: &mut Numbers) -> [bool; 3] {
    let mut corner = || warps::sample_sphere(numbers.two()) * scale;
    let [a, b, c] = [corner(), corner(), corner()];
    let triangle = Triangle { a, b, c };
    // An eye a thousand sizes away, and the middle of the triangle in its view.
    let eye = corner() * 1000.0;
    let to_middle = ((a + b + c).as_dvec3() / 3.0 - eye.as_dvec3()).normalize();
    let ray = Ray::new(eye, to_middle.as_vec3());
    let Some(hit) = triangle.intersect(&PreparedRay::from(&ray), f32::MAX) else {
        return [false; 3];
    };
    let surface = triangle.surface(hit);
    let n = surface.n * -surface.n.dot(ray.direction).signum();
    let out = Frame::new(n).to_world(hemisphere::sample_cosine(numbers.two()));
    let end = naive::hit_point(ray.origin, ray.direction, hit.t);
    let starts = [
        naive::offset_by(1e-3, end, n, out),
        naive::hit_point_off(2.0_f32.powi(-16), end, n, out),
        surface.spawn(out).origin,
    ];
    let beyond = |start: Vec3| {
        let height = (start.as_dvec3() - a.as_dvec3()).dot(n.as_dvec3());
        height > 0.01 * f64::from(scale)
    };
    starts.map(|start| again(&triangle, start, out).is_some() || beyond(start))
}
// ANCHOR_END: one

/// Where a ray meets the triangle it has just left.
fn again(triangle: &Triangle, start: Vec3, out: Vec3) -> Option<Intersection> {
    triangle.intersect(&PreparedRay::from(&Ray::new(start, out)), f32::MAX)
}
