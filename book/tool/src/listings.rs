//! `{{#listing file:anchor}}`, code under the name of its file, and `{{#changes old:anchor new:anchor}}`,
//! what one piece of code has that another has not.
//!
//! Both stand without the indentation they have in their files.

use std::fs;
use std::path::Path;

use similar::{ChangeTag, TextDiff};

use crate::includes::{self, anchor_name};
use crate::markup::escape;

/// Unchanged lines that are shown around changed ones.
const AROUND: usize = 3;

/// The code of one anchor, or of a whole file, with the file's name above it.
pub fn expand(arguments: &[&str], folder: &Path) -> Result<String, String> {
    includes::check(arguments, folder)?;
    let code = read(arguments[0], folder)?;
    let language = match Path::new(file_of(arguments[0])).extension() {
        Some(ending) if ending == "toml" => "toml",
        _ => "rust,ignore",
    };
    Ok(fenced(&shown(arguments[0]), language, &code))
}

/// The second piece of code, with marks at what it has instead of the first.
pub fn changes(arguments: &[&str], folder: &Path) -> Result<String, String> {
    let [old, new] = arguments else {
        return Err("name two pieces of code, `old:anchor new:anchor`".to_string());
    };
    includes::check(&[old], folder)?;
    includes::check(&[new], folder)?;
    let (before, after) = (read(old, folder)?, read(new, folder)?);
    let diff = TextDiff::from_lines(&before, &after);
    let mut marked = String::new();
    for (i, group) in diff.grouped_ops(AROUND).iter().enumerate() {
        if i > 0 {
            marked.push_str("  …\n");
        }
        for change in group.iter().flat_map(|op| diff.iter_changes(op)) {
            let mark = match change.tag() {
                ChangeTag::Delete => "- ",
                ChangeTag::Insert => "+ ",
                ChangeTag::Equal => "  ",
            };
            let line = format!("{mark}{}", change.value().trim_end());
            marked.push_str(line.trim_end());
            marked.push('\n');
        }
    }
    if marked.is_empty() {
        return Err("the two are the same".to_string());
    }
    let name = format!("{}, changed from {}", shown(new), shown(old));
    Ok(fenced(&name, "diff", &marked))
}

fn fenced(name: &str, language: &str, code: &str) -> String {
    format!(
        "<p class=\"listing\">{}</p>\n\n```{language}\n{code}```\n",
        escape(name)
    )
}

fn file_of(target: &str) -> &str {
    target.split_once(':').map_or(target, |(file, _)| file)
}

/// A file's name as seen from the repository's root.
fn shown(target: &str) -> String {
    file_of(target).trim_start_matches("../").to_string()
}

/// The lines of a target that has been checked, without anchors, moved to the left.
fn read(target: &str, folder: &Path) -> Result<String, String> {
    let file = file_of(target);
    let text = fs::read_to_string(folder.join(file))
        .map_err(|error| format!("cannot read `{file}`: {error}"))?;
    let anchor = target.split_once(':').map(|(_, anchor)| anchor);
    Ok(lines_of(&text, anchor))
}

fn lines_of(text: &str, anchor: Option<&str>) -> String {
    let mut inside = anchor.is_none();
    let mut lines = Vec::new();
    for line in text.lines() {
        let [opened, closed] = ["ANCHOR:", "ANCHOR_END:"].map(|mark| anchor_name(line, mark));
        if opened.is_none() && closed.is_none() && inside {
            lines.push(line);
        }
        if anchor.is_some() && (opened == anchor || closed == anchor) {
            inside = opened == anchor;
        }
    }
    let indent = |line: &&str| line.len() - line.trim_start().len();
    let least = lines
        .iter()
        .filter(|line| !line.trim().is_empty())
        .map(indent)
        .min();
    let moved = lines
        .iter()
        .map(|line| line.get(least.unwrap_or(0)..).unwrap_or("").to_string() + "\n");
    moved.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const CODE: &str = "\
mod a;
    // ANCHOR: old
    fn walk() {
        look();

        step();
        // ANCHOR: inner
        rest();
        // ANCHOR_END: inner
    }
    // ANCHOR_END: old
    // ANCHOR: new
    fn walk() {
        look();

        aim();
        rest();
    }
    // ANCHOR_END: new
";

    /// A folder with the code as `c/a.rs`, seen from `c/d`.
    fn written(test: &str) -> std::path::PathBuf {
        let folder = std::env::temp_dir().join(format!("listings-{test}-{}", std::process::id()));
        fs::create_dir_all(folder.join("c/d")).unwrap();
        fs::write(folder.join("c/a.rs"), CODE).unwrap();
        folder
    }

    #[test]
    fn an_excerpt_has_no_anchors_and_no_indentation() {
        let old = lines_of(CODE, Some("old"));
        assert_eq!(
            old,
            "fn walk() {\n    look();\n\n    step();\n    rest();\n}\n"
        );
        assert_eq!(lines_of(CODE, Some("inner")), "rest();\n");
        assert!(lines_of(CODE, None).starts_with("mod a;\n    fn walk"));
    }

    #[test]
    fn a_listing_says_where_it_is_from() {
        let folder = written("listing");
        let page = expand(&["../a.rs:inner"], &folder.join("c/d")).unwrap();
        assert_eq!(
            page,
            "<p class=\"listing\">a.rs</p>\n\n```rust,ignore\nrest();\n```\n"
        );
        assert!(expand(&["../a.rs:none"], &folder.join("c/d")).is_err());
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn changes_mark_what_is_new_and_what_is_gone() {
        let folder = written("changes");
        let at = folder.join("c/d");
        let page = changes(&["../a.rs:old", "../a.rs:new"], &at).unwrap();
        assert!(
            page.contains("a.rs, changed from a.rs</p>\n\n```diff\n"),
            "{page}"
        );
        assert!(
            page.contains("\n-     step();\n+     aim();\n      rest();\n"),
            "{page}"
        );
        assert!(page.contains("  fn walk"), "three lines away: {page}");
        let same = changes(&["../a.rs:old", "../a.rs:old"], &at).unwrap_err();
        assert_eq!(same, "the two are the same");
        assert!(changes(&["../a.rs:old"], &at).is_err());
        fs::remove_dir_all(folder).unwrap();
    }
}
