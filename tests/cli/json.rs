//! The JSON of the commands, key by key, against the page of the book that describes it.

use super::{SCENE, complaint, folder, halfdisk};
use halfdisk::glam::Vec2;
use halfdisk::lab::exercises::{Report, Verdict, turn};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Paths of keys, and the types of what is there.
type Keys = BTreeMap<String, BTreeSet<String>>;

/// What the page says is one of several: an object of which not all keys need be there.
const ONE_OF: &str = "one of";

const TYPES: [&str; 7] = [
    "object", "array", "string", "number", "boolean", "null", ONE_OF,
];

/// The tables of the page by the headings above them.
fn tables(page: &str) -> BTreeMap<String, Keys> {
    let mut tables: BTreeMap<String, Keys> = BTreeMap::new();
    let mut heading = String::new();
    for line in page.lines() {
        if line.starts_with('#') {
            heading = line.trim_start_matches(['#', ' ']).to_owned();
        } else if let Some(row) = line.strip_prefix("| `") {
            let (key, rest) = row.split_once("` | ").expect(line);
            let (types, _) = rest.split_once(" | ").expect(line);
            let types = types.split(" or ").map(str::to_owned).collect();
            let table = tables.entry(heading.clone()).or_default();
            assert!(
                table.insert(key.to_owned(), types).is_none(),
                "{heading}: {key} twice"
            );
        }
    }
    tables
}

/// A table with its shapes written out.
fn whole(tables: &BTreeMap<String, Keys>, table: &str) -> Keys {
    let mut keys = Keys::new();
    for (key, types) in &tables[table] {
        let own = keys.entry(key.clone()).or_default();
        own.extend(
            types
                .iter()
                .filter(|t| TYPES.contains(&t.as_str()))
                .cloned(),
        );
        for shape in types.iter().filter(|t| !TYPES.contains(&t.as_str())) {
            let one_of = tables[shape]
                .keys()
                .all(|key| key.starts_with(char::is_uppercase));
            let own = keys.entry(key.clone()).or_default();
            own.insert(if one_of { ONE_OF } else { "object" }.to_owned());
            let below = whole(tables, shape);
            keys.extend(
                below
                    .into_iter()
                    .map(|(k, types)| (format!("{key}.{k}"), types)),
            );
        }
    }
    keys
}

/// Notes the keys of a value under `path`.
fn note(value: &Value, path: &str, keys: &mut Keys) {
    let of = match value {
        Value::Object(fields) => {
            for (key, value) in fields {
                let key = if path.ends_with(".found_by") {
                    "*"
                } else {
                    key
                };
                note(value, format!("{path}.{key}").trim_start_matches('.'), keys);
            }
            "object"
        }
        Value::Array(items) => {
            items
                .iter()
                .for_each(|item| note(item, &format!("{path}[]"), keys));
            "array"
        }
        Value::String(_) => "string",
        Value::Number(_) => "number",
        Value::Bool(_) => "boolean",
        Value::Null => "null",
    };
    if !path.is_empty() {
        keys.entry(path.to_owned())
            .or_default()
            .insert(of.to_owned());
    }
}

/// The path of what a key belongs to.
fn parent(key: &str) -> &str {
    let end = key.trim_end_matches("[]");
    if end.len() < key.len() {
        return end;
    }
    key.rsplit_once('.').map_or("", |(parent, _)| parent)
}

/// What the page and the keys that were seen do not agree on.
fn apart(page: &Keys, seen: &Keys) -> Vec<String> {
    let mut apart = Vec::new();
    for (key, types) in seen {
        let Some(said) = page.get(key) else {
            apart.push(format!("{key} is not on the page"));
            continue;
        };
        let allowed = |t: &String| said.contains(t) || t == "object" && said.contains(ONE_OF);
        for of in types.iter().filter(|t| !allowed(t)) {
            apart.push(format!("{key} is {of}, where the page has {said:?}"));
        }
    }
    // A key may be missing where what it belongs to had no keys at all, as what was null.
    for key in page.keys().filter(|key| !seen.contains_key(*key)) {
        let above = parent(key);
        let had_keys = seen.keys().any(|key| parent(key) == above);
        let optional = page.get(above).is_some_and(|types| types.contains(ONE_OF));
        if had_keys && !optional {
            apart.push(format!("{key} is on the page only"));
        }
    }
    apart
}

/// The keys of everything that some runs of the program print.
fn seen(folder: &Path, runs: &[&str]) -> Keys {
    let mut keys = Keys::new();
    for run in runs {
        let arguments: Vec<&str> = run.split(' ').chain(["--json"]).collect();
        let output = halfdisk(folder, &arguments);
        assert!(output.status.success(), "{run}: {}", complaint(&output));
        note(
            &serde_json::from_slice(&output.stdout).expect(run),
            "",
            &mut keys,
        );
    }
    keys
}

/// The keys of graded exercises: a right one, a wrong one that prints something, and one that does not compile.
fn graded() -> Keys {
    let mut keys = Keys::new();
    let exam = turn::exam();
    let right: turn::ToWorld = |n, w| Vec2::new(n.y, -n.x) * w.x + n * w.y;
    let reports = [
        exam.grade(&right, 1),
        exam.grade(&exam.mistakes[0].answer, 1),
        Report::unasked(exam.entry, Verdict::NotBuilt, "no".to_owned()),
    ];
    for (report, printed) in reports.iter().zip(["", "printed", ""]) {
        note(
            &serde_json::to_value(report.results(printed)).unwrap(),
            "",
            &mut keys,
        );
    }
    keys
}

#[test]
fn the_page_lists_every_key_of_every_command_with_its_types() {
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/book/src/json.md");
    let tables = tables(&std::fs::read_to_string(page).unwrap());
    let folder = folder();
    std::fs::write(folder.path().join("mine.toml"), SCENE).unwrap();
    for made in [
        "render cornell --size 8x8 --spp 1 --out 0.exr -q",
        "render cornell --size 8x8 --spp 1 --seed 1 --out 1.exr -q",
        "merge --seeds 0.exr 1.exr --out average.exr",
    ] {
        let words: Vec<&str> = made.split(' ').collect();
        assert!(halfdisk(folder.path(), &words).status.success());
    }
    let commands: [(&str, &[&str]); 11] = [
        ("scenes", &["scenes"]),
        ("exercises", &["exercises"]),
        ("doctor", &["doctor --space flat"]),
        (
            "doctor --reading",
            &["doctor --space flat --reading 0.6366"],
        ),
        ("converge --list", &["converge --list"]),
        (
            "converge",
            &[
                "converge half-disk --replicates 64 --doublings 5",
                "converge half-disk --replicates 1 --doublings 2",
            ],
        ),
        (
            "effects",
            &[
                "effects mine.toml --paths LD+E",
                "effects mine.toml --measure --spp 1 --rounds 3",
            ],
        ),
        ("classify", &["classify mine.toml --spp 4"]),
        (
            "render",
            &[
                "render mine.toml --spp 1 --quiet",
                "render caustic --size 8x8 --spp 1 --out caustic.exr --quiet",
                "render mine.toml --spp 16 --integrator kajiya --maps --quiet",
                "render cornell --size 8x8 --spp 1 --integrator radiosity --camera spheres --quiet",
                "render mine.toml --spp 2 --integrator photons --photons 99 --radius 0.1 --quiet",
                "render mine.toml --spp 1 --shard 1/2 --out s.exr --quiet",
                "render mine.toml --target-error 50% --paths LD+E --quiet",
                "render mine.toml --target-error 50% --target-quantile 50% --time 1h --quiet",
            ],
        ),
        (
            "info",
            &[
                "info s.exr",
                "info caustic.exr",
                "info average.exr",
                "info out/mine-photons.png",
            ],
        ),
        (
            "cost",
            &["cost mine.toml --budget 1 --replicates 3 --methods whitted,combine,path,clamped"],
        ),
    ];
    let mut wrong = Vec::new();
    for (command, runs) in commands {
        let apart = apart(&whole(&tables, command), &seen(folder.path(), runs));
        wrong.extend(apart.into_iter().map(|what| format!("{command}: {what}")));
    }
    let apart = apart(&whole(&tables, "exercises check"), &graded());
    wrong.extend(
        apart
            .into_iter()
            .map(|what| format!("exercises check: {what}")),
    );
    assert!(wrong.is_empty(), "{wrong:#?}");
    // Every table belongs to a command or is a shape of one.
    let shapes = [
        "exercises check",
        "measurement",
        "facts",
        "fit",
        "ratio",
        "exam",
        "difference",
        "result",
    ];
    let known = |name: &str| shapes.contains(&name) || commands.iter().any(|(c, _)| *c == name);
    assert!(tables.keys().all(|name| known(name)), "{:?}", tables.keys());
}

#[test]
fn a_key_that_is_new_gone_or_of_another_type_is_noticed() {
    let page = "## a\n| `x` | number or null | it |\n| `y` | pair or null | two |\n| `z[]` | string | all |\n\
                ### pair\n| `one` | number | it |\n| `two` | number | it |\n";
    let tables = tables(page);
    let check = |text: &str| {
        let mut keys = Keys::new();
        note(&serde_json::from_str(text).unwrap(), "", &mut keys);
        keys.remove("z");
        apart(&whole(&tables, "a"), &keys).len()
    };
    assert_eq!(
        check(r#"{"x": 1, "y": {"one": 1, "two": 2}, "z": ["s"]}"#),
        0
    );
    assert_eq!(check(r#"{"x": null, "y": null, "z": []}"#), 0);
    assert_eq!(
        check(r#"{"x": "1", "y": null, "z": []}"#),
        1,
        "another type"
    );
    assert_eq!(check(r#"{"y": null, "z": []}"#), 1, "gone");
    assert_eq!(
        check(r#"{"x": 1, "y": {"one": 1}, "z": []}"#),
        1,
        "gone from a shape"
    );
    assert_eq!(check(r#"{"x": 1, "y": null, "z": [], "w": 1}"#), 1, "new");
}
