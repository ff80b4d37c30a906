//! Chapter 16: Photons.
//!
//! Question: a caustic is found hardly ever from the eye. What if light started at the lamp? New here:
//! `light-tracer`, `photons`, density estimation and its bias. Simulates `L(D|S|G)*E`, blurred. Builds on:
//! chapter 4 (the half disk), 11 (combine) and 14 (the alphabet).

mod caustics;
mod density;
mod fight;
mod finale;
mod landing;
mod rates;
mod sweep;
mod unseen;
mod window;

use halfdisk::lab::chapter::{Chapter, Desk, DeskError};
use halfdisk::lab::ledger::Ledger;
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, gallery};
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch16",
    title: "Photons",
    question: "A lamp sends light through glass onto the floor, and no ray from the eye finds it. What if light started at \
               the lamp?",
};

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    // Where photons land, in both worlds.
    landing::work(desk)?;

    // A window on a line: bias, variance, edges, the nearest.
    density::work(desk)?;
    rates::work(desk)?;

    // Where light goes that mirrors and glass focus.
    caustics::work(desk)?;

    // The radius in pictures, the light that nobody else sees, and who is the faster.
    let swept = sweep::work(desk)?;
    let unseen = unseen::work(desk)?;
    let fought = fight::work(desk)?;
    let last = finale::work(desk)?;

    Ok(Ledger {
        rays: swept + unseen + fought + last,
        ..Ledger::of(
            "Light that starts at the lamp finds every caustic, also of a point and seen in a mirror. Where photons are \
             counted on discs the noise of caustics falls to a fraction, and a blur comes in its place that falls as slowly.",
        )
    })
}

/// A scene of this chapter.
fn scene(file: &'static str, text: &str) -> Result<Scene, DeskError> {
    Ok(gallery::from_text(Source { file, text }, None, |_| {})?)
}
