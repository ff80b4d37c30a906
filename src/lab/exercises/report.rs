//! What a grader says of an answer: in a sentence, and in the format that Exercism's test runners write.

use super::Entry;
use serde::{Deserialize, Serialize};
use std::fmt::{self, Display, Formatter};

/// What became of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// All readings are right.
    Right,
    /// It reads what one known mistake reads.
    Named,
    /// It reads what two known mistakes read together.
    Two,
    /// All its wrong readings are wrong by the same factor.
    Factor,
    /// It is wrong in a way that no known mistake explains.
    Unknown,
    /// Nothing is written yet.
    Unwritten,
    /// It panics.
    Panics,
    /// It did not end in time, or was ended by the system.
    Ended,
    /// It does not compile.
    NotBuilt,
}

/// What one question found.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Check {
    /// What was read.
    pub what: String,
    /// True where it is right.
    pub passed: bool,
    /// What was read and what is right, where it is not.
    pub message: Option<String>,
}

/// A graded answer.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Report {
    /// The exercise.
    pub number: u32,
    /// Its name.
    pub name: String,
    /// What became of the answer.
    pub verdict: Verdict,
    /// The mistakes that explain the readings, the closest first.
    pub mistakes: Vec<String>,
    /// The verdict in sentences.
    pub said: String,
    /// The page of the book, as a file below the folder of halfdisk's source.
    pub page: String,
    /// What each question found.
    pub checks: Vec<Check>,
    /// Points reached: a part of them for each question, all of them for a right answer only.
    pub points: u32,
    /// Points to be had.
    pub of: u32,
}

impl Report {
    /// A report on an answer that could not be asked.
    pub fn unasked(entry: &Entry, verdict: Verdict, said: String) -> Self {
        Report {
            number: entry.number,
            name: entry.name.to_owned(),
            verdict,
            mistakes: Vec::new(),
            said,
            page: format!("book/src/{}.md", entry.page),
            checks: Vec::new(),
            points: 0,
            of: entry.points,
        }
    }

    /// True where the answer is right.
    pub fn passed(&self) -> bool {
        self.verdict == Verdict::Right
    }

    /// The same as Exercism's `results.json`, version 3, with one more key, `halfdisk`. `output` is what the answer's
    /// program printed.
    pub fn results(&self, output: &str) -> Results<'_> {
        let status = match (self.passed(), self.checks.is_empty()) {
            (true, _) => "pass",
            (false, false) => "fail",
            (false, true) => "error",
        };
        let test = |check: &Check| Test {
            name: check.what.clone(),
            status: if check.passed { "pass" } else { "fail" },
            message: check.message.clone(),
            output: None,
            test_code: format!("halfdisk exercises check {}", self.number),
            task_id: self.number,
        };
        let mut tests: Vec<Test> = self.checks.iter().map(test).collect();
        if let Some(first) = tests.first_mut().filter(|_| !output.is_empty()) {
            first.output = Some(output.chars().take(LONGEST_OUTPUT).collect());
        }
        Results {
            version: 3,
            status,
            message: (status == "error").then_some(self.said.as_str()),
            tests,
            halfdisk: self,
        }
    }
}

/// Exercism shows no more of what a test prints.
const LONGEST_OUTPUT: usize = 500;

/// Exercism's `results.json`, version 3.
///
/// Source: Exercism, The Test Runner Interface (exercism.org/docs/building/tooling/test-runners/interface).
#[derive(Clone, Debug, Serialize)]
pub struct Results<'a> {
    version: u32,
    status: &'static str,
    message: Option<&'a str>,
    tests: Vec<Test>,
    halfdisk: &'a Report,
}

#[derive(Clone, Debug, Serialize)]
struct Test {
    name: String,
    status: &'static str,
    message: Option<String>,
    output: Option<String>,
    test_code: String,
    task_id: u32,
}

impl Display for Results<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        self.halfdisk.fmt(f)
    }
}

impl Display for Report {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        writeln!(f, "{:02} {}: {}", self.number, self.name, self.said)?;
        if !self.checks.is_empty() {
            let right = self.checks.iter().filter(|check| check.passed).count();
            writeln!(
                f,
                "{right} of {} readings are right; {} of {} points.",
                self.checks.len(),
                self.points,
                self.of
            )?;
        }
        if !self.passed() && self.verdict != Verdict::NotBuilt {
            writeln!(f, "Read {}", self.page)?;
        }
        Ok(())
    }
}
