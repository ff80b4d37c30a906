//! Chapter 11: Combine.
//!
//! Question: two ways find the same light, and each fails where the other does well. Which one?
//! New here: `integrators::combine`, `sampling::mis`, `estimators::overhead`. Simulates
//! `L(S|G|D)*E`, every light found in two ways. Builds on: chapter 7 (chance) and 9 (aiming).

mod figures;
mod finale;
mod plates;
mod rate;
mod readings;
mod sweep;

use halfdisk::lab::chapter::{Chapter, Desk, DeskError};
use halfdisk::lab::ledger::Ledger;
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch11",
    title: "Combine",
    question: "Two ways find the same light, and each fails where the other does well. Which one?",
};

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    // One lamp in the flat world, from a spark to most of the sky.
    let sweep = sweep::work(desk)?;
    figures::sweep(desk, &sweep)?;
    sweep::by_length(desk);
    rate::chart(desk)?;

    // Four lamps over four plates in space.
    let drawn = plates::work(desk)?;

    // Where every wall is a lamp, everyone must read the same.
    let (rays, in_furnace) = readings::furnace(desk)?;
    readings::mistakes(desk)?;
    let last = finale::work(desk)?;

    let (variance, premium) = (sweep.at_one, sweep.premium);
    Ok(Ledger {
        rays: sweep.rays + drawn + rays + last,
        variance: Some(variance),
        compared: Some(sweep.compared.with(in_furnace).into()),
        // A ray from the eye, one to the lamp, one by chance.
        efficiency: Some(1.0 / (3.0 * variance)),
        ..Ledger::of(&format!(
            "Nobody has to know which technique is the better one: at worst the variance of both \
             together lies {premium:.2} squared means above it, where the wrong choice lies {:.0} \
             above.",
            sweep.stake
        ))
    })
}
