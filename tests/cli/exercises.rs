//! `halfdisk exercises`: what it makes, refuses, keeps and says. Cargo is asked in `tests/exercises/unfilled.rs`.

use super::{complaint, folder, halfdisk, refused};
use halfdisk::lab::exercises::LADDER;
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Runs `exercises` and checks that it succeeds; returns its stdout.
fn said(folder: &Path, arguments: &[&str]) -> String {
    let output = halfdisk(folder, &[&["exercises"], arguments].concat());
    assert!(
        output.status.success(),
        "{arguments:?}: {}",
        complaint(&output)
    );
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn start_makes_a_project_and_never_writes_over_anything() {
    let folder = folder();
    let here = folder.path();
    let task = said(here, &["start", "1"]);
    assert_eq!(task, LADDER[0].task());
    let file = here.join("exercises/src/bin/ex01_half_disk.rs");
    assert_eq!(fs::read_to_string(&file).unwrap(), LADDER[0].unfilled());
    for made in ["Cargo.toml", "Cargo.lock", ".gitignore", "progress.json"] {
        assert!(here.join("exercises").join(made).is_file(), "{made}");
    }
    fs::write(&file, "mine").unwrap();
    let sentence = refused(here, &["exercises", "start", "1"], 2);
    assert!(
        sentence.ends_with("is there already; remove it to start again"),
        "{sentence}"
    );
    assert_eq!(fs::read_to_string(&file).unwrap(), "mine");
    // A second exercise joins the first, from within the folder as well.
    said(
        &here.join("exercises/src"),
        &["start", "half-disk", "../../other"],
    );
    said(&here.join("exercises/src"), &["start", "malley"]);
    assert!(here.join("exercises/src/bin/ex05_malley.rs").is_file());
    assert!(here.join("other/src/bin/ex01_half_disk.rs").is_file());

    let theirs = here.join("theirs");
    fs::create_dir(&theirs).unwrap();
    fs::write(theirs.join("Cargo.toml"), "theirs").unwrap();
    let sentence = refused(here, &["exercises", "start", "2", "theirs"], 2);
    assert!(
        sentence.contains("another project is there already"),
        "{sentence}"
    );
    assert_eq!(
        fs::read_to_string(theirs.join("Cargo.toml")).unwrap(),
        "theirs"
    );
    assert!(!theirs.join("src").exists());
    let sentence = refused(
        here,
        &["exercises", "start", "2", "new", "--source", "theirs"],
        2,
    );
    assert!(
        sentence.contains("theirs is not the folder of halfdisk's source"),
        "{sentence}"
    );
    assert!(!here.join("new").exists());
}

#[test]
fn the_list_knows_how_far_one_is() {
    let folder = folder();
    let states = || -> Vec<String> {
        let rows: Value = serde_json::from_str(&said(folder.path(), &["--json"])).unwrap();
        let rows = rows.as_array().unwrap().iter();
        rows.map(|row| row["state"].as_str().unwrap().to_owned())
            .collect()
    };
    assert!(states().iter().all(|state| state == "open"));
    said(folder.path(), &["start", "1"]);
    said(folder.path(), &["start", "2"]);
    let progress = folder.path().join("exercises/progress.json");
    let text = fs::read_to_string(&progress).unwrap();
    fs::write(&progress, text.replace("\"right\": []", "\"right\": [2]")).unwrap();
    assert_eq!(states()[..3], ["started", "right", "open"]);
    let list = said(folder.path(), &["list"]);
    assert_eq!(list.lines().count(), LADDER.len());
    assert!(
        list.starts_with(" 1  started  half-disk    draw a direction"),
        "{list}"
    );

    // The solution is for those who have one.
    let sentence = refused(folder.path(), &["exercises", "solution", "1"], 1);
    assert!(
        sentence.contains("not solved yet") && sentence.contains("--anyway"),
        "{sentence}"
    );
    let solution = said(folder.path(), &["solution", "2"]);
    assert_eq!(solution, LADDER[1].solved());
    assert_eq!(
        said(folder.path(), &["solution", "1", "--anyway"]),
        LADDER[0].solved()
    );

    fs::write(&progress, text.replace("\"right\"", "\"left\"")).unwrap();
    let sentence = refused(
        folder.path(),
        &["exercises", "list", "--folder", "exercises"],
        2,
    );
    assert!(
        sentence.contains("progress.json: ") && sentence.contains("left"),
        "{sentence}"
    );
}

#[test]
fn each_hint_says_one_more() {
    let folder = folder();
    said(folder.path(), &["start", "cosine"]);
    for n in [1, 2, 3, 3] {
        let hints = said(folder.path(), &["hint", "4"]);
        assert_eq!(hints.lines().count(), n, "{hints}");
        assert!(hints.starts_with("1 of 3: ") && hints.contains(LADDER[3].hints[n - 1]));
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let folder = folder();
    for number in ["0", "99", "-1", "gathering"] {
        let output = halfdisk(folder.path(), &["exercises", "check", number]);
        assert_eq!(output.status.code(), Some(2), "{number}");
    }
    let output = halfdisk(folder.path(), &["exercises", "hint", "99"]);
    assert!(
        complaint(&output).contains("numbers from 1 to 15"),
        "{}",
        complaint(&output)
    );
    for arguments in [&["check", "1"][..], &["watch"]] {
        let sentence = refused(folder.path(), &[&["exercises"], arguments].concat(), 2);
        assert!(
            sentence.starts_with("no exercises here: `halfdisk exercises start 1`"),
            "{sentence}"
        );
    }
    let sentence = refused(
        folder.path(),
        &["exercises", "check", "1", "--folder", "none"],
        2,
    );
    assert!(sentence.starts_with("none/progress.json: "), "{sentence}");
    said(folder.path(), &["start", "1"]);
    let sentence = refused(folder.path(), &["exercises", "check", "2"], 2);
    assert!(
        sentence.contains("ex02_turn.rs: is not there; `halfdisk exercises start 2`"),
        "{sentence}"
    );
}
