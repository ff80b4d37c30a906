//! Chapter 4: The half disk.
//!
//! Question: how much light falls on a point, when it may come from everywhere above it?
//! New here: `estimators::gather` in `Flat`. Simulates `LD+E` in a flat world, cut off at a depth.
//! Builds on: chapter 3 (estimates and their errors).

mod figures;
mod finale;
mod plane_world;
mod radiometry;

use halfdisk::flatland::{FlatHit, FlatWorld, exact, load};
use halfdisk::lab::chapter::{Chapter, Desk, DeskError};
use halfdisk::lab::estimators::directions::Recipe;
use halfdisk::lab::estimators::gather::Gather;
use halfdisk::lab::experiment::convergence::{Convergence, Design, converge};
use halfdisk::lab::experiment::named;
use halfdisk::lab::ledger::Ledger;
use halfdisk::lab::mistakes::{self, Exam};
use halfdisk::space::Dimension;
use std::f64::consts::{FRAC_2_PI, PI};
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch04",
    title: "The half disk",
    question: "How much light falls on a point, when it may come from everywhere above it?",
};

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    let seed = desk.options.seed;
    radiometry::drawings(desk)?;
    figures::drawings(desk)?;

    // What each slip reads under a white sky, where the answer is the albedo.
    let gathers = desk.choose(200_000, 40_000);
    figures::readings(desk, gathers);

    let mut compared = radiometry::numbers(desk);
    // ANCHOR: lamp
    // A lamp over a floor: the essay's formula as it stands, and the seven steps.
    let lamp = load("lamp")?;
    let floor = probe(&lamp)?;
    let samples = desk.choose(500_000, 100_000);
    let walk = Gather {
        samples: 1,
        depth: 1,
        recipe: Recipe::Uniform,
    };
    let truth = 0.5 * f64::from(floor.albedo.r) * exact::segment(1.0, figures::LAMP);
    let read = plane_world::reflected(&lamp, &floor, &walk, samples, seed);
    desk.estimate(
        "segment",
        "a lamp over a floor: the seven steps",
        &read,
        Some(truth),
    );
    let printed = plane_world::reflected_as_printed(&lamp, &floor, samples, seed);
    let says = "a lamp over a floor: the formula as printed";
    desk.estimate("segment_printed", says, &printed, Some(FRAC_2_PI * truth));
    // ANCHOR_END: lamp
    compared.add(read.z(truth));

    // ANCHOR: room
    // A room whose ceiling shines: the gather asks itself at each hit, forty surfaces deep.
    let room = load("room")?;
    let middle = probe(&room)?;
    let deep = Gather { depth: 40, ..walk };
    let walks = desk.choose(60_000, 30_000);
    let read = plane_world::reflected(&room, &middle, &deep, walks, seed);
    let says = "a room with a shining ceiling: middle of the floor";
    desk.estimate("room", says, &read, Some(exact::ROOM_FLOOR));
    // ANCHOR_END: room
    compared.add(read.z(exact::ROOM_FLOOR));

    // More rays help the right estimator, not the wrong one.
    let design = Design {
        replicates: desk.choose(256, 64),
        doublings: desk.choose(10, 8),
        seed,
        ..Design::default()
    };
    let runs: Vec<Convergence> = ["half-disk", "half-disk-literal"]
        .into_iter()
        .filter_map(named::find)
        .map(|estimator| converge(&estimator, &design))
        .collect();
    figures::convergence(desk, &runs)?;

    let last = finale::work(desk)?;

    let one = Exam {
        samples: 1,
        ..Exam::default()
    };
    let right = mistakes::right(Dimension::Flat);
    let variance = right.measure(&one, gathers, seed).variance();
    let says = "standard deviation of one direction, white sky";
    let exact = (PI * PI / 8.0 - 1.0).sqrt();
    desk.known("sigma", says, variance.sqrt(), exact);
    Ok(Ledger {
        rays: 2 * u64::from(samples) + u64::from(walks) * 41 + 7 * 16 * u64::from(gathers) + last,
        variance: Some(variance),
        compared: Some(compared.into()),
        efficiency: Some(1.0 / variance),
        ..Ledger::of(
            "Light from everywhere, by rays in random directions: one answer that four lines can \
             check, for an error that falls as one over the root of the rays.",
        )
    })
}

/// The point that a world's file asks about.
fn probe(world: &FlatWorld) -> Result<FlatHit, DeskError> {
    world
        .probe
        .ok_or_else(|| DeskError::Missing(format!("{} has no probe", world.name)))
}
