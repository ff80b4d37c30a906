//! Checks what mdBook will include.
//!
//! mdBook prints an empty block for an anchor it cannot find and carries on; a book about code
//! must not. The include itself is left in place: expanding it stays mdBook's work.

use std::fs;
use std::path::Path;

/// Checks one `file` or `file:anchor` as seen from the folder of the page that includes it.
pub fn check(arguments: &[&str], folder: &Path) -> Result<(), String> {
    let [target] = arguments else {
        return Err("name one file, `file` or `file:anchor`".to_string());
    };
    let (file, anchor) = match target.split_once(':') {
        Some((file, anchor)) => (file, Some(anchor)),
        None => (*target, None),
    };
    if let Some(anchor) = anchor
        && (!anchor.chars().all(is_name_char) || anchor.chars().all(|c| c.is_ascii_digit()))
    {
        return Err("line numbers drift as the code changes: use a named anchor".to_string());
    }
    let text = fs::read_to_string(folder.join(file))
        .map_err(|error| format!("cannot read `{file}`: {error}"))?;
    anchor.map_or(Ok(()), |anchor| {
        check_anchor(&text, anchor).map_err(|says| format!("{says} in `{file}`"))
    })
}

/// Checks that `anchor` opens once, closes once after that, and holds something.
fn check_anchor(text: &str, anchor: &str) -> Result<(), String> {
    let only = |marker: &str| {
        let mut lines = (text.lines().enumerate())
            .filter(|(_, line)| anchor_name(line, marker) == Some(anchor))
            .map(|(number, _)| number);
        match (lines.next(), lines.next()) {
            (Some(line), None) => Ok(line),
            (None, _) => Err(format!("no `{marker} {anchor}`")),
            (Some(_), Some(_)) => Err(format!("more than one `{marker} {anchor}`")),
        }
    };
    let (open, close) = (only("ANCHOR:")?, only("ANCHOR_END:")?);
    if close < open {
        return Err(format!("anchor `{anchor}` ends before it begins"));
    }
    let is_content = |line: &str| {
        !line.trim().is_empty()
            && anchor_name(line, "ANCHOR:").is_none()
            && anchor_name(line, "ANCHOR_END:").is_none()
    };
    if text.lines().take(close).skip(open + 1).any(is_content) {
        Ok(())
    } else {
        Err(format!("anchor `{anchor}` holds no lines"))
    }
}

/// The name after `marker` on this line, cut where mdBook cuts it.
pub fn anchor_name<'a>(line: &'a str, marker: &str) -> Option<&'a str> {
    let (_, after) = line.split_once(marker)?;
    let after = after.trim_start();
    let end = after.find(|c| !is_name_char(c)).unwrap_or(after.len());
    (end > 0).then_some(&after[..end])
}

fn is_name_char(c: char) -> bool {
    c.is_alphanumeric() || c == '_' || c == '-'
}

#[cfg(test)]
mod tests {
    use super::*;

    const CODE: &str = "\
// ANCHOR: whole
fn one() {}
// ANCHOR: part
fn two() {}
// ANCHOR_END: part
// ANCHOR_END: whole
// ANCHOR: empty

// ANCHOR_END: empty
// ANCHOR: open
// ANCHOR_END: backwards
// ANCHOR: backwards
// ANCHOR: twice
a
// ANCHOR_END: twice
// ANCHOR: twice
";

    #[test]
    fn nested_anchors_with_content_pass() {
        assert_eq!(check_anchor(CODE, "whole"), Ok(()));
        assert_eq!(check_anchor(CODE, "part"), Ok(()));
    }

    #[test]
    fn every_broken_anchor_is_refused() {
        for (anchor, says) in [
            ("empty", "holds no lines"),
            ("open", "no `ANCHOR_END: open`"),
            ("backwards", "ends before it begins"),
            ("twice", "more than one `ANCHOR: twice`"),
            ("par", "no `ANCHOR: par`"),
        ] {
            let refusal = check_anchor(CODE, anchor).unwrap_err();
            assert!(refusal.contains(says), "{anchor}: {refusal}");
        }
    }

    #[test]
    fn files_are_looked_up_beside_the_page() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
        assert_eq!(check(&["src/includes.rs"], folder), Ok(()));
        assert_eq!(check(&["src/includes.rs:part"], folder), Ok(()));
        let refusal = check(&["src/nowhere.rs:part"], folder).unwrap_err();
        assert!(refusal.starts_with("cannot read `src/nowhere.rs`"));
    }

    #[test]
    fn line_numbers_and_wrong_argument_counts_are_refused() {
        for target in ["a.rs:3:7", "a.rs:3", "a.rs:", "a.rs::7", "a.rs:part:7"] {
            let refusal = check(&[target], Path::new(".")).unwrap_err();
            assert!(refusal.contains("named anchor"), "{target}: {refusal}");
        }
        assert!(check(&[], Path::new(".")).is_err());
        assert!(check(&["a.rs", "b.rs"], Path::new(".")).is_err());
    }
}
