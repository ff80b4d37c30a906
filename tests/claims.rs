//! The page of claims: each row has a verdict and a test that is there, and each test of a claim has a row.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// What a claim may be found to be.
const VERDICTS: [&str; 4] = ["holds", "holds if", "false", "left out"];

/// What is wrong with the page of claims, beside the sources by their path from the root.
fn problems(page: &str, sources: &BTreeMap<String, String>) -> Vec<String> {
    let mut problems = Vec::new();
    let mut counts = [0; VERDICTS.len()];
    for row in page.lines().filter(|line| line.starts_with("| S")) {
        let id = &row[2..7];
        let verdict = row.split("| **").nth(1).and_then(|v| v.split("**").next());
        match verdict.and_then(|v| VERDICTS.iter().position(|known| *known == v)) {
            Some(place) => counts[place] += 1,
            None => problems.push(format!("{id}: no verdict")),
        }
        let link = row.rsplit_once("[`").and_then(|(_, link)| {
            let (test, file) = link.split_once("`](../../")?;
            Some((test, file.strip_suffix(") |")?))
        });
        match link {
            None => problems.push(format!("{id}: no test at its end")),
            Some((test, file)) => {
                let there = sources.get(file).is_some_and(|text| has(text, test));
                if !there {
                    problems.push(format!("{id}: {test} is not in {file}"));
                }
            }
        }
    }
    // A test named after a claim speaks for one that the page lists.
    for text in sources.values() {
        for id in text.split("fn s").skip(1).filter_map(claim_of) {
            if !page.contains(&format!("| {id} |")) {
                problems.push(format!("{id} is not on the page"));
            }
        }
    }
    let [holds, under, wrong, out] = counts;
    let sum = format!(
        "Of {} claims {holds} hold as they stand, {under} hold under a condition, {wrong} are false, and {out} \
         are left out.",
        counts.iter().sum::<i32>()
    );
    let said: Vec<&str> = page.split_whitespace().collect();
    if !said.join(" ").contains(&sum) {
        problems.push(format!("the page does not say: {sum}"));
    }
    problems
}

/// True where the text has this test.
fn has(text: &str, test: &str) -> bool {
    text.contains(&format!("fn {test}("))
}

/// The claim that a test is named after: of `0_05_a_caustic(` it is `S0.05`.
fn claim_of(name: &str) -> Option<String> {
    let (document, number) = (name.get(0..1)?, name.get(2..4)?);
    let is_claim = ["0", "1"].contains(&document)
        && name.get(1..2) == Some("_")
        && number.bytes().all(|b| b.is_ascii_digit());
    is_claim.then(|| format!("S{document}.{number}"))
}

fn read(folder: &Path, root: &Path, into: &mut BTreeMap<String, String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            read(&path, root, into);
        } else if path.extension().is_some_and(|e| e == "rs") && !path.ends_with("tests/claims.rs")
        {
            let name = path.strip_prefix(root).unwrap().to_str().unwrap();
            into.insert(name.replace('\\', "/"), fs::read_to_string(&path).unwrap());
        }
    }
}

#[test]
fn every_claim_has_a_verdict_and_a_test_and_every_test_of_a_claim_a_row() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut sources = BTreeMap::new();
    for folder in ["tests", "src"] {
        read(&root.join(folder), root, &mut sources);
    }
    let page = fs::read_to_string(root.join("book/src/claims.md")).unwrap();
    assert!(page.matches("\n| S").count() > 50);
    let found = problems(&page, &sources);
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn a_row_without_a_verdict_or_with_a_test_from_elsewhere_is_noticed() {
    let sources = [
        ("tests/a.rs", "fn right() {}"),
        ("tests/b.rs", "fn s0_01_x() {}"),
    ];
    let sources = sources.map(|(file, text)| (file.to_owned(), text.to_owned()));
    let sources = BTreeMap::from(sources);
    let says = "Of 1 claims 1 hold as they stand, 0 hold under a condition, 0 are false, and 0 are\nleft out.";
    let row = "| S0.01 | so | **holds** | 1 [`right`](../../tests/a.rs) |";
    let of = |row: &str| problems(&format!("{says}\n{row}"), &sources);
    assert_eq!(of(row), [""; 0]);
    for (mistake, says) in [
        (row.replace("**holds**", "**perhaps**"), "S0.01: no verdict"),
        (
            row.replace("tests/a.rs", "tests/b.rs"),
            "S0.01: right is not in tests/b.rs",
        ),
        (
            row.replace("[`right`](../../tests/a.rs)", "`right`"),
            "S0.01: no test at its end",
        ),
        (row.replace("S0.01", "S0.02"), "S0.01 is not on the page"),
        (
            row.replace("**holds**", "**false**"),
            "the page does not say: Of 1 claims 0 hold",
        ),
    ] {
        let found = of(&mistake);
        assert!(
            found.iter().any(|f| f.starts_with(says)),
            "{mistake}: {found:?}"
        );
    }
}
