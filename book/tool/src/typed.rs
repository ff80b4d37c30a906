//! Numbers that were typed into a page: none has more than four digits, unless it is marked as exact or has an
//! error.
//!
//! Nobody knows whether the fifth digit of a measured number is right where no error says so, and a number from a
//! run comes by `{{#number …}}`, which knows. Code, formulas and links may say what they like.

use std::ops::Range;

use pulldown_cmark::{Event, Parser, Tag, TagEnd};

use crate::digits::UNSURE_DIGITS;
use crate::edit::Edit;
use crate::maths::DIALECT;

/// Where a number is marked: so many bytes before it, on its line or the one above.
const BEFORE: usize = 60;
/// What marks a number before it.
const MARKS: [&str; 3] = ["exact", "±", "= "];

/// A refusal for each number with more digits than anybody can vouch for.
pub fn edits(source: &str) -> Vec<Edit> {
    let mut edits = Vec::new();
    let mut silent = 0;
    for (event, span) in Parser::new_ext(source, DIALECT).into_offset_iter() {
        match event {
            Event::Start(Tag::CodeBlock(_) | Tag::Link { .. }) => silent += 1,
            Event::End(TagEnd::CodeBlock | TagEnd::Link) => silent -= 1,
            Event::Text(_) if silent == 0 => edits.extend(
                numbers(source, span)
                    .into_iter()
                    .filter(|number| is_too_long(&source[number.clone()]))
                    .filter(|number| !is_marked(source, number))
                    .map(|number| refusal(source, number)),
            ),
            _ => {}
        }
    }
    edits
}

fn refusal(source: &str, number: Range<usize>) -> Edit {
    let says = format!(
        "`{}` has more than {UNSURE_DIGITS} digits: say that it is exact, give its error, or write fewer",
        &source[number.clone()]
    );
    Edit {
        span: number,
        text: Err(says),
    }
}

/// The numbers with a decimal point in a part of the source; versions such as 0.5.4 are none.
fn numbers(source: &str, part: Range<usize>) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let mut at = part.start;
    let belongs = |c: char| c.is_alphanumeric() || c == '.' || c == '\u{202f}';
    while let Some(start) = source[at..part.end].find(|c: char| c.is_ascii_digit()) {
        let start = at + start;
        let end = source[start..part.end]
            .find(|c| !belongs(c))
            .map_or(part.end, |length| start + length);
        let before = source[..start].chars().next_back();
        let word = source[start..end].trim_end_matches('.');
        let is_number = word.matches('.').count() == 1 && !word.contains(char::is_alphabetic);
        if is_number && !before.is_some_and(|c| belongs(c) || c == '_') {
            found.push(start..start + word.len());
        }
        at = end;
    }
    found
}

/// More digits than a number may have that nothing vouches for. Of 1.0000001 the last digit is all that is said.
fn is_too_long(number: &str) -> bool {
    let digits: String = number.chars().filter(char::is_ascii_digit).collect();
    let significant = digits.trim_start_matches('0');
    let fraction = number.split_once('.').map_or("", |(_, fraction)| fraction);
    let is_step = fraction.len() > UNSURE_DIGITS && fraction.trim_start_matches('0').len() == 1;
    significant.len() > UNSURE_DIGITS && !is_step
}

/// True where the words before say that the number is exact, an error follows, or a directive holds it.
fn is_marked(source: &str, number: &Range<usize>) -> bool {
    let mut from = number.start.saturating_sub(BEFORE);
    while !source.is_char_boundary(from) {
        from -= 1;
    }
    let before = &source[from..number.start];
    let in_directive = before
        .rsplit_once("{{")
        .is_some_and(|(_, inside)| !inside.contains("}}"));
    let after = source[number.end..].trim_start();
    in_directive || after.starts_with('±') || MARKS.iter().any(|mark| before.contains(mark))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edit::rewrite;

    fn refused(source: &str) -> Vec<String> {
        let failures = rewrite(source, edits(source)).err().unwrap_or_default();
        failures.into_iter().map(|(_, says)| says).collect()
    }

    #[test]
    fn a_fifth_digit_that_nothing_vouches_for_is_refused() {
        for (source, number) in [
            ("It reads 0.31301 here.", "0.31301"),
            ("| a | b |\n|---|---|\n| 6.192 | 12.345 |\n", "12.345"),
            ("- about 26.214.\n", "26.214"),
            ("so 12\u{202f}345.6 rays", "12\u{202f}345.6"),
        ] {
            let says = refused(source);
            assert!(
                says[0].starts_with(&format!("`{number}` has more than 4 digits")),
                "{says:?}"
            );
        }
        assert_eq!(refused("0.12345 and\n\n0.54321").len(), 2);
    }

    #[test]
    fn what_is_exact_or_has_an_error_or_is_no_number_stays() {
        for fine in [
            "It reads 0.3130 here, of 69905 rays, and 100\u{202f}000.",
            "0.31301 ± 0.00002",
            "exactly 0.1998249; the exact 1.75, 1.96875 and 1.9999999",
            "1.5 / 1.33 = 1.1278",
            "a cosine of 1.0000001",
            "`0.31301`, $0.31301$, and [doi:10.1145/15922.15902](https://doi.org/10.1145/15922.15902)",
            "```text\n0.31301\n```\n",
            "version 0.5.43, `x`1.23456a",
            "{{#number ch01.x_0.12345}}",
        ] {
            assert_eq!(refused(fine), [""; 0], "{fine}");
        }
    }
}
