//! One thing that is asked of an answer, and what the answer reads.

use super::draw::Draw;
use super::words::{digits, shown, upper};
use crate::stats::Estimate;
use crate::stats::chi_square::ChiSquare;
use crate::stats::z_test::critical;

/// Beyond so many standard errors a reading is wrong: a right one is once in 92 000 times.
pub(super) const LINE: f64 = 4.4;

/// Readings differ by rounding where they are closer than this share of their scale: answers are written in `f32`.
const ROUNDING: f64 = 3e-6;

type Boxed<I, O> = Box<dyn Fn(&I, &mut Draw) -> O + Send + Sync>;

type Asked<A, O> = Box<dyn Fn(&A) -> O + Send + Sync>;

type Test<A> = Box<dyn Fn(&A, u64) -> ChiSquare + Send + Sync>;

enum Kind<A> {
    /// A number without noise.
    Exact(Asked<A, f64>),
    /// The mean of draws.
    Mean(Boxed<A, f64>),
    /// What may never happen.
    Never(Boxed<A, bool>),
    /// The variance of draws around their right mean, times their mean cost. Less is better.
    Variance {
        mean: f64,
        draw: Boxed<A, (f64, f64)>,
    },
    /// Do samples follow a density?
    Fit(Test<A>),
}

/// One thing that is asked of an answer of type `A`.
pub struct Question<A> {
    /// What is read, as a sentence begins with it.
    pub what: &'static str,
    /// What a right answer reads.
    pub truth: f64,
    kind: Kind<A>,
    samples: u32,
    /// More about a wrong answer.
    note: Option<Asked<A, String>>,
}

/// What an answer reads.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading {
    /// The number: a mean, a share of draws, a variance, or the probability of a chi-square test.
    pub value: f64,
    /// Its standard error.
    pub error: f64,
    /// Of so many draws.
    pub draws: u64,
    /// So many were no finite numbers, or happened though they may never.
    pub broken: u64,
    /// Which of the first draws, the corners of the unit square, are among these, as bits.
    pub corners: u32,
    /// The first of these: its first two uniforms.
    pub first: Option<[f32; 2]>,
    /// The same random numbers gave another result when they came again.
    pub wavers: bool,
}

impl<A> Question<A> {
    fn new(what: &'static str, truth: f64, kind: Kind<A>) -> Self {
        Question {
            what,
            truth,
            kind,
            samples: 1 << 15,
            note: None,
        }
    }

    /// A number without noise.
    pub fn exact(
        what: &'static str,
        truth: f64,
        read: impl Fn(&A) -> f64 + Send + Sync + 'static,
    ) -> Self {
        Self::new(what, truth, Kind::Exact(Box::new(read)))
    }

    /// The mean of draws.
    pub fn mean(
        what: &'static str,
        truth: f64,
        draw: impl Fn(&A, &mut Draw) -> f64 + Send + Sync + 'static,
    ) -> Self {
        Self::new(what, truth, Kind::Mean(Box::new(draw)))
    }

    /// What may never happen.
    pub fn never(
        what: &'static str,
        draw: impl Fn(&A, &mut Draw) -> bool + Send + Sync + 'static,
    ) -> Self {
        Self::new(what, 0.0, Kind::Never(Box::new(draw)))
    }

    /// The variance of draws around their right `mean`, times their mean cost: at most `truth`. A draw gives its value
    /// and its cost.
    pub fn variance(
        what: &'static str,
        mean: f64,
        truth: f64,
        draw: impl Fn(&A, &mut Draw) -> (f64, f64) + Send + Sync + 'static,
    ) -> Self {
        let draw = Box::new(draw);
        Self::new(what, truth, Kind::Variance { mean, draw })
    }

    /// Do samples follow a density? Right answers have every probability from 0 to 1 alike.
    pub fn fit(
        what: &'static str,
        test: impl Fn(&A, u64) -> ChiSquare + Send + Sync + 'static,
    ) -> Self {
        Self::new(what, 1.0, Kind::Fit(Box::new(test)))
    }

    /// With so many draws.
    #[must_use]
    pub fn of(self, samples: u32) -> Self {
        Question { samples, ..self }
    }

    /// With more words about a wrong answer.
    #[must_use]
    pub fn noted(self, note: impl Fn(&A) -> String + Send + Sync + 'static) -> Self {
        Question {
            note: Some(Box::new(note)),
            ..self
        }
    }

    /// Asks. The answer's panics come through.
    pub fn ask(&self, answer: &A, seed: u64) -> Reading {
        match &self.kind {
            Kind::Exact(read) => {
                let [value, again] = [read(answer), read(answer)];
                Reading {
                    error: 0.0,
                    wavers: value.to_bits() != again.to_bits(),
                    ..summed([(value, 1.0)].into_iter(), |_| None)
                }
            }
            Kind::Mean(draw) => {
                let one = |i| (draw(answer, &mut Draw::new(seed, i)), 1.0);
                self.drawn(seed, &one, |estimate, _| estimate)
            }
            Kind::Variance { mean, draw } => {
                let one = |i| {
                    let (value, cost) = draw(answer, &mut Draw::new(seed, i));
                    ((value - mean) * (value - mean), cost)
                };
                self.drawn(seed, &one, |estimate, cost| Reading {
                    value: estimate.value * cost,
                    error: estimate.error * cost,
                    ..estimate
                })
            }
            Kind::Never(draw) => {
                let at = |i: u32| match i {
                    0..4 => Draw::corner(seed, i),
                    _ => Draw::new(seed, i),
                };
                let hits = (0..self.samples).filter(|&i| draw(answer, &mut at(i)));
                let hits: Vec<u32> = hits.collect();
                let corners = hits
                    .iter()
                    .filter(|&&i| i < 4)
                    .fold(0, |bits, i| bits | 1 << i);
                let others = hits.len() as u32 - u32::count_ones(corners);
                let draws = f64::from(self.samples);
                Reading {
                    value: f64::from(others) / draws,
                    error: f64::from(others.max(1)).sqrt() / draws,
                    draws: self.samples.into(),
                    broken: hits.len() as u64,
                    corners,
                    first: hits.first().map(|&i| at(i).two()),
                    wavers: false,
                }
            }
            Kind::Fit(test) => Reading {
                value: test(answer, seed).p,
                draws: u64::from(self.samples),
                ..Reading::default()
            },
        }
    }

    fn drawn(
        &self,
        seed: u64,
        one: &dyn Fn(u32) -> (f64, f64),
        finish: impl Fn(Reading, f64) -> Reading,
    ) -> Reading {
        let mut costs = 0.0;
        let all = (0..self.samples)
            .map(one)
            .inspect(|(_, cost)| costs += cost);
        let mut reading = summed(all, |i| Some(Draw::new(seed, i).two()));
        reading.wavers = (0..AGAIN).any(|i| one(i).0.to_bits() != one(i).0.to_bits());
        finish(reading, costs / f64::from(self.samples))
    }

    /// How far a reading lies from the truth, in standard errors; infinite where it is none.
    pub fn distance(&self, reading: &Reading) -> f64 {
        if reading.broken > 0 || reading.wavers {
            return f64::INFINITY;
        }
        match self.kind {
            Kind::Fit(_) => match reading.value {
                p if p >= 1.0 => 0.0,
                p if p > 0.0 => critical(p),
                _ => f64::INFINITY,
            },
            Kind::Never(_) => 0.0,
            Kind::Variance { .. } => {
                (reading.value - self.truth).max(0.0) / error(reading, &exactly(self.truth))
            }
            _ => (reading.value - self.truth).abs() / error(reading, &exactly(self.truth)),
        }
    }

    /// How far two readings lie from each other, in standard errors of both.
    pub fn between(&self, a: &Reading, b: &Reading) -> f64 {
        if matches!(self.kind, Kind::Fit(_)) {
            return 0.0;
        }
        let off = (a.value - b.value).abs() / error(a, b);
        let none = |r: &Reading| r.value == 0.0;
        match self.kind {
            // Only corners are hit: these are the same draws for everyone.
            Kind::Never(_) if none(a) && none(b) && a.corners != b.corners => f64::INFINITY,
            Kind::Never(_) => off,
            _ if a.broken == 0 && b.broken == 0 => off,
            Kind::Exact(_) if a.broken != b.broken => f64::INFINITY,
            // What is broken now and then is so about as often.
            _ => {
                let share = |r: &Reading| r.broken as f64 / r.draws.max(1) as f64;
                let noise = (a.broken + b.broken) as f64 / (a.draws * b.draws).max(1) as f64;
                (share(a) - share(b)).abs() / noise.sqrt()
            }
        }
    }

    /// What is read of an answer with both of two slips, from what is read with each; `None` where nobody knows.
    ///
    /// Factors multiply. What should be 0 adds up, and what may never happen happens by either.
    pub(super) fn both(&self, a: &Reading, b: &Reading) -> Option<Reading> {
        let (value, error) = match self.kind {
            Kind::Fit(_) | Kind::Variance { .. } => return None,
            Kind::Never(_) => (
                a.value + b.value - a.value * b.value,
                libm::hypot(a.error, b.error),
            ),
            _ if self.truth == 0.0 => (a.value + b.value, libm::hypot(a.error, b.error)),
            _ => (
                a.value * b.value / self.truth,
                libm::hypot(a.error * b.value, b.error * a.value) / self.truth.abs(),
            ),
        };
        Some(Reading {
            value,
            error,
            broken: a.broken.max(b.broken),
            corners: a.corners | b.corners,
            ..*a
        })
    }

    /// True where what two slips do to the reading multiplies.
    pub(super) fn multiplies(&self) -> bool {
        matches!(self.kind, Kind::Exact(_) | Kind::Mean(_)) && self.truth != 0.0
    }

    /// True where only the variance is asked.
    pub(super) fn is_variance(&self) -> bool {
        matches!(self.kind, Kind::Variance { .. })
    }

    /// The variance of a right answer, beside what is enough, in a sentence; `None` where nothing was asked of it.
    pub fn price(&self, reading: &Reading) -> Option<String> {
        (self.is_variance() && self.truth > 0.0).then(|| {
            let (what, enough) = (upper(self.what), digits(self.truth));
            format!(" {what} is {}; {enough} is enough.", shown(reading))
        })
    }

    /// What a wrong answer reads, in a sentence.
    pub fn describe(&self, answer: &A, reading: &Reading) -> String {
        let at = match reading.first {
            Some([u, v]) => format!(", first with the uniforms {u} and {v}"),
            None => String::new(),
        };
        let note = self.note.as_ref().map_or_else(String::new, |n| n(answer));
        let what = upper(self.what);
        let named = what.trim_end_matches(',');
        if reading.wavers {
            return format!(
                "{named}: the same random numbers give another result when they come again. Use only those that you are given."
            );
        }
        match self.kind {
            Kind::Never(_) => format!(
                "{what}: {} of {} draws{at}; right is none.{note}",
                reading.broken, reading.draws
            ),
            _ if reading.broken > 0 && reading.draws == 1 => {
                format!("{what} is not a finite number.{note}")
            }
            _ if reading.broken > 0 => format!(
                "{named}: {} of {} draws are not finite numbers{at}.{note}",
                reading.broken, reading.draws
            ),
            Kind::Fit(_) if reading.value < 1e-99 => {
                format!("{what}: a chi-square test gives them the probability 0.{note}")
            }
            Kind::Fit(_) => format!(
                "{what}: a chi-square test gives them the probability {:.1e}.{note}",
                reading.value
            ),
            Kind::Variance { .. } => {
                let cost = match reading.value / self.truth {
                    times if times.is_finite() => format!("{times:.1} times the samples"),
                    _ => "samples where one would do".to_owned(),
                };
                format!(
                    "{what} is {}, and {} is enough: your answer needs {cost}.{note}",
                    shown(reading),
                    digits(self.truth)
                )
            }
            _ => format!(
                "{what} reads {}; right is {}.{note}",
                shown(reading),
                digits(self.truth)
            ),
        }
    }
}

/// So many draws are repeated.
const AGAIN: u32 = 32;

/// The reading of draws, without those that are not finite.
fn summed(
    draws: impl Iterator<Item = (f64, f64)>,
    uniforms: impl Fn(u32) -> Option<[f32; 2]>,
) -> Reading {
    let (mut estimate, mut reading) = (Estimate::new(), Reading::default());
    for (i, (x, _)) in draws.enumerate() {
        reading.draws += 1;
        if x.is_finite() {
            estimate.add(x);
        } else {
            reading.broken += 1;
            if reading.broken == 1 {
                reading.first = uniforms(i as u32);
            }
        }
    }
    let error = estimate.std_error();
    Reading {
        value: estimate.mean(),
        error: if error.is_finite() { error } else { 0.0 },
        ..reading
    }
}

fn exactly(value: f64) -> Reading {
    Reading {
        value,
        ..Reading::default()
    }
}

/// The standard error of a difference, with what both may owe to rounding.
fn error(a: &Reading, b: &Reading) -> f64 {
    let scale = a.value.abs().max(b.value.abs()).max(0.1);
    libm::hypot(libm::hypot(a.error, b.error), ROUNDING * scale)
}
