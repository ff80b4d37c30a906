//! The grammar of expressions, and what is said where a text is not one.
//!
//! It is small on purpose; whatever it lets through is also a pattern of `regex-automata`.

use super::Letter;
use std::fmt::Display;

const LONGEST: usize = 256;
const DEEPEST: usize = 32;
const MOST_TIMES: u32 = 64;

/// What an item may begin with.
const ITEM: &str = "L, D, S, G, E, `.`, `[` or `(`";

/// Where something is wrong, and what.
pub(super) type Problem = (Option<usize>, String);

fn problem<T>(at: usize, what: impl Display) -> Result<T, Problem> {
    Err((Some(at), format!("character {at} {what}")))
}

/// What stands to the left.
#[derive(Clone, Copy, PartialEq)]
enum Before {
    Nothing,
    Item,
    Repeat,
}

/// Reads the characters of an expression, one by one.
pub(super) struct Parser {
    /// The characters that are no spaces, with their positions; the first is read next.
    rest: std::iter::Peekable<std::vec::IntoIter<(usize, char)>>,
    /// The position after the last character.
    end: usize,
}

impl Parser {
    pub fn new(text: &str) -> Result<Parser, Problem> {
        let length = text.chars().count();
        if length > LONGEST {
            let what = format!("has {length} characters, and {LONGEST} are allowed");
            return Err((None, what));
        }
        let numbered = (1..).zip(text.chars());
        let rest: Vec<_> = numbered.filter(|(_, c)| !c.is_whitespace()).collect();
        Ok(Parser {
            rest: rest.into_iter().peekable(),
            end: length + 1,
        })
    }

    /// The whole text as a pattern of `regex-automata`.
    pub fn pattern(mut self) -> Result<String, Problem> {
        let mut pattern = String::new();
        let mut open = Vec::new();
        let mut before = Before::Nothing;
        while let Some((at, c)) = self.rest.next() {
            before = match c {
                '|' | ')' if before == Before::Nothing => {
                    return problem(at, format!("is `{c}` after nothing; allowed are {ITEM}"));
                }
                '*' | '+' | '?' | '{' if before == Before::Nothing => {
                    let what = format!("is `{c}` with nothing to repeat; allowed are {ITEM}");
                    return problem(at, what);
                }
                '*' | '+' | '?' | '{' if before == Before::Repeat => {
                    let what = format!("is `{c}` on a repeat; put what it repeats in `(...)`");
                    return problem(at, what);
                }
                '(' if open.len() == DEEPEST => {
                    let what = format!("opens one group too many inside {DEEPEST} others");
                    return problem(at, what);
                }
                '(' => {
                    open.push(at);
                    pattern += "(?:";
                    Before::Nothing
                }
                ')' if open.pop().is_none() => {
                    return problem(at, "is `)`, but no group is open");
                }
                '|' => {
                    pattern.push(c);
                    Before::Nothing
                }
                '*' | '+' | '?' => {
                    pattern.push(c);
                    Before::Repeat
                }
                '{' => {
                    pattern += &self.count(at)?;
                    Before::Repeat
                }
                _ => {
                    pattern += &match c {
                        ')' => ")".to_owned(),
                        '.' => "[LDSGE]".to_owned(),
                        '[' => self.class(at)?,
                        _ if Letter::read(c).is_some() => c.to_string(),
                        _ => {
                            let also = "`|`, `)`, `*`, `+`, `?` and `{`";
                            let found = c.escape_debug();
                            let what = format!("is `{found}`; expressions hold {ITEM}, {also}");
                            return problem(at, what);
                        }
                    };
                    Before::Item
                }
            };
        }
        match (before, open.pop()) {
            (Before::Nothing, _) => problem(self.end, format!("is missing; allowed are {ITEM}")),
            (_, Some(at)) => {
                let what = format!("the group opened at character {at} is never closed");
                Err((Some(at), what))
            }
            _ => Ok(pattern),
        }
    }

    /// The letters after a `[`, and its `]`.
    fn class(&mut self, opened: usize) -> Result<String, Problem> {
        let mut class = "[".to_owned();
        loop {
            match self.rest.next() {
                Some((_, ']')) if class.len() > 1 => return Ok(class + "]"),
                Some((_, c)) if Letter::read(c).is_some() => class.push(c),
                Some((at, c)) => {
                    let found = c.escape_debug();
                    let what = format!("is `{found}`; between `[` and `]` stand L, D, S, G, E");
                    return problem(at, what);
                }
                None => {
                    let what = format!("the `[` at character {opened} is never closed");
                    return Err((Some(opened), what));
                }
            }
        }
    }

    /// The counts after a `{`, and its `}`.
    fn count(&mut self, opened: usize) -> Result<String, Problem> {
        let low = self.number(opened)?;
        let mut high = Some(low);
        if self.rest.next_if(|&(_, c)| c == ',').is_some() {
            let open_end = matches!(self.rest.peek(), Some((_, '}')));
            high = if open_end {
                None
            } else {
                Some(self.number(opened)?)
            };
        }
        match (self.rest.next(), high) {
            (Some((_, '}')), Some(high)) if high < low => problem(
                opened,
                format!("asks for {low} to {high}; the larger count is second"),
            ),
            (Some((_, '}')), Some(high)) => Ok(format!("{{{low},{high}}}")),
            (Some((_, '}')), None) => Ok(format!("{{{low},}}")),
            (found, _) => self.bad_count(opened, found),
        }
    }

    /// A whole number, its digits next to each other.
    fn number(&mut self, opened: usize) -> Result<u32, Problem> {
        let mut read: Option<(usize, u32)> = None;
        while let Some(&(at, c)) = self.rest.peek() {
            let Some(digit) = c
                .to_digit(10)
                .filter(|_| read.is_none_or(|(p, _)| p + 1 == at))
            else {
                break;
            };
            self.rest.next();
            let value = read.map_or(0, |(_, value)| 10 * value) + digit;
            if value > MOST_TIMES {
                return problem(
                    at,
                    format!("makes a count of {value}; the most is {MOST_TIMES}"),
                );
            }
            read = Some((at, value));
        }
        match read {
            Some((_, value)) => Ok(value),
            None => {
                let found = self.rest.next();
                self.bad_count(opened, found)
            }
        }
    }

    fn bad_count<T>(&self, opened: usize, found: Option<(usize, char)>) -> Result<T, Problem> {
        let allowed = "counts are written {2}, {2,} or {2,3}";
        match found {
            Some((at, c)) => problem(at, format!("is `{}`; {allowed}", c.escape_debug())),
            None => {
                let what = format!("the `{{` at character {opened} is never closed; {allowed}");
                Err((Some(opened), what))
            }
        }
    }
}
