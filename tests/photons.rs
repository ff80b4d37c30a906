//! What photons show is the light, blurred as much as they say.

use crate::checks::{alike, unlike};
use glam::Vec3;
use halfdisk::color::Rgb;
use halfdisk::integrators::{Integrator, LightTracer, Pass, Path, Photons};
use halfdisk::photons::{Photon, PhotonMap, radius};
use halfdisk::render::{Options, Progress, Rendered, Session, compare, render};
use halfdisk::sampling::stream::{Purpose, Sampler, Stream};
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, gallery};
use halfdisk::stats::Estimate;
use halfdisk::stats::slope::fit;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU32, Ordering};

fn scene(text: &str) -> Scene {
    let text = format!("name = 'test'\nfilm.size = [8, 8]\n{text}");
    let source = Source {
        file: "test.toml",
        text: &text,
    };
    gallery::from_text(source, None, |_| {}).unwrap()
}

fn rendered(scene: &Scene, integrator: &dyn Integrator, spp: u32, seed: u64) -> Rendered {
    let options = Options {
        spp,
        seed,
        // Looks at the middle of each pixel.
        fixed: &[Purpose::Pixel],
        ..Options::default()
    };
    let rendered = render(scene, integrator, &options, &());
    assert_eq!(rendered.faults, Default::default(), "{}", scene.name);
    rendered
}

/// Photons whose discs stay as they are.
fn fixed(max_depth: u32, radius: f32, walks: u32) -> Photons {
    Photons {
        radius: Some(radius),
        alpha: 1.0,
        walks: Some(walks),
        ..Photons::new(max_depth)
    }
}

/// The mean of pictures with maps of their own, and its error: pixels of one map are no independent
/// numbers, so it is from the means of whole pictures.
fn mean(scene: &Scene, integrator: &Photons, spp: u32, seeds: u64) -> (f64, f64) {
    let one = |seed| rendered(scene, integrator, spp, seed).film.mean().0;
    let means: Estimate = (0..seeds).map(one).collect();
    (means.mean(), means.std_error())
}

#[test]
fn the_map_finds_what_a_loop_finds() {
    let stream = Stream::new(1, 0, 0);
    for (place, scale) in [1e-3_f32, 1.0, 1e6].into_iter().enumerate() {
        let mut numbers = stream.at(place as u64, Purpose::Integrand);
        let mut point = || Vec3::from_array([(); 3].map(|()| scale * (2.0 * numbers.one() - 1.0)));
        let photons: Vec<Photon> = (0..2000_u32)
            .map(|segments| Photon {
                // Half of them in a plane, and some in the corners of cells.
                p: match segments % 4 {
                    0 | 1 => point() * Vec3::new(1.0, 0.0, 1.0),
                    2 => (point() / (0.2 * scale)).round() * (0.2 * scale),
                    _ => point(),
                },
                n: Vec3::Y,
                wi: Vec3::Y,
                power: Rgb::WHITE,
                segments,
            })
            .collect();
        let (mut found, mut wrong) = (0, 0);
        for share in [1e-3, 0.1, 0.3, 5.0] {
            let map = PhotonMap::new(photons.clone(), 1, share * scale);
            assert_eq!(map.photons().len(), photons.len());
            for i in 0..300 {
                let p = if i < 50 { photons[40 * i].p } else { point() };
                let (mut near, mut all) = (Vec::new(), Vec::new());
                map.near(p, |photon| near.push(photon.segments));
                map.near_by_loop(p, |photon| all.push(photon.segments));
                let order = near.clone();
                map.near(p, |photon| near.push(photon.segments));
                assert_eq!(near[order.len()..], order, "the same order each time");
                near.truncate(order.len());
                near.sort_unstable();
                all.sort_unstable();
                assert_eq!(near, all, "radius {share}, at {p}");
                found += all.len();
                // The mistake of looking in one cell only.
                let cell = |p: Vec3| (p / (2.0 * share * scale)).floor();
                let own = |&&s: &&u32| cell(photons[s as usize].p) == cell(p);
                wrong += usize::from(all.iter().filter(own).count() != all.len());
            }
        }
        assert!(found > 100_000 && wrong > 300, "{found} {wrong}");
    }
    for radius in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        PhotonMap::new(Vec::new(), 1, radius).near(Vec3::ZERO, |_| unreachable!());
    }
}

/// A floor under a mirror, and between them a lamp at height 1: the mirror shows another one at height 3.
const MIRRORED: &str = "camera = { from = [0, 1.9, 0], to = [0, 0, 0], up = [0, 0, 1], fov = 55.5 }\n\
    materials.half.lambert.albedo = 0.5\nmaterials.ideal.mirror.reflectance = 1\n\
    [[objects]]\nmaterial = 'half'\nquad = { corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }\n\
    [[objects]]\nmaterial = 'ideal'\nquad = { corner = [-99, 2, -99], u = [198, 0, 0], v = [0, 0, 198] }\n\
    [[lights]]\npoint = { position = [0, 1, 0], intensity = 1 }\n";

/// Light to the mirror, to the floor, to the eye: no path of more segments.
const ONCE: u32 = 3;

/// The irradiance by a point of 1 W/sr at a height, so far aside of its foot.
fn irradiance(height: f64, aside2: f64) -> f64 {
    let distance2 = height * height + aside2;
    height / (distance2 * distance2.sqrt())
}

/// The same, blurred by Epanechnikov's kernel of a radius.
fn blurred(height: f64, [x, z]: [f64; 2], radius: f64) -> f64 {
    const N: u32 = 24;
    let middle = |i: u32| (f64::from(i) + 0.5) / f64::from(N);
    let mut sum = 0.0;
    for i in 0..N {
        // Uniform in area.
        let share = middle(i);
        let aside = radius * share.sqrt();
        for j in 0..N {
            let (sin, cos) = libm::sincos(std::f64::consts::TAU * middle(j));
            let (x, z) = (x + aside * cos, z + aside * sin);
            sum += 2.0 * (1.0 - share) * irradiance(height, x * x + z * z);
        }
    }
    sum / f64::from(N * N)
}

/// The radiance of the middles of `side * side` pixels of the picture of [`MIRRORED`], row by row.
fn exact(scene: &Scene, side: u32, radius: f64) -> Vec<f64> {
    let half = 0.5 * f64::from(scene.camera.film_area()).sqrt() * 1.9;
    let at = |pixel: u32| half * (2.0 * (f64::from(pixel) + 0.5) / f64::from(side) - 1.0);
    let pixels = (0..side).flat_map(|y| (0..side).map(move |x| [at(x), at(y)]));
    let radiance = |p: [f64; 2]| {
        let sum = irradiance(1.0, p[0] * p[0] + p[1] * p[1]) + blurred(3.0, p, radius);
        0.5 / std::f64::consts::PI * sum
    };
    pixels.map(radiance).collect()
}

#[test]
fn a_lamp_in_a_mirror_lights_the_floor_as_its_image_would() {
    let scene = scene(MIRRORED);
    let average = |pixels: Vec<f64>| pixels.iter().sum::<f64>() / pixels.len() as f64;
    let sharp = (average(exact(&scene, 8, 0.0)), 0.0);
    for radius in [2.0_f32, 1.0, 0.1] {
        let ours = mean(&scene, &fixed(ONCE, radius, 1 << 14), 8, 24);
        let soft = average(exact(&scene, 8, f64::from(radius)));
        println!("radius {radius}: blurred {soft:.6}, sharp {:.6}", sharp.0);
        alike("floor", ours, (soft, 0.0), 0.008);
        // What they bring is the light, the smaller the radius the closer.
        if radius > 1.5 {
            unlike("blur", ours, sharp);
        } else if radius < 0.2 {
            alike("sharp", ours, sharp, 0.008);
        }
        // A photon in ten too many.
        let (direct, error) = (average(exact(&scene, 8, 1e6)), ours.1);
        let more = direct + (ours.0 - direct) * 1.1;
        unlike("more", (more, error), (soft, 0.0));
    }
    // Nothing but light straight from the lamp where no photon is looked for.
    let direct = rendered(&scene, &Photons::new(2), 16, 3).mean();
    alike(
        "direct",
        direct,
        (average(exact(&scene, 8, 1e6)), 0.0),
        0.02,
    );
}

#[test]
fn the_error_falls_as_it_should() {
    let scene = scene(MIRRORED).sized([2, 2]);
    let truth = exact(&scene, 2, 0.0);
    let slope = |alpha: f64| {
        let sizes: Vec<u32> = (4..=9).map(|k| 1 << k).collect();
        let squared = |replicate: u64, size: &u32| {
            let photons = Photons {
                alpha,
                ..fixed(ONCE, 1.6, 32)
            };
            let seed = replicate << 32 | u64::from(*size);
            let film = rendered(&scene, &photons, *size, seed).film;
            let pixels = film.pixels().iter().map(|p| p.mean().unwrap()[0]);
            let squares = pixels.zip(&truth).map(|(x, truth)| (x - truth).powi(2));
            squares.sum::<f64>()
        };
        let replicates: Vec<u64> = (0..160).collect();
        let squares = replicates.into_par_iter();
        let squares = squares.map(|r| sizes.iter().map(|size| squared(r, size)).collect());
        let squares: Vec<Vec<f64>> = squares.collect();
        let costs = vec![sizes.iter().map(|&n| f64::from(n)).collect(); squares.len()];
        fit(&costs, &squares).unwrap()
    };
    let (shrinking, staying) = (slope(radius::FASTEST), slope(1.0));
    println!("shrinking {shrinking}, staying {staying}");
    let off = shrinking.line.slope + 1.0 / 3.0;
    assert!(off.abs() < 0.05, "{shrinking}");
    assert!(shrinking.half_width < 0.03, "{shrinking}");
    assert!(staying.line.slope > -0.25, "{staying}");
    // As the power -1/6 of the number of passes.
    let shrunk = |n: u32| radius::shrunk(radius::FASTEST, n - 1);
    assert_eq!([shrunk(1), radius::shrunk(1.0, 99)], [1.0; 2]);
    assert!((0.5..0.55).contains(&shrunk(64)), "{}", shrunk(64));
    let halved = shrunk(64_000) / shrunk(1000);
    assert!((halved - 0.5).abs() < 1e-4, "{halved}");
}

/// A floor that is seen in a mirror, and a lamp that has no extent: so low that no ray from it goes by way of the
/// mirror down to the floor.
fn in_a_mirror(around_the_lamp: &str) -> Scene {
    scene(&format!(
        "camera = {{ from = [0, 3, 0], to = [0, 1.5, -2], fov = 20 }}\n\
         materials.half.lambert.albedo = 0.5\nmaterials.ideal.mirror.reflectance = 0.8\n\
         materials.clear.glass.ior = 1.5\n\
         [[objects]]\nmaterial = 'half'\nquad = {{ corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }}\n\
         [[objects]]\nmaterial = 'ideal'\nquad = {{ corner = [-4, 0.8, -2], u = [8, 0, 0], v = [0, 4, 0] }}\n\
         [[lights]]\npoint = {{ position = [2, 0.7, 0.4], intensity = 20 }}\n{around_the_lamp}"
    ))
}

#[test]
fn a_point_in_glass_seen_in_a_mirror() {
    // Its rays leave the middle of a ball as they came, and all of them leave it in the end.
    let ball =
        "[[objects]]\nmaterial = 'clear'\nsphere = { center = [2, 0.7, 0.4], radius = 0.05 }\n";
    let (bare, covered) = (in_a_mirror(""), in_a_mirror(ball));
    for nobody in [
        &Path::new(12) as &dyn Integrator,
        &LightTracer { max_depth: 12 },
    ] {
        let dark = rendered(&covered, nobody, 64, 1);
        assert_eq!(dark.film.mean().0, 0.0, "LS+DS+E is out of reach");
    }
    let truth = rendered(&bare, &Path::new(12), 1024, 2).mean();
    let photons = Photons {
        walks: Some(1 << 13),
        radius: Some(0.2),
        ..Photons::new(12)
    };
    // Of which the blur makes half a per cent more.
    let ours = mean(&covered, &photons, 16, 24);
    alike("covered", ours, truth, 0.03);
    alike("bare", mean(&bare, &photons, 16, 4), truth, 0.02);
    unlike("no mirror", (ours.0 / 0.8, ours.1 / 0.8), truth);
}

#[test]
fn power_is_neither_made_nor_lost() {
    let furnace = gallery::load("furnace").unwrap();
    let photons = Photons::new(6);
    let pass = Pass {
        scene: &furnace,
        sample: 3,
        seed: 1,
        sampler: Sampler::Independent,
        fixed: &[],
        stop: &|| false,
    };
    let walks = 1 << 16;
    let traced = pass.trace(0..walks, |tracer, stream, leave| {
        photons.trace(tracer, pass.moment(), stream, leave);
    });
    let (found, rays) = traced.unwrap();
    assert!(rays.secondary > u64::from(walks) && rays.camera == 0);
    // Six walls of four units that send π, and keep half of what they get.
    let emitted = 24.0 * std::f64::consts::PI;
    for segments in 2..6 {
        let lands = found.iter().filter(|photon| photon.segments == segments);
        let sum: f64 = lands.clone().map(|photon| f64::from(photon.power.g)).sum();
        let expected = emitted * 0.5_f64.powi(segments as i32 - 1);
        let share = lands.count() as f64 / f64::from(walks);
        let error = expected / (share * f64::from(walks)).sqrt();
        alike(
            "flux",
            (sum / f64::from(walks), error),
            (expected, 0.0),
            0.1,
        );
    }
    assert!(found.iter().all(|photon| (2..6).contains(&photon.segments)));
    // Roulette keeps their powers alike.
    let all = found.iter().map(|photon| photon.power.g);
    let (least, most) = all.fold((f32::MAX, 0.0_f32), |(a, b), x| (a.min(x), b.max(x)));
    assert!(most < 1.001 * least, "{least} {most}");
}

#[test]
fn a_furnace_reads_what_its_walls_add_up_to() {
    // No disc reaches an edge of the room.
    let furnace = gallery::load("furnace").unwrap().sized([8; 2]);
    let expected = |depth: u32| 2.0 * (1.0 - 0.5_f64.powi(depth as i32));
    for depth in [1, 2, 3, 5, 24] {
        let ours = mean(&furnace, &fixed(depth, 0.08, 1 << 14), 4, 12);
        if depth <= 2 {
            // Light straight from the walls is found by aiming, with some noise.
            assert!((ours.0 / expected(depth) - 1.0).abs() < 0.02, "{ours:?}");
            continue;
        }
        alike("furnace", ours, (expected(depth), 0.0), 0.04);
        if depth < 6 {
            unlike("a bounce too few", ours, (expected(depth - 1), 0.0));
        }
    }
    // Discs that reach beyond walls lack what is not there, and lack less as they shrink.
    let lacks = |radius| 2.0 - mean(&furnace, &fixed(24, radius, 1 << 12), 4, 12).0;
    let [wide, half] = [1.0, 0.5].map(lacks);
    println!("lacks {wide:.3} and {half:.3}");
    assert!(wide > 0.08 && half < 0.7 * wide);
}

#[test]
fn pictures_of_the_gallery_are_those_of_path() {
    for (name, blur) in [
        ("cornell", 0.04),
        ("spheres", 0.04),
        ("caustic", 0.05),
        ("motion", 0.04),
    ] {
        let scene = gallery::load(name).unwrap().sized([16; 2]);
        let max_depth = scene.suggested.max_depth.min(8);
        let photons = Photons {
            walks: Some(1 << 12),
            ..Photons::new(max_depth)
        };
        let evenly = |spp| Options {
            spp,
            sampler: Sampler::Sobol,
            ..Options::default()
        };
        let ours = render(&scene, &photons, &evenly(64), &());
        let path = render(&scene, &Path::new(max_depth), &evenly(1024), &());
        let ratio = ours.film.mean().0 / path.film.mean().0;
        let [a, b] = [&ours, &path].map(|made| made.film.picture().in_squares(4));
        let rel = compare::rel_mse(&a, &b).sqrt();
        println!("{name}: {ratio:.4} of path, parts differ by {rel:.4}");
        assert!((ratio - 1.0).abs() < blur, "{name}: {ratio}");
        assert!(rel < 0.2, "{name}: {rel}");
    }
}

/// Stops when it was asked so often.
struct After(AtomicU32, u32);

impl Progress for After {
    fn tell(&self, _: u64, _: u64) {}

    fn stop(&self) -> bool {
        self.0.fetch_add(1, Ordering::Relaxed) >= self.1
    }
}

#[test]
fn photons_are_the_same_on_any_threads_tiles_and_pauses_and_stop_when_told() {
    let scene = gallery::load("six").unwrap().sized([24, 17]);
    let photons = Photons::new(6);
    let options = |tile| Options {
        spp: 5,
        tile,
        ..Options::default()
    };
    let made = |threads: usize, tile: u32| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let work = || render(&scene, &photons, &options(tile), &());
        pool.build().unwrap().install(work)
    };
    let (one, three) = (made(1, 16), made(3, 5));
    assert_eq!(one.film, three.film);
    assert_eq!(one.rays, three.rays);
    let mut session = Session::new(&scene, &photons as &dyn Integrator, &options(16));
    session.advance(2, &());
    session.advance(5, &());
    assert_eq!(one.film, session.film());
    // Within the first paths from the lights, and later.
    for questions in [1, 500, 1000] {
        let progress = After(AtomicU32::new(0), questions);
        let rendered = render(&scene, &photons, &options(16), &progress);
        assert!(rendered.interrupted, "{questions}");
        let counts = rendered.film.pixels().iter().map(|pixel| pixel.count());
        assert_eq!(counts.max() == Some(0), questions < 24 * 17, "{questions}");
    }
}
