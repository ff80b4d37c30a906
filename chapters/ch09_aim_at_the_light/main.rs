//! Chapter 9: Aim at the light.
//!
//! Question: a walk meets a small lamp hardly ever. What if it asked for the lamp's light instead?
//! New here: `integrators::next_event`. Simulates `L(S|D)*E`, of lamps without extent `LD(S|D)*E`.
//! Builds on: chapters 4 to 6 (the half disk, densities, direct light) and 7 (the walk).

mod figures;
mod finale;
mod geometry_term;
mod lamps;
mod pick_one;
mod rate;
mod shrinking_lamp;

use halfdisk::lab::chapter::{Chapter, Desk, DeskError};
use halfdisk::lab::estimators::walks::Walks;
use halfdisk::lab::ledger::Ledger;
use shrinking_lamp::Technique;
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch09",
    title: "Aim at the light",
    question: "A walk meets a small lamp hardly ever. What if it asked for the lamp's light instead?",
};

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    // The room is dim for a screen: shown with twice the light.
    desk.expose(1.0);
    // One lamp that shrinks over one surface: by chance until so many walks have found it.
    let finds = desk.choose(4_000.0, 2_500.0);
    let (of_sweep, rays_sweep) = figures::sweep(desk, finds)?;

    rate::chart(desk)?;

    // What aiming is, in the plane and in the box.
    geometry_term::drawing(desk)?;
    figures::shadow_rays(desk)?;
    let rays_boxes = figures::boxes(desk)?;

    // The mistake that everybody makes once.
    let rays_twice = lamps::twice(desk)?;

    // Eight lamps: ask all of them, or one.
    let count = desk.choose(100_000, 40_000);
    let (of_lamps, rays_lamps) = lamps::many(desk, count)?;

    // What cannot be aimed at.
    let (of_mirror, rays_mirror) = lamps::mirror(desk, count)?;

    // The bargain at a lamp a tenth of a radian wide to each side.
    let [chance, aim] = [Technique::Cosine, Technique::Aim]
        .map(|technique| shrinking_lamp::flat(technique, 0.1, 100_000, desk.options.seed));
    let (chance, aim) = (chance?, aim?);
    let price = |walks: &Walks| walks.squares.mean() * walks.rays_each();
    let gain = price(&chance) / price(&aim);
    let says = "half-angle 0.1: rays by chance for one ray with aiming, at equal error";
    desk.value("gain", says, figures::three(gain));
    let last = finale::work(desk)?;
    Ok(Ledger {
        rays: rays_sweep + rays_boxes + rays_twice + rays_lamps + rays_mirror + last,
        variance: Some(aim.squares.mean()),
        compared: Some(of_sweep.with(of_lamps).with(of_mirror).into()),
        efficiency: Some(1.0 / price(&aim)),
        ..Ledger::of(
            "One more ray for each lamp and surface; the smaller the lamp, the more it saves.",
        )
    })
}
