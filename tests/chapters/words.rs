//! The chapters about words for light, and what they say of pictures.

use super::{check, number};
use halfdisk::integrators::{FilteredPath, Integrator, Path, Whitted};
use halfdisk::lab::effects::language::{everything, of_lamps};
use halfdisk::notation::Expression;
use halfdisk::render::{Options, Picture, compare, render};
use halfdisk::scene::{Scene, gallery};

#[test]
fn ch14_alphabet() {
    let data = check(env!("CARGO_BIN_EXE_ch14-alphabet"), "ch14");
    let value = |name: &str| number(&data, name, "value");
    assert_eq!(value("by_hand"), 30.0);
    // What is drawn is the automaton in use.
    for name in ["states", "alike"] {
        assert_eq!(value(name), number(&data, name, "exact"), "{name}");
    }
    assert!(value("sum_is_off_by") <= 1e-6);
    for lamp in ["lamp", "point"] {
        for named in [
            "whitted",
            "kajiya",
            "which_ray",
            "roulette",
            "next_event",
            "combine",
            "path",
        ] {
            let name = format!("{lamp}_{named}");
            let [value, exact, error] =
                ["value", "exact", "error"].map(|p| number(&data, &name, p));
            assert!(
                (value - exact).abs() <= 4.4 * error + 1e-4,
                "{name}: {value} ± {error} for {exact}"
            );
        }
    }
    // A walk that meets lamps by chance never meets a point, and says so.
    assert_eq!(value("point_kajiya"), 0.0);
    assert_eq!(value("point_kajiya_direct"), 0.0);
    assert_eq!(value("point_combine_caustic"), 0.0);
    assert_eq!(value("point_path_caustic"), 0.5);
    let lost = number(&data, "ball_lost", "value");
    assert!(lost > 4.0 * number(&data, "ball_lost", "error"));
    assert_eq!(value("lamp_path_caustic"), 1.0);
    assert_eq!(value("lamp_whitted_bleeding"), 0.0);
    // What it lacks is out of the noise's reach: a tree that had it would be noticed.
    let lacks = number(&data, "lamp_path", "value") - value("lamp_whitted");
    assert!(lacks > 8.0 * number(&data, "lamp_whitted", "error"));
    for scene in ["cornell", "spheres", "caustic", "mixture"] {
        let classes = [
            "seen",
            "seen_specular",
            "direct",
            "direct_specular",
            "bleeding",
            "caustic",
        ];
        let shares = classes.map(|class| value(&format!("{scene}_{class}")));
        let sum: f64 = shares.iter().sum();
        assert!((sum - 100.0).abs() < 1e-6, "{scene}: {sum}");
    }
    assert_eq!(value("cornell_caustic"), 0.0);
    for surfaces in 1..=4 {
        let missing = value(&format!("missing_{surfaces}"));
        assert_eq!(missing, f64::from((1 << surfaces) - 2), "{surfaces}");
    }
}

#[test]
fn ch19_what_the_scene_asks() {
    let data = check(env!("CARGO_BIN_EXE_ch19-what-the-scene-asks"), "ch19");
    let value = |name: &str| number(&data, name, "value");
    let asked = ["area_lights", "diffuse", "specular", "bleeding", "caustics"];
    for effect in asked {
        assert_eq!(value(&format!("asks_{effect}")), 1.0, "{effect}");
        // What is simulated is worth something, beyond all noise.
        let [worth, error] =
            ["value", "error"].map(|part| number(&data, &format!("worth_{effect}"), part));
        assert!(worth > 4.4 * error, "{effect}: {worth} ± {error}");
    }
    for effect in ["point_lights", "sky", "gloss", "lens", "motion"] {
        assert_eq!(value(&format!("asks_{effect}")), 0.0, "{effect}");
    }
    // What is not there costs no ray and changes no bit.
    for scene in ["cornell", "room", "caustic", "gloss", "veach", "mesh"] {
        assert_eq!(value(&format!("differ_{scene}")), 0.0, "{scene}");
        assert_eq!(value(&format!("rays_all_{scene}")), 1.0, "{scene}");
    }
    // Bleeding and caustics are the same words in both tables.
    for [class, effect] in [["bleeding"; 2], ["caustic", "caustics"]] {
        let [class, effect] = [format!("share_{class}"), format!("worth_{effect}")];
        let apart = value(&class) - value(&effect);
        let error = |name: &str| number(&data, name, "error");
        let error = error(&class).hypot(error(&effect));
        assert!(apart.abs() < 4.0 * error, "{class} {apart} ± {error}");
    }
    assert_eq!(value("point_lost"), 0.0);
    assert_eq!(value("point_has"), 1.0);
    assert_eq!(value("point_kajiya"), 0.0);
    for name in ["ball_caustics", "ball_lost", "point_caustics"] {
        assert!(value(name) > 4.0 * number(&data, name, "error"), "{name}");
    }
    assert!((value("share_sum") - 1.0).abs() <= 1e-6);
}

/// What the command answers.
fn answer(arguments: &[&str]) -> String {
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_halfdisk"))
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    assert!(output.status.success());
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn the_page_shows_what_the_command_answers() {
    let page = include_str!("../../book/src/ch19-what-the-scene-asks.md");
    let point = "chapters/ch19_what_the_scene_asks/point.toml";
    for scene in ["room", point] {
        let report = answer(&["effects", scene]);
        assert!(page.contains(&report), "{scene} is now\n{report}");
    }
    assert!(!page.contains(&answer(&["effects", "cornell"])));
}

fn picture(scene: &Scene, by: &impl Integrator, seed: u64) -> Picture {
    let options = Options {
        spp: 256,
        seed,
        ..Options::default()
    };
    render(scene, by, &options, &()).film.picture()
}

/// The z score of the means of Whitted's picture and of the paths of an expression, and the mean
/// squared z score of their pixels.
fn apart(scene: &Scene, paths: &Expression) -> [f64; 2] {
    let max_depth = scene.suggested.max_depth;
    let whitted = picture(scene, &Whitted { max_depth }, 3);
    let sum = FilteredPath {
        path: Path::new(max_depth),
        paths: paths.eye_first(),
    };
    let z = compare::z_scores(&whitted, &picture(scene, &sum, 4)).unwrap();
    println!("{paths}: means {:+.2}, {:?}", z.of_means, z.squares.mean());
    [z.of_means, z.squares.mean()]
}

#[test]
fn s0_02_whitteds_picture_is_that_of_its_words() {
    let scene = gallery::load("spheres").unwrap().sized([32, 32]);
    let own = of_lamps(&Whitted::ENTRY).unwrap();
    let [means, squares] = apart(&scene, &own);
    assert!(means.abs() <= 4.4, "{means}");
    assert!((squares - 1.0).abs() < 0.15, "{squares}");
    // A word too many, a class too few: noticed.
    for wrong in ["L(D|G)?S*E|LDDE", "LD?E|LS+E"] {
        let [_, squares] = apart(&scene, &wrong.parse().unwrap());
        assert!(squares > 1.3, "{wrong}: {squares}");
    }
}

#[test]
fn s0_05_a_caustic_is_ls_plus_de_and_none_of_whitteds_words() {
    let slides: Expression = "LSDE".parse().unwrap();
    let caustic: Expression = "LS+DE".parse().unwrap();
    assert!(caustic.light_first().includes(slides.light_first()));
    assert!(!slides.light_first().includes(caustic.light_first()));
    let whitted = of_lamps(&Whitted::ENTRY).unwrap();
    let both = caustic.light_first().intersection(whitted.light_first());
    assert!(both.is_empty(), "{:?}", both.shortest(3));
    let all = everything();
    assert!(all.light_first().includes(caustic.light_first()));
}
