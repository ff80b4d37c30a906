//! The path tracer for use paints what the plain ladder paints.

use halfdisk::integrators::{Combine, Integrator, Path};
use halfdisk::render::{Options, Picture, compare, render};
use halfdisk::sampling::mis::Heuristic;
use halfdisk::scene::gallery::{self, GALLERY};
use halfdisk::scene::{Casters, Scene};

const CRITICAL: f64 = 4.4;

fn picture(scene: &Scene, integrator: &impl Integrator, spp: u32, seed: u64) -> Picture {
    let options = Options {
        spp,
        seed,
        ..Options::default()
    };
    let rendered = render(scene, integrator, &options, &());
    assert_eq!(rendered.non_finite, 0, "{}", scene.name);
    rendered.film.picture()
}

fn small(name: &str) -> Scene {
    gallery::load_with(name, |said| said.film.size = [16; 2]).unwrap()
}

#[test]
fn on_every_scene_of_the_gallery() {
    for (name, _) in GALLERY {
        let scene = small(name);
        let max_depth = scene.suggested.max_depth.min(12);
        let heuristic = Heuristic::Balance;
        let plain = Combine {
            max_depth,
            heuristic,
        };
        let path = Path {
            max_depth,
            roulette_from: 3,
        };
        let ours = picture(&scene, &path, 512, 1);
        let theirs = picture(&scene, &plain, 512, 2);
        let [ours, theirs] = [ours, theirs].map(|p| p.in_squares(4));
        let z = compare::z_scores(&ours, &theirs).unwrap();
        println!(
            "{name}: means {:.5?} and {:.5?}, z {:+.2}, largest |z| {:.2}",
            ours.mean(),
            theirs.mean(),
            z.of_means,
            z.largest
        );
        // Pictures without noise are equal, and 0 / 0 errors apart.
        let agree = |z: f64, line| z.is_nan() || z.abs() <= line;
        assert!(agree(z.of_means, CRITICAL), "{name}");
        assert!(agree(z.largest, 6.0), "{name}");
    }
}

#[test]
fn looking_towards_glass_changes_the_noise_and_not_the_mean() {
    for (name, gain) in [("spheres", 1.02), ("caustic", 0.95)] {
        let scene = small(name);
        let path = Path::new(scene.suggested.max_depth);
        let looking = picture(&scene, &path, 4096, 1);
        let mut blind = scene.clone();
        blind.casters = Casters::default();
        let not = picture(&blind, &path, 4096, 2);
        let error = |p: &Picture| p.mean().1.unwrap();
        let z = compare::z_scores(&looking.in_squares(8), &not.in_squares(8)).unwrap();
        println!(
            "{name}: means {:?} and {:?}, z {:+.2}, z² {:.2}",
            looking.mean(),
            not.mean(),
            z.of_means,
            z.squares.mean()
        );
        assert!(z.of_means.abs() <= CRITICAL && z.largest < 6.0, "{name}");
        // Errors over errors without: little is gained where most glass is close by.
        assert!(error(&looking) < gain * error(&not), "{name}");
    }
}
