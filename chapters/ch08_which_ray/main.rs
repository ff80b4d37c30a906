//! Chapter 8: Which ray?
//!
//! Question: a surface scatters, mirrors and lets through; which of the three does one ray follow?
//! New here: `integrators::WhichRay`, `materials::Choice`. Simulates `L(S|D)*E`.
//! Builds on: chapter 2 (the tree), chapter 7 (one ray in its place).

mod figures;
mod finale;
mod furnaces;
mod mixed_furnace;
mod rate;

use figures::z;
use halfdisk::integrators::{Integrator, WhichRay};
use halfdisk::lab::chapter::{Chapter, Desk, DeskError};
use halfdisk::lab::ledger::Ledger;
use halfdisk::materials::Choice;
use halfdisk::render::{Options, Rendered, render};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::{Scene, Tracer, gallery};
use halfdisk::stats::Estimate;
use rayon::prelude::*;
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch08",
    title: "Which ray?",
    question: "A surface scatters, mirrors and lets through: which of the three does one ray follow?",
};

/// The rules of choice, their names in data, and in charts.
const RULES: [(Choice, &str, &str); 4] = [
    (Choice::Equal, "equal", "alike"),
    (Choice::ByMean, "mean", "by mean"),
    (Choice::ByLuminance, "luminance", "by luminance"),
    (Choice::Analog, "analog", "or absorbed"),
];

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    let seed = desk.options.seed;
    // The picture, and which ray each of its pixels would follow first.
    let scene = gallery::load("mixture")?;
    let max_depth = scene.suggested.max_depth;
    let which = |choice| WhichRay { max_depth, choice };
    let whole = picture(desk, &scene, &which(Choice::ByMean), desk.spp(12, 2), seed)?;
    let caption = "Three materials in the corners, each two halved between them, all three in the \
                   middle.";
    desk.picture("image.png", caption, &whole.film, &scene)?;
    let first = figures::FirstChoice(which(Choice::ByMean));
    let map = picture(desk, &scene, &first, desk.spp(6, 4), seed)?;
    let caption = "How often the first ray chosen is diffuse (orange), specular (blue), transmitted \
                   (green).";
    desk.picture("choices.png", caption, &map.film, &scene)?;

    // How often each kind is chosen, and what a furnace reads.
    let mut compared = furnaces::frequencies(desk).with(furnaces::readings(desk));
    compared = compared.with(furnaces::variances(desk)?);
    compared = compared.with(furnaces::two_ways_to_lose(desk));
    furnaces::growth(desk)?;

    // ANCHOR: slab
    // The slab of chapter 2: there every ray split, here each path takes one way.
    let slab = gallery::load("slab")?;
    let path = WhichRay {
        max_depth: 32,
        choice: Choice::ByMean,
    };
    let paths = desk.choose(100_000, 85_000);
    let straight = slab.camera.ray(0.5, 0.5);
    let one = |i| {
        let mut tracer = Tracer::new(&slab);
        let li = path.li(&mut tracer, &straight, &Stream::new(seed, i, 0));
        (li, tracer.counts().total())
    };
    let found: Vec<_> = (0..paths).into_par_iter().map(one).collect();
    let through: Estimate = found.iter().map(|(li, _)| f64::from(li.r)).collect();
    let back: Estimate = found.iter().map(|(li, _)| f64::from(li.g)).collect();
    // ANCHOR_END: slab
    let slab_rays: u64 = found.iter().map(|(_, rays)| rays).sum();
    for (name, read, exact) in [
        ("through", through, 12.0 / 13.0),
        ("back", back, 1.0 / 13.0),
    ] {
        let says = format!("glass slab: share of light that comes {name}");
        desk.estimate(&format!("slab_{name}"), &says, &read, Some(exact));
        compared.add(z(&read, exact));
    }
    let per_path: Estimate = found.iter().map(|(_, rays)| *rays as f64).collect();
    let says = "glass slab: rays of a path";
    desk.estimate("slab_rays", says, &per_path, Some(3.0));

    // The same picture by each rule: the light is the same, the variance is not.
    let small = gallery::load("mixture")?.sized([48, 48]);
    let mut spent = whole.rays.total() + map.rays.total() + slab_rays + finale::work(desk)?;
    let mut bargain = [0.0; 2];
    for (choice, name, called) in RULES {
        let mut variance = Estimate::new();
        let mut rays = Estimate::new();
        for batch in 0..4 {
            let own = seed.wrapping_mul(1000).wrapping_add(batch);
            let spp = desk.choose(24, 8);
            let part = picture(desk, &small, &which(choice), spp, own)?;
            variance.add(part.film.sample_variance());
            rays.add(part.rays.total() as f64 / part.rays.camera as f64);
            spent += part.rays.total();
        }
        let says = format!("picture: variance of a sample, chosen {called}");
        desk.estimate(&format!("picture_{name}"), &says, &variance, None);
        let says = format!("picture: rays of a sample, chosen {called}");
        desk.estimate(&format!("picture_rays_{name}"), &says, &rays, None);
        if choice == Choice::ByMean {
            bargain = [variance.mean(), rays.mean()];
        }
    }

    Ok(Ledger {
        rays: spent,
        variance: Some(bargain[0]),
        compared: Some(compared.into()),
        efficiency: Some(1.0 / (bargain[0] * bargain[1])),
        ..Ledger::of(
            "One ray instead of three, for a weight k/p and the variance of a choice; for grey \
             shares that variance is none.",
        )
    })
}

/// A scene seen by an integrator.
fn picture(
    desk: &Desk,
    scene: &Scene,
    integrator: &impl Integrator,
    spp: u32,
    seed: u64,
) -> Result<Rendered, DeskError> {
    let options = Options {
        spp,
        seed,
        ..Options::default()
    };
    let rendered = render(scene, integrator, &options, &desk.bar("which ray"));
    if rendered.interrupted {
        return Err(DeskError::Interrupted);
    }
    Ok(rendered)
}
