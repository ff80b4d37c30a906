//! The page of references: each source can be found, stands there once, and is cited where it says.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// What is wrong with a page of references. `read` gives the text of a file by its path from the root, `pages`
/// the other pages.
fn problems(
    page: &str,
    pages: &BTreeMap<String, String>,
    read: impl Fn(&str) -> Option<String>,
) -> Vec<String> {
    let mut problems = Vec::new();
    let mut titles = Vec::new();
    for entry in page.split("\n- ").skip(1) {
        let entry = entry.split("\n\n").next().unwrap_or_default();
        let entry = words(entry);
        let title = between(&entry, "*", ".*").unwrap_or_default().to_owned();
        if title.is_empty() {
            problems.push(format!("no title: {entry}"));
            continue;
        }
        if titles.contains(&title) {
            problems.push(format!("{title}: stands there twice"));
        }
        let (source, cited) = entry.split_once(" Cited in ").unwrap_or((&entry, ""));
        let findable = ["](http", "ISBN", "(In print only.)"];
        if !findable.iter().any(|mark| source.contains(mark)) {
            problems.push(format!("{title}: no DOI, link or ISBN"));
        }
        let author = source.split([',', '.']).next().unwrap_or_default();
        let surname = author
            .rsplit(' ')
            .find(|word| *word != "al")
            .unwrap_or_default();
        for link in cited
            .split("](")
            .skip(1)
            .filter_map(|link| link.split(')').next())
        {
            let text = match link.strip_prefix("../../") {
                Some(file) => read(file).unwrap_or_default(),
                None => pages.get(link).cloned().unwrap_or_default(),
            };
            let text = words(
                &text
                    .replace("//!", " ")
                    .replace("///", " ")
                    .replace("//", " "),
            );
            if !text.contains(&title) && !text.contains(surname) && !text.contains("cornell.edu") {
                problems.push(format!("{title}: not cited in {link}"));
            }
        }
        if !cited.contains("](") {
            problems.push(format!("{title}: cited nowhere"));
        }
        titles.push(title);
    }
    // Sources at the end of a page, whose titles are in italics.
    for (file, text) in pages {
        let end = ["## Further reading", "## References"]
            .iter()
            .find_map(|head| text.split_once(head));
        let Some((_, list)) = end else { continue };
        let list = words(list);
        for title in list.split('*').skip(1).step_by(2) {
            let title = title.trim_end_matches('.');
            if !titles.iter().any(|known| known == title) {
                problems.push(format!(
                    "{file} cites {title}, which is not on the page of references"
                ));
            }
        }
    }
    problems
}

/// A text with single spaces.
fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// What stands between two marks, the first time.
fn between<'a>(text: &'a str, start: &str, end: &str) -> Option<&'a str> {
    text.split_once(start)?
        .1
        .split_once(end)
        .map(|(inner, _)| inner)
}

#[test]
fn each_source_can_be_found_and_is_cited_where_it_says() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut pages = BTreeMap::new();
    for entry in fs::read_dir(root.join("book/src")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if name.ends_with(".md") {
            pages.insert(name, fs::read_to_string(&path).unwrap());
        }
    }
    let page = pages.remove("references.md").unwrap();
    assert!(page.matches("\n- ").count() > 70);
    let found = problems(&page, &pages, |file| {
        fs::read_to_string(root.join(file)).ok()
    });
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn a_source_that_cannot_be_found_or_is_cited_nowhere_is_noticed() {
    let pages = [(
        "a.md",
        "As Kajiya says. ## Further reading\n- Kajiya, *The Rendering\n  Equation*.",
    )];
    let pages = pages.map(|(file, text)| (file.to_owned(), text.to_owned()));
    let pages = BTreeMap::from(pages);
    let code = |file: &str| (file == "src/a.rs").then(|| "//! Turk, Random\n//! Points".to_owned());
    let good = "# References\n\n- Kajiya. *The Rendering Equation.* 1986. [doi](https://doi.org/1). Cited in \
                [01](a.md).\n\n## Code\n\n- Turk. *Random Points.* ISBN 1. Cited in [`src/a.rs`](../../src/a.rs).\n";
    let of = |page: &str| problems(page, &pages, code);
    assert_eq!(of(good), [""; 0]);
    for (mistake, says) in [
        (
            good.replace("[doi](https://doi.org/1)", "doi:1"),
            "The Rendering Equation: no DOI",
        ),
        (
            good.replace(" Cited in [01](a.md).", ""),
            "The Rendering Equation: cited nowhere",
        ),
        (
            good.replace("src/a.rs)", "src/b.rs)"),
            "Random Points: not cited in ../../src/b.rs",
        ),
        (
            good.replace("Turk. *Random Points.*", "Turk. *The Rendering Equation.*"),
            "The Rendering Equation: stands",
        ),
        (
            good.replace("The Rendering", "A Rendering"),
            "a.md cites The Rendering Equation",
        ),
    ] {
        let found = of(&mistake);
        assert!(
            found.iter().any(|f| f.starts_with(says)),
            "{says}: {found:?}"
        );
    }
}
