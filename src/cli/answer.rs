//! The one place that decides how a command prints its result: as text, or as JSON.

use super::Stop;
use crate::lab::chapter;
use serde::Serialize;
use std::fmt::{self, Display, Formatter};
use std::io::IsTerminal;

/// Prints a result, as JSON where that is wanted. To be called when every file is written, since it may fail.
pub(super) fn answer(result: &(impl Serialize + Display), json: bool) -> Result<(), Stop> {
    print(&match json {
        true => to_json(result)?,
        false => result.to_string(),
    })
}

/// A result as JSON, with its keys in alphabetical order. A number that is not finite becomes null.
pub(super) fn to_json(result: &impl Serialize) -> Result<String, Stop> {
    let value = serde_json::to_value(result)?;
    Ok(serde_json::to_string_pretty(&value)? + "\n")
}

/// Prints a text.
pub(super) fn print(text: &str) -> Result<(), Stop> {
    chapter::answer(text).map_err(|e| Stop::Failure(format!("stdout: {e}")))
}

/// The widest text that is easy to read.
const WIDEST: usize = 100;

/// Lines as wide as the terminal, if it is one that reads; else as they are.
pub(super) fn for_terminal(text: &str) -> String {
    if !std::io::stdout().is_terminal() {
        return text.to_owned();
    }
    let width = textwrap::termwidth().min(WIDEST);
    let options = textwrap::Options::new(width).subsequent_indent("    ");
    textwrap::wrap(text.trim_end(), options).join("\n") + "\n"
}

/// A list of results: an array in JSON, one after the other in text.
#[derive(Serialize)]
pub(super) struct List<T>(pub Vec<T>);

impl<T: Display> Display for List<T> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        self.0.iter().try_for_each(|entry| entry.fmt(f))
    }
}
