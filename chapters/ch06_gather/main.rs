//! Chapter 6: The gather integral.
//!
//! Question: what does a room look like when every wall lights every other?
//! New here: `estimators::gather` in `Solid`, and in scenes. Simulates `LD{1,4}E`.
//! Builds on: chapters 4 and 5 (the same source in the flat world; directions).

mod figures;
mod finale;
mod rate;

use glam::Vec3;
use halfdisk::lab::chapter::{Chapter, Desk, DeskError};
use halfdisk::lab::estimators::directions::Recipe;
use halfdisk::lab::estimators::furnace::{self, irradiance};
use halfdisk::lab::estimators::gather::Gather;
use halfdisk::lab::estimators::worlds::{Sky, ball};
use halfdisk::lab::ledger::Ledger;
use halfdisk::render::{Options, Rendered, render};
use halfdisk::scene::{Scene, gallery};
use halfdisk::space::Solid;
use halfdisk::stats::z_test::Largest;
use std::f64::consts::PI;
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch06",
    title: "The gather integral",
    question: "What does a room look like when every wall lights every other?",
};

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    let seed = desk.options.seed;
    // The room is dim for a screen: shown with twice the light.
    desk.expose(1.0);
    // The Cornell box with four directions at each surface, up to three bounces between walls.
    let scene = gallery::load("cornell")?.sized([desk.choose(96, 88); 2]);
    let mut pictures = Vec::new();
    for depth in 0..=3 {
        pictures.push(picture(desk, &scene, depth)?);
    }
    figures::pictures(desk, &scene, &pictures)?;

    let bleeding = figures::bleeding(desk, &scene, desk.choose(8_000, 3_000))?;

    // ANCHOR: bounces
    // A room whose walls all glow: bounce k adds the k-th power of the albedo.
    let mut compared = Largest::default();
    let (albedo, walks) = (0.5, desk.choose(150_000, 50_000));
    for k in 0..=3 {
        let read = furnace::bounce::<Solid>(Recipe::Uniform, albedo, k, walks, seed);
        let exact = f64::from(albedo).powi(k as i32);
        let says = format!("glowing room: what bounce {k} adds");
        desk.estimate(&format!("bounce_{k}"), &says, &read, Some(exact));
        compared.add(read.z(exact));
    }
    // ANCHOR_END: bounces

    // Lamps one above a floor, found by chance: irradiances with known answers.
    let disk = |w: Vec3| f32::from(w.y > 0.0 && w.x * w.x + w.z * w.z < w.y * w.y);
    let square = |w: Vec3| f32::from(w.y > 0.0 && w.x.abs().max(w.z.abs()) < 0.5 * w.y);
    let samples = desk.choose(200_000, 100_000);
    let ball = irradiance::<Solid, _>(ball::<Solid>(0.5, 0.0), samples, seed);
    let disk = irradiance::<Solid, _>(Sky(disk), samples, seed);
    let square = irradiance::<Solid, _>(Sky(square), samples, seed);
    for (name, says, read, exact) in [
        ("sphere", "a sphere half as large as far", ball, PI / 4.0),
        ("disk", "a disc as large as far", disk, PI / 2.0),
        ("square", "a unit square one above", square, 0.752_274_688),
    ] {
        let says = format!("irradiance from {says}");
        desk.estimate(name, &says, &read, Some(exact));
        compared.add(read.z(exact));
    }

    figures::growth(desk, seed)?;
    let in_trees = rate::chart(desk)?;
    let ending = finale::work(desk)?;

    let last = pictures
        .pop()
        .map_or_else(Default::default, |p| (p.film.sample_variance(), p.rays));
    let (variance, rays) = last;
    let per_sample = rays.total() as f64 / rays.camera.max(1) as f64;
    let drawn: u64 = pictures.iter().map(|p| p.rays.total()).sum();
    Ok(Ledger {
        rays: drawn + rays.total() + bleeding + 3 * u64::from(samples) + in_trees + ending,
        variance: Some(variance),
        compared: Some(compared.into()),
        efficiency: Some(1.0 / (variance * per_sample)),
        ..Ledger::of(&format!(
            "Every wall lights every other, for {per_sample:.0} rays a sample: each further bounce \
             costs four times the rays and adds less light."
        ))
    })
}

/// The box with up to `depth` bounces between walls.
fn picture(desk: &Desk, scene: &Scene, depth: u32) -> Result<Rendered, DeskError> {
    let gather = Gather {
        samples: 4,
        depth,
        recipe: Recipe::Cosine,
    };
    let options = Options {
        spp: desk.spp(3, 2),
        seed: desk.options.seed,
        ..Options::default()
    };
    let rendered = render(scene, &gather, &options, &desk.bar("gather"));
    if rendered.interrupted {
        return Err(DeskError::Interrupted);
    }
    Ok(rendered)
}
