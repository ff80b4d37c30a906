//! No page uses a term of the glossary before the page that explains it, unless it links to that page.
//!
//! The glossary is the table of `glossary.md`: its first cell has the terms in bold, and the first link of its
//! last cell is the page that explains them. Code, links and formulas count for nothing.

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

/// A term and the file of the page that explains it.
#[derive(Debug, PartialEq)]
struct Term {
    words: String,
    page: String,
}

/// What is wrong with the order of these pages, given as file and text: a sentence for each page and term.
pub fn used_too_early(pages: &[(String, String)]) -> Vec<(String, String)> {
    let Some((_, glossary)) = pages.iter().find(|(file, _)| file == "glossary.md") else {
        return Vec::new();
    };
    let place = |name: &str| pages.iter().position(|(file, _)| file == name);
    let mut problems = Vec::new();
    for Term { words, page } in terms(glossary) {
        let Some(explained) = place(&page) else {
            continue;
        };
        for (file, text) in &pages[..explained] {
            if !text.contains(&page) && says(&prose(text), &words) {
                let problem = format!(
                    "`{words}` is explained in {page} only: link to it, or say it otherwise"
                );
                problems.push((file.clone(), problem));
            }
        }
    }
    problems
}

/// The terms of a glossary's table.
fn terms(glossary: &str) -> Vec<Term> {
    let rows = glossary.lines().filter(|line| line.starts_with("| **"));
    rows.flat_map(|row| {
        let cells: Vec<&str> = row.trim_matches('|').split(" | ").collect();
        let last = cells.last().copied().unwrap_or_default();
        let link = last
            .split_once("](")
            .map(|(_, link)| link.split([')', '#']).next().unwrap_or_default());
        let bold = cells[0].split("**").skip(1).step_by(2);
        let term = |words: &str| {
            Some(Term {
                words: words.to_lowercase(),
                page: link?.to_string(),
            })
        };
        bold.filter_map(term).collect::<Vec<_>>()
    })
    .collect()
}

/// Where a page ends and its list of sources begins, whose titles are no prose.
const SOURCES: [&str; 2] = ["\n## Further reading", "\n## References"];

/// The running text of a page, in lower case.
fn prose(text: &str) -> String {
    let end = SOURCES
        .iter()
        .filter_map(|heading| text.find(heading))
        .min();
    let text = &text[..end.unwrap_or(text.len())];
    let options = Options::ENABLE_TABLES | Options::ENABLE_MATH;
    let (mut prose, mut silent) = (String::new(), 0);
    for event in Parser::new_ext(text, options) {
        match event {
            Event::Start(Tag::CodeBlock(_) | Tag::Link { .. }) => silent += 1,
            Event::End(TagEnd::CodeBlock | TagEnd::Link) => silent -= 1,
            Event::Text(said) if silent == 0 => prose.push_str(&said.to_lowercase()),
            _ => prose.push(' '),
        }
    }
    prose
}

/// Whether the words stand in a text, as words of their own.
fn says(prose: &str, words: &str) -> bool {
    let is_letter = |c: Option<char>| c.is_some_and(char::is_alphanumeric);
    prose.match_indices(words).any(|(at, _)| {
        let before = prose[..at].chars().next_back();
        let after = prose[at + words.len()..].chars().next();
        !is_letter(before) && !is_letter(after)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const GLOSSARY: &str = "\
| the field | in a sentence | explained in |
|---|---|---|
| **radiance** | what a ray carries | [Light](b.md#radiance) |
| **BRDF**, **BSDF** | what a surface does | [Light](b.md#brdf), [later](c.md) |
";

    fn problems(first: &str) -> Vec<(String, String)> {
        let pages = [
            ("a.md", first),
            ("b.md", "Radiance, BSDF."),
            ("glossary.md", GLOSSARY),
        ];
        used_too_early(&pages.map(|(file, text)| (file.to_string(), text.to_string())))
    }

    #[test]
    fn a_term_before_its_page_is_refused() {
        let found = problems("The *Radiance* of a BRDF.");
        let said: Vec<_> = found
            .iter()
            .map(|(file, says)| (file.as_str(), says.split(' ').next().unwrap()))
            .collect();
        assert_eq!(said, [("a.md", "`radiance`"), ("a.md", "`brdf`")]);
    }

    #[test]
    fn a_link_to_that_page_is_enough_and_code_is_no_text() {
        for fine in [
            "Radiance, see [Light](b.md).",
            "`radiance`\n\n```text\nbrdf\n```\n",
            "Irradiance and radiances.",
            "$radiance$",
            "Light.\n\n## Further reading\n\n- Somebody, *Radiance*.",
        ] {
            assert_eq!(problems(fine), [], "{fine}");
        }
    }
}
