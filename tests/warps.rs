//! Samples against densities: each density integrates to one, and the samples follow it.

use glam::{DVec3, Vec2, Vec3};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::sampling::{hemisphere, warps};
use halfdisk::stats::chi_square::{ChiSquare, chi_square};
use halfdisk::stats::z_test::sidak;
use std::f64::consts::TAU;

/// The probability that any of the chi-square tests below rejects a right pair.
const SIGNIFICANCE: f64 = 1e-3;
/// How many of them there are, here and in `twins`: twenty pairs at two resolutions each.
const TESTS: u32 = 40;
/// Rows and columns of cells: coarse sees a smooth error, fine a local one.
const RESOLUTIONS: [[usize; 2]; 2] = [[8, 4], [20, 40]];

/// What is sampled, as the image of the unit square.
#[derive(Clone, Copy)]
pub enum Domain {
    /// Unit directions `ω` with `1 - ω.z` up to this.
    Cap(f64),
    /// The unit disc in the plane `z = 0`.
    Disk,
}

impl Domain {
    fn point(self, [a, b]: [f64; 2]) -> Vec3 {
        let (sin, cos) = libm::sincos(TAU * b);
        let (r, z) = match self {
            Domain::Cap(top) => ((a * top * (2.0 - a * top)).sqrt(), 1.0 - a * top),
            Domain::Disk => (a, 0.0),
        };
        DVec3::new(r * cos, r * sin, z).as_vec3()
    }

    fn square(self, w: Vec3) -> [f64; 2] {
        let w = w.as_dvec3();
        let r2 = w.x * w.x + w.y * w.y;
        let a = match self {
            // The difference from the squares near the pole, where `1 - z` has lost its digits.
            Domain::Cap(top) if w.z > 0.0 => r2 / (1.0 + (1.0 - r2).max(0.0).sqrt()) / top,
            Domain::Cap(top) => (1.0 - w.z) / top,
            Domain::Disk => r2.sqrt(),
        };
        let turn = libm::atan2(w.y, w.x) / TAU;
        [a, if turn < 0.0 { turn + 1.0 } else { turn }]
    }

    /// Measure of the domain per measure of the square.
    fn stretch(self, [a, _]: [f64; 2]) -> f64 {
        match self {
            Domain::Cap(top) => TAU * top,
            Domain::Disk => TAU * a,
        }
    }

    /// The integral of `pdf` over a rectangle of the square, by midpoints.
    fn integral(self, pdf: &impl Fn(Vec3) -> f32, low: [f64; 2], size: [f64; 2]) -> f64 {
        const STEPS: usize = 64;
        let mut sum = 0.0;
        for i in 0..STEPS * STEPS {
            let steps = [i / STEPS, i % STEPS].map(|k| (k as f64 + 0.5) / STEPS as f64);
            let x = [0, 1].map(|k| low[k] + size[k] * steps[k]);
            sum += f64::from(pdf(self.point(x))) * self.stretch(x);
        }
        sum * size[0] * size[1] / (STEPS * STEPS) as f64
    }
}

pub fn check(
    name: &str,
    domain: Domain,
    sample: impl Fn([f32; 2]) -> Vec3,
    pdf: impl Fn(Vec3) -> f32,
) {
    const SAMPLES: u32 = 1_000_000;
    for [rows, columns] in RESOLUTIONS {
        let size = [1.0 / rows as f64, 1.0 / columns as f64];
        let expected: Vec<f64> = (0..rows * columns)
            .map(|i| [i / columns, i % columns])
            .map(|cell| [0, 1].map(|k| cell[k] as f64 * size[k]))
            .map(|low| domain.integral(&pdf, low, size))
            .collect();
        let total: f64 = expected.iter().sum();
        assert!(
            (total - 1.0).abs() < 1e-4,
            "{name}: the density integrates to {total}"
        );
        let mut counts = vec![0_u64; rows * columns];
        // Numbers of its own for each pair.
        let seed = name.bytes().map(u64::from).sum();
        let mut u = Stream::new(seed, 0, 0).at(0, Purpose::Direction);
        for _ in 0..SAMPLES {
            let [a, b] = domain.square(sample(u.two()));
            let row = ((a * rows as f64) as usize).min(rows - 1);
            let column = ((b * columns as f64) as usize).min(columns - 1);
            counts[row * columns + column] += 1;
        }
        let expected: Vec<f64> = expected.iter().map(|p| p * f64::from(SAMPLES)).collect();
        judge(name, total, &counts, &expected);
    }
}

/// Accepts counts that follow what was expected of them.
pub fn judge(name: &str, total: f64, counts: &[u64], expected: &[f64]) {
    let ChiSquare {
        statistic,
        freedom,
        p,
    } = chi_square(counts, expected);
    println!("{name}: integral {total:.6}, chi2 {statistic:.1} of {freedom}, p {p:.4}");
    let level = sidak(SIGNIFICANCE, TESTS);
    assert!(p > level, "{name}: chi2 {statistic:.1}, p {p:e}");
}

fn disk(u: [f32; 2]) -> Vec3 {
    warps::sample_disk(u).extend(0.0)
}

#[test]
fn cosine_hemisphere() {
    let (sample, pdf) = (hemisphere::sample_cosine, hemisphere::pdf_cosine);
    check("cosine", Domain::Cap(1.0), sample, pdf);
}

#[test]
fn sphere() {
    let pdf = |_| warps::pdf_sphere();
    check("sphere", Domain::Cap(2.0), warps::sample_sphere, pdf);
}

#[test]
fn unit_disk() {
    let pdf = |p: Vec3| warps::pdf_disk(p.truncate());
    check("disk", Domain::Disk, disk, pdf);
    let concentric = |u| warps::sample_disk_concentric(u).extend(0.0);
    check("concentric disk", Domain::Disk, concentric, pdf);
    assert_eq!(warps::sample_disk_concentric([0.5; 2]), Vec2::ZERO);
}

#[test]
fn cones_from_the_hemisphere_down_to_a_distant_lamp() {
    for top in [1.0, 0.3, 1e-3, 1e-9] {
        let sample = |u| warps::sample_cone(u, top);
        let pdf = |_| warps::pdf_cone(top);
        check(
            &format!("cone {top:e}"),
            Domain::Cap(f64::from(top)),
            sample,
            pdf,
        );
    }
}

#[test]
#[should_panic(expected = "chi2")]
fn a_wrong_pair_is_caught() {
    let sample = |u| warps::sample_cone(u, 1.0);
    check("wrong", Domain::Cap(1.0), sample, hemisphere::pdf_cosine);
}

#[test]
#[should_panic(expected = "integrates")]
fn a_wrong_constant_is_caught() {
    let pdf = |w: Vec3| w.z / 3.0;
    check("wrong", Domain::Cap(1.0), hemisphere::sample_cosine, pdf);
}

#[test]
#[should_panic(expected = "chi2")]
fn a_radius_without_its_square_root_is_caught() {
    let pdf = |p: Vec3| warps::pdf_disk(p.truncate());
    check("wrong", Domain::Disk, |u| disk([u[0] * u[0], u[1]]), pdf);
}

/// The smallest and largest uniforms and their middle.
fn corners() -> impl Iterator<Item = [f32; 2]> {
    const EDGES: [f32; 4] = [0.0, f32::EPSILON / 2.0, 0.5, 1.0 - f32::EPSILON / 2.0];
    (0..16).map(|i| [EDGES[i / 4], EDGES[i % 4]])
}

pub fn off_unit(w: Vec3) -> f64 {
    (w.as_dvec3().length() - 1.0).abs()
}

#[test]
fn a20_the_corners_of_the_unit_square_stay_in_their_domain() {
    let mut worst = 0.0_f64;
    for u in corners() {
        let w = hemisphere::sample_cosine(u);
        assert!(w.z > 0.0 && hemisphere::pdf_cosine(w) > 0.0, "{u:?}: {w}");
        worst = worst.max(off_unit(w));
        worst = worst.max(off_unit(warps::sample_sphere(u)));
        let p = warps::sample_disk(u);
        assert!(p.is_finite() && warps::pdf_disk(p) > 0.0, "{u:?}: {p}");
        for top in [1.0, 0.3, 1e-3, 1e-9, 1e-30] {
            let w = warps::sample_cone(u, top);
            worst = worst.max(off_unit(w));
            assert!(1.0 - w.z <= top + f32::EPSILON, "{u:?}: {w}");
            let pdf = warps::pdf_cone(top);
            assert!(pdf > 0.0 && pdf.is_finite());
        }
    }
    println!("worst distance from unit length {worst:e}");
    assert!(worst < 1e-6);
}

#[test]
fn a20_no_uniform_puts_a_cosine_sample_on_the_rim() {
    let (mut lowest, mut worst) = (f32::INFINITY, 0.0_f64);
    for mantissa in 0..1_u32 << 24 {
        let u = mantissa as f32 / 16_777_216.0;
        assert!(u < 1.0);
        let w = hemisphere::sample_cosine([u, 0.3]);
        lowest = lowest.min(w.z);
        worst = worst.max(off_unit(w));
    }
    println!("lowest z {lowest:e}, worst distance from unit length {worst:e}");
    assert!(lowest > 0.0 && worst < 1e-6);
}

#[test]
fn a20_no_turn_puts_a_disk_sample_outside_its_density() {
    for mantissa in 0..1_u32 << 24 {
        let u = [1.0 - f32::EPSILON / 2.0, mantissa as f32 / 16_777_216.0];
        let p = warps::sample_disk(u);
        assert!(warps::pdf_disk(p) > 0.0, "{u:?}: {p}");
    }
}
