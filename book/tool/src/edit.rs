//! A page is rewritten by a list of edits, so that whatever no edit touches stays byte for byte.

use std::fmt;
use std::ops::Range;
use std::path::PathBuf;

/// A span of a page's source, and what shall stand there: new text, or the reason it cannot.
#[derive(Debug, PartialEq)]
pub struct Edit {
    /// Where in the source, in bytes.
    pub span: Range<usize>,
    /// The replacement, or a sentence for the author of the page.
    pub text: Result<String, String>,
}

/// Something an author has to mend, with the place to mend it.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Problem {
    /// The page, as its author would name it from the repository's root.
    pub page: PathBuf,
    /// The line, counted from 1.
    pub line: usize,
    /// What is wrong, in one sentence.
    pub says: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.page.display(), self.line, self.says)
    }
}

/// Applies all edits, or lists every one that failed as a line number and a sentence.
///
/// Edits that succeed never overlap: a directive inside a formula is refused by the maths.
pub fn rewrite(source: &str, mut edits: Vec<Edit>) -> Result<String, Vec<(usize, String)>> {
    edits.sort_by_key(|edit| edit.span.start);
    let mut written = String::with_capacity(source.len());
    let mut failures = Vec::new();
    let mut copied = 0;
    for Edit { span, text } in edits {
        match text {
            Ok(text) if failures.is_empty() => {
                written.push_str(&source[copied..span.start]);
                written.push_str(&text);
                copied = span.end;
            }
            Ok(_) => {}
            Err(says) => {
                let line = 1 + source[..span.start].matches('\n').count();
                failures.push((line, says));
            }
        }
    }
    if failures.is_empty() {
        written.push_str(&source[copied..]);
        Ok(written)
    } else {
        Err(failures)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edit(span: Range<usize>, text: &str) -> Edit {
        Edit {
            span,
            text: Ok(text.to_string()),
        }
    }

    #[test]
    fn edits_apply_in_source_order_and_leave_the_rest_alone() {
        let edits = vec![edit(6..7, "three"), edit(0..1, "one")];
        assert_eq!(
            rewrite("1, 2, 3!\r\n", edits).unwrap(),
            "one, 2, three!\r\n"
        );
    }

    #[test]
    fn every_failure_is_listed_with_its_line() {
        let failure = |at: usize, says: &str| Edit {
            span: at..at + 1,
            text: Err(says.to_string()),
        };
        let edits = vec![failure(4, "last"), edit(2..3, "fine"), failure(0, "first")];
        assert_eq!(
            rewrite("a\nb\nc", edits).unwrap_err(),
            [(1, "first".to_string()), (3, "last".to_string())]
        );
    }
}
