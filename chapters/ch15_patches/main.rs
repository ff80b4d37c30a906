//! Chapter 15: Patches.
//!
//! Question: must every pixel of every view ask for the light again, where the light of a diffuse room
//! depends on no view? New here: `radiosity`, form factors, a linear system and its solvers. Simulates
//! `LD*(S|G)*E`. Builds on: chapters 6 (the gather integral) and 12 (the path tracer).

mod drawing;
mod fight;
mod finale;
mod forms;
mod levels;
mod rates;
mod room;
mod shown;
mod solvers;
mod stays;

use halfdisk::lab::chapter::{Chapter, Desk, DeskError};
use halfdisk::lab::ledger::Ledger;
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch15",
    title: "Patches",
    question: "A diffuse room looks the same from everywhere. Can its light be solved once, for all views?",
};

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    // The room is dim for a screen: shown with twice the light.
    desk.expose(1.0);
    // How much of each other two patches see.
    drawing::patches(desk)?;
    forms::work(desk)?;

    // The cube whose ceiling shines: errors, sweeps, shots.
    rates::work(desk)?;
    solvers::work(desk)?;

    // The box with its blocks, as patches and gathered.
    let drawn = shown::work(desk)?;

    // What samples take away, and what they leave.
    let levelled = levels::work(desk)?;

    // Against paths.
    let fight = fight::work(desk)?;
    let last = finale::work(desk)?;

    Ok(Ledger {
        rays: drawn + levelled + fight + last,
        ..Ledger::of(
            "One system of equations holds the light of a diffuse room for every view. It costs the square \
             of the patches in memory, and its error is that of the patches, which no sample takes away.",
        )
    })
}
