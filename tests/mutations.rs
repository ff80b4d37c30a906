//! Files changed at random: loading never panics, and errors are one line each with a place.

use crate::cli::SCENE;
use crate::cli::meshes::{Ply, TETRAHEDRON, scene};
use crate::cli::textured_meshes::textured;
use halfdisk::integrators::Whitted;
use halfdisk::render::{Options, render};
use halfdisk::scene::description::Shape;
use halfdisk::scene::gallery::{GALLERY, from_text};
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, SceneError};
use proptest::prelude::*;
use std::path::Path;

/// A change to a file; places and lengths are shares of what is there.
#[derive(Clone, Debug)]
enum Change {
    Flip(usize, u8),
    Delete(usize, usize),
    Insert(usize, String),
    Swap(usize, usize),
    Repeat(usize, usize),
}

/// Numbers at the edges of what may be said.
const EDGES: [&str; 12] = [
    "nan", "inf", "-inf", "-1", "0", "-0.0", "1e-46", "1e-40", "1e38", "1e39", "1e999", "-1e-300",
];

fn change() -> impl Strategy<Value = Change> {
    let word = prop_oneof![
        "[ -~\n]{1,4}",
        proptest::sample::select(&EDGES[..]).prop_map(|e| format!(" {e} ")),
        proptest::sample::select(
            &[
                "\"",
                "[",
                "]",
                "{",
                "}",
                "\n",
                "=",
                "\0",
                "é",
                "\u{2028}",
                "[[objects]]\n",
                "99999999999"
            ][..]
        )
        .prop_map(str::to_owned),
    ];
    prop_oneof![
        (any::<usize>(), any::<u8>()).prop_map(|(at, bit)| Change::Flip(at, bit)),
        (any::<usize>(), 1..12_usize).prop_map(|(at, n)| Change::Delete(at, n)),
        (any::<usize>(), word).prop_map(|(at, word)| Change::Insert(at, word)),
        (any::<usize>(), any::<usize>()).prop_map(|(a, b)| Change::Swap(a, b)),
        (any::<usize>(), 1..40_usize).prop_map(|(at, n)| Change::Repeat(at, n)),
    ]
}

fn apply(bytes: &mut Vec<u8>, change: &Change) {
    let length = bytes.len();
    if length == 0 {
        return;
    }
    match change {
        Change::Flip(at, bit) => bytes[at % length] ^= 1 << (bit % 8),
        Change::Delete(at, n) => {
            let at = at % length;
            bytes.drain(at..length.min(at + n));
        }
        Change::Insert(at, word) => {
            let at = at % (length + 1);
            bytes.splice(at..at, word.bytes());
        }
        Change::Swap(a, b) => swap_words(bytes, a % length, b % length),
        Change::Repeat(at, n) => {
            let at = at % length;
            let piece = bytes[at..length.min(at + n)].to_vec();
            bytes.splice(at..at, piece);
        }
    }
}

/// Exchanges the words at two places.
fn swap_words(bytes: &mut Vec<u8>, a: usize, b: usize) {
    let word = |at: usize| {
        let inside = |c: &u8| c.is_ascii_alphanumeric() || b"._-\"".contains(c);
        let before = bytes[..at].iter().rev().take_while(|c| inside(c)).count();
        let after = bytes[at..].iter().take_while(|c| inside(c)).count();
        at - before..at + after
    };
    let (a, b) = (word(a.min(b)), word(a.max(b)));
    if a.end <= b.start {
        let second = bytes[b.clone()].to_vec();
        let first = bytes[a.clone()].to_vec();
        bytes.splice(b, first);
        bytes.splice(a, second);
    }
}

/// Loads a scene, and checks its error: one line, with file and line number.
fn load(text: &str, folder: Option<&Path>) -> Option<Scene> {
    let source = Source {
        file: "file.toml",
        text,
    };
    // Meshes from formulas are kept small: it is the text that is tested.
    let result = from_text(source, folder, |said| {
        for object in &mut said.objects {
            if let Shape::BumpySphere { columns, rows, .. } = &mut object.shape {
                columns.0 = columns.0.min(8);
                rows.0 = rows.0.min(8);
            }
        }
    });
    match result {
        Ok(scene) => Some(scene),
        Err(error) => {
            check_error(&error, text);
            None
        }
    }
}

fn check_error(error: &SceneError, text: &str) {
    let sentence = error.to_string();
    let breaks = |c: char| c.is_control() || "\u{2028}\u{2029}".contains(c);
    assert!(!sentence.contains(breaks), "{sentence:?}");
    let SceneError::Value { line, .. } = error else {
        panic!("{sentence}");
    };
    assert!(
        (1..=1 + text.matches('\n').count()).contains(line),
        "{sentence}"
    );
    assert!(
        sentence.starts_with(&format!("file.toml:{line}: ")),
        "{sentence}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 3000,
        rng_seed: proptest::test_runner::RngSeed::Fixed(1),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn scenes(which in 0..GALLERY.len() + 1, changes in prop::collection::vec(change(), 1..4)) {
        let text = GALLERY.get(which).map_or(SCENE, |(_, text)| *text);
        let mut bytes = text.as_bytes().to_vec();
        changes.iter().for_each(|c| apply(&mut bytes, c));
        load(&String::from_utf8_lossy(&bytes), None);
    }

    #[test]
    fn meshes(kind in 0..7_usize, changes in prop::collection::vec(change(), 1..4)) {
        load_mesh(kind, &changes);
    }
}

/// Loads a scene with a tetrahedron or a textured square from a file of some kind, changed.
fn load_mesh(kind: usize, changes: &[Change]) -> Option<Scene> {
    let (name, mut bytes) = match kind {
        0 => ("m.ply", TETRAHEDRON.ply(Ply::Ascii)),
        1 => ("m.ply", TETRAHEDRON.ply(Ply::Little)),
        2 => ("m.ply", TETRAHEDRON.ply(Ply::Big)),
        3 => ("m.ply", textured(Ply::Ascii)),
        4 => ("m.ply", textured(Ply::Little)),
        5 => ("m.ply", textured(Ply::Big)),
        _ => ("m.obj", TETRAHEDRON.obj(|i| format!("{}/1/1", i + 1))),
    };
    changes.iter().for_each(|c| apply(&mut bytes, c));
    FOLDER.with(|folder| {
        std::fs::write(folder.path().join(name), &bytes).unwrap();
        load(&scene(name), Some(folder.path()))
    })
}

thread_local! {
    static FOLDER: tempfile::TempDir = crate::cli::folder();
}

#[test]
fn every_number_at_the_edges() {
    // Each number of the sample in turn, by each of the edges; whatever loads also renders.
    let is_number = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    let mut loaded = 0;
    for line in SCENE.lines().filter(|l| l.contains('=')) {
        let value = line.find('=').unwrap();
        let mut at = value;
        while let Some(start) = line[at..].find(is_number).map(|i| at + i) {
            let end = line[start..]
                .find(|c| !is_number(c))
                .map_or(line.len(), |i| start + i);
            for edge in EDGES {
                let changed = format!("{}{edge}{}", &line[..start], &line[end..]);
                let text = SCENE.replacen(line, &changed, 1);
                if let Some(scene) = load(&text, None) {
                    loaded += 1;
                    let options = Options {
                        spp: 1,
                        ..Options::default()
                    };
                    let rendered = render(&scene, &Whitted { max_depth: 4 }, &options, &());
                    // Light beyond what f32 can add up is counted, never NaN in a mean.
                    let huge = edge == "1e38";
                    assert!(rendered.non_finite == 0 || huge, "{changed}: {rendered:?}");
                }
            }
            at = end;
        }
    }
    assert!(loaded > 100, "{loaded}");
}

/// Changes files at random, as many as asked for, and checks each.
fn many<T: std::fmt::Debug>(
    cases: u32,
    strategy: impl Strategy<Value = T>,
    check: impl Fn(T),
) -> String {
    let start = std::time::Instant::now();
    let mut runner = proptest::test_runner::TestRunner::new(ProptestConfig {
        cases,
        rng_seed: proptest::test_runner::RngSeed::Fixed(2),
        failure_persistence: None,
        ..ProptestConfig::default()
    });
    let all = runner.run(&strategy, |case| {
        check(case);
        Ok(())
    });
    all.unwrap();
    // Linux says how much memory was in use at most, in kB.
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let most = status.lines().find_map(|l| l.strip_prefix("VmHWM:"));
    let most = most.unwrap_or("unknown").trim().to_owned();
    let kilobytes = most.trim_end_matches(" kB").parse::<u64>().unwrap_or(0);
    assert!(kilobytes < 1 << 20, "more than 1 GiB: {most}");
    format!("{cases} files in {:?}, at most {most}", start.elapsed())
}

#[test]
#[ignore = "takes minutes: ask for it by name"]
fn long_a_million_scene_files() {
    let changes = (0..GALLERY.len() + 1, prop::collection::vec(change(), 1..6));
    let loaded = std::cell::Cell::new(0);
    let said = many(1_000_000, changes, |(which, changes)| {
        let text = GALLERY.get(which).map_or(SCENE, |(_, text)| *text);
        let mut bytes = text.as_bytes().to_vec();
        changes.iter().for_each(|c| apply(&mut bytes, c));
        let scene = load(&String::from_utf8_lossy(&bytes), None);
        loaded.set(loaded.get() + usize::from(scene.is_some()));
    });
    println!(
        "{said}: {} are scenes, the others errors with a line",
        loaded.get()
    );
}

#[test]
#[ignore = "takes minutes: ask for it by name"]
fn long_a_hundred_thousand_mesh_files() {
    let loaded = std::cell::Cell::new(0);
    let changes = (0..7_usize, prop::collection::vec(change(), 1..6));
    let said = many(100_000, changes, |(kind, changes)| {
        loaded.set(loaded.get() + usize::from(load_mesh(kind, &changes).is_some()));
    });
    println!(
        "{said}: {} are meshes, the others errors with a line",
        loaded.get()
    );
}
