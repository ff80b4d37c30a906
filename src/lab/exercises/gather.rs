//! Exercise 3: the gather integral in seven steps, under a white sky.

use super::exam::Mistake;
use super::{Entry, Exam, Question};
use crate::lab::doctor::{Patient, questions};
use crate::lab::mistakes::{self, Exam as Asked};
use crate::space::{Dimension, Flat};
use std::sync::Arc;

/// The light that a surface reflects: one estimate.
pub type Gather = Arc<dyn Fn(&mut Patient<Flat>) -> f32 + Send + Sync>;

/// How it is listed.
pub const ENTRY: Entry = Entry {
    number: 3,
    name: "gather",
    title: "gather the light that falls on a point, in seven steps",
    page: "ch04-half-disk",
    points: 10,
    hints: &[
        "Steps 1 to 3 make a direction and look along it; 4 multiplies by the cosine; 5 adds up; 6 divides by N; 7 is the surface's albedo. What does a white surface under a white sky read, and what should it?",
        "The mean over N directions is an integral only after division by the density, 1/π. And a diffuse surface of the flat world has the BRDF albedo/2.",
    ],
    source: include_str!("../../../examples/exercises/ex03_gather.rs"),
};

/// The surfaces that are asked about, and what is read.
const ASKED: [&str; 5] = [
    "a white surface under a white sky",
    "a surface of albedo 1/2 under a white sky",
    "a white surface tilted by 30 degrees",
    "a white surface with 4 directions",
    "a white surface under a sky that shadow rays do not find",
];

/// Two mistakes that are the same numbers in another order.
const AS_PRINTED: &str = "formula as printed";
const OF_SPACE: &str = "1/pi of space";

/// Its questions and mistakes.
pub fn exam() -> Exam<Gather> {
    let asked = questions().into_iter().filter(|exam| exam.bounces == 1);
    let ask = |(exam, what): (Asked, &'static str)| {
        Question::mean(what, exam.albedo.into(), move |gather: &Gather, draw| {
            gather(&mut Patient::new(&exam, draw.numbers().clone())).into()
        })
        .of(1 << 14)
    };
    let slip = |variant: mistakes::Variant| Mistake {
        name: variant.name,
        forgot: match variant.name {
            AS_PRINTED => {
                "both the density and the Lambert constant: albedo · (1/N) Σ L cos θ; or you took the 1/π of \
                 space for the 1/2 of the flat world, which reads the same"
            }
            _ => variant.forgot,
        },
        answer: Arc::new(move |p: &mut Patient<Flat>| p.ask(&variant)) as Gather,
    };
    let known = mistakes::all(Dimension::Flat).into_iter();
    let known = known.filter(|variant| variant.name != OF_SPACE);
    Exam::new(
        &ENTRY,
        asked.zip(ASKED).map(ask).collect(),
        known.map(slip).collect(),
    )
}
