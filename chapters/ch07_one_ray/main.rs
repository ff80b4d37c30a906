//! Chapter 7: One ray, not a tree.
//!
//! Question: must a surface be asked in sixteen directions, when each answer asks sixteen more?
//! New here: `integrators::kajiya`. Simulates `L(S|D)*E` of lamps with extent.
//! Builds on: chapters 3 (chance), 4 (the half disk) and 6 (the tree, and direct light).

mod compare;
mod figures;
mod finale;
mod rate;
mod split;

use glam::Vec2;
use halfdisk::flatland::{self, exact};
use halfdisk::integrators::{Integrator, Kajiya};
use halfdisk::lab::chapter::{Chapter, Desk, DeskError};
use halfdisk::lab::estimators::directions::Recipe;
use halfdisk::lab::estimators::gather::Gather;
use halfdisk::lab::estimators::walks;
use halfdisk::lab::ledger::Ledger;
use halfdisk::notation::Expression;
use halfdisk::render::{Options, Rendered, render};
use halfdisk::scene::{Scene, gallery};
use halfdisk::space::{Flat, Ray};
use halfdisk::stats::z_test::Largest;
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch07",
    title: "One ray, not a tree",
    question: "Must a surface be asked in sixteen directions, when each answer asks sixteen more?",
};

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    // The room is dim for a screen: shown with twice the light.
    desk.expose(1.0);
    figures::tree_and_path(desk)?;
    let mut compared = Largest::default();
    let (z_room, variance, rays_room) = room(desk)?;
    rate::chart(desk, variance)?;
    let (z_tree, rays_tree) = compare::tree_and_paths(desk)?;
    [z_room, z_tree].into_iter().for_each(|z| compared.add(z));
    let rays_split = compare::splitting(desk)?;
    let side = desk.choose(72, 40);
    let scene = gallery::load("cornell")?.sized([side; 2]);
    let rays_forty = figures::forty_paths(desk, &scene)?;
    let rays_noise = figures::noise(desk, 6)?;
    let rays_edge = figures::edge(desk)?;
    reach(desk)?;
    let last = finale::work(desk)?;
    Ok(Ledger {
        rays: rays_room + rays_tree + rays_split + rays_forty + rays_noise + rays_edge + last,
        variance: Some(variance),
        compared: Some(compared.into()),
        efficiency: Some(1.0 / (variance * f64::from(SEGMENTS))),
        ..Ledger::of(
            "A path costs as many rays as it has segments, where a tree costs a power of them.",
        )
    })
}

/// Segments of the longest path in the flat room: what further ones would add is below 10⁻⁷.
const SEGMENTS: u32 = 24;

/// The flat room whose answer is known: distance from it, variance of one path, and rays.
fn room(desk: &mut Desk) -> Result<(f64, f64, u64), DeskError> {
    let (room, truth) = (flatland::load("room")?, exact::ROOM_FLOOR);
    let (count, seed) = (desk.choose(100_000, 50_000), desk.options.seed);
    let eye = Ray::<Flat>::new(Vec2::splat(0.5), Vec2::NEG_Y);
    // ANCHOR: room
    let max_depth = SEGMENTS;
    let found = walks::flat(&room, truth, count, seed, |world, stream| {
        Kajiya { max_depth }.walk(world, &eye, stream)
    });
    // ANCHOR_END: room
    desk.estimate(
        "room",
        "the middle of the flat room's floor",
        &found.estimate,
        Some(truth),
    );
    desk.known(
        "room_rays",
        "  rays of a path",
        found.rays_each(),
        f64::from(max_depth),
    );
    for bounces in [2, 4] {
        let tree = Gather {
            samples: 16,
            depth: bounces,
            recipe: Recipe::Cosine,
        };
        let says = format!("rays of a tree of sixteen, {bounces} bounces");
        desk.value(&format!("tree_rays_{bounces}"), &says, tree.rays() as f64);
        let path = walks::flat(&room, truth, 1, seed, |world, stream| {
            let max_depth = bounces + 1;
            Kajiya { max_depth }.walk(world, &eye, stream)
        });
        let exact = f64::from(bounces + 1);
        desk.known(
            &format!("path_rays_{bounces}"),
            "  of a path",
            path.rays as f64,
            exact,
        );
    }
    let z = found.estimate.z(truth);
    Ok((z, found.estimate.variance(), found.rays))
}

/// What the walk reaches that a tree of mirrors does not.
fn reach(desk: &Desk) -> Result<(), DeskError> {
    let parse = |text: &str| -> Result<Expression, DeskError> {
        text.parse()
            .map_err(|e| DeskError::Missing(format!("{text}: {e}")))
    };
    let (walk, tree) = (parse("L(S|D)*E")?, parse("LD?S*E")?);
    let more = walk.light_first().difference(tree.light_first());
    let words: Vec<String> = more.shortest(5).iter().map(|w| w.to_string()).collect();
    desk.say(&format!(
        "paths that Whitted's tree lacks: {}",
        words.join(", ")
    ));
    Ok(())
}

/// A picture, from a seed of its own.
fn picture(
    desk: &Desk,
    scene: &Scene,
    integrator: &impl Integrator,
    spp: u32,
    number: u64,
) -> Result<Rendered, DeskError> {
    let options = Options {
        spp,
        seed: desk.options.seed + number,
        ..Options::default()
    };
    let rendered = render(scene, integrator, &options, &desk.bar("render"));
    if rendered.interrupted {
        return Err(DeskError::Interrupted);
    }
    Ok(rendered)
}
