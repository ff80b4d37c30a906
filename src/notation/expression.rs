//! Expressions over the letters, ready for questions about words.

use super::automaton::{MOST_STATES, Order, compile};
use super::language::Language;
use super::parser::Parser;
use std::fmt::{self, Display, Formatter};
use std::str::FromStr;

/// A regular expression over the letters `L`, `D`, `S`, `G`, `E`.
///
/// `XY` is X, then Y; `X|Y` either; `(X)` a group; `[DS]` one of these letters; `.` any letter; `X?`
/// none or one, `X*` any number, `X+` one or more, `X{2}` exactly 2, `X{2,}` 2 or more, `X{2,3}` 2 or
/// 3, with counts up to 64. Spaces mean nothing.
#[derive(Clone, Debug)]
pub struct Expression {
    text: String,
    light_first: Language,
    eye_first: Language,
}

/// Why a text is no expression, in one sentence that points at the character.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}: {what}", shown(text))]
pub struct ExpressionError {
    /// The text as given.
    pub text: String,
    /// The character in question, counted from 1; `None` where it is the whole text.
    pub position: Option<usize>,
    /// What was found and what is allowed.
    pub what: String,
}

impl Expression {
    /// Reads an expression and prepares it for questions about words.
    pub fn parse(text: &str) -> Result<Expression, ExpressionError> {
        let error = |(position, what)| ExpressionError {
            text: text.to_owned(),
            position,
            what,
        };
        let pattern = Parser::new(text).and_then(Parser::pattern).map_err(error)?;
        let language = |order| {
            let what = format!("needs more than {MOST_STATES} states; lower its counts");
            compile(&pattern, order).ok_or_else(|| error((None, what)))
        };
        Ok(Expression {
            light_first: language(Order::LightFirst)?,
            eye_first: language(Order::EyeFirst)?,
            text: text.to_owned(),
        })
    }

    /// The words as they are written: from the light to the eye.
    pub fn light_first(&self) -> &Language {
        &self.light_first
    }

    /// The same words reversed: from the eye to the light, as paths are traced.
    pub fn eye_first(&self) -> &Language {
        &self.eye_first
    }
}

impl FromStr for Expression {
    type Err = ExpressionError;

    fn from_str(text: &str) -> Result<Expression, ExpressionError> {
        Expression::parse(text)
    }
}

impl Display for Expression {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// The text on one line, shortened where it is long.
fn shown(text: &str) -> String {
    let start: String = text.chars().take(60).collect();
    let more = if start.len() < text.len() { "..." } else { "" };
    match start.trim() {
        "" => "an expression of nothing".to_owned(),
        _ => format!("{}{more}", start.escape_debug()),
    }
}
