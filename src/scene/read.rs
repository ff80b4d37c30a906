//! From a file to a description, with errors that name the line and the field.

use super::field::{Problem, Step};
use super::tree::Value;
use serde::de::DeserializeOwned;
use std::borrow::Cow;
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
    let meant = guess(name, &names);
    SceneError::Unknown(format!(
        "`{name}` is neither a scene of the gallery ({all}) nor a file{meant}"
    ))
}

/// Names less alike than this (Jaro and Winkler) are other names.
const ALIKE: f64 = 0.8;

/// A question for the name that was meant, if one is near enough.
pub(super) fn guess(name: &str, names: &[&str]) -> String {
    let stem = name.trim_end_matches(".toml").to_lowercase();
    let near = names
        .iter()
        .map(|other| (strsim::jaro_winkler(&stem, other), other));
    match near.max_by(|a, b| a.0.total_cmp(&b.0)) {
        Some((alike, meant)) if alike > ALIKE => format!("; did you mean `{meant}`?"),
        _ => String::new(),
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
    /// Reads the text into a description of any kind.
    pub fn parse<T: DeserializeOwned>(&self) -> Result<T, SceneError> {
        let top = self.top()?;
        T::deserialize(Value::Said(top.get_ref())).map_err(|problem| self.locate(&problem))
    }

    /// Turns a problem of a value into an error with its line: where the value is missing, that of the
    /// nearest table around it.
    pub fn locate(&self, problem: &Problem) -> SceneError {
        let top = match self.top() {
            Ok(top) => top,
            Err(error) => return error,
        };
        let mut value = &top;
        for step in &problem.field.0 {
            let next = match step {
                Step::Key(key) => value.get_ref().get(key),
                Step::Item(index) => value.get_ref().get(index),
            };
            let Some(next) = next else { break };
            value = next;
        }
        self.error(value.span().start, problem.field.to_string(), &problem.what)
    }

    /// The whole file as a value.
    fn top(&self) -> Result<Spanned<DeValue<'_>>, SceneError> {
        match DeTable::parse(self.text) {
            Ok(top) => Ok(Spanned::new(top.span(), DeValue::Table(top.into_inner()))),
            Err(error) => {
                let at = error.span().map_or(0, |span| span.start);
                let what = format!("is not proper TOML: {}", error.message());
                Err(self.error(at, String::new(), &what))
            }
        }
    }

    fn error(&self, at: usize, field: String, what: &str) -> SceneError {
        SceneError::Value {
            file: self.file.to_owned(),
            line: line_after(&self.text.as_bytes()[..at.min(self.text.len())]),
            field,
            // On one line.
            what: what.split_whitespace().collect::<Vec<_>>().join(" "),
        }
    }
}
