//! The same light, however the scene is put: scaled, turned, mirrored, doubled, cut in pieces.

use super::{made, room_with, scene};
use crate::checks::between;
use glam::DVec3;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Entry, Integrator, Kajiya, Path, Roulette};
use halfdisk::lab::naive;
use halfdisk::render::{Film, Options, render};
use halfdisk::sampling::stream::{Sampler, Stream};
use halfdisk::scene::description::{Description, Shape};
use halfdisk::scene::value::Triple;
use halfdisk::scene::{Scene, Tracer};

const SIZE: [i64; 2] = [40, 30];

fn film(scene: &Scene, spp: u32, seed: u64) -> Film {
    let options = Options {
        spp,
        seed,
        sampler: Sampler::Independent,
        ..Options::default()
    };
    let rendered = render(scene, &Path::new(6), &options, &());
    assert_eq!(rendered.faults, Default::default());
    rendered.film
}

/// By how many standard errors the means of two pictures differ.
fn apart(a: &Film, b: &Film) -> f64 {
    between(a.mean(), b.mean()).0
}

/// The room with every point sent elsewhere; `turns` where left and right change places.
fn mapped(map: impl Fn(DVec3) -> DVec3, scale: f64, turns: bool) -> Scene {
    room_with(SIZE, |said: &mut Description| {
        let point = |p: &mut [f64; 3]| *p = map(DVec3::from(*p)).to_array();
        let camera = &mut said.camera;
        [&mut camera.from.0, &mut camera.to.0, &mut camera.up.0]
            .into_iter()
            .for_each(point);
        for object in &mut said.objects {
            match &mut object.shape {
                Shape::Sphere { center, radius, .. } => {
                    point(&mut center.0);
                    radius.0 *= scale;
                }
                Shape::Quad { corner, u, v } => {
                    [&mut corner.0, &mut u.0, &mut v.0]
                        .into_iter()
                        .for_each(point);
                    if turns {
                        std::mem::swap(u, v);
                    }
                }
                _ => {}
            }
        }
    })
}

#[test]
fn a04_scaled_by_any_power_of_two_no_bit_changes() {
    let first = film(&mapped(|p| p, 1.0, false), 4, 1);
    for k in -20..=20 {
        let scale = libm::exp2(f64::from(k));
        let scaled = film(&mapped(|p| p * scale, scale, false), 4, 1);
        assert_eq!(first, scaled, "2^{k}");
    }
    // Scaled by anything else the roundings are others.
    assert_ne!(first, film(&mapped(|p| p * 3.0, 3.0, false), 4, 1));
    println!("41 scales, all bits equal");
}

#[test]
fn turned_and_mirrored_the_light_is_the_same() {
    let first = film(&mapped(|p| p, 1.0, false), 256, 1);
    let turn = |p: DVec3| {
        let (sin, cos) = libm::sincos(0.7);
        DVec3::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y, p.z)
    };
    let pictures = [
        (
            "x to y to z",
            mapped(|p| DVec3::new(p.z, p.x, p.y), 1.0, false),
        ),
        (
            "upside down",
            mapped(|p| DVec3::new(-p.x, -p.y, p.z), 1.0, false),
        ),
        ("by 0.7", mapped(turn, 1.0, false)),
        (
            "mirrored",
            mapped(|p| DVec3::new(-p.x, p.y, p.z), 1.0, true),
        ),
    ];
    for (name, scene) in pictures {
        let z = apart(&first, &film(&scene, 256, 2));
        println!("seeds 1, 2: {name}: z {z:.2}");
        assert!(z.abs() <= 4.4, "{name}: {z}");
    }
    // A room a little narrower is noticed.
    let narrow = mapped(|p| DVec3::new(p.x * 0.95, p.y, p.z), 1.0, false);
    assert!(apart(&first, &film(&narrow, 256, 2)).abs() > 4.4);
}

fn corner_and_edge(shape: &mut Shape) -> [&mut Triple; 2] {
    match shape {
        Shape::Quad { corner, u, .. } => [corner, u],
        other => panic!("{other:?}"),
    }
}

#[test]
fn objects_doubled_and_lamps_cut_in_two() {
    let plain = |_: &mut Description| {};
    let first = film(&room_with(SIZE, plain), 16, 3);
    // Of two surfaces in one place the first in the file is met.
    let doubled = room_with(SIZE, |said| {
        let dark = said.objects.iter().filter(|o| o.emits.is_none());
        let again: Vec<_> = dark.cloned().collect();
        said.objects.extend(again);
    });
    assert_eq!(first, film(&doubled, 16, 3), "doubled");
    let turned = room_with(SIZE, |said| said.objects.reverse());
    assert_eq!(first, film(&turned, 16, 3), "in another order");

    let halves = |said: &mut Description| {
        let lamp = said.objects.iter().position(|o| o.emits.is_some());
        let mut half = said.objects.remove(lamp.expect("a lamp"));
        let [_, u] = corner_and_edge(&mut half.shape);
        u.0 = u.0.map(|x| 0.5 * x);
        let mut other = half.clone();
        let [corner, u] = corner_and_edge(&mut other.shape);
        (0..3).for_each(|i| corner.0[i] += u.0[i]);
        said.objects.extend([half, other]);
    };
    let whole = film(&room_with(SIZE, plain), 256, 4);
    let z = apart(&whole, &film(&room_with(SIZE, halves), 256, 5));
    println!("seeds 4, 5: a lamp in two halves: z {z:.2}");
    assert!(z.abs() <= 4.4);
    // Of two lamps in one place the second is never met, and not aimed at.
    let twice = room_with(SIZE, |said| {
        let lamp = said.objects.iter().find(|o| o.emits.is_some()).cloned();
        said.objects.extend(lamp);
    });
    assert_eq!((twice.lights.len(), twice.report.hidden_lights), (1, 1));
    assert_eq!(whole, film(&twice, 256, 4), "two lamps in one place");
    // A lamp a little below hides the first, and is another picture.
    let below = room_with(SIZE, |said| {
        let lamp = said.objects.iter().find(|o| o.emits.is_some()).cloned();
        let mut lamp = lamp.expect("a lamp");
        corner_and_edge(&mut lamp.shape)[0].0[1] -= 0.2;
        said.objects.push(lamp);
    });
    assert!(apart(&whole, &film(&below, 256, 5)).abs() > 4.4);
}

#[test]
fn a47_sums_in_another_order_are_other_sums() {
    let mut draw = super::draw::Draw::new(47, 0);
    let samples: Vec<f32> = (0..100_000).map(|_| draw.one()).collect();
    let halves = |count: usize| {
        let parts = samples.chunks(samples.len().div_ceil(count));
        naive::mean(parts.map(|part| naive::mean(part.iter().copied())))
    };
    let plain = [1, 2, 7].map(halves);
    println!("seed 47: means of 1, 2, 7 parts in f32: {plain:?}");
    assert!(plain[0] != plain[1] || plain[1] != plain[2]);
    // Ours are the same on any threads and tiles: `determinism::threads_*` and `tiles_*`; here on
    // pools of their own.
    let scene = room_with(SIZE, |_| {});
    let pools = [1, 2, 7].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build().unwrap().install(|| film(&scene, 8, 47))
    });
    assert_eq!(pools[0], pools[1]);
    assert_eq!(pools[0], pools[2]);
}

#[test]
fn a48_paths_end_before_their_light_does() {
    // Walls that reflect a billionth: every bounce brings throughputs closer to those that cost more.
    let dim = scene(
        "[materials.dim]\nlambert.albedo = 1e-9\n[[objects]]\nmaterial = 'dim'\nemits = 1\n\
         sphere = { center = [0, 0, 0], radius = 1, inward = true }\n",
    );
    let rays = |integrator: Entry| {
        let (name, integrator) = (integrator.name, made(&integrator, &dim, 1000));
        let mut tracer = Tracer::new(&dim);
        let mut sum = 0.0;
        for i in 0..1000 {
            let ray = Ray::new(glam::Vec3::ZERO, glam::Vec3::Z);
            sum += f64::from(integrator.li(&mut tracer, &ray, &Stream::new(48, 0, i)).g);
        }
        assert!((sum / 1000.0 - 1.0).abs() < 1e-6, "{name}: {sum}");
        tracer.counts().total() as f64 / 1000.0
    };
    let [path, roulette, walk] = [Path::ENTRY, Roulette::ENTRY, Kajiya::ENTRY].map(rays);
    println!("seed 48: rays of a path {path:.1}, by roulette {roulette:.1}, cut at 1000 {walk:.0}");
    assert!(path < 20.0 && roulette < 3.0 && walk > 900.0);
}
