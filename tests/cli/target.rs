//! `render` to an error or a time, as people meet it.

use super::{complaint, folder, halfdisk, left_out, refused};
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
        // The pilot of an error also chooses how many paths start at the lights.
        let light_paths = said["facts"]["light_paths"].to_string();
        let by_number = ["--spp", &spp, "--light-paths", &light_paths, "--out", &b];
        let again = json(folder.path(), &[&small[..], &by_number].concat());
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
    let kinds = ["variance", "required", "histogram"].into_iter();
    for (i, kind) in kinds.enumerate() {
        let names = ["svg", "png"].map(|ending| format!("p.{kind}.{ending}"));
        assert_eq!(said["maps"][2 * i], names[0]);
        assert_eq!(said["maps"][2 * i + 1], names[1]);
        let svg = std::fs::read_to_string(folder.path().join(&names[0])).unwrap();
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
        let png = image::open(folder.path().join(&names[1])).unwrap();
        assert_eq!(png.width(), 1440);
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
    // The scatter of photons is not all of their error.
    let photons = ["render", "lamp", "--integrator", "photons"];
    refused(
        folder.path(),
        &[&photons[..], &["--target-error", "5%"]].concat(),
        2,
    );
    let small = ["--spp", "4", "--size", "4x4"];
    let output = halfdisk(folder.path(), &[&photons[..], &small].concat());
    let text = complaint(&output);
    assert!(text.contains("that error is noise alone"), "{text}");
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

#[test]
fn a_constant_sky_ends_at_once_and_claims_no_error() {
    let folder = folder();
    for (light, objects) in [
        ("environment.radiance = 1", ""),
        ("background = [1, 2, 3]", left_out::LAMP),
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
