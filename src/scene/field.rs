//! The address of a value in a scene file, and what may be wrong with it.

use std::collections::BTreeMap;
use std::fmt;

/// One step from a table or list to a value in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// The value of a key.
    Key(String),
    /// An item of a list, counted from 0.
    Item(usize),
}

impl From<&str> for Step {
    fn from(key: &str) -> Self {
        Step::Key(key.to_owned())
    }
}

impl From<usize> for Step {
    fn from(item: usize) -> Self {
        Step::Item(item)
    }
}

/// The way from the top of a file to a value, such as `objects[2].sphere.radius`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Field(pub Vec<Step>);

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for (i, step) in self.0.iter().enumerate() {
            match step {
                Step::Key(key) => {
                    let dot = if i == 0 { "" } else { "." };
                    // Other keys stand in quotes in the file too, and may hold line breaks.
                    let bare = |c: char| c.is_ascii_alphanumeric() || "-_".contains(c);
                    if !key.is_empty() && key.chars().all(bare) {
                        write!(f, "{dot}{key}")?;
                    } else {
                        write!(f, "{dot}{key:?}")?;
                    }
                }
                Step::Item(index) => write!(f, "[{index}]")?,
            }
        }
        Ok(())
    }
}

/// A value that is not allowed: which one, and what is.
///
/// Whoever finds it knows the value alone; its address grows on the way up, see [`Within`].
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{what}")]
pub struct Problem {
    /// Which value.
    pub field: Field,
    /// What is wrong and what is allowed.
    pub what: String,
}

impl Problem {
    /// A problem of the value at hand.
    pub fn new(what: impl Into<String>) -> Self {
        Problem {
            field: Field::default(),
            what: what.into(),
        }
    }

    /// The same as the result of a check.
    pub fn of<T>(what: impl Into<String>) -> Checked<T> {
        Err(Problem::new(what))
    }
}

/// What a check returns.
pub type Checked<T> = Result<T, Problem>;

/// A problem, unless all is `well`.
pub fn check(well: bool, what: impl fmt::Display) -> Checked<()> {
    match well {
        true => Ok(()),
        false => Problem::of(what.to_string()),
    }
}

/// Says where a problem was found.
pub trait Within {
    /// The same, seen from the table or list in which the value stands.
    #[must_use]
    fn within(self, step: impl Into<Step>) -> Self;
}

impl Within for Problem {
    fn within(mut self, step: impl Into<Step>) -> Self {
        self.field.0.insert(0, step.into());
        self
    }
}

impl<T> Within for Checked<T> {
    fn within(self, step: impl Into<Step>) -> Self {
        self.map_err(|problem| problem.within(step))
    }
}

/// The material of a name.
pub fn named<'a, T>(materials: &'a BTreeMap<String, T>, name: &str) -> Checked<&'a T> {
    materials.get(name).ok_or_else(|| {
        let defined: Vec<&str> = materials.keys().map(String::as_str).collect();
        Problem::new(if defined.is_empty() {
            format!("names {name:?}, but the file defines no materials")
        } else {
            format!("names {name:?}; defined are {}", defined.join(", "))
        })
    })
}
