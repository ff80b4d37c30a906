//! Chapter 19: Full path tracing: only what the scene asks for.
//!
//! Question: what must be simulated for this scene, what need not be, and what does the rest cost?
//! New here: `effects`, `halfdisk effects`. Simulates `L(D|S|G)*E`, of which each scene asks for a
//! part. Builds on: all chapters.

mod finale;
mod pictures;
mod race;
mod report;
mod savings;
mod unseen;

use halfdisk::lab::chapter::{Chapter, Desk, DeskError};
use halfdisk::lab::ledger::Ledger;
use halfdisk::scene::{Scene, SceneError, gallery};
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch19",
    title: "Full path tracing: only what the scene asks for",
    question: "What must be simulated for this scene, what need not be, and what does the rest cost?",
};

/// The scene of this chapter.
const ROOM: &str = "room";

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    // What the scene calls for, by reading it.
    report::of_room(desk)?;
    let asked = report::point_through_glass(desk)? + unseen::pictures(desk)?;

    // The room is dim for a screen: shown with twice the light.
    desk.expose(1.0);
    // The picture, and what each class of paths has of it.
    let drawn = pictures::work(desk)?;

    // What each effect brings, and what it costs to leave absent ones at work.
    let measured = savings::worth(desk)? + savings::absent(desk)?;

    // Every integrator of the book on this scene.
    let race = race::work(desk)?;

    // All of it together.
    let last = finale::work(desk)?;
    Ok(Ledger {
        rays: asked + drawn.rays + measured + race.rays + last,
        variance: Some(drawn.variance),
        efficiency: Some(1.0 / (drawn.variance * drawn.per_sample)),
        ..Ledger::of(&format!(
            "Half of the effects are absent here, known by reading the scene, and no ray is spent on \
             them. A random walk alone pays {:.0} times the rays for the same error.",
            race.gain
        ))
    })
}

/// The scene in another size.
fn load(name: &str, size: [u32; 2]) -> Result<Scene, SceneError> {
    gallery::load(name).map(|scene| scene.sized(size))
}
