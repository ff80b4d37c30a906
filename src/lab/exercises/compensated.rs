//! Exercise 14: a mean in single precision that keeps its digits.

use super::exam::mistake;
use super::{Entry, Exam, Question};

/// The mean of samples, with sums in `f32` only.
pub type Mean = fn(&[f32]) -> f32;

/// How it is listed.
pub const ENTRY: Entry = Entry {
    number: 14,
    name: "compensated",
    title: "sum in single precision, and remember what each addition loses",
    page: "ch17-hard-cases",
    points: 5,
    hints: &[
        "A large sum and a small term: the last digits of the term are rounded away. The difference (sum after − sum before) says what was really added.",
        "Keep what was added too much, and take it from the next term (Kahan 1965).",
    ],
    source: include_str!("../../../examples/exercises/ex14_compensated.rs"),
};

/// Rows of numbers whose plain sums lose digits.
fn tenths() -> Vec<f32> {
    vec![0.1; 1 << 20]
}

fn one_large() -> Vec<f32> {
    (0..1 << 20)
        .map(|i| if i == 0 { 1e8 } else { 1.0 })
        .collect()
}

fn alternating() -> Vec<f32> {
    (0..1 << 20)
        .map(|i| if i % 2 == 0 { 3.3 } else { -1.1 })
        .collect()
}

fn exactly(samples: &[f32]) -> f64 {
    samples.iter().map(|x| f64::from(*x)).sum::<f64>() / samples.len() as f64
}

/// A sum that loses and gives back, right or wrong: what is done with a term, and what is lost.
fn sum(
    samples: &[f32],
    term: impl Fn(f32, f32) -> f32,
    lost: impl Fn(f32, f32, f32) -> f32,
) -> f32 {
    let (mut sum, mut left) = (0.0, 0.0);
    for &x in samples {
        let x = term(x, left);
        let next = sum + x;
        left = lost(next, sum, x);
        sum = next;
    }
    sum / samples.len() as f32
}

/// Its questions and mistakes.
pub fn exam() -> Exam<Mean> {
    let slip = mistake::<Mean>;
    let ask = |what, samples: Vec<f32>| {
        Question::exact(what, exactly(&samples), move |a: &Mean| a(&samples).into())
    };
    Exam::new(
        &ENTRY,
        vec![
            ask("the mean of 1, 2 and 6", vec![1.0, 2.0, 6.0]),
            ask("the mean of a million tenths", tenths()),
            ask(
                "the mean of a hundred million and a million ones",
                one_large(),
            ),
            ask(
                "the mean of a million numbers, 3.3 and −1.1 in turn,",
                alternating(),
            ),
        ],
        vec![
            slip(
                "plain sum",
                "that each addition rounds to the spacing of the sum: take what was added too much from the next term; it is (next − sum) − x, and next − (sum + x) is always 0",
                |samples| samples.iter().sum::<f32>() / samples.len() as f32,
            ),
            slip(
                "given back the wrong way",
                "the sign: (next − sum) − x is what was added too much, and is taken from the next term",
                |samples| sum(samples, |x, lost| x + lost, |next, sum, x| (next - sum) - x),
            ),
            slip(
                "sum for mean",
                "to divide by the number of samples",
                |samples| {
                    sum(samples, |x, lost| x - lost, |next, sum, x| (next - sum) - x)
                        * samples.len() as f32
                },
            ),
        ],
    )
}
