//! Snapshots of each chapter's quick run: its data, its pictures as estimates, what its charts say, and one
//! drawing of each kind as a file.
//!
//! To review a change: run `cargo insta review` (or look at the `.snap.new` files), and open the sheet that
//! a refused picture leaves: what was expected, what came, and the difference.

mod charts;
mod hard_cases;
mod judge;
mod patches;
mod photons;
mod pictures;
mod prices;
mod scenes;
mod shown;
mod walks;
mod words;

use halfdisk::output;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Chapters with pictures, and the samples of each of their pixels: so many that a bias of 1 % is noticed,
/// where that takes seconds.
const PROGRAMS: [(&str, &str, &str); 18] = [
    (env!("CARGO_BIN_EXE_ch01-from-the-eye"), "ch01", "800"),
    (env!("CARGO_BIN_EXE_ch02-whitteds-tree"), "ch02", "16"),
    (env!("CARGO_BIN_EXE_ch03-hit-or-miss"), "ch03", "64"),
    (env!("CARGO_BIN_EXE_ch04-half-disk"), "ch04", "64"),
    (env!("CARGO_BIN_EXE_ch05-importance-sampling"), "ch05", "64"),
    (env!("CARGO_BIN_EXE_ch06-gather"), "ch06", "16"),
    (env!("CARGO_BIN_EXE_ch07-one-ray"), "ch07", "64"),
    (env!("CARGO_BIN_EXE_ch08-which-ray"), "ch08", "16"),
    (env!("CARGO_BIN_EXE_ch09-aim-at-the-light"), "ch09", "32"),
    (env!("CARGO_BIN_EXE_ch10-roulette"), "ch10", "64"),
    (env!("CARGO_BIN_EXE_ch11-combine"), "ch11", "32"),
    (env!("CARGO_BIN_EXE_ch12-the-path-tracer"), "ch12", "64"),
    (env!("CARGO_BIN_EXE_ch13-six-integrals"), "ch13", "16"),
    (env!("CARGO_BIN_EXE_ch14-alphabet"), "ch14", "256"),
    (env!("CARGO_BIN_EXE_ch15-patches"), "ch15", "256"),
    (env!("CARGO_BIN_EXE_ch16-photons"), "ch16", "16"),
    (env!("CARGO_BIN_EXE_ch18-cost"), "ch18", "64"),
    (
        env!("CARGO_BIN_EXE_ch19-what-the-scene-asks"),
        "ch19",
        "256",
    ),
];

/// Pictures, or all whose names begin so, that show how noisy a method is, or have next to no light: a bias of 3 %
/// would take minutes.
const SHOW_NOISE: [&str; 13] = [
    "ch01-light",
    "ch14-caustic",
    "ch14-seen_specular",
    "ch09-chance_",
    "ch09-twice",
    "ch11-chance",
    "ch12-aiming",
    "ch12-chance",
    "ch16-sweep_",
    "ch16-unseen_",
    "ch17-acne_end",
    "ch19-caustic",
    "ch19-seen_specular",
];

/// A chapter's program, run quickly into a folder of its own.
fn run(program: &str, id: &str, more: &[&str]) -> (tempfile::TempDir, Value) {
    let folder = tempfile::tempdir().unwrap();
    let output = Command::new(program)
        .args(["--quick", "--exr", "--out"])
        .arg(folder.path())
        .args(more)
        .output()
        .unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{id}: {errors}");
    let text = fs::read_to_string(folder.path().join(id).join("data.json")).unwrap();
    let mut data: Value = serde_json::from_str(&text).unwrap();
    data["ledger"]["seconds"] = Value::from("masked");
    mask(&mut data);
    round(&mut data);
    (folder, data)
}

/// True for what differs from run to run.
fn is_timed(name: &str) -> bool {
    name.contains("time_") || name.starts_with("seconds")
}

/// Hides what was timed: numbers, and what is said about figures.
fn mask(data: &mut Value) {
    for (name, number) in data["numbers"].as_object_mut().unwrap() {
        if is_timed(name) {
            *number = Value::from("masked");
        }
    }
    for figure in data["figures"].as_array_mut().unwrap() {
        if is_timed(figure["file"].as_str().unwrap()) {
            figure["caption"] = Value::from("masked");
        }
    }
}

/// Nine significant digits: enough to notice any change, few enough to read.
fn round(value: &mut Value) {
    match value {
        Value::Number(number) if number.is_f64() => {
            let rounded = format!("{:.8e}", number.as_f64().unwrap());
            *value = Value::from(rounded.parse::<f64>().unwrap());
        }
        Value::Array(items) => items.iter_mut().for_each(round),
        Value::Object(fields) => fields.values_mut().for_each(round),
        _ => {}
    }
}

/// Compares a picture with the stored one, as what it is: an estimate.
fn check_picture(name: &str, path: &Path) {
    let blocks = pictures::in_blocks(&output::read(&path.with_extension("exr")).unwrap());
    let mut settings = insta::Settings::clone_current();
    settings.set_comparator(Box::new(pictures::Judge(name.to_owned())));
    settings.bind(|| {
        let bytes = pictures::snapshot(path, &blocks);
        insta::assert_binary_snapshot!(&format!("{name}.png"), bytes);
    });
    let notices = pictures::Verdict::of(&blocks, &blocks).notices;
    println!("{name}: would notice a bias of {:.2} %", 100.0 * notices);
    let excused = (SHOW_NOISE.iter())
        .any(|shows| *shows == name || shows.ends_with('_') && name.starts_with(shows));
    let enough = notices <= 0.03 || excused;
    assert!(enough, "{name}: would notice a bias of {notices} only");
}

/// Compares everything a chapter made with what it made before.
fn check(program: &str, id: &str) -> Value {
    let spp = PROGRAMS.iter().find(|(_, other, _)| *other == id);
    let more = spp.map(|(_, _, spp)| ["--spp", spp]);
    let (folder, data) = run(program, id, more.as_ref().map_or(&[], |more| more));
    let folder = folder.path().join(id);
    insta::assert_json_snapshot!(format!("{id}-data"), data);
    shown::has_a_last_picture(&folder, &data);
    let mut said = String::new();
    for figure in data["figures"].as_array().unwrap() {
        let file = figure["file"].as_str().unwrap();
        let path = folder.join(file);
        let (stem, ending) = file.split_once('.').unwrap();
        let name = format!("{id}-{stem}");
        match ending {
            "svg" => {
                let svg = fs::read_to_string(&path).unwrap();
                let words = charts::words(&format!("{id}/{file}"), &svg);
                if is_timed(file) {
                    assert!(!words.is_empty(), "{file}");
                    continue;
                }
                said += &format!("{file}: {}\n", words.join(" | "));
                if charts::ONE_OF_EACH_KIND.contains(&name.as_str()) {
                    insta::assert_binary_snapshot!(&format!("{name}.svg"), svg.into_bytes());
                }
            }
            _ if is_timed(file) => assert!(path.exists(), "{file}"),
            _ => check_picture(&name, &path),
        }
    }
    if !said.is_empty() {
        insta::assert_snapshot!(format!("{id}-charts"), said);
    }
    data
}

fn number(data: &Value, name: &str, part: &str) -> f64 {
    data["numbers"][name][part].as_f64().unwrap()
}

#[test]
fn ch01_from_the_eye() {
    let data = check(env!("CARGO_BIN_EXE_ch01-from-the-eye"), "ch01");
    for name in ["slit", "slit_doubled", "disc", "disc_doubled"] {
        let [value, exact, error] = ["value", "exact", "error"].map(|p| number(&data, name, p));
        let z = (value - exact) / error;
        assert!(z.abs() <= 4.0, "{name}: {value} for {exact}, z = {z}");
        // Three in space for two in the plane: a count of the other would not pass.
        assert!(
            error < 0.04 * exact,
            "{name}: the error {error} must tell apart"
        );
    }
    assert_eq!(number(&data, "slit_pinhole", "value"), 0.0);
    assert_eq!(number(&data, "disc_pinhole", "value"), 0.0);
    assert!(
        number(&data, "price", "value") > 3.0,
        "from the eye is cheaper"
    );
}

#[test]
fn ch02_whitteds_tree() {
    let data = check(env!("CARGO_BIN_EXE_ch02-whitteds-tree"), "ch02");
    for depth in 1..=14 {
        let rays = number(&data, &format!("rays_{depth}"), "value");
        assert_eq!(rays, f64::from((1 << depth) - 1), "1, 3, 7, 15 …");
        let weight = number(&data, &format!("weight_{depth}"), "value");
        assert!((weight - 1.0).abs() <= 1e-12, "depth {depth}: {weight}");
    }
    for name in ["slab_through", "slab_back"] {
        let difference = number(&data, name, "value") - number(&data, name, "exact");
        assert!(difference.abs() <= 1e-6, "{name}: {difference:e}");
    }
    assert!(number(&data, "tunnel_error", "value") <= 1e-6);
}

/// |value - exact| within four of its own standard errors, or equal where it has none.
fn near(data: &Value, name: &str) {
    let [value, exact, error] = ["value", "exact", "error"].map(|p| number(data, name, p));
    assert!(
        (value - exact).abs() <= 4.0 * error + 1e-9,
        "{name}: {value} ± {error} for {exact}"
    );
}

#[test]
fn ch04_half_disk() {
    let data = check(env!("CARGO_BIN_EXE_ch04-half-disk"), "ch04");
    for name in [
        "reading_correct",
        "reading_printed",
        "reading_over_pi",
        "reading_cosine",
        "reading_one_more",
        "reading_transposed",
        "segment",
        "segment_printed",
        "room",
        "sky_flat",
        "sky_solid",
        "bulb_one",
        "bulb_two",
        "slope_correct",
        "slope_literal",
    ] {
        near(&data, name);
    }
    // The readings of the mistakes are far from the right one, in their own errors.
    for name in [
        "reading_printed",
        "reading_over_pi",
        "reading_cosine",
        "reading_one_more",
    ] {
        let off = (number(&data, name, "value") - 1.0).abs();
        assert!(off > 20.0 * number(&data, name, "error"), "{name}");
    }
    assert!(number(&data, "slope_correct", "value") < -0.4);
    assert!(number(&data, "slope_literal", "value") > -0.1);
    // Twice as far: a quarter of the irradiance, and neither a half nor an eighth.
    let [near, far] = ["bulb_one", "bulb_two"].map(|name| number(&data, name, "value"));
    assert!((3.5..4.5).contains(&(near / far)), "{near} and {far}");
    // Paths of 24 segments lack the share 2^-24 of the light.
    let lacks = 2.0 - number(&data, "furnace", "value");
    assert!((0.0..4e-7).contains(&lacks), "{lacks:e}");
}

#[test]
fn ch06_gather() {
    let data = check(env!("CARGO_BIN_EXE_ch06-gather"), "ch06");
    for name in [
        "bounce_0", "bounce_1", "bounce_2", "bounce_3", "sphere", "disk", "square",
    ] {
        near(&data, name);
    }
    assert_eq!(number(&data, "rays_16_2", "value"), 273.0);
    assert_eq!(number(&data, "rays_16_4", "value"), 69_905.0);
    // Bleeding is all in the indirect light: exactly none without it.
    assert_eq!(number(&data, "bleeding_red_0", "value"), 1.0);
    let tinge = number(&data, "bleeding_red_4", "value") - 1.0;
    assert!(
        tinge > 20.0 * number(&data, "bleeding_red_4", "error"),
        "{tinge}"
    );
    assert!(number(&data, "bleeding_green_4", "value") < 1.0);
}

#[test]
fn ch03_hit_or_miss() {
    let data = check(env!("CARGO_BIN_EXE_ch03-hit-or-miss"), "ch03");
    let parts = |name: &str| ["value", "exact", "error"].map(|part| number(&data, name, part));
    // Each with the largest relative error at which the check still says something.
    for (name, widest) in [
        ("pi_darts", 0.002),
        ("pi_mean", 0.001),
        ("sigma_darts", 0.0025),
        ("sigma_mean", 0.0025),
        ("variance_ratio", 0.005),
        ("coverage", 0.005),
        ("slope_darts", 0.03),
        ("slope_mean", 0.03),
        ("slope_step", 0.03),
        ("worse", 0.02),
    ] {
        let [value, exact, error] = parts(name);
        let z = (value - exact) / error;
        assert!(z.abs() <= 4.0, "{name}: {value} for {exact}, z = {z}");
        assert!(error < widest * exact.abs(), "{name}: the error is {error}");
    }
    // Two equal runs would be worse every other time, and four errors away that is refused.
    let [worse, _, error] = parts("worse");
    assert!((worse - 0.5).abs() > 4.0 * error);
    // The band is made for 95 of 100.
    assert!((parts("coverage")[0] - 0.95).abs() <= 0.015);
    let [jittered, law, error] = parts("slope_jittered");
    assert!((jittered - law).abs() <= 0.03, "{jittered}");
    assert!(
        (jittered + 0.5).abs() > 4.0 * error,
        "not the rate of darts"
    );
    assert_eq!(number(&data, "crossing", "value"), 4.0);
    for d in [1, 2, 3, 4, 6] {
        let name = format!("grid_{d}");
        let difference = number(&data, &name, "value") / number(&data, &name, "exact") - 1.0;
        assert!(difference.abs() < 1e-4, "{name}: {difference}");
    }
    for d in 1..=8 {
        let [value, exact, error] = parts(&format!("chance_{d}"));
        assert!((value - exact).abs() <= 4.0 * error, "d = {d}: {value}");
    }
}

#[test]
fn ch05_importance_sampling() {
    let data = check(env!("CARGO_BIN_EXE_ch05-importance-sampling"), "ch05");
    for name in ["mean_cos", "variance_uniform", "gain", "slope_uniform"] {
        for world in ["_flat", "_solid"].map(|w| if name.starts_with("slope") { "" } else { w }) {
            let name = format!("{name}{world}");
            let [value, exact, error] =
                ["value", "exact", "error"].map(|p| number(&data, &name, p));
            let z = (value - exact) / error;
            assert!(z.abs() <= 4.0, "{name}: {value} for {exact}, z = {z}");
        }
    }
    for world in ["flat", "solid"] {
        for law in ["uniform", "cosine", "cos_n"] {
            let p = number(&data, &format!("p_{law}_{world}"), "value");
            assert!(p > 1e-3, "{world}, {law}: {p}");
        }
        let p = number(&data, &format!("p_wrong_{world}"), "value");
        assert!(p < 1e-6, "{world}: {p}");
        // Every sample lies a quarter from the mean, so nothing is left to chance.
        let variance = number(&data, &format!("variance_cosine_{world}"), "value");
        assert!((variance - 0.0625).abs() < 1e-6, "{world}: {variance}");
        let variance = number(&data, &format!("furnace_variance_{world}"), "value");
        assert!(variance < 1e-12, "{world}: {variance:e}");
        assert!(number(&data, &format!("gain_{world}"), "value") > 3.0);
    }
    assert!(number(&data, "p_polar_solid", "value") < 1e-6);
    // Strata of a line, of a grid, of a grid with an edge: each law is out of the others' reach.
    for (name, law, within) in [
        ("slope_stratified", -1.5, 0.06),
        ("slope_grid", -1.0, 0.08),
        ("slope_edge", -0.75, 0.1),
        ("slope_edge_cosine", -0.75, 0.1),
    ] {
        let slope = number(&data, name, "value");
        assert!((slope - law).abs() < within, "{name}: {slope}");
    }
}
