//! What a density estimate reads where the answer is known: plates, their edges and corners, the nearest.

use super::scene;
use crate::checks::{CRITICAL, alike, reject};
use glam::Vec3;
use halfdisk::integrators::{Pass, Photons};
use halfdisk::photons::edge::{share_on_line, share_on_rectangle};
use halfdisk::photons::nearest::{Count, density};
use halfdisk::photons::{Kernel, Photon, PhotonMap};
use halfdisk::sampling::stream::{Purpose, Sampler, Stream};
use halfdisk::space::{Flat, Solid, Space};
use halfdisk::stats::Estimate;

/// A plate under light of irradiance 1 that comes straight down.
const PLATE: &str = "camera = { from = [5, 9, 5], to = [5, 0, 5], up = [0, 0, 1], fov = 40 }\n\
    materials.half.lambert.albedo = 0.5\n[[objects]]\nmaterial = 'half'\n\
    quad = { corner = [0, 0, 10], u = [10, 0, 0], v = [0, 0, -10] }\n\
    [[lights]]\ndirectional = { direction = [0, -1, 0], irradiance = 1 }\n";

fn of(reads: &Estimate) -> (f64, f64) {
    (reads.mean(), reads.std_error())
}

/// A point of the plate as the scene has it, whose origin is the camera.
fn from_the_camera(x: f32, z: f32) -> Vec3 {
    Vec3::new(x - 5.0, -9.0, z - 5.0)
}

/// Photons of a pass over the plate, and how many walks brought them.
fn plate(walks: u32, seed: u64) -> Vec<Photon> {
    let scene = scene(PLATE);
    let pass = Pass {
        scene: &scene,
        sample: 0,
        seed,
        sampler: Sampler::Independent,
        fixed: &[],
        stop: &|| false,
    };
    let photons = Photons::new(3);
    let found = pass.trace(0..walks, |tracer, stream, leave| {
        photons.trace(tracer, 0.0, stream, leave);
    });
    found.unwrap().0
}

#[test]
fn a_plate_reads_half_at_an_edge_and_a_quarter_in_a_corner() {
    const WALKS: u32 = 1 << 16;
    let radius = 1.0;
    for kernel in [Kernel::Constant, Kernel::Epanechnikov] {
        let maps: Vec<PhotonMap> = (0..16)
            .map(|seed| PhotonMap::new(plate(WALKS, seed), WALKS, radius, kernel))
            .collect();
        for (what, [x, z], share) in [
            ("middle", [5.0, 5.0], 1.0),
            ("edge", [0.0, 5.0], 0.5),
            ("corner", [10.0, 0.0], 0.25),
        ] {
            let at = from_the_camera(x, z);
            let read = |map: &PhotonMap| map.estimate(at, Vec3::Y, radius, |p| p.power).g;
            let reads: Estimate = maps.iter().map(|map| f64::from(read(map))).collect();
            alike(what, of(&reads), (share, 0.0), 0.12);
            // The cure, which is exact for the constant kernel, and by symmetry here for any.
            let part = share_on_rectangle([x, z].map(f64::from), [10.0; 2], f64::from(radius));
            let cured: Estimate = maps.iter().map(|map| f64::from(read(map)) / part).collect();
            alike("cured", of(&cured), (1.0, 0.0), 0.12);
            if part < 0.9 {
                reject("not cured", &reads, 1.0);
            }
        }
    }
}

#[test]
fn a_line_reads_half_at_its_end() {
    const WALKS: u32 = 20_000;
    let length = 10.0_f64;
    let photons = |seed: u32| -> Vec<Photon<Flat>> {
        let one = |i| {
            let u = Stream::new(5, i, seed).at(0, Purpose::Emission).one();
            Photon {
                p: Flat::from_plane(glam::Vec2::new(u * length as f32, 0.0)),
                n: glam::Vec2::Y,
                wi: glam::Vec2::Y,
                power: halfdisk::color::Rgb::grey(length as f32),
                segments: 1,
            }
        };
        (0..WALKS).map(one).collect()
    };
    for (at, share) in [(5.0, 1.0), (0.0, 0.5), (10.0, 0.5), (0.5, 0.75)] {
        let read = |seed| {
            let map = PhotonMap::new(photons(seed), WALKS, 1.0, Kernel::Constant);
            let p = glam::Vec2::new(at, 0.0);
            f64::from(map.estimate(p, glam::Vec2::Y, 1.0, |p| p.power).g)
        };
        let reads: Estimate = (0..40).map(read).collect();
        alike("line", of(&reads), (share, 0.0), 0.04);
        let part = share_on_line(f64::from(at), length, 1.0);
        let cured = reads.mean() / part;
        assert!(
            (cured - 1.0).abs() < CRITICAL * reads.std_error() / part,
            "{cured}"
        );
    }
}

/// The density of evenly spread points by the k nearest of a place, `runs` times.
fn nearest<S: Space>(k: usize, count: Count, runs: u32) -> Estimate {
    let side = 2.0;
    let points = 400;
    let one = |run| {
        let mut numbers = Stream::new(11, run, k as u32).at(0, Purpose::Integrand);
        let mut along = || side * (f64::from(numbers.one()) - 0.5);
        let mut squares: Vec<f64> = (0..points)
            .map(|_| (0..S::FALL_OFF).map(|_| along().powi(2)).sum())
            .collect();
        let measure: f64 = (0..S::FALL_OFF).map(|_| side).product();
        let density = density::<S>(&mut squares, k, count).unwrap();
        density * measure / f64::from(points)
    };
    (0..runs).map(one).collect()
}

#[test]
fn the_nearest_read_what_they_should_and_one_too_many_reads_more() {
    fn check<S: Space>() {
        for (k, runs) in [(5, 100_000), (20, 40_000), (50, 20_000)] {
            let right = nearest::<S>(k, Count::LessOne, runs);
            alike("right", of(&right), (1.0, 0.0), 0.015);
            let wrong = nearest::<S>(k, Count::All, runs);
            let more = k as f64 / (k as f64 - 1.0);
            alike("k / (k - 1)", of(&wrong), (more, 0.0), 0.015);
            reject("k", &wrong, 1.0);
            // Its scatter, of points in a finite world a little less.
            let deviation = right.variance().sqrt();
            let expected = 1.0 / (k as f64 - 2.0).sqrt();
            assert!(
                (deviation / expected - 1.0).abs() < 0.1,
                "{deviation} {expected}"
            );
        }
    }
    check::<Flat>();
    check::<Solid>();
}

#[test]
fn the_nearest_of_a_map() {
    const WALKS: u32 = 1 << 14;
    let at = from_the_camera(5.0, 5.0);
    let read = |seed, count| {
        let map = PhotonMap::new(plate(WALKS, seed), WALKS, 2.0, Kernel::Constant);
        map.irradiance_by_nearest(at, Vec3::Y, 10, count).unwrap()
    };
    let right: Estimate = (0..600).map(|seed| read(seed, Count::LessOne)).collect();
    let (z, error) = (right.z(1.0), right.std_error());
    println!("{:.4} ± {error:.4}", right.mean());
    assert!(z.abs() < CRITICAL && error < 0.02);
    let wrong: Estimate = (0..600).map(|seed| read(seed, Count::All)).collect();
    reject("ten of nine", &wrong, 1.0);
    let few = PhotonMap::new(plate(50, 1), 50, 0.1, Kernel::Constant);
    let none = few.irradiance_by_nearest(at, Vec3::Y, 10, Count::LessOne);
    assert_eq!(none, None, "fewer than ten");
    for (distances, k) in [(vec![], 2), (vec![1.0; 5], 1), (vec![0.0; 5], 3)] {
        let mut distances = distances;
        assert_eq!(density::<Solid>(&mut distances, k, Count::LessOne), None);
    }
}
