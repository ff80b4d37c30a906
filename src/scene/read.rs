//! From a file to a description, with errors that name the line and the field.

use super::description::Description;
use super::field::{Field, Problem, Step};
use std::ops::Range;
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

fn quoted(field: &str) -> String {
    if field.is_empty() {
        String::new()
    } else {
        format!("`{field}` ")
    }
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
    /// Reads the text into a description.
    pub fn parse(&self) -> Result<Description, SceneError> {
        toml::from_str(self.text).map_err(|error| self.parse_error(&error))
    }

    /// Turns a complaint about a field into an error with its line.
    pub fn locate(&self, problem: &Problem) -> SceneError {
        let line = DeTable::parse(self.text)
            .map_or(1, |top| self.line(span_of(&top, &problem.field).start));
        SceneError::Value {
            file: self.file.to_owned(),
            line,
            field: problem.field.to_string(),
            what: problem.what.clone(),
        }
    }

    fn parse_error(&self, error: &toml::de::Error) -> SceneError {
        let span = error.span().unwrap_or(0..0);
        let field = DeTable::parse(self.text)
            .map(|top| field_at(&top, &span))
            .unwrap_or_default();
        SceneError::Value {
            file: self.file.to_owned(),
            line: self.line(span.start),
            field: field.to_string(),
            what: sentence(error.message()),
        }
    }

    fn line(&self, offset: usize) -> usize {
        let before = &self.text.as_bytes()[..offset.min(self.text.len())];
        1 + before.iter().filter(|b| **b == b'\n').count()
    }
}

/// A parser's message without its line breaks.
fn sentence(message: &str) -> String {
    message.split_whitespace().collect::<Vec<_>>().join(" ")
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
                            _ => return here,
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
