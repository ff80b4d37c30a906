//! `render` to an error or a time, as people meet it.

use super::{complaint, folder, halfdisk, refused};
use serde_json::Value;
use std::path::Path;

fn json(folder: &Path, arguments: &[&str]) -> Value {
    let output = halfdisk(folder, &[arguments, &["--json"]].concat());
    assert!(output.status.success(), "{}", complaint(&output));
    serde_json::from_slice(&output.stdout).expect("one JSON object")
}

#[test]
fn the_samples_that_were_chosen_give_the_same_bytes() {
    let folder = folder();
    let small = ["render", "spheres", "--size", "20x16", "--seed", "3"];
    for (goal, ending) in [
        (&["--target-error", "12%"][..], "exr"),
        (
            &["--target-error", "0.1", "--target-quantile", "80%"],
            "png",
        ),
        (&["--time", "0.5s", "--threads", "1"], "exr"),
        (&["--target-error", "0.001%", "--time", "0.5s"], "png"),
    ] {
        let (a, b) = (format!("a.{ending}"), format!("b.{ending}"));
        let said = json(folder.path(), &[&small, goal, &["--out", &a]].concat());
        let accuracy = &said["accuracy"];
        assert!(accuracy["prediction"]["spp"].as_u64().unwrap() > 0);
        assert!(accuracy["prediction"]["seconds"].as_f64().unwrap() > 0.0);
        let by = if goal.contains(&"--time") {
            "time"
        } else {
            "error"
        };
        assert_eq!(accuracy["stopped_by"], by, "{accuracy}");
        assert!(accuracy["top_share"].as_f64().unwrap() > 0.0);
        let spp = accuracy["reached"]["spp"].to_string();
        assert_eq!(said["facts"]["spp"].to_string(), spp);
        let again = json(
            folder.path(),
            &[&small[..], &["--spp", &spp, "--out", &b]].concat(),
        );
        assert_eq!(again["accuracy"]["prediction"], Value::Null);
        assert_eq!(again["accuracy"]["stopped_by"], "samples");
        let read = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
        assert!(read(&a) == read(&b), "{goal:?}: {spp} samples");
    }
}

#[test]
fn people_are_told_before_and_after() {
    let folder = folder();
    let small = ["render", "lamp", "--target-error", "5%"];
    let said = complaint(&halfdisk(folder.path(), &small));
    let lines = [
        "pilot: ",
        "lamp: ",
        "error: ",
        "samples per pixel: ",
        "fireflies: ",
        "ended at its target (to within 5.00 % of it)",
    ];
    let places: Vec<_> = lines.iter().map(|l| said.find(l)).collect();
    assert!(
        places.iter().all(Option::is_some) && places.is_sorted(),
        "{said}"
    );
    // Few even samples can only bound their error, and 32 know it.
    for (spp, bound) in [("16", true), ("32", false)] {
        let said = complaint(&halfdisk(folder.path(), &["render", "lamp", "--spp", spp]));
        assert_eq!(
            said.matches("at most ").count(),
            if bound { 2 } else { 0 },
            "{said}"
        );
    }
    let quiet = [&small[..], &["--quiet"]].concat();
    assert!(halfdisk(folder.path(), &quiet).stderr.is_empty());
}

#[test]
fn maps_lie_beside_the_picture() {
    let folder = folder();
    let said = json(
        folder.path(),
        &["render", "lamp", "--spp", "64", "--maps", "--out", "p.exr"],
    );
    for (i, kind) in ["variance", "required", "histogram"]
        .into_iter()
        .enumerate()
    {
        let name = format!("p.{kind}.svg");
        assert_eq!(said["maps"][i], name);
        let svg = std::fs::read_to_string(folder.path().join(name)).unwrap();
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    }
    let normals = [
        "render",
        "furnace",
        "--integrator",
        "normals",
        "--size",
        "4x4",
        "--maps",
    ];
    assert!(halfdisk(folder.path(), &normals).status.success());
}

#[test]
fn goals_that_make_no_sense() {
    let folder = folder();
    for more in [
        &["--target-error", "0"][..],
        &["--target-error", "-2%"],
        &["--target-error", "nan"],
        &["--target-error", "101%"],
        &["--target-error", "two"],
        &["--target-quantile", "95%"],
        &["--time", "0s"],
        &["--time", "-1"],
        &["--time", "inf"],
        &["--time", "soon"],
        &["--time", "1h30"],
        &["--target-error", "2"],
        &["--time", "3s", "--spp", "4"],
        &["--target-error", "2%", "--spp", "4"],
    ] {
        let output = halfdisk(folder.path(), &[&["render", "lamp"], more].concat());
        let text = complaint(&output);
        assert_eq!(output.status.code(), Some(2), "{more:?}: {text}");
        assert!(!text.contains("panicked"), "{text}");
    }
    assert!(folder.path().read_dir().unwrap().next().is_none());
    refused(
        folder.path(),
        &["render", "lamp", "--time", "1s", "--out", "p.jpg"],
        2,
    );
}

#[cfg(unix)]
#[test]
fn ctrl_c_keeps_the_picture_and_says_how_good_it_is() {
    let folder = folder();
    let long = [
        "render",
        "lamp",
        "--threads",
        "1",
        "--target-error",
        "0.00001%",
        "--json",
        "--out",
        "p.png",
    ];
    let output = super::interrupted(folder.path(), &long);
    let said = complaint(&output);
    assert_eq!(output.status.code(), Some(130), "{said}");
    assert!(
        said.contains("error: ") && said.contains("interrupted: "),
        "{said}"
    );
    let object: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(object["accuracy"]["stopped_by"], "interrupt");
    let error = object["accuracy"]["reached"]["error"].as_f64().unwrap();
    assert!(error > 1e-7 && error < 0.2, "{error}");
    let image = image::open(folder.path().join("p.png")).unwrap().to_rgb8();
    assert!(image.pixels().all(|p| p.0 != [255, 0, 255]));
}

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
const LAMP: &str = "[[objects]]\nemits = 5\n\
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
        ("path", format!("{SUN}{ball}"), &["LSDE"]),
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
        assert_eq!(json(folder.path(), &arguments)["left_out"], Value::Null);
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
fn a_constant_sky_ends_at_once_and_claims_no_error() {
    let folder = folder();
    for (light, objects) in [
        ("environment.radiance = 1", ""),
        ("background = [1, 2, 3]", LAMP),
    ] {
        let text = format!(
            "name = 'sky'\n{light}\nfilm.size = [16, 16]\n\
             [camera]\nfrom = [0, 1, 5]\nto = [0, 9, 9]\nfov = 40\n{objects}"
        );
        std::fs::write(folder.path().join("sky.toml"), text).unwrap();
        for error in ["2%", "0.0001%"] {
            let arguments = ["render", "sky.toml", "--target-error", error, "--json"];
            let output = halfdisk(folder.path(), &arguments);
            let said = complaint(&output);
            assert!(
                said.contains("all samples of each pixel are alike"),
                "{said}"
            );
            let object: Value = serde_json::from_slice(&output.stdout).unwrap();
            assert_eq!(object["accuracy"]["stopped_by"], "no-noise");
            assert!(object["mean"]["error"].as_f64().unwrap() > 5e-8);
        }
    }
}

#[test]
fn the_clock_rules_from_the_first_sample() {
    let folder = folder();
    // A pass over such a picture takes a good part of the time; a pilot of 32 took fifty times as long.
    let picture = ["--size", "500x500", "--time", "0.3s", "--out", "p.exr"];
    let said = json(
        folder.path(),
        &[&["render", "cornell"][..], &picture].concat(),
    );
    let reached = &said["accuracy"]["reached"];
    let (spp, seconds) = (
        reached["spp"].as_u64().unwrap(),
        reached["seconds"].as_f64().unwrap(),
    );
    // One pass is finished whatever the clock says.
    assert!(seconds < 1.0 || spp == 1, "{spp} samples in {seconds} s");
    assert_eq!(said["accuracy"]["stopped_by"], "time");
}

#[test]
fn words_count_and_say_what_is_not_known() {
    let folder = folder();
    let run = |more: &[&str]| {
        let output = halfdisk(
            folder.path(),
            &[&["render", "lamp", "--size", "8x8"], more].concat(),
        );
        assert!(output.status.success());
        complaint(&output)
    };
    let one = run(&["--spp", "1", "--maps"]);
    for words in [
        "error: not known (one sample has no spread)",
        "(error not known)",
        "note: no maps: one sample has no spread",
    ] {
        assert!(one.contains(words), "{words}: {one}");
    }
    assert!(!one.contains("fireflies") && !folder.path().join("out/lamp.histogram.svg").exists());
    assert!(run(&["--spp", "16"]).contains("error: at most "));
    let goal = run(&["--target-error", "3%"]);
    assert!(
        goal.contains("; the same picture comes by --spp "),
        "{goal}"
    );
    assert!(goal.contains("fireflies: the worst pixel has "), "{goal}");
    let refused = |more: &[&str]| complaint(&halfdisk(folder.path(), more));
    let said = refused(&["render", "lamp", "--target-error", "2"]);
    assert!(
        said.contains("2 per cent is written as 2% or 0.02"),
        "{said}"
    );
    for ignored in [
        &["effects", "lamp", "--spp", "4"][..],
        &["effects", "lamp", "--rounds", "3"],
        &["render", "lamp", "--integrator", "kajiya", "--all-effects"],
    ] {
        let output = halfdisk(folder.path(), ignored);
        assert_eq!(output.status.code(), Some(2), "{ignored:?}");
    }
    for command in ["render", "effects"] {
        let help = halfdisk(folder.path(), &[command, "--help"]).stdout;
        let help = String::from_utf8(help).unwrap();
        let headed = help.split("Which light:").nth(1).expect("a heading");
        let headed = headed.split("Examples:").next().unwrap();
        let options = headed
            .lines()
            .filter(|line| line.trim_start().starts_with('-'));
        let options: Vec<_> = options.map(str::trim).collect();
        assert!(
            options.len() == 2 && options[0].starts_with("--paths"),
            "{options:?}"
        );
    }
}
