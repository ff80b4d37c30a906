//! An exercise's questions, and a table of hypotheses: the right answer, and every named mistake.

use super::question::{LINE, Question, Reading};
use super::report::{Check, Report, Verdict};
use super::words::{digits, upper};
use super::{Entry, constants};
use std::sync::OnceLock;

/// A mistake that people make: a whole answer with one thing wrong.
#[derive(Clone, Debug)]
pub struct Mistake<A> {
    /// Its name.
    pub name: &'static str,
    /// What was forgotten or mixed up; stands behind "you forgot".
    pub forgot: &'static str,
    /// The answer that makes it.
    pub answer: A,
}

/// Shorter than the struct with its fields.
pub(super) fn mistake<A>(name: &'static str, forgot: &'static str, answer: A) -> Mistake<A> {
    Mistake {
        name,
        forgot,
        answer,
    }
}

/// An exercise that can be graded.
pub struct Exam<A> {
    /// What it is about.
    pub entry: &'static Entry,
    /// What is asked, the plainest first.
    pub questions: Vec<Question<A>>,
    /// What is often got wrong.
    pub mistakes: Vec<Mistake<A>>,
    /// What each mistake reads, once that was asked.
    table: OnceLock<Vec<Vec<Reading>>>,
}

/// How far the readings of a hypothesis lie from those of an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The mistake, or the two of them.
    pub names: Vec<&'static str>,
    /// What they forgot.
    pub forgot: Vec<&'static str>,
    /// The largest distance of a reading, in standard errors of both.
    pub z: f64,
}

/// The random numbers with which mistakes are read: others than those of the answer.
const OF_MISTAKES: u64 = 0x6d69_7374_616b_6573;

impl<A> Exam<A> {
    /// An exercise with its questions, the plainest first, and its mistakes.
    pub fn new(
        entry: &'static Entry,
        questions: Vec<Question<A>>,
        mistakes: Vec<Mistake<A>>,
    ) -> Self {
        Exam {
            entry,
            questions,
            mistakes,
            table: OnceLock::new(),
        }
    }

    /// What an answer reads, question by question.
    pub fn read(&self, answer: &A, seed: u64) -> Vec<Reading> {
        let asked = self.questions.iter().zip(0..);
        asked
            .map(|(question, i)| question.ask(answer, seed.wrapping_add(i << 32)))
            .collect()
    }

    /// What each mistake reads.
    pub fn table(&self) -> &[Vec<Reading>] {
        let read = |mistake: &Mistake<A>| self.read(&mistake.answer, OF_MISTAKES);
        self.table
            .get_or_init(|| self.mistakes.iter().map(read).collect())
    }

    /// How far two sets of readings lie from each other: the largest distance of one question.
    pub fn apart(&self, a: &[Reading], b: &[Reading]) -> f64 {
        let pairs = self.questions.iter().zip(a.iter().zip(b));
        pairs.map(|(q, (a, b))| q.between(a, b)).fold(0.0, f64::max)
    }

    /// Grades an answer with the random numbers of `seed`. Its panics come through.
    pub fn grade(&self, answer: &A, seed: u64) -> Report {
        let readings = self.read(answer, seed);
        let distances: Vec<f64> = (self.questions.iter().zip(&readings))
            .map(|(question, reading)| question.distance(reading))
            .collect();
        let wrong: Vec<usize> = (0..readings.len())
            .filter(|&i| distances[i].is_nan() || distances[i] > LINE)
            .collect();
        let checks = (0..readings.len()).map(|i| {
            let question = &self.questions[i];
            let passed = !wrong.contains(&i);
            Check {
                what: question.what.to_owned(),
                passed,
                message: (!passed).then(|| question.describe(answer, &readings[i])),
            }
        });
        let checks: Vec<Check> = checks.collect();
        let (verdict, found, said) = if wrong.is_empty() {
            let largest = distances.iter().copied().fold(0.0, f64::max);
            let mut said = format!(
                "right. {} readings agree with their closed forms, within {largest:.1} standard errors at most.",
                readings.len()
            );
            for (question, reading) in self.questions.iter().zip(&readings) {
                said += &question.price(reading).unwrap_or_default();
            }
            (Verdict::Right, Vec::new(), said)
        } else {
            let only_variance = wrong.iter().all(|&i| self.questions[i].is_variance());
            let (verdict, found, why) = self.explain(&readings, &wrong);
            let seen = checks.iter().find_map(|check| check.message.as_deref());
            let start = match only_variance {
                true => "right in the mean, but at a price. ",
                false => "wrong. ",
            };
            let said = format!("{start}{} {why}", seen.unwrap_or_default());
            (verdict, found, said)
        };
        let right = checks.iter().filter(|check| check.passed).count() as u32;
        let of = self.entry.points;
        let part = of * right / (checks.len() as u32).max(1);
        Report {
            mistakes: found.iter().map(|&name| name.to_owned()).collect(),
            points: match verdict {
                Verdict::Right => of,
                _ => part.min(of.saturating_sub(1)),
            },
            checks,
            ..Report::unasked(self.entry, verdict, said)
        }
    }

    /// Which mistakes explain wrong readings, and a sentence about it.
    fn explain(
        &self,
        readings: &[Reading],
        wrong: &[usize],
    ) -> (Verdict, Vec<&'static str>, String) {
        if wrong.iter().any(|&i| readings[i].wavers) {
            return (Verdict::Unknown, Vec::new(), String::new());
        }
        let table = self.table();
        let single = self.single(readings, table);
        let close = single.partition_point(|finding| finding.z <= LINE);
        if let Some((first, others)) = single[..close].split_first() {
            let mut said = format!("You forgot {} ({}).", first.forgot[0], first.names[0]);
            for other in others {
                said += &format!(" Or {} ({}).", other.forgot[0], other.names[0]);
            }
            let names = single[..close].iter().map(|finding| finding.names[0]);
            return (Verdict::Named, names.collect(), said);
        }
        if let Some(two) = self.two(readings, wrong, table) {
            let said = format!(
                "No single known mistake reads this, but two together do. You forgot {} ({}), and {} ({}).",
                two.forgot[0], two.names[0], two.forgot[1], two.names[1]
            );
            return (Verdict::Two, two.names, said);
        }
        if let Some(factor) = self.factor(readings, wrong) {
            let all = match wrong.len() {
                1 => "This is".to_owned(),
                n => format!("All {n} wrong readings are"),
            };
            let said = format!(
                "{all} {} times what is right{}.",
                digits(factor),
                constants::name(factor).map_or_else(String::new, |name| {
                    format!(", and that is {name}: look for such a factor")
                })
            );
            return (Verdict::Factor, Vec::new(), said);
        }
        let mut said = format!(
            "None of {} known mistakes reads this, nor do two of them.",
            self.mistakes.len()
        );
        let further = wrong.iter().skip(1).filter(|&&i| readings[i].broken == 0);
        for &i in further.take(2) {
            let reading = &readings[i];
            said += &format!(
                " {} is wrong as well ({} for {}).",
                upper(self.questions[i].what),
                digits(reading.value),
                digits(self.questions[i].truth)
            );
        }
        (Verdict::Unknown, Vec::new(), said)
    }

    /// Every mistake with its distance from the readings, the closest first.
    pub fn single(&self, readings: &[Reading], table: &[Vec<Reading>]) -> Vec<Finding> {
        let mut found: Vec<Finding> = (self.mistakes.iter().zip(table))
            .map(|(mistake, reads)| Finding {
                names: vec![mistake.name],
                forgot: vec![mistake.forgot],
                z: self.apart(readings, reads),
            })
            .collect();
        found.sort_by(|a, b| a.z.total_cmp(&b.z));
        found
    }

    /// The two mistakes whose factors multiply to the readings, if there are such.
    fn two(
        &self,
        readings: &[Reading],
        wrong: &[usize],
        table: &[Vec<Reading>],
    ) -> Option<Finding> {
        if !wrong.iter().any(|&i| self.questions[i].multiplies()) {
            return None;
        }
        let apart = |a: usize, b: usize| {
            let asked = self.questions.iter().zip(readings).enumerate();
            let z = asked.filter_map(|(i, (question, reading))| {
                let both = question.both(&table[a][i], &table[b][i])?;
                Some(question.between(reading, &both))
            });
            z.fold(0.0, f64::max)
        };
        let pairs = (0..table.len()).flat_map(|a| (a + 1..table.len()).map(move |b| (a, b)));
        let best = pairs
            .map(|(a, b)| (a, b, apart(a, b)))
            .min_by(|x, y| x.2.total_cmp(&y.2))?;
        let (a, b, z) = best;
        let [a, b] = [a, b].map(|k| &self.mistakes[k]);
        (z <= LINE).then(|| Finding {
            names: vec![a.name, b.name],
            forgot: vec![a.forgot, b.forgot],
            z,
        })
    }

    /// The factor by which all wrong readings are wrong, if it is one.
    fn factor(&self, readings: &[Reading], wrong: &[usize]) -> Option<f64> {
        let ratio = |i: usize| readings[i].value / self.questions[i].truth;
        let error = |i: usize| readings[i].error / self.questions[i].truth.abs();
        let usual = wrong.iter().all(|&i| {
            self.questions[i].multiplies() && readings[i].broken == 0 && readings[i].value != 0.0
        });
        let best = *wrong
            .iter()
            .min_by(|&&a, &&b| error(a).total_cmp(&error(b)))?;
        let factor = ratio(best);
        let near = |&i: &usize| {
            let noise = libm::hypot(error(i), error(best)) + 1e-5 * factor.abs();
            (ratio(i) - factor).abs() <= LINE * noise
        };
        (usual && wrong.iter().all(near)).then_some(factor)
    }
}
