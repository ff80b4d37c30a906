//! `{{#number chapter.name}}`, `{{#number chapter.name.field}}` for one field of it alone, and either with
//! `digits=3` where its first digits are enough.

use crate::data::Run;
use crate::digits;

/// The text that stands for the number.
pub fn expand(arguments: &[&str], run: &Run) -> Result<String, String> {
    let (parts, digits): (Vec<&str>, _) = match arguments {
        [path] => (path.split('.').collect(), None),
        [path, digits] => (path.split('.').collect(), Some(wanted(digits)?)),
        _ => (Vec::new(), None),
    };
    let plain = |value, plain: fn(f64) -> String| {
        digits.map_or_else(|| plain(value), |n| digits::significant(value, n))
    };
    let (chapter, name, field) = match parts[..] {
        [chapter, name] => (chapter, name, None),
        [chapter, name, field] => (chapter, name, Some(field)),
        _ => return Err("write `chapter.name` or `chapter.name.field`".to_string()),
    };
    let of = run.chapter(chapter)?;
    let Some(number) = of.numbers.get(name) else {
        return of.without(chapter, name);
    };
    let missing = |field: &str| format!("`{chapter}.{name}` has no `{field}`");
    match field {
        None => {
            let written = match digits {
                Some(digits) => digits::significant(number.value, digits),
                None => match number.error {
                    Some(error) => digits::with_error(number.value, error),
                    None => digits::unsure(number.value),
                },
            };
            Ok(match &number.unit {
                Some(unit) => digits::with_unit(&written, unit),
                None => written,
            })
        }
        Some("value") => Ok(plain(number.value, digits::unsure)),
        Some("exact") => {
            (number.exact.map(|exact| plain(exact, digits::plain))).ok_or_else(|| missing("exact"))
        }
        Some("error") => (number.error)
            .map(|error| digits::significant(error, digits::ERROR_DIGITS))
            .ok_or_else(|| missing("error")),
        Some(other) => Err(format!(
            "unknown field `{other}` (known: value, error, exact)"
        )),
    }
}

/// The number of digits in `digits=3`.
fn wanted(argument: &str) -> Result<usize, String> {
    argument
        .strip_prefix("digits=")
        .and_then(|digits| digits.parse().ok())
        .filter(|digits| (1..=digits::DIGITS).contains(digits))
        .ok_or_else(|| {
            format!(
                "`{argument}` is no `digits=1` to `digits={}`",
                digits::DIGITS
            )
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::tests::fixtures;

    fn number(path: &str) -> Result<String, String> {
        let written = expand(&[path], &fixtures())?;
        Ok(written.replace(['\u{202f}', '\u{a0}'], " "))
    }

    #[test]
    fn the_whole_number_has_error_and_unit() {
        assert_eq!(number("ch01.hits_3d").unwrap(), "12 345 ± 12 rays");
        assert_eq!(number("ch01.depth").unwrap(), "4");
    }

    #[test]
    fn a_field_stands_alone() {
        assert_eq!(number("ch01.hits_3d.value").unwrap(), "12 345");
        assert_eq!(number("ch01.hits_3d.exact").unwrap(), "12 350.1");
        assert_eq!(number("ch01.hits_3d.error").unwrap(), "12");
    }

    #[test]
    fn what_is_neither_exact_nor_given_an_error_has_four_digits() {
        assert_eq!(digits::unsure(0.313_014_6), "0.313");
        assert_eq!(digits::unsure(6.191_739), "6.192");
        assert_eq!(
            digits::unsure(4_828_245.0).replace('\u{202f}', " "),
            "4 828 245"
        );
        assert_eq!(digits::plain(0.923_076_92), "0.9230769");
    }

    #[test]
    fn as_many_digits_as_are_wanted() {
        let digits = |path, digits| expand(&[path, digits], &fixtures());
        let read = |text: &str| text.replace(['\u{202f}', '\u{a0}'], " ");
        assert_eq!(
            read(&digits("ch01.hits_3d.exact", "digits=3").unwrap()),
            "12 400"
        );
        assert_eq!(
            read(&digits("ch01.hits_3d", "digits=2").unwrap()),
            "12 000 rays"
        );
        for wrong in ["digits=0", "digits=8", "3"] {
            assert!(
                digits("ch01.depth", wrong)
                    .unwrap_err()
                    .contains("is no `digits=1`")
            );
        }
    }

    #[test]
    fn absent_and_unknown_fields_are_refused() {
        for (path, says) in [
            ("ch01.depth.exact", "`ch01.depth` has no `exact`"),
            ("ch01.depth.error", "`ch01.depth` has no `error`"),
            (
                "ch01.depth.mean",
                "unknown field `mean` (known: value, error, exact)",
            ),
            ("depth", "write `chapter.name` or `chapter.name.field`"),
        ] {
            assert_eq!(number(path).unwrap_err(), says);
        }
    }
}
