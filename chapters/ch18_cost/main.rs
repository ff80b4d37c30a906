//! Chapter 18: What accuracy costs.
//!
//! Question: a picture is too noisy. How many samples does it lack, and what would they cost?
//! New here: `experiment::cost`, the folder's `noise`, `render::accuracy`, `render::stopping`. Simulates
//! what each integrator before it does. Builds on: chapters 3 (the error bar and its rate) and 7 to 11
//! (the integrators).

mod finale;
mod law;
mod maps;
mod needs;
mod noise;
mod prices;
mod steps;

use halfdisk::lab::chapter::{Chapter, Desk, DeskError};
use halfdisk::lab::ledger::Ledger;
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch18",
    title: "What accuracy costs",
    question: "A picture is too noisy. How many samples does it lack, and what would they cost?",
};

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    law::drawing(desk)?;

    // What a thousand samples more are worth, early and late.
    steps::falls(desk)?;
    let mut rays = steps::forty(desk)?;
    rays += steps::halves(desk)?;

    // Where samples are needed, and how many.
    rays += maps::box_of_noise(desk)?;
    rays += maps::four_scenes(desk)?;

    // What each way to make a picture asks for accuracy.
    let prices = prices::work(desk)?;
    rays += prices.rays;
    rays += needs::held_out(desk, &prices)?;
    rays += needs::target(desk, &prices)?;
    rays += finale::work(desk)?;

    let (variance, per_sample) = (prices.variance, prices.rays_per_sample);
    Ok(Ledger {
        rays,
        variance: Some(variance),
        compared: Some(prices.biases.into()),
        efficiency: Some(1.0 / (variance * per_sample)),
        ..Ledger::of(
            "The price list: half the error costs four times the rays, whoever makes the picture; who \
             makes it decides the rest.",
        )
    })
}
