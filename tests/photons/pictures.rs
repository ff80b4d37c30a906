//! Whole pictures, and light that nobody else finds.

use super::{mean, rendered, scene};
use crate::checks::{alike, unlike};
use halfdisk::integrators::{Integrator, LightTracer, Path, Photons};
use halfdisk::render::{Options, Progress, Session, compare, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::{Scene, gallery};
use std::sync::atomic::{AtomicU32, Ordering};

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
fn s0_01_a_point_in_glass_seen_in_a_mirror() {
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
