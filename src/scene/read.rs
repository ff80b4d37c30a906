//! From a file to a description, with errors that name the line and the field.

use super::field::{Field, Problem, Step};
use super::tables::{TABLE_OF, Tables};
use serde::de::DeserializeOwned;
use std::borrow::Cow;
use std::ops::Range;
use std::path::Path;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Why a scene cannot be rendered, as one sentence for people.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SceneError {
    /// The file cannot be read at all.
    #[error("{file}: {reason}")]
    File {
        /// The file as the user named it.
        file: String,
        /// Why.
        reason: String,
    },
    /// There is no scene of this name.
    #[error("{0}")]
    Unknown(String),
    /// A value in the file is not allowed.
    #[error("{file}:{line}: {}{what}", quoted(field))]
    Value {
        /// The file as the user named it.
        file: String,
        /// The line of the value, counted from 1.
        line: usize,
        /// The value's address, such as `objects[2].sphere.radius`; empty for the whole file.
        field: String,
        /// What is wrong and what is allowed.
        what: String,
    },
}

impl SceneError {
    /// The error of a file that is not text after these bytes.
    fn not_text(file: &str, proper: &[u8], what: &str) -> SceneError {
        SceneError::Value {
            file: file.to_owned(),
            line: line_after(proper),
            field: String::new(),
            what: format!("is not text: {what}"),
        }
    }
}

/// The number of the line on which the byte after these stands, counted from 1.
fn line_after(before: &[u8]) -> usize {
    1 + before.iter().filter(|b| **b == b'\n').count()
}

fn quoted(field: &str) -> String {
    if field.is_empty() {
        String::new()
    } else {
        format!("`{field}` ")
    }
}

/// The text of a gallery name, borrowed from the gallery, or of a path to a file.
pub fn text_of(
    scene: &str,
    gallery: &[(&str, &'static str)],
) -> Result<Cow<'static, str>, SceneError> {
    if let Some((_, text)) = gallery.iter().find(|(name, _)| *name == scene) {
        return Ok(Cow::Borrowed(text));
    }
    let path = Path::new(scene);
    if path.extension().is_none() && !path.exists() {
        return Err(unknown(scene, gallery));
    }
    let refuse = |reason: String| SceneError::File {
        file: scene.to_owned(),
        reason,
    };
    let is_toml = |ending: &std::ffi::OsStr| ending.eq_ignore_ascii_case("toml");
    if !path.extension().is_some_and(is_toml) {
        let reason = "is not a scene file: their names end in .toml";
        return Err(refuse(reason.to_owned()));
    }
    let bytes = std::fs::read(path).map_err(|e| refuse(format!("cannot be read: {e}")))?;
    decode(scene, bytes).map(Cow::Owned)
}

/// The text of a file in UTF-8, or in UTF-16 that a byte order mark announces: so Windows PowerShell
/// redirects what a program prints.
fn decode(file: &str, bytes: Vec<u8>) -> Result<String, SceneError> {
    let unit: fn([u8; 2]) -> u16 = match bytes.as_slice() {
        [0xff, 0xfe, ..] => u16::from_le_bytes,
        [0xfe, 0xff, ..] => u16::from_be_bytes,
        [0, _, ..] | [_, 0, ..] => {
            let what = "it looks like UTF-16 without a byte order mark; save it as UTF-8";
            return Err(SceneError::not_text(file, &[], what));
        }
        _ => {
            return String::from_utf8(bytes).map_err(|e| {
                let proper = &e.as_bytes()[..e.utf8_error().valid_up_to()];
                SceneError::not_text(file, proper, "a scene file must be UTF-8")
            });
        }
    };
    let (pairs, odd) = bytes.as_chunks::<2>();
    let units: Vec<u16> = pairs[1..].iter().map(|pair| unit(*pair)).collect();
    match String::from_utf16(&units) {
        Ok(text) if odd.is_empty() => Ok(text),
        _ => {
            let what = "it begins like UTF-16, but is not; save it as UTF-8";
            Err(SceneError::not_text(file, &[], what))
        }
    }
}

/// The error of a name that is neither in the gallery nor a file.
pub fn unknown(name: &str, gallery: &[(&str, &str)]) -> SceneError {
    let names: Vec<&str> = gallery.iter().map(|(name, _)| *name).collect();
    let all = names.join(", ");
    if name.trim().is_empty() {
        let text = format!("no scene is named: give one of the gallery ({all}) or a .toml file");
        return SceneError::Unknown(text);
    }
    let meant = match nearest(name, &names) {
        Some(near) => format!("; did you mean `{near}`?"),
        None => String::new(),
    };
    SceneError::Unknown(format!(
        "`{name}` is neither a scene of the gallery ({all}) nor a file{meant}"
    ))
}

/// Names less alike than this (Jaro and Winkler) are other names.
const ALIKE: f64 = 0.8;

/// The name that was meant, if one is near enough.
fn nearest<'a>(name: &str, names: &[&'a str]) -> Option<&'a str> {
    let stem = name.trim_end_matches(".toml").to_lowercase();
    let near = |other: &&'a str| (strsim::jaro_winkler(&stem, other), *other);
    let best = names.iter().map(near).max_by(|a, b| a.0.total_cmp(&b.0))?;
    (best.0 > ALIKE).then_some(best.1)
}

/// A scene file's text with its name, for error messages.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The file as the user named it.
    pub file: &'a str,
    /// What it says.
    pub text: &'a str,
}

impl Source<'_> {
    /// Reads the text into a description of any kind.
    pub fn parse<T: DeserializeOwned>(&self) -> Result<T, SceneError> {
        toml::Deserializer::parse(self.text)
            .and_then(|document| T::deserialize(Tables(document)))
            .map_err(|error| self.parse_error(&error))
    }

    /// Turns a complaint about a field into an error with its line.
    pub fn locate(&self, problem: &Problem) -> SceneError {
        let line = DeTable::parse(self.text)
            .map_or(1, |top| self.line(span_of(&top, &problem.field).start));
        SceneError::Value {
            file: self.file.to_owned(),
            line,
            field: problem.field.to_string(),
            what: sentence(&problem.what),
        }
    }

    fn parse_error(&self, error: &toml::de::Error) -> SceneError {
        let span = error.span().unwrap_or(0..0);
        let message = sentence(error.message());
        let problem = match DeTable::parse(self.text) {
            Ok(top) => explain(&field_at(&top, &span), &message),
            Err(_) => Field::top().problem(format!("is not proper TOML: {message}")),
        };
        SceneError::Value {
            file: self.file.to_owned(),
            line: self.line(span.start),
            field: problem.field.to_string(),
            what: problem.what,
        }
    }

    fn line(&self, offset: usize) -> usize {
        line_after(&self.text.as_bytes()[..offset.min(self.text.len())])
    }
}

/// A message without its line breaks.
fn sentence(message: &str) -> String {
    message.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Serde's complaint about `field` in the words of all others; what is none of its usual ones
/// stays as it is.
fn explain(field: &Field, message: &str) -> Problem {
    if let Some(name) = message.strip_prefix("missing field ") {
        return field.key(name.trim_matches('`')).problem("is missing");
    }
    let Some((found, expected)) = message.rsplit_once(", expected ") else {
        return field.problem(format!("cannot be read: {message}"));
    };
    let (expected, fields) = match expected.strip_prefix(TABLE_OF) {
        Some(fields) => ("a table", format!("; its fields are {fields}")),
        None => (expected, String::new()),
    };
    let expected = match expected {
        "f64" => "a number",
        "i64" => "a whole number",
        "a sequence" => "a list",
        other => other.trim_start_matches("one of "),
    };
    field.problem(if found.starts_with("unknown field ") {
        format!("is not a field here; allowed: {expected}")
    } else if let Some(count) = found.strip_prefix("invalid length ") {
        format!("must be {expected}, not {count} of them")
    } else {
        let found = found
            .trim_start_matches("invalid type: ")
            .trim_end_matches(" as i128");
        match found {
            "map" => format!("must be {expected}, not a table"),
            "sequence" => format!("must be {expected}, not a list{fields}"),
            _ => format!("must be {expected}, not the {found}{fields}"),
        }
    })
}

/// Where the value of `field` stands; the nearest table around it where it is missing.
fn span_of(top: &Spanned<DeTable>, field: &Field) -> Range<usize> {
    let mut span = top.span();
    let mut steps = field.0.iter();
    let Some(Step::Key(first)) = steps.next() else {
        return span;
    };
    let Some((_, mut value)) = entry(top.get_ref(), first) else {
        return span;
    };
    span = value.span();
    for step in steps {
        let next = match (value.get_ref(), step) {
            (DeValue::Table(table), Step::Key(key)) => entry(table, key).map(|(_, v)| v),
            (DeValue::Array(array), Step::Item(index)) => array.get(*index),
            _ => None,
        };
        match next {
            Some(v) => value = v,
            None => break,
        }
        span = value.span();
    }
    span
}

fn entry<'a, 'i>(
    table: &'a DeTable<'i>,
    key: &str,
) -> Option<(
    &'a Spanned<toml::de::DeString<'i>>,
    &'a Spanned<DeValue<'i>>,
)> {
    table.iter().find(|(k, _)| k.get_ref() == key)
}

/// The innermost field whose key or value covers `span`.
fn field_at(top: &Spanned<DeTable>, span: &Range<usize>) -> Field {
    let mut field = Field::top();
    let mut table = top.get_ref();
    'deeper: loop {
        for (key, value) in table {
            let here = field.key(key.get_ref());
            if covers(&key.span(), span) {
                return here;
            }
            match value.get_ref() {
                DeValue::Table(inner) if covers(&value.span(), span) || reaches(inner, span) => {
                    field = here;
                    table = inner;
                    continue 'deeper;
                }
                DeValue::Array(items) => {
                    let inside = items.iter().enumerate().find(|(_, item)| {
                        covers(&item.span(), span)
                            || matches!(item.get_ref(), DeValue::Table(t) if reaches(t, span))
                    });
                    match inside {
                        Some((i, item)) => match item.get_ref() {
                            DeValue::Table(inner) => {
                                field = here.item(i);
                                table = inner;
                                continue 'deeper;
                            }
                            _ => return here.item(i),
                        },
                        None if covers(&value.span(), span) => return here,
                        None => {}
                    }
                }
                _ if covers(&value.span(), span) => return here,
                _ => {}
            }
        }
        return field;
    }
}

/// True where a key or value anywhere below `table` covers `span`: the span of a table with a
/// header of its own is the header alone.
fn reaches(table: &DeTable, span: &Range<usize>) -> bool {
    table.iter().any(|(key, value)| {
        covers(&key.span(), span)
            || covers(&value.span(), span)
            || match value.get_ref() {
                DeValue::Table(inner) => reaches(inner, span),
                DeValue::Array(items) => items
                    .iter()
                    .any(|item| matches!(item.get_ref(), DeValue::Table(t) if reaches(t, span))),
                _ => false,
            }
    })
}

fn covers(outer: &Range<usize>, inner: &Range<usize>) -> bool {
    outer.start <= inner.start && inner.end <= outer.end && !inner.is_empty()
}
