//! Chapter 12: The path tracer.
//!
//! Question: aiming, weights and roulette each mend one fault. What do they give together, and which of them is
//! worth its rays where?
//! New here: `integrators::path`. Simulates `L(S|G|D)*E`. Builds on: chapters 7, 9, 10 and 11.

mod agree;
mod checks;
mod figures;
mod furnace;
mod left_out;
mod price;
mod rate;

use halfdisk::lab::chapter::{Chapter, Desk, DeskError};
use halfdisk::lab::ledger::Ledger;
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch12",
    title: "The path tracer",
    question: "Aiming, weights and roulette each mend one fault. What do they give together, and which is worth its \
               rays where?",
};

/// Segments of the longest path, where nothing else is said: what longer ones bring is far below any error here.
const SEGMENTS: u32 = 64;

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    // The room is dim for a screen: shown with twice the light.
    desk.expose(1.0);
    figures::idea(desk)?;
    let says = "segments of the longest path";
    desk.value("segments", says, f64::from(SEGMENTS));
    let (in_closed_form, checked) = checks::work(desk)?;
    let (in_furnace, glowed) = furnace::work(desk)?;
    let charted = rate::chart(desk)?;
    let pictures = figures::pictures(desk)?;
    let agreed = agree::work(desk)?;
    let saved = price::work(desk)?;
    let last = figures::finale(desk)?;
    Ok(Ledger {
        rays: checked + glowed + charted + pictures + agreed.rays + saved.rays + last,
        variance: Some(agreed.variance),
        compared: Some(in_closed_form.with(in_furnace).into()),
        efficiency: Some(1.0 / (agreed.variance * agreed.per_sample)),
        ..Ledger::of(&format!(
            "One walk for all scenes. For the same error, shadow rays save {:.0} times the rays in the box, weights {:.0} \
             times among glossy plates, roulette {:.1} times, and the choice of one lamp of 64 saves {:.0} times.",
            saved.aiming, saved.weights, saved.roulette, saved.choice
        ))
    })
}
