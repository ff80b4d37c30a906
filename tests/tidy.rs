//! The house stays in order: floors, file sizes, and a book whose code is really there.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// The floors, from the ground up; modules of one floor may use each other. Drawings know no renderer.
const FLOORS: &[&[&str]] = &[
    &["numeric", "color", "notation", "time"],
    &["sampling", "stats"],
    &["lab::drawing"],
    &["geometry", "space"],
    &["materials", "lights", "camera"],
    &["scene", "flatland"],
    &["radiosity", "photons"],
    &["integrators"],
    &["render", "output"],
    &["lab::naive", "lab::effects"],
    &["lab::mistakes", "lab::doctor", "lab::estimators"],
    &["lab::experiment", "lab::exercises"],
    &["lab::figures", "lab::ledger", "lab::chapter"],
    &["cli"],
];

const LONGEST_FILE: usize = 400;
const LONGEST_CHAPTER: usize = 150;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path, ending));
        } else if path.extension().is_some_and(|e| e == ending) {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// The modules of the crate that a source text uses outside its tests.
fn uses(text: &str) -> Vec<String> {
    let shipped = text.split("#[cfg(test)]").next().unwrap_or("");
    let code = shipped
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"))
        .collect::<Vec<_>>()
        .join("\n");
    let names = code.split("crate::").skip(1).flat_map(|rest| {
        let name = |s: &str| {
            s.chars()
                .take_while(|c| c.is_alphanumeric() || *c == '_')
                .collect::<String>()
        };
        match rest.strip_prefix('{') {
            Some(list) => {
                let list = list.split("};").next().unwrap_or("");
                // Inner braces hold items of a module already named before them.
                let mut depth = 0;
                let outer: String = list
                    .chars()
                    .filter(|c| {
                        depth += i32::from(*c == '{');
                        let keep = depth == 0;
                        depth -= i32::from(*c == '}');
                        keep
                    })
                    .collect();
                outer.split(',').map(|s| name(s.trim())).collect()
            }
            // Rooms of the laboratory have floors of their own.
            None => match rest.strip_prefix("lab::") {
                Some(room) => vec![format!("lab::{}", name(room))],
                None => vec![name(rest)],
            },
        }
    });
    names.filter(|n| !n.is_empty()).collect()
}

fn floor_of(module: &str) -> Option<usize> {
    FLOORS.iter().position(|floor| floor.contains(&module))
}

/// Each use of a higher floor, as `file uses module`.
fn climbs(sources: &BTreeMap<String, String>) -> Vec<String> {
    let mut found = Vec::new();
    // Tests in a file of their own may use all floors, as those within a file may.
    let code = sources
        .iter()
        .filter(|(file, _)| !file.ends_with("/tests.rs"));
    for (file, text) in code {
        let mut steps = file.split(['/', '.']);
        let module = match (steps.next().unwrap(), steps.next()) {
            ("lib" | "main", _) | ("lab", Some("mod")) => continue,
            ("lab", Some(room)) => format!("lab::{room}"),
            (module, _) => module.to_owned(),
        };
        let own = floor_of(&module).unwrap_or_else(|| panic!("{file}: on no floor"));
        let is_renderer = !module.starts_with("lab::") && module != "cli";
        for used in uses(text) {
            let Some(floor) = floor_of(&used) else {
                panic!("{file} uses crate::{used}, which is on no floor");
            };
            if floor > own || is_renderer && used.starts_with("lab::") {
                found.push(format!("{file} uses {used}"));
            }
        }
    }
    found
}

fn sources() -> BTreeMap<String, String> {
    let src = root().join("src");
    files(&src, "rs")
        .into_iter()
        .map(|path| {
            let name = path.strip_prefix(&src).unwrap().to_str().unwrap();
            (name.replace('\\', "/"), fs::read_to_string(&path).unwrap())
        })
        .collect()
}

#[test]
fn a_file_uses_only_floors_below_its_own() {
    let found = climbs(&sources());
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn a_climb_is_noticed() {
    let mut sources = sources();
    for text in [
        "use crate::cli::Command;",
        "use crate::{color, render::{Film, Pixel}, stats};",
        "fn f() { crate::lab::chapter::on_ctrl_c(); }",
        "use crate::lab::drawing::Stroke;",
    ] {
        sources.insert("numeric/mistake.rs".to_owned(), text.to_owned());
        assert_eq!(
            climbs(&sources).len(),
            1 + usize::from(text.contains("stats")),
            "{text}"
        );
    }
    sources.insert(
        "lab/drawing/mistake.rs".to_owned(),
        "use crate::scene::Scene;".to_owned(),
    );
    sources.remove("numeric/mistake.rs");
    assert_eq!(climbs(&sources).len(), 1, "a drawing knows no renderer");
    sources.remove("lab/drawing/mistake.rs");
    sources.insert(
        "numeric/mistake.rs".to_owned(),
        "#[cfg(test)] mod tests { use crate::cli; }".to_owned(),
    );
    assert_eq!(climbs(&sources).len(), 0, "tests may look anywhere");
}

#[test]
fn files_and_chapters_stay_short() {
    for (folder, longest) in [
        ("src", LONGEST_FILE),
        ("tests", LONGEST_FILE),
        ("examples", LONGEST_FILE),
        ("book/figures/src", LONGEST_FILE),
        ("book/tool/src", LONGEST_FILE),
    ] {
        for path in files(&root().join(folder), "rs") {
            let lines = fs::read_to_string(&path).unwrap().lines().count();
            assert!(lines <= longest, "{}: {lines} lines", path.display());
        }
    }
    for path in files(&root().join("chapters"), "rs") {
        if path.file_name().is_some_and(|name| name == "main.rs") {
            let lines = fs::read_to_string(&path).unwrap().lines().count();
            assert!(
                lines <= LONGEST_CHAPTER,
                "{}: {lines} lines",
                path.display()
            );
        }
    }
}

/// What is wrong with the includes of a page: files or anchors that are not there exactly once.
fn broken_includes(page: &str, read: impl Fn(&str) -> Option<String>) -> Vec<String> {
    let mut problems = Vec::new();
    let marks = ["{{#include ", "{{#listing ", "{{#changes "];
    let named = marks.map(|mark| {
        let all = page.split(mark).skip(1);
        all.filter_map(|directive| directive.split("}}").next())
            .flat_map(str::split_whitespace)
            .collect::<Vec<_>>()
    });
    for target in named.concat() {
        let (file, anchor) = target.split_once(':').unwrap_or((target, ""));
        let Some(code) = read(file) else {
            problems.push(format!("{target}: no such file"));
            continue;
        };
        for mark in ["ANCHOR", "ANCHOR_END"] {
            let wanted = format!("{mark}: {anchor}");
            let count = code
                .lines()
                .filter(|l| l.trim_end().ends_with(&wanted))
                .count();
            if !anchor.is_empty() && count != 1 {
                problems.push(format!("{target}: `{wanted}` occurs {count} times"));
            }
        }
    }
    problems
}

#[test]
fn the_book_includes_code_that_exists() {
    let mut includes = 0;
    for page in files(&root().join("book/src"), "md") {
        let text = fs::read_to_string(&page).unwrap();
        includes += text.matches("{{#listing ").count();
        let folder = page.parent().unwrap();
        let problems = broken_includes(&text, |file| fs::read_to_string(folder.join(file)).ok());
        assert!(problems.is_empty(), "{}: {problems:#?}", page.display());
    }
    assert!(includes > 0, "the book shows code");
}

#[test]
fn a_broken_include_is_noticed() {
    let file = |name: &str| {
        (name == "a.rs").then(|| "// ANCHOR: x\nlet y;\n// ANCHOR_END: x\n".to_owned())
    };
    assert!(broken_includes("{{#include a.rs:x}} {{#include a.rs}}", file).is_empty());
    assert_eq!(broken_includes("{{#include a.rs:z}}", file).len(), 2);
    assert_eq!(broken_includes("{{#include b.rs:x}}", file).len(), 1);
    assert_eq!(broken_includes("{{#listing b.rs:x}}", file).len(), 1);
    assert_eq!(broken_includes("{{#changes a.rs:x b.rs:x}}", file).len(), 1);
}

#[test]
fn every_page_is_in_the_summary() {
    let summary = fs::read_to_string(root().join("book/src/SUMMARY.md")).unwrap();
    for page in files(&root().join("book/src"), "md") {
        let name = page.file_name().unwrap().to_str().unwrap();
        if name != "SUMMARY.md" {
            assert!(
                summary.contains(&format!("({name})")),
                "{name} is not in the summary"
            );
        }
    }
}

#[test]
fn every_chapter_has_a_program_a_page_and_a_place_in_the_tour() {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).unwrap();
    let tour = fs::read_to_string(root().join("src/cli/tour.rs")).unwrap();
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let tests = fs::read_to_string(root().join("tests/chapters.rs")).unwrap();
    let parts = files(&root().join("tests/chapters"), "rs");
    let tests = parts
        .iter()
        .fold(tests, |all, path| all + &fs::read_to_string(path).unwrap());
    for entry in fs::read_dir(root().join("chapters")).unwrap() {
        let folder = entry.unwrap().file_name().into_string().unwrap();
        let program = folder.replace('_', "-");
        assert!(
            manifest.contains(&format!("name = \"{program}\"")),
            "{program}: no program"
        );
        assert!(
            tour.contains(&format!("\"{program}\"")),
            "{program}: not in the tour"
        );
        let page = root().join(format!("book/src/{program}.md"));
        assert!(page.exists(), "{} is missing", page.display());
        let row = format!("(book/src/{program}.md)");
        assert!(readme.contains(&row), "{program}: not in the README");
        let run = format!("CARGO_BIN_EXE_{program}");
        assert!(tests.contains(&run), "{program}: no test runs it");
    }
}

/// The exercises of a page that nobody solves: neither a program that they name, nor an entry under the page's
/// title.
fn unsolved(page: &str, solutions: &str) -> Vec<String> {
    let unnumbered = |title: &str| {
        let title = title.trim_start_matches(|c: char| c == '#' || c == ' ' || c.is_ascii_digit());
        title.to_owned()
    };
    let title = unnumbered(page.lines().next().unwrap_or_default());
    let part = |text: &str, head: &str| {
        let mut parts = text.split("\n## ").skip(1);
        let found = parts.find(|part| unnumbered(part.lines().next().unwrap_or_default()) == head);
        found.unwrap_or_default().to_owned()
    };
    let solved = part(solutions, &title);
    let exercises = format!("\n{}", part(page, "Exercises"));
    (1..=9)
        .filter_map(|n| {
            let (_, rest) = exercises.split_once(&format!("\n{n}. "))?;
            let exercise = rest.split(&format!("\n{}. ", n + 1)).next()?;
            let is_solved =
                exercise.contains("--example ") || solved.contains(&format!("**{n}.**"));
            (!is_solved).then(|| format!("{title}, exercise {n}"))
        })
        .collect()
}

#[test]
fn every_exercise_is_solved() {
    let solutions = fs::read_to_string(root().join("book/src/solutions.md")).unwrap();
    let mut exercises = 0;
    for page in files(&root().join("book/src"), "md") {
        let text = fs::read_to_string(&page).unwrap();
        exercises += usize::from(text.contains("\n## Exercises\n"));
        let missing = unsolved(&text, &solutions);
        assert!(missing.is_empty(), "{missing:?}");
    }
    assert!(exercises > 18);
}

#[test]
fn an_exercise_without_a_solution_is_noticed() {
    let page = "# 01 Eye\n\n## Exercises\n\n1. By hand.\n2. Run `cargo run --example x`.\n3. Write.\n\n## Further reading\n";
    let solutions = "# Solutions\n\n## 01 Eye\n\n**1.** So.\n\n**3.** And so.\n\n## 02 Tree\n";
    assert_eq!(unsolved(page, solutions), [""; 0]);
    let mistake = solutions.replace("**3.**", "3.");
    assert_eq!(unsolved(page, &mistake), ["Eye, exercise 3"]);
    let mistake = solutions.replace("01 Eye", "01 Lens");
    assert_eq!(unsolved(page, &mistake).len(), 2);
}
