//! Radiosity against paths, on diffuse scenes.

use super::{BLOCKS, CUBE, scene, solve};
use halfdisk::integrators::{Integrator, Kajiya, Path, Radiosity};
use halfdisk::lab::estimators::directions::Recipe;
use halfdisk::lab::estimators::gather::Gather;
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

/// What is allowed of the error of the mesh, which is one of points of the indirect light: the mean of a
/// picture is off by less, for points are too bright here and too dark there.
const OF_MESH: f64 = 0.25;

/// Level: four standard errors in 30 comparisons, one in 500.
#[test]
fn five_rooms_look_alike_by_four_integrators() {
    for (name, scene) in scenes() {
        let path = mean(&scene, &Path::new(60), 256, 1);
        let direct = mean(&scene, &Path::new(2), 256, 4);
        let walk = mean(&scene, &Kajiya { max_depth: 60 }, 256, 2);
        // One direction at each surface, or the tree would never end.
        let gather = Gather {
            samples: 1,
            depth: 58,
            recipe: Recipe::Cosine,
        };
        let gather = mean(&scene, &gather, 256, 5);
        let patches = Radiosity::new(&scene, 60, PatchSize::Number(500), &()).expect("patches");
        let report = *patches.solved().expect("a report");
        let mesh = report.mesh_error.expect("an error of the mesh");
        let found = mean(&scene, &patches, 256, 3);
        let indirect = path.0 - direct.0;
        println!(
            "{name}: path {:.5} ± {:.5}, kajiya {:.5} ± {:.5}, gather {:.5} ± {:.5}, {} patches {:.5} ± {:.5}; the \
             indirect light {indirect:.5}, its mesh {:.1} %; off by {:.3} of that",
            path.0,
            path.1,
            walk.0,
            walk.1,
            gather.0,
            gather.1,
            report.effort.patches,
            found.0,
            found.1,
            100.0 * mesh,
            (found.0 - path.0) / (mesh * indirect)
        );
        let apart = |a: (f64, f64), b: (f64, f64)| ((a.0 - b.0).abs(), libm::hypot(a.1, b.1));
        let alike = |a, b, mesh: f64| {
            let (off, error) = apart(a, b);
            off < FOUR * error + mesh
        };
        let allowed = OF_MESH * mesh * indirect;
        for (a, b, mesh) in [
            (path, walk, 0.0),
            (path, gather, 0.0),
            (walk, gather, 0.0),
            (path, found, allowed),
            (walk, found, allowed),
            (gather, found, allowed),
        ] {
            assert!(alike(a, b, mesh), "{name}: {a:?} {b:?}");
        }
        assert!(mesh < 0.12, "{name}: {mesh}");
        // The mistake: without the light that patches hold.
        assert!(
            !alike(direct, found, 10.0 * allowed),
            "{name}: {direct:?} {found:?}"
        );
    }
}

#[test]
fn gloss_is_lit_by_shadow_rays() {
    // A rough plate of metal under a small lamp and a point; what is diffuse faces away and is dark.
    let text = "materials.metal.glossy = { reflectance = 0.8, roughness = 0.35 }\n\
        [[objects]]\nmaterial = 'metal'\nquad = { corner = [-2, 0, 2], u = [4, 0, 0], v = [0, 0, -4] }\n\
        [[objects]]\nmaterial = 'half'\nquad = { corner = [-2, -1, -2], u = [4, 0, 0], v = [0, 0, 4] }\n\
        [[objects]]\nemits = 300\nquad = { corner = [0.2, 1.5, -0.3], u = [0.05, 0, 0], v = [0, 0, 0.05] }\n\
        [[lights]]\npoint = { position = [0, 0.8, -0.2], intensity = 1 }\n";
    let scene = scene(text);
    let patches = Radiosity::new(&scene, 60, PatchSize::Number(100), &()).expect("patches");
    let path = mean(&scene, &Path::new(60), 64, 1);
    let found = mean(&scene, &patches, 64, 2);
    let kajiya = mean(&scene, &Kajiya { max_depth: 60 }, 64, 3);
    println!("a plate of metal: path {path:?}, patches {found:?}; by chance alone {kajiya:?}");
    let error = libm::hypot(path.1, found.1);
    assert!(
        (path.0 - found.0).abs() < FOUR * error,
        "{path:?} {found:?}"
    );
    assert!(error < 0.03 * path.0, "{error:e}");
    // The mistake: gloss left to chance, which never meets the point.
    assert!((kajiya.0 - found.0).abs() > FOUR * kajiya.1, "{kajiya:?}");
    assert!(kajiya.1 > 2.0 * found.1, "{kajiya:?} {found:?}");
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
