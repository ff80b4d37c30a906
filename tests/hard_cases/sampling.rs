//! Frames, directions, weights, survival, and points that lie evenly.

use super::draw::Draw;
use super::made;
use glam::{Vec2, Vec3};
use halfdisk::color::Rgb;
use halfdisk::integrators::Survival;
use halfdisk::lab::naive;
use halfdisk::sampling::frame::Frame;
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::stream::{Purpose, Sampler, Stream};
use halfdisk::sampling::{hemisphere, warps};
use halfdisk::stats::Estimate;

/// How far three vectors are from a right-handed orthonormal basis, the last of which is given: the
/// root mean square of what the others add.
fn off_basis([a, b]: [Vec3; 2], n: Vec3) -> f64 {
    let [a, b, n] = [a, b, n].map(Vec3::as_dvec3);
    let products = [
        a.length_squared() - 1.0,
        b.length_squared() - 1.0,
        a.dot(b),
        a.dot(n),
        b.dot(n),
    ];
    (products.iter().map(|x| x * x).sum::<f64>() / 5.0).sqrt()
}

#[test]
fn a10_frames_have_no_bad_direction() {
    let ours = |n: Vec3| {
        let frame = Frame::new(n);
        [frame.to_world(Vec3::X), frame.to_world(Vec3::Y)]
    };
    for n in [Vec3::X, Vec3::Y, Vec3::Z] {
        assert_eq!(off_basis(ours(n), n) + off_basis(ours(-n), -n), 0.0);
    }
    let (mut worst, mut plain) = (0.0_f64, 0.0_f64);
    let printed = [
        Vec3::new(0.000_385_273_16, 0.000_384_600_16, -0.999_999_9),
        Vec3::new(-0.000_197_872_2, -0.000_148_574_8, -0.999_999_96),
    ];
    let mut draw = Draw::new(10, 0);
    let near = (0..1_000_000).map(|i| {
        let off = draw.cube(2e-3);
        Vec3::new(off.x, off.y, if i % 2 == 0 { -1.0 } else { 1.0 }).normalize()
    });
    for n in printed.into_iter().chain(near) {
        // What the normal itself is off by, is not the frame's.
        let slack = (n.as_dvec3().length_squared() - 1.0).abs();
        worst = worst.max(off_basis(ours(n), n) - slack);
        plain = plain.max(off_basis(naive::basis(n), n));
    }
    println!("seed 10: worst rms ours {worst:.1e}, plain {plain:.2}");
    assert!(worst < 1e-7 && plain > 0.1);
}

#[test]
fn a21_no_sample_lies_on_the_rim() {
    let (mut flat, mut lowest) = (0, f32::INFINITY);
    for k in 0..1 << 16 {
        // The left side of the square is the left half of the rim.
        let p = warps::sample_disk_concentric([0.0, k as f32 / 65536.0]);
        let w = naive::lifted(p);
        let weight = w.z / hemisphere::pdf_cosine(w);
        flat += usize::from(!weight.is_finite());
        let last = 1.0 - (k + 1) as f32 * 2.0_f32.powi(-24);
        lowest = lowest.min(hemisphere::sample_cosine([last, 0.3]).z);
    }
    println!("lowest cosine ours {lowest:.2e}; lifted from the disk {flat} of 65536 are 0 / 0");
    assert!(lowest > 2e-4 && flat > 100);
}

#[test]
fn a26_weights_of_all_densities() {
    let (mut worst, mut plain) = (0.0_f32, 0);
    let powers = || (-38..=38).map(|k| libm::exp10(f64::from(k)) as f32);
    for f in powers().chain([0.0]) {
        for g in powers().chain([0.0]).filter(|g| f + g > 0.0) {
            let power = |f, g| Heuristic::Power.weight(f, g);
            worst = worst.max((power(f, g) + power(g, f) - 1.0).abs());
            let sum = naive::power_weight(f, g) + naive::power_weight(g, f);
            plain += usize::from((sum - 1.0).abs() > 1e-6 || sum.is_nan());
        }
    }
    println!("sums of weights off one: ours {worst:.1e}, plainly {plain} of 6083 pairs");
    assert!(worst <= 1e-6 && plain > 1000);
}

#[test]
fn a28_survival_is_a_probability() {
    // The mean of what is left of a throughput after the game.
    let play = |throughput: f32, q: f32| -> Estimate {
        let mut draw = Draw::new(28, throughput.to_bits());
        let mut one = || {
            if draw.one() < q {
                f64::from(throughput / q)
            } else {
                0.0
            }
        };
        (0..100_000).map(|_| one()).collect()
    };
    for throughput in [1e-30, 1e-3, 0.3, 1.0, 1.5, 100.0_f32] {
        let q = Survival::Throughput(0.05).probability(Rgb::grey(throughput));
        assert!((0.05..=0.95).contains(&q));
        let z = play(throughput, q).z(f64::from(throughput));
        let plain = play(throughput, naive::survival(throughput)).mean();
        let share = plain / f64::from(throughput);
        println!("throughput {throughput}: z {z:.2}; unclamped keeps {share:.3}");
        assert!(z.abs() <= 4.4);
        assert_eq!(share < 0.9, !(1e-6..=1.0).contains(&throughput));
    }
    // A throughput that is no number ends its path: no number is below a probability that is none.
    let broken = Survival::Throughput(0.05).probability(Rgb::grey(f32::NAN));
    assert!(broken.is_nan() || broken < 1.0);
}

fn correlation(a: &[f32], b: &[f32]) -> f64 {
    let mean = |x: &[f32]| x.iter().map(|x| f64::from(*x)).sum::<f64>() / x.len() as f64;
    let (ma, mb) = (mean(a), mean(b));
    let (mut ab, mut aa, mut bb) = (0.0, 0.0, 0.0);
    for (&x, &y) in a.iter().zip(b) {
        let (x, y) = (f64::from(x) - ma, f64::from(y) - mb);
        ab += x * y;
        aa += x * x;
        bb += y * y;
    }
    ab / (aa * bb).sqrt()
}

/// The first `count` points of a pixel, dimension by dimension: four of each of eight purposes.
fn dimensions(seed: u64, pixel: u32, count: u32) -> Vec<Vec<f32>> {
    use Purpose::{Branch, Direction, Lens, LightPoint, Pixel, Time};
    let places = [Pixel, Lens, Time, Direction].map(|p| (0, p));
    let more = [Direction, LightPoint, Branch, Direction].map(|p| (1, p));
    let last = |i, p| if i == 3 { (2, p) } else { (1, p) };
    let more = [0, 1, 2, 3].map(|i| last(i, more[i].1));
    let mut all = vec![Vec::new(); 32];
    for sample in 0..count {
        let stream = Stream::with(Sampler::Sobol, seed, pixel, sample);
        for (k, (place, purpose)) in places.into_iter().chain(more).enumerate() {
            let mut numbers = stream.at(place, purpose);
            (0..4).for_each(|d| all[4 * k + d].push(numbers.one()));
        }
    }
    all
}

#[test]
fn a29_dimensions_that_know_nothing_of_each_other() {
    let pixels = 64;
    let mut sums = vec![0.0; 32 * 32];
    for pixel in 0..pixels {
        let all = dimensions(29, pixel, 256);
        for i in 0..32 {
            for j in 0..i {
                sums[32 * i + j] += correlation(&all[i], &all[j]);
            }
        }
    }
    let worst = sums.iter().map(|s| (s / f64::from(pixels)).abs());
    let worst = worst.fold(0.0, f64::max);
    let halton = |base| -> Vec<f32> { (0..59).map(|i| naive::radical_inverse(base, i)).collect() };
    let plain = correlation(&halton(59), &halton(61));
    println!("seed 29: largest mean correlation {worst:.4}; of bases 59 and 61 {plain:.2}");
    assert!(worst < 0.05 && plain > 0.8);
}

#[test]
fn a29_points_below_one_and_beyond_the_end_of_the_sequence() {
    let mut largest = 0.0_f32;
    for sample in (0..1_000_000).step_by(7).chain(u32::MAX - 1000..=u32::MAX) {
        for place in 0..4 {
            let stream = Stream::with(Sampler::Sobol, 1, 2, sample);
            let mut numbers = stream.at(place, Purpose::Direction);
            (0..4).for_each(|_| largest = largest.max(numbers.one()));
        }
    }
    let plain = [(3, 3_u32.pow(20)), (5, 5_u32.pow(13)), (7, 7_u32.pow(11))];
    let plain = plain.map(|(base, power)| naive::radical_inverse(base, power - 1));
    println!("largest point {largest}; radical inverses of b^k - 1 {plain:?}");
    assert!(largest < 1.0);
    assert!(plain.iter().any(|x| *x >= 1.0));
}

#[test]
fn a29_other_seeds_make_other_errors() {
    // The integral of x y by 16 points, in each of many pixels.
    let errors = |seed: u64| -> Vec<f32> {
        let pixel = |pixel: u32| {
            let product = |sample| {
                let stream = Stream::with(Sampler::Sobol, seed, pixel, sample);
                let [x, y] = stream.at(0, Purpose::Pixel).two();
                x * y
            };
            (0..16).map(product).sum::<f32>() / 16.0 - 0.25
        };
        (0..65_536).map(pixel).collect()
    };
    let (one, two) = (errors(1), errors(2));
    let (apart, same) = (correlation(&one, &two), correlation(&one, &errors(1)));
    println!("correlation of errors: seeds 1 and 2 {apart:.4}, the same seed {same:.1}");
    assert!(apart.abs() < 0.02 && same > 0.999);
}

#[test]
fn a30_jitter_far_to_the_right_of_a_picture() {
    use halfdisk::stats::chi_square::chi_square;
    let mut taken_back = [0_u64; 800];
    let mut drawn = [0_u64; 800];
    let mut within = Vec2::new(f32::INFINITY, f32::NEG_INFINITY);
    for sample in 0..200_000 {
        let u = Stream::new(30, 65_535, sample).at(0, Purpose::Pixel).one();
        let x = 65_535.0 + u;
        let cell = |u: f32| ((f64::from(u) * 800.0) as usize).min(799);
        drawn[cell(u)] += 1;
        taken_back[cell(x - 65_535.0)] += 1;
        within = Vec2::new(within.x.min(x), within.y.max(x));
    }
    let expected = [250.0; 800];
    let [ours, plain] = [drawn, taken_back].map(|seen| chi_square(&seen, &expected).p);
    println!("seed 30: p of the jitter {ours:.3}, taken back from the place {plain:.1e}; {within}");
    assert!(ours > 1e-5 && plain < 1e-5);
    // The place stays in its pixel, ends included.
    assert!(within.x >= 65_535.0 && within.y <= 65_536.0);
}

#[test]
fn a26_lights_without_extent_are_found_by_aiming_alone() {
    use halfdisk::integrators::{Combine, Integrator, NextEvent, Path, WhichRay};
    use halfdisk::scene::Tracer;
    // A point light two units above a floor, and a lamp that shines elsewhere.
    let lit = super::scene(
        "[[objects]]\nmaterial = 'half'\nquad = { corner = [-5, -1, -5], u = [0, 0, 10], v = [10, 0, 0] }\n\
         [[lights]]\npoint = { position = [0, 1, 0], intensity = 3 }\n\
         [[objects]]\nemits = 1\nsphere = { center = [0, -9, 0], radius = 1 }\n",
    );
    // f I cos / d², straight below.
    let truth = 0.5 / std::f64::consts::PI * 3.0 / 4.0;
    let ray = halfdisk::geometry::Ray::new(Vec3::ZERO, Vec3::NEG_Y);
    let placeholder = f64::from(Heuristic::Power.weight(1.0, hemisphere::pdf_cosine(Vec3::Z)));
    for integrator in [
        NextEvent::ENTRY,
        WhichRay::ENTRY,
        Combine::ENTRY,
        Path::ENTRY,
    ] {
        let read: Estimate = (0..20_000)
            .map(|i| {
                let mut tracer = Tracer::new(&lit);
                let li = made(&integrator, &lit, 2).li(&mut tracer, &ray, &Stream::new(26, 0, i));
                f64::from(li.g)
            })
            .collect();
        let off = |truth: f64| (read.mean() - truth).abs() <= 4.4 * read.std_error() + 1e-6 * truth;
        assert!(off(truth), "{}: {read:?} for {truth}", integrator.name);
        assert!(
            !off(placeholder * truth),
            "a placeholder density loses light"
        );
    }
    println!(
        "seed 26: a point light {truth:.6} by four integrators; a placeholder keeps {placeholder:.3}"
    );
    assert!((placeholder - 0.908).abs() < 1e-3);
}
