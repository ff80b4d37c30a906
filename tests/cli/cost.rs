//! `halfdisk cost`: what it prints, writes and refuses.

use super::{SCENE, complaint, folder, halfdisk, refused};
use serde_json::Value;
use std::path::Path;

const SMALL: [&str; 8] = [
    "--budget",
    "1",
    "--size",
    "24x24",
    "--replicates",
    "3",
    "--methods",
    "whitted,path,path-sobol",
];

fn cost(folder: &Path, arguments: &[&str]) -> String {
    let output = halfdisk(folder, &[&["cost"], arguments].concat());
    assert!(output.status.success(), "{}", complaint(&output));
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn a_page_charts_pictures_and_numbers() {
    let folder = folder();
    let text = cost(folder.path(), &[&["cornell"][..], &SMALL].concat());
    for words in [
        "cornell, 24 x 24, 3 replicates",
        "path-sobol needs ",
        "at 256 x 256",
        "never",
    ] {
        assert!(text.contains(words), "no {words:?} in {text}");
    }
    let made = folder.path().join("out/cost/cornell");
    let page = std::fs::read_to_string(made.join("index.html")).unwrap();
    // Everything the page shows lies beside it.
    let shown: Vec<&str> = page
        .split("src=\"")
        .skip(1)
        .filter_map(|s| s.split('"').next())
        .collect();
    // Two charts; of each method a picture and its error in equal time, and of those that reach it
    // the same in equal error.
    assert!([2 + 6 + 4, 2 + 6 + 6].contains(&shown.len()), "{shown:?}");
    assert!(
        shown.iter().all(|file| made.join(file).exists()),
        "{shown:?}"
    );
    assert!(!page.contains("NaN") && !page.contains("inf"), "{page}");
    let csv = std::fs::read_to_string(made.join("cost.csv")).unwrap();
    assert!(csv.starts_with("method,spp,rays,seconds,"));
    assert!(csv.contains("whitted,") && csv.contains(",biased"), "{csv}");
    let json: Value =
        serde_json::from_str(&std::fs::read_to_string(made.join("cost.json")).unwrap()).unwrap();
    assert_eq!(json["methods"].as_array().unwrap().len(), 3);
    assert_eq!(json["methods"][0]["verdict"], "biased");
}

#[test]
fn a_scene_of_ones_own_and_json() {
    let folder = folder();
    std::fs::write(folder.path().join("mine.toml"), SCENE).unwrap();
    let small = [
        "cost",
        "mine.toml",
        "--budget",
        "1",
        "--replicates",
        "2",
        "--json",
        "--out",
        "here",
    ];
    let output = halfdisk(folder.path(), &small);
    assert!(output.status.success(), "{}", complaint(&output));
    let json: Value = serde_json::from_slice(&output.stdout).unwrap();
    // Lamps without extent: walks by chance cannot render this.
    assert_eq!(json["methods"].as_array().unwrap().len(), 9);
    let page = std::fs::read_to_string(folder.path().join("here/index.html")).unwrap();
    assert!(page.contains("kajiya: a random walk never meets a point or a direction"));
}

#[test]
fn what_it_cannot_do_it_says() {
    let folder = folder();
    let sentence = refused(folder.path(), &["cost", "cornell", "--methods", "magic"], 2);
    assert!(
        sentence.contains("there is no method \"magic\"; there are whitted, kajiya"),
        "{sentence}"
    );
    let sentence = refused(
        folder.path(),
        &["cost", "whitted", "--methods", "kajiya"],
        2,
    );
    assert!(sentence.contains("never meets a point"), "{sentence}");
    refused(folder.path(), &["cost", "nowhere"], 2);
    for arguments in [
        &["cost"][..],
        &["cost", "cornell", "--budget", "0"],
        &["cost", "cornell", "--budget", "NaN"],
        &["cost", "cornell", "--replicates", "0"],
        &["cost", "cornell", "--size", "0x4"],
        &["cost", "cornell", "--threads", "0"],
    ] {
        let output = halfdisk(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    }
    assert!(
        folder.path().read_dir().unwrap().next().is_none(),
        "nothing was written"
    );
}

#[cfg(unix)]
#[test]
fn ctrl_c_keeps_what_is_complete() {
    let folder = folder();
    let slow = [
        "cost",
        "cornell",
        "--budget",
        "400",
        "--size",
        "8x8",
        "--replicates",
        "1000",
        "--methods",
        "whitted,path",
    ];
    let output = super::interrupted(folder.path(), &slow);
    assert_eq!(output.status.code(), Some(130));
    // On a slow machine the first replicate may not be complete; then there is nothing to keep.
    let page = folder.path().join("out/cost/cornell/index.html");
    let kept = complaint(&output).contains("replicates were finished");
    assert_eq!(page.exists(), kept);
    if kept {
        assert!(
            std::fs::read_to_string(page)
                .unwrap()
                .contains("Stopped early")
        );
    }
}

#[test]
fn shares_of_the_replicates_make_one_page() {
    let folder = folder();
    let folder = folder.path();
    let settings = "--size 16x16 --replicates 3 --methods path,clamped --rays 20000";
    let settings: Vec<&str> = settings.split(' ').collect();
    for shard in ["1/2", "2/2"] {
        cost(
            folder,
            &[&["cornell", "--shard", shard], &settings[..]].concat(),
        );
    }
    let files = [
        "out/cost/cornell/cost-2-of-2.json",
        "out/cost/cornell/cost-1-of-2.json",
    ];
    let merged = cost(folder, &[&["cornell", "--merge"], &files[..]].concat());
    cost(
        folder,
        &[&["cornell", "--out", "whole"], &settings[..]].concat(),
    );
    assert!(
        merged.starts_with("cornell, 16 x 16, 3 replicates"),
        "{merged}"
    );
    // But for seconds they are the same.
    let numbers = |file: &str| -> Vec<String> {
        let csv = std::fs::read_to_string(folder.join(file)).unwrap();
        let columns = csv
            .lines()
            .map(|line| line.split(',').take(3).collect::<Vec<_>>());
        columns.map(|columns| columns.join(",")).collect()
    };
    assert_eq!(
        numbers("out/cost/cornell/cost.csv"),
        numbers("whole/cost.csv")
    );
    assert!(folder.join("out/cost/cornell/index.html").exists());
    for (arguments, said) in [
        (
            vec!["cornell", "--merge", files[0]],
            "missing: the shares 1/2",
        ),
        (
            vec!["furnace", "--merge", files[0], files[1]],
            "the shares are of another scene than furnace",
        ),
    ] {
        let sentence = refused(folder, &[&["cost"], &arguments[..]].concat(), 2);
        assert!(sentence.contains(said), "{sentence}");
    }
    let output = halfdisk(folder, &["cost", "cornell", "--shard", "1/2"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        complaint(&output).contains("--rays <RAYS>"),
        "{}",
        complaint(&output)
    );
}
