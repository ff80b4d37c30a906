//! Chapter 1: From the eye.
//!
//! Question: light goes from the lamp to the eye; why do ray tracers go the other way?
//! New here: the folder's `aperture` and `two_ways`. Simulates `LE` and `LDE`.

mod aperture;
mod figures;
mod prices;
mod two_ways;

use aperture::{count_through_disc, count_through_slit, disc_chance, slit_chance};
use halfdisk::lab::chapter::{Chapter, Desk, DeskError, Number};
use halfdisk::lab::ledger::Ledger;
use halfdisk::scene::gallery;
use halfdisk::stats::Estimate;
use halfdisk::stats::z_test::Largest;
use std::process::ExitCode;
use two_ways::{Traced, TwoWays};

const CHAPTER: Chapter = Chapter {
    id: "ch01",
    title: "From the eye",
    question: "Light goes from the lamp to the eye. Why do ray tracers go the other way?",
};

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    let seed = desk.options.seed;

    // ANCHOR: counts
    // How many of a million rays from a lamp enter an eye three units away?
    let (rays, distance) = (1_000_000, 3.0);
    let mut compared = Largest::default();
    for (name, width) in [("slit", 0.4), ("slit_doubled", 0.8), ("slit_pinhole", 0.0)] {
        let hits = count_through_slit(width, distance, rays, seed);
        let chance = slit_chance(width.into(), distance.into());
        let says = format!("flat world: rays through a slit of width {width}");
        compared.add(counted(desk, name, &says, &hits, chance));
    }
    for (name, radius) in [("disc", 0.2), ("disc_doubled", 0.4), ("disc_pinhole", 0.0)] {
        let hits = count_through_disc(radius, distance, rays, seed);
        let chance = disc_chance(radius.into(), distance.into());
        let says = format!("space: rays through a disc of radius {radius}");
        compared.add(counted(desk, name, &says, &hits, chance));
    }
    // ANCHOR_END: counts
    figures::drawings(desk)?;

    // The same view both ways, with the same number of rays: first few, then many.
    let scene = gallery::load("lamp")?;
    let view = TwoWays::new(&scene, 0.5)?;
    let pictures = view.both(desk.spp(800, 400), seed);
    desk.value(
        "picture_rays",
        "rays traced for each picture",
        pictures[0].rays as f64,
    );
    figures::pictures(desk, &scene, &pictures)?;
    let [light, eye] = view.both(desk.choose(4_000, 2_000), seed);
    let wasted = (light.rays - light.useful) as f64 / light.useful as f64;
    desk.value(
        "useful",
        "rays from the light that entered the eye",
        light.useful as f64,
    );
    desk.value("wasted", "rays wasted for each of them", wasted);
    agreement(desk, &light, &eye);

    // What the same error costs either way, against a reference from other random numbers.
    let reference = view.picture_by_eye(desk.choose(1_024, 512), seed + 1);
    let (doublings, replicates) = desk.choose((5, 3), (3, 3));
    let prices = prices::measure(&view, &reference.film, doublings, replicates, seed + 2);
    prices::record(desk, &prices);
    figures::chart(desk, &prices)?;
    let last = figures::finale(desk)?;

    let variance = eye.film.sample_variance();
    Ok(Ledger {
        rays: 6 * u64::from(rays) + light.rays + eye.rays + reference.rays + last,
        variance: Some(variance),
        compared: Some(compared.into()),
        efficiency: Some(1.0 / (2.0 * variance)),
        ..Ledger::of(&format!(
            "From the eye no ray is lost; from the light {wasted:.0} are, for each that arrives."
        ))
    })
}

/// Records a count beside its prediction; how many standard errors it is away from it.
fn counted(desk: &mut Desk, name: &str, says: &str, hits: &Estimate, chance: f64) -> f64 {
    let rays = hits.count() as f64;
    let (found, expected) = (hits.mean() * rays, chance * rays);
    // The error that theory gives a count, so that a count of zero has one too.
    let error = (expected * (1.0 - chance)).sqrt();
    let number = Number::new(says, found).exact(expected).unit("rays");
    desk.number(
        name,
        Number {
            error: Some(error),
            ..number
        },
    );
    if found == expected {
        0.0
    } else {
        (found - expected).abs() / error
    }
}

/// Records how far the two pictures are apart.
fn agreement(desk: &mut Desk, light: &Traced, eye: &Traced) {
    let ((a, error_a), (b, error_b)) = (light.film.mean(), eye.film.mean());
    let error = (error_a * error_a + error_b * error_b).sqrt();
    let mean = Number::new("mean of the picture from the light, and from the eye", a).exact(b);
    desk.number(
        "mean",
        Number {
            error: Some(error),
            ..mean
        },
    );
}
