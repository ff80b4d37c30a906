//! Exercise 6: one of three ways to go on, and its weight.

use super::Draw;
use super::exam::mistake;
use super::{Entry, Exam, Question};

/// Chooses one of three shares by a uniform: which, and the weight of what it brings.
pub type Choose = fn([f64; 3], f64) -> (usize, f64);

/// How it is listed.
pub const ENTRY: Entry = Entry {
    number: 6,
    name: "choose",
    title: "follow one of the diffuse, specular and transmitted rays, and know its weight",
    page: "ch08-which-ray",
    points: 10,
    hints: &[
        "Lay the three shares side by side, and let the uniform fall on their whole length.",
        "What was chosen with the probability p stands for 1/p of its kind: its weight is k/p.",
    ],
    source: include_str!("../../../examples/exercises/ex06_choose.rs"),
};

/// The shares that are asked about: a surface that absorbs a fifth, and one without a diffuse part.
const SHARES: [[f64; 3]; 2] = [[0.5, 0.25, 0.05], [0.0, 0.6, 0.3]];

/// A share of zero stands first, in the middle and last.
const WITHOUT: [[f64; 3]; 3] = [[0.0, 0.6, 0.3], [0.6, 0.0, 0.3], [0.3, 0.6, 0.0]];

fn in_turn(shares: [f64; 3], length: f64) -> usize {
    let mut below = 0.0;
    for (i, share) in shares.into_iter().enumerate() {
        below += share;
        if length < below {
            return i;
        }
    }
    2
}

fn total(shares: [f64; 3]) -> f64 {
    shares.iter().sum()
}

/// What is chosen by the shares.
fn chosen(k: [f64; 3], u: f64) -> usize {
    in_turn(k, u * total(k))
}

fn brings(choose: &Choose, k: [f64; 3], i: usize, draw: &mut Draw) -> f64 {
    let (which, weight) = choose(k, draw.fine());
    if which == i { weight } else { 0.0 }
}

/// Its questions and mistakes.
pub fn exam() -> Exam<Choose> {
    let slip = mistake::<Choose>;
    let [k, other] = SHARES;
    let mean = |what, i: usize| Question::mean(what, k[i], move |a: &Choose, d| brings(a, k, i, d));
    let chance = |what, i: usize| {
        Question::mean(what, k[i] / total(k), move |a: &Choose, d| {
            f64::from(u8::from(a(k, d.fine()).0 == i))
        })
    };
    Exam::new(
        &ENTRY,
        vec![
            Question::never("choices that are none of 0, 1, 2", move |a: &Choose, d| {
                a(k, d.fine()).0 > 2
            }),
            Question::never("choices of a part whose share is 0", |a: &Choose, d| {
                let u = d.fine();
                WITHOUT.iter().any(|k| k.get(a(*k, u).0) == Some(&0.0))
            }),
            mean("the light that part 0 brings, of share 0.5,", 0),
            mean("the light that part 1 brings, of share 0.25,", 1),
            mean("the light that part 2 brings, of share 0.05,", 2),
            Question::mean(
                "the light of all parts, of shares 0, 0.6 and 0.3,",
                0.9,
                move |a: &Choose, d| a(other, d.fine()).1,
            ),
            chance("the probability of part 0, of share 0.5 in 0.8,", 0),
            chance("the probability of part 2, of share 0.05 in 0.8,", 2),
            Question::variance(
                "the variance of the weight",
                total(k),
                0.0,
                move |a: &Choose, d| (a(k, d.fine()).1, 1.0),
            ),
        ],
        vec![
            slip(
                "weight forgotten",
                "the weight: what a chosen part brings counts k/p, or every surface reflects everything",
                |k, u| (chosen(k, u), 1.0),
            ),
            slip(
                "share counted again",
                "that the choice has the share in it already: the weight is k/p, and not k",
                |k, u| {
                    let i = chosen(k, u);
                    (i, k[i])
                },
            ),
            slip(
                "one over the probability",
                "the share in the weight: it is k/p, and not 1/p",
                |k, u| {
                    let i = chosen(k, u);
                    (i, total(k) / k[i])
                },
            ),
            slip(
                "probability for weight",
                "that what is chosen rarely counts more: the weight is k/p, and not p",
                |k, u| {
                    let i = chosen(k, u);
                    (i, k[i] / total(k))
                },
            ),
            slip(
                "a third each",
                "the shares in the choice: a third each needs the weight 3 k, and yours is that of the shares",
                |k, u| (((3.0 * u) as usize).min(2), total(k)),
            ),
            slip(
                "a third each, weighted",
                "that a choice by the shares has the same weight for all parts; a third each is right in the mean, and noisy",
                |k, u| {
                    let i = ((3.0 * u) as usize).min(2);
                    (i, 3.0 * k[i])
                },
            ),
            slip(
                "uniform not scaled",
                "to stretch the uniform over the sum of the shares: the last part gets what the surface absorbs",
                |k, u| (in_turn(k, u), total(k)),
            ),
            slip(
                "shares not added up",
                "to add up the shares: each one is compared with the uniform by itself",
                |k, u| {
                    let r = u * total(k);
                    let i = k.iter().position(|share| r < *share).unwrap_or(2);
                    (i, total(k))
                },
            ),
            slip(
                "at most instead of below",
                "that the uniform may be 0: compare with <, or a part without a share is chosen",
                |k, u| {
                    let r = u * total(k);
                    let i = match r {
                        r if r <= k[0] => 0,
                        r if r <= k[0] + k[1] => 1,
                        _ => 2,
                    };
                    (i, total(k))
                },
            ),
        ],
    )
}
