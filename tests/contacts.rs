//! Surfaces within rounding of each other, one of which shines: aiming and chance agree on what is
//! met, whatever the order of the file.

use crate::checks::CRITICAL;
use halfdisk::integrators::{Combine, Integrator, Kajiya, Path};
use halfdisk::render::{Options, render};
use halfdisk::sampling::mis::Heuristic;
use halfdisk::scene::Scene;
use halfdisk::scene::gallery;
use halfdisk::scene::read::Source;

/// The smallest bias that each comparison has to see; what is met twice, or never, is a matter of
/// thirty per cent and more.
const SMALLEST: f64 = 0.1;

/// Some objects before a camera.
fn scene_of(objects: &str) -> Scene {
    let text = format!(
        "name = 'test'\ncamera = {{ from = [0, 0.2, -3], to = [0, 0, 0], fov = 60, shutter = [0, 1] }}\n\
         film.size = [16, 16]\nmaterials.d.lambert.albedo = 0.6\nmaterials.dark.lambert.albedo = 0.2\n\
         {objects}"
    );
    let source = Source {
        file: "test.toml",
        text: &text,
    };
    gallery::from_text(source, None, |_| {}).unwrap()
}

/// Means and their errors by three ways: a walk that finds lamps by chance, one that aims at all, and
/// the one in use.
fn three_ways(objects: &str, seed: u64) -> [(f64, f64); 3] {
    let scene = scene_of(objects);
    let mean = |integrator: &dyn Integrator, spp| {
        let options = Options {
            spp,
            seed,
            ..Options::default()
        };
        render(&scene, integrator, &options, &()).film.mean()
    };
    let combine = Combine {
        max_depth: 4,
        heuristic: Heuristic::Power,
    };
    [
        mean(&Kajiya { max_depth: 4 }, 600),
        mean(&combine, 96),
        mean(&Path::new(4), 96),
    ]
}

fn agree(what: &str, [(a, ea), (b, eb)]: [(f64, f64); 2]) {
    let error = ea.hypot(eb);
    let z = (a - b) / error;
    assert!(
        z.abs() <= CRITICAL,
        "{what}: {a} and {b}, {z:.1} standard errors apart"
    );
    assert!(
        CRITICAL * error < SMALLEST * a.max(b),
        "{what}: too noisy: {error}"
    );
}

/// All ways agree, with the objects in this order and in the opposite one.
fn same_light(what: &str, objects: &[&str]) -> f64 {
    let forward: String = objects.concat();
    let backward: String = objects.iter().rev().copied().collect();
    let [chance, combine, path] = three_ways(&forward, 1);
    println!("{what}: {chance:?} {combine:?} {path:?}");
    agree(what, [chance, combine]);
    agree(what, [chance, path]);
    agree(what, [combine, path]);
    let [chance_back, combine_back, path_back] = three_ways(&backward, 2);
    println!("    reversed: {chance_back:?} {combine_back:?} {path_back:?}");
    agree(what, [chance_back, combine_back]);
    agree(what, [chance_back, path_back]);
    agree(&format!("{what}, reversed"), [path, path_back]);
    path.0
}

const FLOOR: &str =
    "[[objects]]\nmaterial = 'd'\nquad = { corner = [-3, -1, -3], u = [0, 0, 6], v = [6, 0, 0] }\n";
const CEILING: &str =
    "[[objects]]\nmaterial = 'd'\nquad = { corner = [-3, 1, -3], u = [6, 0, 0], v = [0, 0, 6] }\n";
/// Looks down.
const LAMP: &str =
    "[[objects]]\nemits = 4\nquad = { corner = [-1, 1, -1], u = [2, 0, 0], v = [0, 0, 2] }\n";

#[test]
fn a_lamp_told_twice_shines_once() {
    let again =
        "[[objects]]\nemits = 4\nquad = { corner = [1, 1, 1], u = [-2, 0, 0], v = [0, 0, -2] }\n";
    let once = same_light("one lamp", &[FLOOR, LAMP]);
    let twice = same_light("a lamp from two corners", &[FLOOR, LAMP, again]);
    assert!((twice / once - 1.0).abs() < 0.05, "{once} {twice}");
    // Corners that round differently, and of triangles.
    let apart = "[[objects]]\nemits = 4\nquad = { corner = [-0.9, 1, -0.7], u = [2.1, 0, 0.3], v = [-0.3, 0, 2.1] }\n";
    let apart_again = "[[objects]]\nemits = 4\nquad = { corner = [0.9, 1, 1.7], u = [-2.1, 0, -0.3], v = [0.3, 0, -2.1] }\n";
    let once = same_light("a turned lamp", &[FLOOR, apart]);
    let twice = same_light("a turned lamp twice", &[FLOOR, apart, apart_again]);
    assert!((twice / once - 1.0).abs() < 0.05, "{once} {twice}");
    let a =
        "[[objects]]\nemits = 4\ntriangle = { a = [-1, 1, -1], b = [1, 1, -1], c = [0, 1, 1] }\n";
    let b =
        "[[objects]]\nemits = 4\ntriangle = { a = [0, 1, 1], b = [-1, 1, -1], c = [1, 1, -1] }\n";
    same_light("a triangle from two corners", &[FLOOR, a, b]);
}

#[test]
fn a_lamp_in_the_plane_of_a_wall_shines() {
    let alone = same_light("no ceiling", &[FLOOR, LAMP]);
    let flush = same_light("a lamp in a ceiling", &[FLOOR, CEILING, LAMP]);
    assert!(flush > 0.95 * alone, "{alone} {flush}");
    let cabinet =
        "[[objects]]\nmaterial = 'd'\nbox = { min = [-1.5, -1, 0], max = [1.5, -0.5, 2] }\n";
    let lamp = "[[objects]]\nemits = 4\nquad = { corner = [-1, -0.5, 0.5], u = [0, 0, 1], v = [2, 0, 0] }\n";
    same_light("a lamp let into a box", &[FLOOR, CEILING, cabinet, lamp]);
    let standing = "[[objects]]\nmaterial = 'd'\nemits = 4\nbox = { min = [-0.5, -1, 0], max = [0.5, -0.5, 1] }\n";
    same_light("a box of light on the floor", &[FLOOR, CEILING, standing]);
    // In planes that no axis is along, a thousand units away.
    let turn =
        "transform = { rotate = { axis = [1, 2, 3], degrees = 33 }, translate = [0.2, 0, 0.4] }\n";
    let wall = format!(
        "[[objects]]\nmaterial = 'd'\nquad = {{ corner = [-2, 0.5, -2], u = [4, 0, 0], v = [0, 0, 4] }}\n{turn}"
    );
    let lamp = format!(
        "[[objects]]\nemits = 4\nquad = {{ corner = [-1, 0.5, -1], u = [1.3, 0, 0], v = [0, 0, 1.1] }}\n{turn}"
    );
    same_light("a lamp in a tilted wall", &[FLOOR, &wall, &lamp]);
}

#[test]
fn walls_within_rounding_of_a_lamp() {
    for offset in [-1e-4, -1e-6, -1e-7, -1e-8, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4] {
        // Behind the lamp, or before it where it looks from below.
        let wall = format!(
            "[[objects]]\nmaterial = 'd'\nquad = {{ corner = [-3, {}, -3], u = [6, 0, 0], v = [0, 0, 6] }}\n",
            1.0 + offset
        );
        let other = "[[objects]]\nemits = 1\nsphere = { center = [1.5, 0, 0], radius = 0.3 }\n";
        same_light(
            &format!("a wall {offset:e} above"),
            &[FLOOR, &wall, LAMP, other],
        );
    }
}

#[test]
fn two_sides_that_shine() {
    let up = "[[objects]]\nmaterial = 'dark'\nemits = 2\nquad = { corner = [-1, 0.4, 0], u = [0, 0, 2], v = [2, 0, 0] }\n";
    let down = "[[objects]]\nmaterial = 'dark'\nemits = 2\nquad = { corner = [-1, 0.4, 0], u = [2, 0, 0], v = [0, 0, 2] }\n";
    let both = format!("{down}two_sided = true\n");
    let flipped = same_light("two flipped quads", &[FLOOR, CEILING, up, down]);
    let one = same_light("two sides", &[FLOOR, CEILING, &both]);
    assert!((flipped / one - 1.0).abs() < 0.05, "{flipped} {one}");
    let bumpy = "[[objects]]\nemits = 2\ntwo_sided = true\nbumpy_sphere = { center = [0, 0, 0], radius = 0.4, columns = 8, rows = 4 }\n";
    same_light("a mesh with two sides", &[FLOOR, CEILING, bumpy]);
    let triangle = "[[objects]]\nemits = 3\ntwo_sided = true\ntriangle = { a = [-1, 0, 0], b = [1, 0.3, 0], c = [0, 0.5, 1] }\n";
    same_light("a triangle with two sides", &[FLOOR, CEILING, triangle]);
}

#[test]
fn lamps_that_overlap() {
    let bright = "[[objects]]\nemits = 9\nquad = { corner = [-0.2, 1, -0.5], u = [2, 0, 0], v = [0, 0, 1] }\n";
    let [chance, combine, path] = three_ways(&[FLOOR, LAMP, bright].concat(), 3);
    agree("the first of two lamps", [chance, combine]);
    agree("the first of two lamps", [chance, path]);
    // Of two lamps in one place the first in the file is met.
    let once = three_ways(&[FLOOR, LAMP].concat(), 5)[2];
    let again =
        "[[objects]]\nemits = 9\nquad = { corner = [1, 1, 1], u = [-2, 0, 0], v = [0, 0, -2] }\n";
    let dimmed = three_ways(&[FLOOR, LAMP, again].concat(), 6)[2];
    agree("the first of two lamps in one place", [once, dimmed]);
    let triangle =
        "[[objects]]\nemits = 9\ntriangle = { a = [-1, 1, -1], b = [1, 1, -1], c = [0, 1, 1] }\n";
    let [chance, combine, path] = three_ways(&[FLOOR, triangle, LAMP, CEILING].concat(), 4);
    agree("a triangle over a quad", [chance, combine]);
    agree("a triangle over a quad", [chance, path]);
}

#[test]
fn lamps_told_again_from_another_corner_are_counted() {
    let lamp = |shape: &str| format!("[[objects]]\nemits = 1\n{shape}\n");
    for (shape, again) in [
        (
            "quad = { corner = [-1, 1, -1], u = [2, 0, 0], v = [0, 0, 2] }",
            "quad = { corner = [1, 1, 1], u = [-2, 0, 0], v = [0, 0, -2] }",
        ),
        (
            "quad = { corner = [1, 0, 0], u = [1, 2, 0], v = [0, 0, 1] }",
            "quad = { corner = [1, 0, 1], u = [0, 0, -1], v = [1, 2, 0] }",
        ),
        (
            "triangle = { a = [0, 1, 0], b = [1, 1, 0], c = [0, 2, 3] }",
            "triangle = { a = [1, 1, 0], b = [0, 2, 3], c = [0, 1, 0] }",
        ),
        (
            "sphere = { center = [0, 1, 0], radius = 0.5 }",
            "sphere = { center = [0, 1, 0], radius = 0.5 }",
        ),
    ] {
        let hidden = |objects: &[String]| scene_of(&objects.concat()).report.hidden_lights;
        assert_eq!(hidden(&[lamp(shape), lamp(again)]), 1, "{again}");
        assert_eq!(hidden(&[lamp(shape), lamp(again), lamp(again)]), 2);
        // Elsewhere, turned over or shining on both sides it is another.
        let moved = format!("{again}\ntransform.translate = [0, 0.5, 0]");
        let both = format!("{again}\ntwo_sided = true");
        let others = if shape.starts_with("sphere") {
            vec![moved]
        } else {
            vec![moved, both]
        };
        for other in others {
            assert_eq!(hidden(&[lamp(shape), lamp(&other)]), 0, "{other}");
        }
    }
    let turned = "quad = { corner = [-1, 1, -1], u = [0, 0, 2], v = [2, 0, 0] }";
    assert_eq!(
        scene_of(&[LAMP.to_owned(), lamp(turned)].concat())
            .report
            .hidden_lights,
        0
    );
}

#[test]
fn balls_in_one_place() {
    let lamp = "[[objects]]\nemits = 4\nsphere = { center = [0.5, 0.2, 0.5], radius = 0.4 }\n";
    let ball = "[[objects]]\nmaterial = 'd'\nsphere = { center = [0.5, 0.2, 0.5], radius = 0.4 }\n";
    same_light("a ball and a lamp", &[FLOOR, CEILING, ball, lamp]);
}

#[test]
fn a_lamp_that_slides_in_its_ceiling() {
    let moving = format!("{LAMP}motion = [0.5, 0, 0.2]\n");
    same_light("a lamp that slides", &[FLOOR, CEILING, &moving]);
}

#[test]
fn a_lamp_that_sinks_out_of_its_ceiling() {
    let moving = format!("{LAMP}motion = [0, -1.4, 0]\n");
    same_light("a lamp that sinks", &[FLOOR, CEILING, &moving]);
}
