//! Radiosity against paths, on diffuse scenes.

use super::{BLOCKS, CUBE, scene, solve};
use halfdisk::integrators::{Integrator, Kajiya, Path, Radiosity};
use halfdisk::radiosity::PatchSize;
use halfdisk::render::{Options, render};
use halfdisk::scene::Scene;
use halfdisk::stats::z_test::FOUR;

fn scenes() -> [(&'static str, Scene); 5] {
    let dim = CUBE.replace("emits = 1\n", "");
    let lamp = "[[objects]]\nemits = 20\nquad = { corner = [0.4, 0.99, 0.4], u = [0.2, 0, 0], v = [0, 0, 0.2] }\n";
    let ball = "[[objects]]\nemits = 5\nsphere = { center = [0.2, 0.8, 0.2], radius = 0.1 }\n";
    let wall = "[[objects]]\nmaterial = 'red'\ntriangle = { a = [0.3, 0, 0.1], b = [0.9, 0, 0.2], c = [0.5, 0.7, 0.15] }\n";
    let open = dim.replacen("emits = 1", "", 1);
    let open = open.rsplit_once("[[objects]]").expect("walls").0.to_owned();
    [
        ("the room", scene(CUBE)),
        ("a small lamp", scene(&(dim.clone() + lamp))),
        ("a ball that shines", scene(&(dim + ball))),
        ("blocks", scene(&(CUBE.to_owned() + BLOCKS))),
        (
            "open to the sky, with a wall",
            scene(&("background = 0.7\n".to_owned() + &open + wall)),
        ),
    ]
}

fn mean(scene: &Scene, by: &impl Integrator, spp: u32, seed: u64) -> (f64, f64) {
    let options = Options {
        spp,
        seed,
        ..Options::default()
    };
    render(scene, by, &options, &()).film.mean()
}

#[test]
fn five_rooms_look_alike_by_four_integrators() {
    for (name, scene) in scenes() {
        let path = mean(&scene, &Path::new(60), 196, 1);
        let walk = mean(&scene, &Kajiya { max_depth: 60 }, 196, 2);
        let patches = Radiosity::new(&scene, 60, PatchSize::Number(500), &()).expect("patches");
        let report = *patches.solved().expect("a report");
        let mesh = report.mesh_error.expect("an error of the mesh");
        let found = mean(&scene, &patches, 200, 3);
        println!(
            "{name}: path {:.5} ± {:.5}, kajiya {:.5} ± {:.5}, {} patches {:.5} ± {:.5}, mesh {:.1} %",
            path.0,
            path.1,
            walk.0,
            walk.1,
            report.effort.patches,
            found.0,
            found.1,
            100.0 * mesh
        );
        // The picture's mean is off by less than its points are; a tenth of the mesh's error is allowed for it.
        let allowed = |error: f64| FOUR * error + 0.1 * mesh * path.0;
        let apart = |a: (f64, f64), b: (f64, f64)| ((a.0 - b.0).abs(), libm::hypot(a.1, b.1));
        let (off, error) = apart(path, walk);
        assert!(off < FOUR * error, "{name}: {path:?} {walk:?}");
        let (off, error) = apart(path, found);
        assert!(off < allowed(error), "{name}: {path:?} {found:?}");
        assert!(mesh < 0.12, "{name}: {mesh}");
        // The mistake: without the light that patches hold.
        let dark = mean(&scene, &Path::new(2), 196, 4);
        let (off, error) = apart(dark, found);
        assert!(off > 2.0 * allowed(error), "{name}: {dark:?} {found:?}");
    }
}

#[test]
fn a_wall_in_the_middle_of_a_patch_does_not_leak() {
    // The left half of the room has the lamp; the right one is closed off and dark.
    let text = CUBE.replace("emits = 1\n", "")
        + "[[objects]]\nmaterial = 'half'\nquad = { corner = [0.6, 0, 0], u = [0, 1, 0], v = [0, 0, 1] }\n\
           [[objects]]\nemits = 9\nquad = { corner = [0.2, 0.9, 0.2], u = [0.2, 0, 0], v = [0, 0, 0.2] }\n";
    let solution = solve(&scene(&text), PatchSize::Length(0.5));
    let [mut dark, mut lit] = [0, 0];
    for (patch, reflected) in solution.patches.all.iter().zip(&solution.reflected) {
        let x = patch.polygon.iter().map(|p| p.x + 0.5).sum::<f64>() / patch.polygon.len() as f64;
        let behind = x > 0.6 + 1e-6 || (x > 0.6 - 1e-6 && patch.normal.x > 0.5);
        if behind {
            dark += 1;
            assert_eq!(*reflected, [0.0; 3], "{patch:?}");
        } else {
            lit += usize::from(reflected[0] > 0.0);
        }
    }
    assert!(dark > 10 && lit > 10, "{dark} {lit}");
    // The mistake: patches of the floor that reach through the wall.
    let widest = solution
        .patches
        .all
        .iter()
        .filter(|patch| patch.normal.y > 0.5);
    let crosses = |patch: &halfdisk::radiosity::Patch| {
        let sides = patch.polygon.iter().map(|p| (p.x - 0.1).partial_cmp(&0.0));
        let [mut left, mut right] = [false, false];
        for side in sides {
            left |= side == Some(std::cmp::Ordering::Less);
            right |= side == Some(std::cmp::Ordering::Greater);
        }
        let narrow = patch.polygon.iter().all(|p| (p.x - 0.1).abs() < 1e-5);
        left && right
            && !narrow
            && patch.polygon.iter().any(|p| p.x < 0.1 - 1e-5)
            && patch.polygon.iter().any(|p| p.x > 0.1 + 1e-5)
    };
    assert_eq!(widest.filter(|patch| crosses(patch)).count(), 0);
}

#[test]
fn s0_26_another_view_of_the_same_light() {
    let here = scene(&(CUBE.to_owned() + BLOCKS));
    let there = here
        .changed(|said| {
            said.camera.from = halfdisk::scene::value::Triple([0.2, 0.3, 0.8]);
            said.camera.to = halfdisk::scene::value::Triple([0.7, 0.3, 0.0]);
        })
        .expect("a proper scene");
    let size = PatchSize::Number(500);
    let first = Radiosity::new(&here, 60, size, &()).expect("patches");
    let moved = mean(
        &there,
        &first
            .moved(there.origin() - here.origin())
            .expect("another view"),
        64,
        5,
    );
    let anew = mean(
        &there,
        &Radiosity::new(&there, 60, size, &()).expect("patches"),
        64,
        5,
    );
    println!("a second view: moved {moved:?}, solved anew {anew:?}");
    assert!((moved.0 / anew.0 - 1.0).abs() < 3e-3, "{moved:?} {anew:?}");
    // The mistake: patches left where they were.
    let left = mean(&there, &first, 64, 5);
    assert!((left.0 / anew.0 - 1.0).abs() > 0.01, "{left:?} {anew:?}");
}

#[test]
fn the_same_patches_on_any_number_of_threads() {
    let scene = scene(&(CUBE.to_owned() + BLOCKS));
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("threads");
        pool.install(|| solve(&scene, PatchSize::Number(300)).reflected)
    };
    let one = on(1);
    assert!(one == on(2) && one == on(5));
}
