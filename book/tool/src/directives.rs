//! Finds the `{{#name arguments}}` directives of a page.
//!
//! The spelling is mdBook's own, so `\{{#…}}` stays text here as it does there. A directive counts
//! wherever it stands, code blocks included: that is where most includes are.

use crate::edit::Edit;

/// One directive as the author wrote it.
#[derive(Debug, PartialEq)]
pub struct Directive<'a> {
    /// All of it, braces included.
    pub source: &'a str,
    /// The word after the `#`.
    pub name: &'a str,
    /// The words after the name.
    pub arguments: Vec<&'a str>,
    /// Whether nothing else stands on its line: a block of HTML needs that.
    pub alone: bool,
}

/// Turns every directive of the page into an edit by asking `expand` what it stands for.
pub fn edits(
    source: &str,
    mut expand: impl FnMut(&Directive) -> Result<String, String>,
) -> Vec<Edit> {
    let mut edits = Vec::new();
    let mut from = 0;
    while let Some(start) = source[from..].find("{{").map(|at| from + at) {
        from = start + 2;
        if source[..start].ends_with('\\') || !source[from..].trim_start().starts_with('#') {
            continue;
        }
        let line_end = source[start..]
            .find('\n')
            .map_or(source.len(), |at| start + at);
        let Some(end) = source[start..line_end].find("}}").map(|at| start + at + 2) else {
            edits.push(Edit {
                span: start..line_end,
                text: Err("a directive is opened by `{{#` but not closed on its line".to_string()),
            });
            continue;
        };
        let line_start = source[..start].rfind('\n').map_or(0, |at| at + 1);
        let body = source[from..end - 2].trim_start().trim_start_matches('#');
        let mut words = body.split_whitespace();
        let directive = Directive {
            source: &source[start..end],
            name: words.next().unwrap_or_default(),
            arguments: words.collect(),
            alone: source[line_start..start].trim().is_empty()
                && source[end..line_end].trim().is_empty(),
        };
        edits.push(Edit {
            span: start..end,
            text: expand(&directive).map_err(|says| format!("{}: {says}", directive.source)),
        });
        from = end;
    }
    edits
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What `edits` hands to its callback, as `name(arguments)` with `!` when alone on a line.
    fn found(source: &str) -> Vec<String> {
        let mut found = Vec::new();
        edits(source, |directive| {
            let alone = if directive.alone { "!" } else { "" };
            let arguments = directive.arguments.join(",");
            found.push(format!("{}({arguments}){alone}", directive.name));
            Ok(String::new())
        });
        found
    }

    #[test]
    fn names_arguments_and_standing_alone_are_read() {
        let page = "A {{#number ch01.n}}.\n  {{#figure a.png width=50%}} \n{{ #ledger }}";
        assert_eq!(
            found(page),
            ["number(ch01.n)", "figure(a.png,width=50%)!", "ledger()!"]
        );
    }

    #[test]
    fn code_is_searched_but_escaped_directives_and_bare_braces_are_not() {
        assert_eq!(
            found("```rust\n{{#include a.rs}}\n```\n\\{{#number x}} {{name}}"),
            ["include(a.rs)!"]
        );
    }

    #[test]
    fn an_unclosed_directive_is_refused() {
        let edits = edits("see {{#number ch01.n} here\n}}", |_| Ok(String::new()));
        assert_eq!(edits.len(), 1);
        assert_eq!(edits[0].span.start, 4);
        assert!(edits[0].text.as_ref().unwrap_err().contains("not closed"));
    }

    #[test]
    fn a_failure_quotes_its_directive() {
        let edits = edits("{{#number x}}", |_| Err("no such thing".to_string()));
        assert_eq!(
            edits[0].text,
            Err("{{#number x}}: no such thing".to_string())
        );
    }
}
