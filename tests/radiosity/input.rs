//! What patches refuse, and what is said then.

use super::{CUBE, scene};
use glam::DVec3;
use halfdisk::integrators::{Radiosity, Settings};
use halfdisk::radiosity::{Patch, PatchSize, Patches, RadiosityError, Solution, Watch};

fn refused(text: &str, size: PatchSize) -> String {
    match Solution::new(&scene(text), size, &()) {
        Err(error) => error.to_string(),
        Ok(_) => panic!("not refused"),
    }
}

#[test]
fn what_has_no_patches_is_refused_with_a_reason() {
    let usual = PatchSize::default();
    let mirror = "[[objects]]\nmaterial = 'mirror'\nquad = { corner = [0, 0, 0], u = [1, 0, 0], v = [0, 1, 0] }\n";
    let ball = "[[objects]]\nmaterial = 'half'\nsphere = { center = [0, 0, 0], radius = 0.1 }\n";
    // More sides than any number of patches allows: a thousand, as usual, are not what is wrong.
    let triangle = "[[objects]]\nmaterial = 'half'\ntriangle = { a = [0, 0, 0], b = [1, 0, 0], c = [0, 1, 0] }\n";
    let many = triangle.repeat(16_385);
    for (text, size, says) in [
        (mirror, usual, "nothing in the scene is diffuse"),
        (ball, usual, "1 of the diffuse shapes is a sphere"),
        (
            CUBE,
            PatchSize::Number(5),
            "5 patches are too few: the scene has 6 sides",
        ),
        (
            CUBE,
            PatchSize::Number(100_000),
            "100000 patches have 40 GB of form factors",
        ),
        (
            CUBE,
            PatchSize::Length(0.001),
            "6000000 patches have 144000 GB of form factors",
        ),
        (
            &many,
            usual,
            "16385 patches have 1.1 GB of form factors, and 1.1 GB (16384 patches) are allowed",
        ),
        (CUBE, PatchSize::Length(0.0), "a patch cannot be 0 long"),
        (
            CUBE,
            PatchSize::Length(f64::NAN),
            "a patch cannot be NaN long",
        ),
    ] {
        let said = refused(text, size);
        assert!(said.starts_with(says), "{said}");
    }
    let white = CUBE.replace("'half'", "'white'") + "[materials.white.lambert]\nalbedo = 1\n";
    let said = refused(&white, PatchSize::Number(100));
    assert!(said.starts_with("the light does not settle"), "{said}");
}

#[test]
fn degenerate_patches_are_refused() {
    let line = [0.0, 1.0, 3.0].map(DVec3::splat).to_vec();
    let nan = vec![DVec3::ZERO, DVec3::X, DVec3::new(0.0, f64::NAN, 0.0)];
    for polygon in [line, nan, vec![DVec3::ZERO], Vec::new()] {
        let made = Patch::new(polygon, [0.5; 3], [0.0; 3]);
        assert_eq!(made.err(), Some(RadiosityError::Degenerate));
    }
}

#[test]
fn surfaces_in_one_place_count_once() {
    let twice = CUBE.to_owned() + CUBE;
    let once = Solution::new(&scene(CUBE), PatchSize::Length(0.5), &()).expect("patches");
    let both = Solution::new(&scene(&twice), PatchSize::Length(0.5), &()).expect("patches");
    assert_eq!(both.patches.all.len(), once.patches.all.len());
    // The scene has left out the second ceiling, which is a lamp.
    assert_eq!(both.patches.hidden, 20);
    assert!(super::worst(&both.reflected, &once.reflected) < 1e-6);
}

#[test]
fn the_number_of_patches_is_at_most_what_was_asked_for() {
    let scene = scene(CUBE);
    for number in [6, 7, 24, 100, 1000, 3000] {
        let found = Patches::new(&scene, PatchSize::Number(number))
            .expect("patches")
            .all
            .len();
        assert!(found <= number && 3 * found > number, "{number}: {found}");
    }
}

/// Someone who stops at once.
struct Stops;

impl Watch for Stops {
    fn tell(&self, _: u64, _: u64) {}
    fn stop(&self) -> bool {
        true
    }
}

#[test]
fn whoever_watches_may_stop() {
    let scene = scene(CUBE);
    let settings = Settings {
        watch: &Stops,
        ..Settings::new(8)
    };
    let made = Radiosity::ENTRY.prepare(&scene, &settings);
    assert!(made.err().is_some_and(|refused| refused.is_stop()));
    assert!(Radiosity::ENTRY.prepare(&scene, &Settings::new(8)).is_ok());
}
