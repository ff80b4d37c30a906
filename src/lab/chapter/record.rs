//! A chapter's findings as data.

use super::{Chapter, Options};
use crate::lab::ledger::Ledger;
use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

/// The content of a chapter's `data.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Short name, such as `ch01`.
    pub chapter: String,
    /// Title.
    pub title: String,
    /// Question.
    pub question: String,
    /// Seed of the run.
    pub seed: u64,
    /// True for a run with few samples.
    pub quick: bool,
    /// What was found, by name, in the order in which it was found.
    pub numbers: IndexMap<String, Number>,
    /// What was drawn, in order.
    pub figures: Vec<Figure>,
    /// What it cost and gained.
    pub ledger: Option<Ledger>,
}

/// A number that was found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Number {
    /// What it is, in a few words.
    pub says: String,
    /// The number.
    pub value: f64,
    /// Its standard error, where it is an estimate.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub error: Option<f64>,
    /// What theory says it should be, where theory says it.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub exact: Option<f64>,
    /// Its unit, where it has one.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub unit: Option<String>,
}

/// A picture or chart that was drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Figure {
    /// File name in the chapter's folder.
    pub file: String,
    /// What it shows.
    pub caption: String,
}

impl Record {
    pub(super) fn new(chapter: Chapter, options: &Options) -> Self {
        Record {
            chapter: chapter.id.to_owned(),
            title: chapter.title.to_owned(),
            question: chapter.question.to_owned(),
            seed: options.seed,
            quick: options.quick,
            numbers: IndexMap::new(),
            figures: Vec::new(),
            ledger: None,
        }
    }
}

impl Number {
    /// A number without error, truth or unit.
    pub fn new(says: &str, value: f64) -> Self {
        Number {
            says: says.to_owned(),
            value,
            error: None,
            exact: None,
            unit: None,
        }
    }

    /// The same with what theory says.
    #[must_use]
    pub fn exact(self, exact: f64) -> Self {
        Number {
            exact: Some(exact),
            ..self
        }
    }

    /// The same with a unit.
    #[must_use]
    pub fn unit(self, unit: &str) -> Self {
        Number {
            unit: Some(unit.to_owned()),
            ..self
        }
    }

    /// The number for people, in one line.
    pub fn line(&self) -> String {
        let mut line = format!("{:<58} {}", self.says, digits(self.value));
        if let Some(error) = self.error {
            line += &format!(" ± {error:.2e}");
        }
        if let Some(unit) = &self.unit {
            line += &format!(" {unit}");
        }
        if let Some(exact) = self.exact {
            line += &format!("   exact {}", digits(exact));
        }
        if let (Some(error), Some(exact)) = (self.error, self.exact)
            && error > 0.0
        {
            line += &format!(
                ", {:+.2} standard errors away",
                (self.value - exact) / error
            );
        }
        line
    }
}

/// Whole numbers whole, others with seven significant digits.
fn digits(x: f64) -> String {
    if x.fract() == 0.0 && x.abs() < 1e15 {
        return format!("{x:.0}");
    }
    let size = libm::log10(x.abs()).floor();
    if (-4.0..7.0).contains(&size) {
        format!("{x:.*}", (6.0 - size) as usize)
    } else {
        format!("{x:.6e}")
    }
}
