//! Chapter 10: Roulette.
//!
//! Question: light bounces for ever and a program must end. How does it end without a lie?
//! New here: `integrators::roulette`, the folder's `survival`. Simulates `L(S|G|D)*E` without a
//! depth cut. Builds on: chapter 7 (one ray, not a tree).

mod figures;
mod finale;
mod furnace;
mod pictures;
mod survival;

use halfdisk::flatland::gallery;
use halfdisk::integrators::world::FlatTracer;
use halfdisk::integrators::{Kajiya, Roulette, Survival};
use halfdisk::lab::chapter::{Chapter, Desk, DeskError, Number};
use halfdisk::lab::estimators::worlds::{Counted, Furnace};
use halfdisk::lab::ledger::Ledger;
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::read::Source;
use halfdisk::space::{Flat, Ray};
use halfdisk::stats::Estimate;
use std::process::ExitCode;
use survival::Game;

const CHAPTER: Chapter = Chapter {
    id: "ch10",
    title: "Roulette",
    question: "Light bounces for ever and a program must end. How does it end without a lie?",
};

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    // What a depth cut loses, for ever.
    furnace::cuts(desk);

    // Roulette loses nothing; what it costs depends on the chance to survive.
    let played = furnace::survivals(desk);
    let mut rays = played.rays;
    rays += figures::plateau(desk)?;
    rays += figures::running(desk)?;
    figures::wall(desk, played.prices)?;
    furnace::clamps(desk);
    furnace::needed(desk);
    endless(desk);

    // A room, and a floor, where survival follows what a path carries.
    let picture = pictures::work(desk)?;
    dark_floor(desk)?;
    rays += finale::work(desk)?;

    let game = Game {
        albedo: 0.8,
        survival: 0.9,
    };
    Ok(Ledger {
        rays: rays + picture.rays,
        variance: Some(game.variance()),
        compared: Some(played.compared.into()),
        efficiency: Some(1.0 / game.price()),
        ..Ledger::of(&format!(
            "No light is lost, whatever the depth. In the box, survival by what a path carries buys \
             {:.2} times the certainty per ray of the best constant tried.",
            picture.gain
        ))
    })
}

/// Between white walls nothing is ever lost, and a walk ends all the same.
fn endless(desk: &mut Desk) {
    let walks = desk.choose(50_000, 10_000);
    let roulette = Roulette {
        survival: Survival::Throughput(0.05),
    };
    let one = |i| {
        let mut room = Counted::new(Furnace { albedo: 1.0 });
        let stream = Stream::new(desk.options.seed, i, 5);
        roulette.walk::<Flat>(&mut room, &Furnace::eye(), &stream);
        room.rays as f64
    };
    let segments: Estimate = (0..walks).map(one).collect();
    let says = "segments of a walk between white walls";
    desk.estimate("white_segments", says, &segments, Some(20.0));
}

// ANCHOR: dark_floor
/// A dark floor under a white sky: two segments are the whole answer, and roulette spoils it.
fn dark_floor(desk: &mut Desk) -> Result<(), DeskError> {
    let text = "name = 'dark'\nbackground = 1\n\
                [[objects]]\nalbedo = 0.05\nsegment = { from = [-1, 0], to = [1, 0] }";
    let world = gallery::from_text(Source { file: "dark", text })?;
    let eye = Ray::<Flat>::new(glam::Vec2::Y, glam::Vec2::NEG_Y);
    // ANCHOR_END: dark_floor
    let walks = desk.choose(120_000, 40_000);
    let roulette = Roulette {
        survival: Survival::Throughput(0.05),
    };
    for (name, says, cut) in [
        ("cut", "two segments", true),
        ("roulette", "roulette", false),
    ] {
        let mut floor = FlatTracer::new(&world);
        let one = |i| {
            let stream = Stream::new(desk.options.seed, i, 6);
            let li = if cut {
                Kajiya { max_depth: 2 }.walk(&mut floor, &eye, &stream)
            } else {
                roulette.walk(&mut floor, &eye, &stream)
            };
            f64::from(li.r)
        };
        let read: Estimate = (0..walks).map(one).collect();
        let truth = Some(0.05);
        desk.estimate(
            &format!("dark_{name}"),
            &format!("dark floor, {says}"),
            &read,
            truth,
        );
        let exact = if cut { 0.0 } else { 0.05 * 0.95 };
        let number = Number::new(&format!("its variance, {says}"), read.variance());
        desk.number(&format!("dark_variance_{name}"), number.exact(exact));
        let per_walk = floor.rays as f64 / f64::from(walks);
        desk.value(
            &format!("dark_rays_{name}"),
            &format!("its rays, {says}"),
            per_walk,
        );
    }
    Ok(())
}
