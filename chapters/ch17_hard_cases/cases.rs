//! One number for each case: how far the plain form is off, and ours.

use super::patches::along_a_wall;
use glam::{DVec3, Vec3};
use halfdisk::geometry::{Aabb, PreparedRay, Ray, Sphere, Triangle};
use halfdisk::integrators::Survival;
use halfdisk::lab::naive;
use halfdisk::materials::{Glass, fresnel, ggx::Ggx};
use halfdisk::numeric;
use halfdisk::radiosity::RadiosityError;
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::stream::{Numbers, Purpose, Stream};
use halfdisk::sampling::{frame::Frame, half_disk, warps};
use halfdisk::stats::Estimate;

/// A computation, and what two ways make of it.
pub struct Case {
    pub name: &'static str,
    pub says: &'static str,
    pub plain: f64,
    pub ours: f64,
    pub truth: f64,
}

/// The numbers of a case.
pub fn numbers(seed: u64, case: u32) -> Numbers {
    Stream::new(seed, case, 0).at(0, Purpose::Integrand)
}

fn case(name: &'static str, says: &'static str, [plain, ours]: [f64; 2], truth: f64) -> Case {
    Case {
        name,
        says,
        plain,
        ours,
        truth,
    }
}

/// All of them, with `n` samples where there is something to sample.
pub fn all(n: u32, seed: u64) -> Result<Vec<Case>, RadiosityError> {
    let last = Vec3::new(0.000_385_273_16, 0.000_384_600_16, -0.999_999_9);
    let sums = sums(10 * n, seed);
    Ok(vec![
        case(
            "sphere",
            "hits lost on a sphere ten thousand radii away",
            spheres(n, seed),
            0.0,
        ),
        case(
            "vertex",
            "rays lost at a vertex of a mesh",
            vertices(n, seed),
            0.0,
        ),
        case("slab", "rays lost in faces of a box", slabs(), 0.0),
        case(
            "cone",
            "solid angle of a lamp of r/d = 1/1000, over the truth",
            cone(1e-6),
            1.0,
        ),
        case(
            "frame",
            "how far tangents are from orthonormal near -z",
            [off(naive::basis(last), last), off(ours_frame(last), last)],
            0.0,
        ),
        case("rim", "cosine of the first uniform direction", rim(), 0.0),
        case(
            "words",
            "words of 32 bits that make the uniform 1",
            words(),
            0.0,
        ),
        case(
            "weights",
            "sum of both weights for densities of 2e19 and 1",
            weights(2e19, 1.0),
            1.0,
        ),
        case(
            "fresnel",
            "angles inside glass that reflect no number",
            interface(),
            0.0,
        ),
        case(
            "schlick",
            "reflectance inside glass just beyond the critical angle",
            critical(),
            1.0,
        ),
        case(
            "ggx",
            "peak of facets of roughness 1/1000, over the truth",
            peak(1e-3),
            1.0,
        ),
        case(
            "survival",
            "light left of a throughput of 1.5 after roulette, over before",
            survival(1.5),
            1.0,
        ),
        case("mean", "mean of tenths", sums[0], f64::from(0.1_f32)),
        case(
            "variance",
            "variance around a mean of 1000",
            sums[1],
            1.0 / 3.0,
        ),
        case(
            "edge",
            "form factor of squares that share an edge",
            along_a_wall(1.0)?,
            0.200_043_776_1,
        ),
        case(
            "sliver",
            "form factor of a sliver to the wall that it lies along",
            along_a_wall(1e-6)?,
            0.5,
        ),
    ])
}

/// The share of rays aimed inside a small sphere that miss it.
fn spheres(n: u32, seed: u64) -> [f64; 2] {
    let mut numbers = numbers(seed, 1);
    let sphere = Sphere::new(Vec3::ZERO, 1.0);
    let mut lost = [0.0; 2];
    for _ in 0..n {
        let from = warps::sample_sphere(numbers.two()) * 1e4;
        let aim = warps::sample_sphere(numbers.two()) * 0.95;
        let towards = (aim.as_dvec3() - from.as_dvec3()).normalize();
        let ray = Ray::new(from, towards.as_vec3());
        let plain = naive::sphere_after(from, ray.direction, sphere.center, sphere.radius, 0.0);
        let ours = sphere.intersect(&PreparedRay::from(&ray), f32::MAX);
        lost[0] += f64::from(u8::from(plain.is_none()));
        lost[1] += f64::from(u8::from(ours.is_none()));
    }
    lost.map(|count| count / f64::from(n))
}

/// The share of rays aimed at the tip of a pyramid of six triangles that slip between them.
fn vertices(n: u32, seed: u64) -> [f64; 2] {
    let mut numbers = numbers(seed, 2);
    let mut lost = [0.0; 2];
    for _ in 0..n {
        let tip = warps::sample_sphere(numbers.two()) * 0.3;
        let from = Vec3::new(numbers.one() - 0.5, numbers.one() - 0.5, 3.0);
        let foot = |k: u32| {
            let (sin, cos) = numeric::sin_cos(k as f32 * std::f32::consts::FRAC_PI_3);
            Vec3::new(cos, sin, -1.0)
        };
        let ray = Ray::new(from, tip - from);
        let prepared = PreparedRay::from(&ray);
        let [mut plain, mut ours] = [false; 2];
        for k in 0..6 {
            let [a, b, c] = [tip, foot(k), foot((k + 1) % 6)];
            plain |= naive::triangle(ray.origin, ray.direction, [a, b, c]).is_some();
            ours |= Triangle { a, b, c }
                .intersect(&prepared, f32::MAX)
                .is_some();
        }
        lost[0] += f64::from(u8::from(!plain));
        lost[1] += f64::from(u8::from(!ours));
    }
    lost.map(|count| count / f64::from(n))
}

/// The share of rays along an axis, in faces of the unit box, that miss it.
fn slabs() -> [f64; 2] {
    let (mut lost, mut count) = ([0.0; 2], 0.0);
    let unit = Aabb {
        min: Vec3::ZERO,
        max: Vec3::ONE,
    };
    for axis in 0..3 {
        for (first, second) in [(0.0, 0.5), (1.0, 0.5), (0.0, 1.0), (1.0, 1.0), (0.5, 0.0)] {
            for zero in [0.0, -0.0] {
                let (mut o, mut d) = (Vec3::ZERO, Vec3::splat(zero));
                (o[axis], d[axis]) = (-1.0, 1.0);
                (o[(axis + 1) % 3], o[(axis + 2) % 3]) = (first, second);
                let ours = unit.entry(&PreparedRay::from(&Ray::new(o, d)), f32::MAX);
                lost[0] += f64::from(u8::from(!naive::slab(o, d, unit.min, unit.max)));
                lost[1] += f64::from(u8::from(ours.is_none()));
                count += 1.0;
            }
        }
    }
    lost.map(|lost| lost / count)
}

fn cone(sin2: f32) -> [f64; 2] {
    let exact = f64::from(sin2) / (1.0 + (1.0 - f64::from(sin2)).sqrt());
    [naive::one_minus_cos(sin2), numeric::one_minus_cos(sin2)].map(|x| f64::from(x) / exact)
}

fn ours_frame(n: Vec3) -> [Vec3; 2] {
    let frame = Frame::new(n);
    [frame.to_world(Vec3::X), frame.to_world(Vec3::Y)]
}

/// The root mean square of what two tangents lack to be unit and at right angles.
fn off([a, b]: [Vec3; 2], n: Vec3) -> f64 {
    let [a, b, n]: [DVec3; 3] = [a, b, n].map(Vec3::as_dvec3);
    let lengths = [a, b].map(|t| t.length_squared() - 1.0);
    let angles = [a.dot(b), a.dot(n), b.dot(n)];
    let squares = lengths.into_iter().chain(angles).map(|x| x * x);
    (squares.sum::<f64>() / 5.0).sqrt()
}

fn rim() -> [f64; 2] {
    [naive::uniform_flat(0.0).y, half_disk::sample_uniform(0.0).y].map(f64::from)
}

/// Of the 256 largest words, those that become 1; ours keep their 24 upper bits.
fn words() -> [f64; 2] {
    let largest = || (0..256).map(|k| u32::MAX - k);
    let plain = largest()
        .filter(|word| naive::uniform(*word) == 1.0)
        .count();
    let ours = largest().filter(|word| (word >> 8) as f32 / 16_777_216.0 == 1.0);
    [plain as f64, ours.count() as f64]
}

fn weights(f: f32, g: f32) -> [f64; 2] {
    let plain = naive::power_weight(f, g) + naive::power_weight(g, f);
    let power = Heuristic::Power;
    let ours = power.weight(f, g) + power.weight(g, f);
    [plain, ours].map(f64::from)
}

/// The share of cosines inside glass for which the interface reflects NaN.
fn interface() -> [f64; 2] {
    let cosines = || (0..=1000).map(|k| k as f32 / 1000.0);
    let plain = cosines().filter(|cos| naive::fresnel(*cos, 1.0 / 1.5).is_nan());
    let glass = Glass { ior: 1.5 };
    let inside = |cos: f32| Vec3::new((1.0 - cos * cos).sqrt(), 0.0, -cos);
    let ours = cosines().filter(|cos| {
        let s = glass.specular(inside(*cos));
        s.reflected.is_none_or(|b| b.weight.r.is_nan())
    });
    [plain.count() as f64 / 1001.0, ours.count() as f64 / 1001.0]
}

fn critical() -> [f64; 2] {
    let cos = (1.0_f64 - 1.0 / 2.25).sqrt() - 1e-6;
    let plain = naive::schlick(cos as f32, 1.0 / 1.5);
    [f64::from(plain), fresnel::dielectric(cos, 1.0 / 1.5)]
}

fn peak(alpha: f64) -> [f64; 2] {
    let truth = 1.0 / (std::f64::consts::PI * alpha * alpha);
    let ours = Ggx { alpha }.d(DVec3::Z);
    [f64::from(naive::ggx(alpha as f32, 1.0)), ours].map(|d| d / truth)
}

/// What roulette leaves of a throughput in the mean, as a share.
fn survival(throughput: f32) -> [f64; 2] {
    let beta = halfdisk::color::Rgb::grey(throughput);
    let ours = Survival::Throughput(0.05).probability(beta);
    // Nothing survives more often than always.
    [naive::survival(throughput), ours].map(|q| f64::from(q.min(1.0)) / f64::from(q))
}

/// The mean of tenths, and the variance of numbers around 1000.
fn sums(n: u32, seed: u64) -> [[f64; 2]; 2] {
    let tenths = || (0..n).map(|_| 0.1_f32);
    let around = || {
        let mut numbers = numbers(seed, 3);
        (0..n).map(move |_| 999.0 + 2.0 * numbers.one())
    };
    let ours =
        |samples: &mut dyn Iterator<Item = f32>| samples.map(f64::from).collect::<Estimate>();
    let mean = [f64::from(naive::mean(tenths())), ours(&mut tenths()).mean()];
    let variance = [
        f64::from(naive::variance(around())),
        ours(&mut around()).variance(),
    ];
    [mean, variance]
}
