//! `{{#number chapter.name}}`, and `{{#number chapter.name.field}}` for one field of it alone.

use crate::data::Run;
use crate::digits;

/// The text that stands for the number.
pub fn expand(arguments: &[&str], run: &Run) -> Result<String, String> {
    let parts: Vec<&str> = match arguments {
        [path] => path.split('.').collect(),
        _ => Vec::new(),
    };
    let (chapter, name, field) = match parts[..] {
        [chapter, name] => (chapter, name, None),
        [chapter, name, field] => (chapter, name, Some(field)),
        _ => return Err("write `chapter.name` or `chapter.name.field`".to_string()),
    };
    let number = run.number(chapter, name)?;
    let missing = |field: &str| format!("`{chapter}.{name}` has no `{field}`");
    match field {
        None => {
            let written = digits::with_error(number.value, number.error.unwrap_or(0.0));
            Ok(match &number.unit {
                Some(unit) => digits::with_unit(&written, unit),
                None => written,
            })
        }
        Some("value") => Ok(digits::plain(number.value)),
        Some("exact") => (number.exact.map(digits::plain)).ok_or_else(|| missing("exact")),
        Some("error") => (number.error)
            .map(|error| digits::significant(error, digits::ERROR_DIGITS))
            .ok_or_else(|| missing("error")),
        Some(other) => Err(format!(
            "unknown field `{other}` (known: value, error, exact)"
        )),
    }
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
