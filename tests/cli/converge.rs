//! `halfdisk converge`: what it prints, writes and refuses.

use super::{complaint, folder, halfdisk, refused};
use halfdisk::lab::experiment::named;
use serde_json::Value;
use std::path::Path;

/// Runs `converge` in `folder`; returns its stdout.
fn converge(folder: &Path, arguments: &[&str]) -> String {
    let output = halfdisk(folder, &[&["converge"], arguments].concat());
    assert!(output.status.success(), "{}", complaint(&output));
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn every_estimator_is_listed() {
    let folder = folder();
    let text = converge(folder.path(), &["--list"]);
    let json: Value =
        serde_json::from_str(&converge(folder.path(), &["--list", "--json"])).unwrap();
    let all = named::all();
    assert_eq!(text.lines().count(), all.len());
    assert_eq!(json.as_array().unwrap().len(), all.len());
    for ((line, entry), estimator) in text.lines().zip(json.as_array().unwrap()).zip(&all) {
        assert_eq!(line.split_whitespace().next(), Some(estimator.name));
        assert!(line.ends_with(estimator.about), "{line}");
        assert_eq!(entry["name"], estimator.name);
        for key in ["about", "truth", "sizes"] {
            assert!(entry.get(key).is_some(), "no {key} in {entry}");
        }
    }
    assert!(folder.path().read_dir().unwrap().next().is_none());
}

#[test]
fn a_table_a_chart_and_numbers_for_several() {
    let folder = folder();
    let names = ["half-disk", "half-disk-literal", "half-disk"];
    let text = converge(folder.path(), &names);
    assert!(text.contains("N   error ± its error"), "{text}");
    assert!(
        text.contains("slope -0.") && !text.contains("-0.000"),
        "{text}"
    );
    let path = folder
        .path()
        .join("out/converge/half-disk+half-disk-literal");
    let read = |ending| std::fs::read_to_string(format!("{}.{ending}", path.display())).unwrap();
    let csv = read("csv");
    // A name given twice is run once; there is one header.
    assert_eq!(csv.lines().count(), 1 + 2 * 11);
    assert_eq!(csv.matches("name,samples,").count(), 1);
    let svg = read("svg");
    for words in [
        "samples N",
        "root mean squared error",
        "half-disk: slope -0.",
        "256 runs",
    ] {
        assert!(svg.contains(words), "no {words:?} in the chart");
    }
    let png = image::open(format!("{}.png", path.display())).unwrap();
    assert_eq!(png.width(), 1440, "twice as fine as the page");
    let json: Value = serde_json::from_str(&read("json")).unwrap();
    assert_eq!(json["replicates"], 256);
    let slope = |i: usize| {
        json["estimators"][i]["fit"]["line"]["slope"]
            .as_f64()
            .unwrap()
    };
    assert!((slope(0) + 0.5).abs() < 0.02 && slope(1).abs() < 0.02);
}

#[test]
fn json_is_all_there_is_on_stdout_and_in_the_file() {
    let folder = folder();
    let few = [
        "darts",
        "--replicates",
        "4",
        "--doublings",
        "3",
        "--json",
        "--out",
        "deep/er",
    ];
    let text = converge(folder.path(), &few);
    let object: Value = serde_json::from_str(&text).expect("one JSON object");
    for key in ["seed", "replicates", "doublings", "estimators"] {
        assert!(object.get(key).is_some(), "no {key}");
    }
    let run = &object["estimators"][0];
    for key in ["name", "truth", "sizes", "fit", "insufficient", "says"] {
        assert!(run.get(key).is_some(), "no {key}");
    }
    assert_eq!(run["sizes"].as_array().unwrap().len(), 3);
    for key in [
        "samples",
        "rays",
        "bias",
        "bias_error",
        "rmse",
        "rmse_error",
        "variance",
    ] {
        assert!(run["sizes"][2].get(key).is_some(), "no {key}");
    }
    let file = std::fs::read_to_string(folder.path().join("deep/er/darts.json")).unwrap();
    assert_eq!(file, text);
}

#[test]
fn too_little_for_a_slope_says_why() {
    let folder = folder();
    for (replicates, doublings, why) in [
        ("1", "3", "fewer than two replicates"),
        ("9", "1", "fewer than two sizes"),
        ("3", "3", "the interval is too wide: slope "),
    ] {
        let few = [
            "darts",
            "--replicates",
            replicates,
            "--doublings",
            doublings,
        ];
        let text = converge(folder.path(), &few);
        assert!(text.contains(&format!("insufficient: {why}")), "{text}");
        assert!(folder.path().join("out/converge/darts.svg").exists());
    }
}

#[test]
fn threads_change_no_byte_and_the_seed_does() {
    let run = |threads, seed| {
        let folder = folder();
        let names = [
            "hemisphere-lamp",
            "step",
            "--replicates",
            "16",
            "--doublings",
            "5",
        ];
        let more = ["--threads", threads, "--seed", seed];
        let text = converge(folder.path(), &[&names[..], &more].concat());
        let stem = folder.path().join("out/converge/hemisphere-lamp+step");
        let read = |ending| std::fs::read(stem.with_extension(ending)).unwrap();
        (text, ["csv", "json", "svg"].map(read))
    };
    assert!(run("1", "1") == run("2", "1"));
    assert!(run("1", "1") != run("1", "2"));
}

#[test]
fn many_names_make_a_short_file_name() {
    let folder = folder();
    let names: Vec<&str> = named::all().iter().map(|e| e.name).collect();
    let few = ["--replicates", "2", "--doublings", "3"];
    converge(folder.path(), &[&names[..], &few].concat());
    for entry in folder.path().join("out/converge").read_dir().unwrap() {
        assert!(entry.unwrap().file_name().len() <= 90);
    }
}

#[test]
fn requests_that_cannot_be_met() {
    let folder = folder();
    let sentence = refused(folder.path(), &["converge", "half-disk", "magic"], 2);
    assert!(sentence.starts_with("there is no estimator \"magic\"; there are darts, "));
    for estimator in named::all() {
        assert!(sentence.contains(estimator.name), "{sentence}");
    }
    for arguments in [
        &["converge"][..],
        &["converge", "darts", "--list"],
        &["converge", "darts", "--replicates", "0"],
        &["converge", "darts", "--doublings", "0"],
        &["converge", "darts", "--doublings", "99"],
        &["converge", "darts", "--threads", "0"],
    ] {
        let output = halfdisk(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    }
    assert!(folder.path().read_dir().unwrap().next().is_none());
    std::fs::write(folder.path().join("file"), "").unwrap();
    let few = ["converge", "darts", "--replicates", "2", "--out", "file/in"];
    assert!(refused(folder.path(), &few, 1).starts_with("file/in: "));
}

#[cfg(unix)]
#[test]
fn ctrl_c_keeps_what_is_finished() {
    let folder = folder();
    // Midpoints take a moment, the product in 8 dimensions many; a busy machine may be slower still.
    let two = ["converge", "midpoints", "product-8", "--threads", "1"];
    let long = ["--replicates", "600", "--doublings", "13"];
    let output = super::interrupted(folder.path(), &[&two[..], &long[..]].concat());
    let said = complaint(&output);
    assert_eq!(output.status.code(), Some(130), "{said}");
    let kept = said.contains("interrupted: 1 of 2 estimators");
    assert!(kept || said.contains("interrupted: 0 of 2"), "{said}");
    // Of the second one the runs are kept that were finished, if any were.
    let began = said.contains("runs of product-8 are kept");
    let names = [
        ("midpoints", kept && !began),
        ("midpoints+product-8", began),
    ];
    for (name, there) in names {
        let file = folder.path().join(format!("out/converge/{name}.csv"));
        assert_eq!(file.exists(), there, "{said}");
    }
}

#[test]
fn of_one_run_alone_neither_error_nor_variance_is_known() {
    let folder = folder();
    for name in ["darts", "half-disk"] {
        let one = [name, "--replicates", "1", "--doublings", "3"];
        let text = converge(folder.path(), &one);
        let rows: Vec<&str> = text.lines().filter(|l| l.contains(" ± ")).collect();
        assert!(rows.len() > 1, "{text}");
        for row in rows.iter().skip(1) {
            assert_eq!(row.matches("unknown").count(), 2, "{row}");
        }
        let path = folder.path().join("out/converge").join(name);
        let read = |ending| std::fs::read_to_string(path.with_extension(ending)).unwrap();
        for line in read("csv").lines().skip(1) {
            assert!(line.ends_with(','), "{line}");
        }
        let json: Value = serde_json::from_str(&read("json")).unwrap();
        let sizes = json["estimators"][0]["sizes"].as_array().unwrap();
        assert_eq!(sizes.len(), 3);
        for size in sizes {
            assert!(
                size["variance"].is_null() && size["rmse_error"].is_null(),
                "{size}"
            );
            assert!(size["rmse"].as_f64().unwrap() >= 0.0);
        }
        // Two runs know them.
        let two = converge(
            folder.path(),
            &[name, "--replicates", "2", "--doublings", "3"],
        );
        assert!(!two.contains("unknown"), "{two}");
    }
}

#[test]
fn shares_of_the_replicates_make_the_bytes_of_one_run() {
    let folder = folder();
    let folder = folder.path();
    let names = [
        "half-disk",
        "step",
        "--replicates",
        "10",
        "--doublings",
        "4",
    ];
    let whole = converge(folder, &[&names[..], &["--out", "whole"]].concat());
    let share = |settings: &[&str], shard: &str, out: &str| {
        converge(
            folder,
            &[settings, &["--shard", shard, "--out", out]].concat(),
        );
        let shard = shard.replace('/', "-of-");
        format!("{out}/{}+{}-{shard}.json", settings[0], settings[1])
    };
    let mut parts = ["1/3", "2/3", "3/3"].map(|shard| share(&names, shard, "parts"));
    parts.reverse();
    let [three, two, one] = parts.each_ref().map(String::as_str);
    let merged = converge(folder, &["--merge", three, two, one, "--out", "merged"]);
    assert_eq!(merged, whole);
    for ending in ["csv", "json", "svg", "png"] {
        let [a, b] = ["whole", "merged"].map(|out| {
            std::fs::read(folder.join(format!("{out}/half-disk+step.{ending}"))).unwrap()
        });
        assert!(a == b, "{ending}");
    }
    let seed = share(&[&names[..], &["--seed", "2"]].concat(), "2/3", "seed");
    let two_of_four = share(&names, "2/4", "four");
    let text = std::fs::read_to_string(folder.join(two)).unwrap();
    let broken = text.replacen('7', "8", 1);
    std::fs::write(folder.join("broken.json"), broken).unwrap();
    std::fs::write(folder.join("cut.json"), &text[..text.len() / 2]).unwrap();
    for (files, said) in [
        (&[one, three][..], "missing: the shares 2/3".to_owned()),
        (
            &[one, two, three, two],
            format!("{two}: is share 2/3, as {two} is"),
        ),
        (
            &[one, &seed, three],
            format!("{seed}: measures something else than {one}"),
        ),
        (
            &[one, &two_of_four],
            format!("{two_of_four}: is one of 4 shares, {one} one of 3"),
        ),
        (
            &[one, "broken.json", three],
            "broken.json: is damaged".to_owned(),
        ),
        (
            &[one, "cut.json", three],
            "cut.json: is no share of this command: EOF".to_owned(),
        ),
        (
            &["whole/half-disk+step.json"],
            "is no share of this command".to_owned(),
        ),
        (&["nix.json"], "nix.json: ".to_owned()),
    ] {
        let sentence = refused(folder, &[&["converge", "--merge"], files].concat(), 2);
        assert!(sentence.contains(&said), "{files:?}: {sentence}");
    }
}
