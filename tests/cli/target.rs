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
        "error reached: ",
        "samples per pixel: ",
        "fireflies: ",
        "ended at its target",
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
            said.matches(" or less").count(),
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
        said.contains("error reached: ") && said.contains("interrupted: "),
        "{said}"
    );
    let object: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(object["accuracy"]["stopped_by"], "interrupt");
    let error = object["accuracy"]["reached"]["error"].as_f64().unwrap();
    assert!(error > 1e-7 && error < 0.2, "{error}");
    let image = image::open(folder.path().join("p.png")).unwrap().to_rgb8();
    assert!(image.pixels().all(|p| p.0 != [255, 0, 255]));
}
