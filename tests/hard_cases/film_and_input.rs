//! What becomes of bad samples, of many samples, and of files that say impossible things.

use super::draw::Draw;
use super::{made, room, scene};
use halfdisk::color::{Rgb, quantise, srgb_encode};
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Integrator, Kajiya, LADDER, Normals, Path, Settings};
use halfdisk::lab::naive;
use halfdisk::render::{Faults, Options, Pixel, Rendered, render, too_bright};
use halfdisk::sampling::stream::{Purpose, Sampler, Stream};
use halfdisk::scene::gallery::{self, GALLERY, load};
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, SceneError, Tracer};
use halfdisk::stats::Estimate;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// A path tracer in which one sample in ten thousand comes out as something else.
#[derive(Default)]
struct Injected {
    nan: AtomicU64,
    infinite: AtomicU64,
    negative: AtomicU64,
    /// True where bad samples are only counted, and those that replace them are black.
    nothing: bool,
}

impl Integrator for Injected {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let li = Path::new(4).li(tracer, ray, stream);
        // A number that no path asks for.
        let u = stream.at(u64::MAX, Purpose::Integrand).one();
        let (count, bad) = match (f64::from(u) * 1e4) as u32 {
            0 => match (f64::from(u) * 3e4) as u32 {
                0 => (&self.nan, Rgb::new(li.r, f32::NAN, f32::INFINITY)),
                1 => (&self.infinite, Rgb::new(f32::NEG_INFINITY, li.g, -1.0)),
                _ => (&self.negative, Rgb::new(li.r, li.g, -1e-20)),
            },
            _ => return li,
        };
        count.fetch_add(1, Relaxed);
        if self.nothing { li } else { bad }
    }
}

fn options(spp: u32) -> Options {
    Options {
        spp,
        seed: 39,
        ..Options::default()
    }
}

#[test]
fn a39_injected_faults_are_counted_exactly_and_spoil_no_other_sample() {
    let scene = room([64, 48]);
    let injected = Injected::default();
    let spoilt = render(&scene, &injected, &options(64), &());
    let count = |n: &AtomicU64| n.load(Relaxed);
    let expected = Faults {
        nan: count(&injected.nan),
        infinite: count(&injected.infinite),
        negative: count(&injected.negative),
    };
    println!(
        "seed 39: injected {expected:?}, counted {:?}",
        spoilt.faults
    );
    assert_eq!(spoilt.faults, expected);
    assert!(
        [expected.nan, expected.infinite, expected.negative]
            .iter()
            .all(|n| *n > 3)
    );
    assert_eq!(spoilt.non_finite, expected.nan + expected.infinite);
    assert!(spoilt.first_bad.is_some());

    let nothing = Injected {
        nothing: true,
        ..Injected::default()
    };
    let sound = render(&scene, &nothing, &options(64), &());
    assert_eq!((sound.faults, sound.first_bad), (Faults::default(), None));
    assert!(sound.largest > 0.0 && sound.largest.is_finite());
    // Pixels without a bad sample have the same bits, and the others lack only those.
    let mut untouched = 0;
    for (a, b) in spoilt.film.pixels().iter().zip(sound.film.pixels()) {
        let channels = a.channels.iter().zip(&b.channels);
        if a.count() == 64
            && channels
                .clone()
                .all(|(a, b)| (a.mean() - b.mean()).abs() < 1e-20)
        {
            untouched += 1;
        }
        assert!(channels.clone().all(|(a, _)| a.mean().is_finite()));
    }
    let all = expected.nan + expected.infinite + expected.negative;
    assert!(untouched + all >= 64 * 48 && untouched < 64 * 48);
    let ((a, error), (b, _)) = (spoilt.film.mean(), sound.film.mean());
    assert!((a - b).abs() < error, "{a} {b} {error}");

    // The plain twin: one such sample in a sum, and the level of what comes of it.
    let pixel = naive::mean([0.2, f32::NAN, 0.3]);
    assert!(
        pixel.is_nan() && naive::level(pixel) == 0,
        "a NaN pixel looks black"
    );
}

#[test]
fn a39_no_sample_of_the_gallery_is_at_fault() {
    let (mut samples, mut largest) = (0, 0.0_f32);
    for (name, _) in GALLERY {
        let scene = load(name).expect("a scene").sized([32, 24]);
        let depth = scene.suggested.max_depth.min(10);
        for integrator in LADDER {
            // Patches refuse scenes with round or moving things.
            let Ok(made) = integrator.prepare(&scene, &Settings::new(depth)) else {
                assert!(integrator.is_prepared(), "{name}");
                continue;
            };
            let by = integrator.name;
            let options = Options {
                sampler: Sampler::Sobol,
                ..options(16)
            };
            let Rendered {
                film,
                faults,
                largest: most,
                ..
            } = render(&scene, &made, &options, &());
            assert_eq!(faults, Faults::default(), "{name}, {by}");
            let longest = if integrator.is_endless {
                u32::MAX
            } else {
                depth
            };
            if let Some(bound) = scene.brightest(longest) {
                assert_eq!(too_bright(&film, bound), 0, "{name}, {by}, {bound}");
            }
            samples += 32 * 24 * 16;
            largest = largest.max(most);
        }
    }
    println!("seed 39: {samples} samples of the gallery without fault; the largest is {largest}");
}

/// Makes light: what comes along a path counts more than it should.
struct Lavish(f32);

impl Integrator for Lavish {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        Path::new(30).li(tracer, ray, stream) * self.0
    }
}

#[test]
fn a39_more_light_than_there_is_is_noticed() {
    // A closed room whose walls glow: 1 / (1 - 0.5) everywhere.
    let furnace = gallery::load("furnace").unwrap().sized([32, 32]);
    let bound = furnace.brightest(30).expect("lamps with extent only");
    let above = |share| {
        let film = render(&furnace, &Lavish(share), &options(32), &()).film;
        too_bright(&film, bound)
    };
    let found = [1.0, 1.2, 1.5].map(above);
    println!("bound {bound:.4}: of 1024 pixels too bright {found:?}, with 0, 20, 50 % more light");
    assert!(found[0] == 0 && found[2] > 900);
    let point = scene("[[lights]]\npoint = { position = [0, 1, 0], intensity = 1 }");
    assert_eq!(
        point.brightest(9),
        None,
        "near a point light there is no bound"
    );
}

#[test]
fn a39_the_bound_on_light_is_reached_at_every_depth_and_never_passed() {
    // In a closed sphere each path brings the same: `1 + 0.5 + 0.25 + …`, a term for each segment.
    let furnace = scene(
        "film.size = [8, 6]\n[[objects]]\nmaterial = 'half'\nemits = [1, 0.5, 0.25]\n\
         sphere = { center = [0, 0, 0], radius = 2, inward = true }",
    );
    for depth in 1..8_u32 {
        let bound = furnace.brightest(depth).expect("a lamp with extent");
        let exact = 2.0 - libm::pow(0.5, f64::from(depth - 1));
        assert!(
            (bound - exact).abs() < 1e-12,
            "{depth}: {bound} for {exact}"
        );
        let walk = Kajiya { max_depth: depth };
        let film = render(&furnace, &walk, &options(16), &()).film;
        let brightest = film.max();
        assert!(
            (brightest / bound - 1.0).abs() < 1e-5,
            "{depth}: {brightest}"
        );
        assert_eq!(too_bright(&film, bound), 0, "{depth}");
        // A bound of a bounce less is passed everywhere.
        if let Some(less) = furnace.brightest(depth - 1) {
            assert_eq!(too_bright(&film, less), film.pixels().len(), "{depth}");
        }
    }
    assert_eq!(furnace.brightest(0), Some(0.0));
}

#[test]
fn a40_a_hundred_million_samples_in_one_pixel() {
    // Multiples of 2^-24: their sum is a whole number.
    let (mut estimate, mut sum) = (Estimate::new(), 0_u64);
    let mut draw = Draw::new(40, 0);
    let n = 100_000_000_u64;
    let mut plain = 0.0_f32;
    for _ in 0..n {
        let x = 0.5 + draw.one();
        sum += (f64::from(x) * 16_777_216.0) as u64;
        plain += x;
        estimate.add(f64::from(x));
    }
    let truth = sum as f64 / 16_777_216.0 / n as f64;
    let off = (estimate.mean() / truth - 1.0).abs();
    let plain = (f64::from(plain) / n as f64 / truth - 1.0).abs();
    println!("seed 40: 10^8 samples, mean off by {off:.1e} of itself; a sum in f32 by {plain:.2}");
    assert!(off < 1e-6 && plain > 0.5);

    let tenths: Estimate = (0..10_000_000).map(|_| f64::from(0.1_f32)).collect();
    assert!((tenths.mean() - 0.1).abs() < 1e-6 && tenths.variance() == 0.0);
    let tenths = || std::iter::repeat_n(0.1, 10_000_000);
    let plain = [naive::mean(tenths()), naive::running_mean(tenths())];
    println!("10^7 tenths in f32: mean {plain:?}");
    assert!((plain[0] - 0.1).abs() > 1e-3);
    let ones: Estimate = (0..1 << 25).map(|_| 1.0).collect();
    assert_eq!((ones.mean(), ones.count()), (1.0, 1 << 25));
    assert_ne!(naive::mean(std::iter::repeat_n(1.0, 1 << 25)), 1.0);
}

#[test]
fn a41_variances_with_any_mean() {
    let mut draw = Draw::new(41, 0);
    // Mean 0, variance 1/3.
    let samples: Vec<f32> = (0..1_000_000).map(|_| draw.between(-1.0, 1.0)).collect();
    let third = 1.0 / 3.0;
    for mean in [0.0, 100.0, 1e3, 1e4] {
        let shifted = || samples.iter().map(|x| x + mean);
        let ours: Estimate = shifted().map(f64::from).collect();
        let plain = naive::variance(shifted());
        println!(
            "seed 41: mean {mean}: variance {:.5}, plainly {plain:.3}",
            ours.variance()
        );
        // At 1e4 the samples themselves are rounded to 1e-3.
        assert!((ours.variance() - third).abs() < 1e-3);
        assert!(mean < 1e3 || (plain - third as f32).abs() > 1.0);
    }
    let constant: Estimate = (0..1000).map(|_| f64::from(0.1_f32)).collect();
    assert_eq!(constant.variance(), 0.0);
    assert_ne!(naive::variance(std::iter::repeat_n(0.1, 1_000_000)), 0.0);

    let all = |part: &[f32]| {
        part.iter()
            .map(|x| f64::from(*x) + 1e4)
            .collect::<Estimate>()
    };
    let (whole, parts) = (all(&samples), samples.chunks(777).map(all));
    let joined = parts.fold(Estimate::new(), |sum, part| sum.merge(&part));
    assert!((joined.variance() / whole.variance() - 1.0).abs() < 1e-5);
}

#[test]
fn a42_rare_bright_samples_are_kept() {
    let mut draw = Draw::new(42, 0);
    let (mut ours, mut clamped) = (Pixel::default(), Estimate::new());
    for _ in 0..10_000_000 {
        let x = if draw.one() < 1e-4 { 1e4 } else { 0.0 };
        ours.add(Rgb::grey(x));
        clamped.add(f64::from(x.min(10.0)));
    }
    let kept = ours.channels[0];
    println!(
        "seed 42: mean 1 reads {:.3}; clamped at 10 {:.4}",
        kept.mean(),
        clamped.mean()
    );
    assert!(kept.z(1.0).abs() <= 4.4 && clamped.z(1.0).abs() > 4.4);
}

#[test]
fn a43_levels_are_equally_wide() {
    for k in 0..=255 {
        assert_eq!(quantise(f64::from(k) / 255.0), k as u8);
    }
    // How many of 256 000 even values have each level. Rounded to the nearest the first and the last
    // have half as many, and all others more.
    let widths = |level: &dyn Fn(f64) -> u8| {
        let mut widths = [0; 256];
        (0..256_000).for_each(|i| widths[usize::from(level((f64::from(i) + 0.5) / 256e3))] += 1);
        widths
    };
    assert_eq!(widths(&quantise), [1000; 256]);
    let rounded = widths(&|x| (x * 255.0).round() as u8);
    assert!(rounded[0] == 502 && rounded[255] == 502 && rounded[100] == 1004);
    let mean = |level: &dyn Fn(f32) -> u8| {
        let each = (0..1_000_000).map(|i| f64::from(level((i as f32 + 0.5) / 1e6)));
        each.sum::<f64>() / 255e6
    };
    let bias = [mean(&|x| quantise(f64::from(x))), mean(&naive::level)].map(|m| m - 0.5);
    println!(
        "mean level of all values: ours {:+.1e}, cut off {:+.1e}",
        bias[0], bias[1]
    );
    assert!(bias[0].abs() < 1e-6 && bias[1] < -1.9e-3);
    assert_eq!([-1.0, -0.0, f64::NEG_INFINITY].map(quantise), [0; 3]);
    let knee = 0.003_130_8_f64;
    assert!((srgb_encode(knee.next_up()) - srgb_encode(knee)).abs() < 1e-6);
}

fn try_load(text: &str) -> Result<Scene, SceneError> {
    let source = Source {
        file: "t.toml",
        text,
    };
    gallery::from_text(source, None, |_| {})
}

#[test]
fn a44_pictures_of_any_size_or_a_sentence() {
    let sized = |size: [u64; 2]| {
        try_load(&format!(
            "name = 't'\ncamera = {{ from = [0, 0, 0], to = [0, 0, 1], fov = 40 }}\n\
             film.size = {size:?}\n"
        ))
    };
    for size in [[1, 1], [1, 65_536], [65_536, 1], [3, 4096]] {
        let scene = sized(size).unwrap();
        let film = render(&scene, &Normals, &options(1), &()).film;
        assert_eq!(film.pixels().len() as u64, size[0] * size[1]);
    }
    for size in [
        [0, 0],
        [0, 5],
        [5, 0],
        [1, 65_537],
        [65_536, 65_536],
        [u64::from(u32::MAX), 1],
        [u64::from(u32::MAX); 2],
    ] {
        let sentence = sized(size).expect_err("no such picture").to_string();
        assert!(sentence.starts_with("t.toml:3: `film.size"), "{sentence}");
    }
    println!("four extreme sizes painted, seven refused");
    assert_eq!(
        naive::pixels([65_536; 2]),
        0,
        "counted in 32 bits it has no pixel"
    );
}

#[test]
fn a45_what_rust_reads_as_a_number() {
    // All of these are numbers for `str::parse`.
    for word in ["nan", "inf", "1e39"] {
        assert!(word.parse::<f32>().is_ok_and(|x| !x.is_finite()));
        let text = format!(
            "name = 't'\ncamera = {{ from = [0, 0, 0], to = [0, 0, 1], fov = 40 }}\n\
             [[lights]]\npoint = {{ position = [0, {word}, 0], intensity = 1 }}\n"
        );
        let sentence = try_load(&text).expect_err("no number").to_string();
        assert!(
            sentence.starts_with("t.toml:4: `lights[0].point.position[1]`"),
            "{sentence}"
        );
    }
    println!("three words that parse as no finite number: refused with line and field");
}

#[test]
fn a46_nothing_at_all() {
    let text = "name = 't'\nbackground = [0.1, 0.2, 30]\nfilm.size = [5, 4]\n\
                camera = { from = [0, 0, 0], to = [0, 0, 1], fov = 40 }\n";
    for (objects, shade) in [("", 1.0), ("objects = []\nlights = []\n", 1.0)] {
        let scene = try_load(&format!("{objects}{text}")).unwrap();
        // Where nothing is diffuse there are no patches.
        for integrator in LADDER.into_iter().filter(|entry| !entry.is_prepared()) {
            let film = render(&scene, &made(&integrator, &scene, 5), &options(3), &()).film;
            for pixel in film.pixels() {
                let exact = [0.1_f32, 0.2, 30.0].map(|x| f64::from(x) * shade);
                assert_eq!(pixel.mean(), Some(exact), "{}", integrator.name);
            }
        }
    }
    println!("empty scenes: the background to the last bit, by seven integrators");
}
