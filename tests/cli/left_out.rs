//! What `render` says of light that it cannot find, or has not found.

use super::{complaint, folder, halfdisk};
use serde_json::Value;
use std::path::Path;

/// A room lit by what `light` says, seen by `camera`.
fn room(folder: &Path, camera: &str, light: &str) {
    let text = format!(
        "name = 'room'\nfilm.size = [12, 12]\nmaterials.white.lambert.albedo = 0.6\n\
         materials.clear.glass.ior = 1.5\n\
         [camera]\n{camera}\nfov = 50\n\
         [[objects]]\nmaterial = 'white'\n\
         quad = {{ corner = [-3, 0, 3], u = [6, 0, 0], v = [0, 0, -6] }}\n\
         [[objects]]\nmaterial = 'white'\n\
         quad = {{ corner = [-3, 0, -3], u = [6, 0, 0], v = [0, 4, 0] }}\n{light}"
    );
    std::fs::write(folder.join("room.toml"), text).unwrap();
}

const CAMERA: &str = "from = [0, 1, 5]\nto = [0, 0.8, 0]";
const SUN: &str = "[[lights]]\ndirectional = { direction = [1, -2, -1], irradiance = 2 }\n";
/// A lamp that shines downwards.
pub const LAMP: &str = "[[objects]]\nemits = 5\n\
    quad = { corner = [-0.5, 3, 0.5], u = [0, 0, -1], v = [1, 0, 0] }\n";

#[test]
fn light_that_an_integrator_cannot_find_is_named_and_its_target_is_not_reached_without_a_word() {
    let folder = folder();
    let ball = "[[objects]]\nmaterial = 'clear'\nsphere = { center = [0, 1, 0], radius = 0.5 }\n";
    for (integrator, light, words) in [
        ("whitted", LAMP.to_owned(), &["LDDE"][..]),
        ("kajiya", SUN.to_owned(), &["LDE", "LDDE"]),
        ("roulette", format!("{SUN}{LAMP}"), &["LDE"]),
        (
            "kajiya",
            format!("{SUN}environment.radiance = 0.2\n"),
            &["LDE"],
        ),
        ("whitted", format!("{SUN}{ball}"), &["LDDE", "LSDE"]),
        ("path", format!("{SUN}{ball}"), &["LSDSE"]),
        ("combine", format!("{SUN}{LAMP}{ball}"), &["LSDE"]),
    ] {
        // Tables of the top come first in a file.
        let (top, rest) = match light.split_once("environment") {
            Some((rest, sky)) => (format!("environment{sky}"), rest.to_owned()),
            None => (String::new(), light),
        };
        room(folder.path(), CAMERA, &rest);
        let file = folder.path().join("room.toml");
        let text = std::fs::read_to_string(&file).unwrap();
        std::fs::write(&file, top + &text).unwrap();
        let arguments = ["render", "room.toml", "--integrator", integrator];
        let goal = ["--target-error", "20%", "--json", "--out", "p.exr"];
        let output = halfdisk(folder.path(), &[&arguments[..], &goal].concat());
        let said = complaint(&output);
        assert!(output.status.success(), "{said}");
        let object: Value = serde_json::from_slice(&output.stdout).unwrap();
        let left_out = &object["left_out"];
        assert_eq!(left_out["integrator"], integrator);
        let named: Vec<_> = left_out["words"].as_array().unwrap().iter().collect();
        for word in words {
            assert!(
                named.iter().any(|name| *name == word),
                "{integrator}: {left_out}"
            );
            assert!(said.contains(word), "{integrator}: {said}");
        }
        let last = said.lines().find(|line| line.starts_with("ended"));
        let last = last.expect("it says why it ended");
        let without = last.contains("at its target") && !last.contains("leaves out");
        assert!(!without, "{integrator}: {said}");
    }
    room(folder.path(), CAMERA, &format!("{SUN}{LAMP}"));
    for integrator in ["path", "combine", "which-ray", "next-event"] {
        let arguments = [
            "render",
            "room.toml",
            "--integrator",
            integrator,
            "--spp",
            "1",
        ];
        let output = halfdisk(folder.path(), &[&arguments[..], &["--json"]].concat());
        let object: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(object["left_out"], Value::Null);
    }
}

#[test]
fn what_no_sample_has_found_is_no_certainty() {
    let folder = folder();
    let tiny = "[[objects]]\nemits = 5\nsphere = { center = [0.2, 2, 6], radius = 1e-5 }\n";
    for (integrator, light, black) in [
        ("kajiya", SUN, "kajiya cannot find the light"),
        ("kajiya", tiny, "no sample of kajiya found one"),
        ("roulette", tiny, "no sample of roulette found one"),
        ("path", "", "no light in the scene"),
    ] {
        room(folder.path(), CAMERA, light);
        let arguments = ["render", "room.toml", "--integrator", integrator, "--json"];
        for goal in [
            &["--target-error", "2%"][..],
            &["--spp", "1"],
            &["--time", "0.05s"],
        ] {
            let output = halfdisk(folder.path(), &[&arguments[..], goal].concat());
            let said = complaint(&output);
            assert!(output.status.success(), "{said}");
            assert!(
                said.contains("the picture is black: ") && said.contains(black),
                "{said}"
            );
            assert!(said.contains("error: not known ("), "{said}");
            assert!(
                !said.contains("at its target") && !said.contains("0.00 %"),
                "{said}"
            );
            let object: Value = serde_json::from_slice(&output.stdout).unwrap();
            assert!(object["black"].as_str().unwrap().contains(black));
            assert_eq!(object["accuracy"]["reached"]["error"], Value::Null);
            assert_eq!(object["accuracy"]["top_share"], Value::Null);
            assert_eq!(object["mean"]["error"], Value::Null);
            assert_ne!(object["accuracy"]["stopped_by"], "error");
        }
    }
}

#[test]
fn a_black_picture_says_why() {
    let folder = folder();
    let away = "[[objects]]\nemits = 5\n\
        quad = { corner = [-0.5, 4.5, 0.5], u = [1, 0, 0], v = [0, 0, -1] }\n";
    let inside = "[[objects]]\nmaterial = 'white'\nsphere = { center = [0, 1, 5], radius = 0.5 }\n";
    let in_a_box =
        "[[objects]]\nmaterial = 'white'\nbox = { min = [-1, 0.5, 4], max = [1, 2, 6] }\n";
    let roof = "[[objects]]\nmaterial = 'white'\n\
        quad = { corner = [-50, 5, 50], u = [100, 0, 0], v = [0, 0, -100] }\n";
    let behind = "[[lights]]\ndirectional = { direction = [0, 1, 0], irradiance = 2 }\n";
    let up = "from = [0, 1, 5]\nto = [0, 9, 9]";
    for (camera, light, depth, why) in [
        (CAMERA, away.to_owned(), "5", "every lamp shows its back"),
        (
            CAMERA,
            format!("{LAMP}{inside}"),
            "5",
            "the camera is inside an object",
        ),
        (
            CAMERA,
            format!("{SUN}{in_a_box}"),
            "5",
            "the camera is inside an object",
        ),
        (
            CAMERA,
            format!("{SUN}{roof}"),
            "5",
            "surfaces stand between",
        ),
        (CAMERA, behind.to_owned(), "5", "far side"),
        (up, SUN.to_owned(), "5", "the camera sees nothing"),
        (CAMERA, SUN.to_owned(), "1", "paths end after one segment"),
    ] {
        room(folder.path(), camera, &light);
        let arguments = ["render", "room.toml", "--spp", "8", "--max-depth", depth];
        let said = complaint(&halfdisk(folder.path(), &arguments));
        let line = said
            .lines()
            .find(|line| line.starts_with("the picture is black: "));
        assert!(line.is_some_and(|line| line.contains(why)), "{why}: {said}");
    }
    room(folder.path(), CAMERA, LAMP);
    let said = complaint(&halfdisk(
        folder.path(),
        &["render", "room.toml", "--spp", "1"],
    ));
    assert!(!said.contains("black"), "{said}");
}

#[test]
fn a_lamp_that_no_sample_has_met_is_not_in_the_error() {
    let folder = folder();
    let tiny = "[[objects]]\nemits = 9e9\nsphere = { center = [0.2, 2, 6], radius = 1e-5 }\n";
    for (integrator, light, unmet) in [
        ("kajiya", format!("{LAMP}{tiny}"), 1),
        ("roulette", format!("{tiny}{LAMP}{tiny}"), 1),
        ("kajiya", LAMP.to_owned(), 0),
        ("path", format!("{LAMP}{tiny}"), 0),
    ] {
        room(folder.path(), CAMERA, &light);
        let arguments = ["render", "room.toml", "--integrator", integrator, "--json"];
        let goal = ["--target-error", "100%"];
        let output = halfdisk(folder.path(), &[&arguments[..], &goal].concat());
        let said = complaint(&output);
        let object: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(object["lamps_unmet"], unmet, "{said}");
        let told = format!("has met {unmet} of 2 lamps");
        assert_eq!(said.matches(&told).count(), 2 * unmet, "{said}");
        let last = said.lines().find(|line| line.starts_with("ended")).unwrap();
        assert_eq!(last.contains(&told), unmet > 0, "{said}");
    }
}
