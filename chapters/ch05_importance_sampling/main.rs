//! Chapter 5: Importance sampling.
//!
//! Question: some directions matter more than others; can the random numbers know?
//! New here: `sampling::{half_disk, hemisphere}` and their strata, `stats::chi_square`. Simulates
//! one gather of `LDE` under a sky. Builds on: chapter 4 (the half disk).

mod angles;
mod figures;
mod finale;
mod inversion;
mod slopes;

use halfdisk::lab::chapter::{Chapter, Desk, DeskError, Number};
use halfdisk::lab::estimators::directions::Recipe;
use halfdisk::lab::estimators::furnace;
use halfdisk::lab::estimators::gather::Gather;
use halfdisk::lab::estimators::worlds::{Sky, floor};
use halfdisk::lab::ledger::Ledger;
use halfdisk::sampling::stream::Stream;
use halfdisk::space::{Flat, Solid, Space};
use halfdisk::stats::Estimate;
use halfdisk::stats::z_test::{FOUR, Largest, ROUNDING, z_test};
use std::f64::consts::{FRAC_PI_4, PI};
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch05",
    title: "Importance sampling",
    question: "Some directions matter more than others. Can the random numbers know?",
};

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    // What the angles of each law look like, in both worlds.
    let flat = angles::work(desk, angles::flat(), "flat", FRAC_PI_4);
    let solid = angles::work(desk, angles::solid(), "solid", 2.0 / 3.0);
    figures::angles(desk, &flat.0, &solid.0)?;
    figures::points(desk)?;
    inversion::drawings(desk)?;

    // How fast the error falls, with and without strata.
    let spent = slopes::work(desk)?;

    // What one sample is worth.
    let of_flat = 5.0 * PI * PI / 64.0 - 9.0 / 16.0;
    let (gain_flat, in_flat, _) = variances::<Flat>(desk, "flat", of_flat);
    let (gain_solid, in_solid, variance) = variances::<Solid>(desk, "solid", 13.0 / 48.0);
    let last = finale::work(desk)?;
    let rays = u64::from(desk.choose(1_000_000, 100_000_u32));
    let mut compared = in_flat.with(in_solid);
    [flat.1, solid.1].into_iter().for_each(|z| compared.add(z));
    Ok(Ledger {
        rays: 6 * rays + spent + last,
        variance: Some(variance),
        compared: Some(compared.into()),
        efficiency: Some(1.0 / variance),
        ..Ledger::of(&format!(
            "Cosine directions do the work of {gain_flat:.2} times as many uniform ones in the \
             flat world, of {gain_solid:.2} times in space; no ray costs more."
        ))
    })
}

// ANCHOR: two_tone
/// What a white floor reflects of a sky that is half as bright on the left, one ray at a time:
/// the mean, which is 3/4, and the variance around it.
fn two_tone<S: Space>(recipe: Recipe, rays: u32, seed: u64) -> [Estimate; 2] {
    let one_ray = Gather {
        samples: 1,
        depth: 1,
        recipe,
    };
    let mut sky = Sky(|w: S::Vector| if S::to_plane(w).x > 0.0 { 1.0 } else { 0.5 });
    let mut both = [Estimate::new(); 2];
    for i in 0..rays {
        let x = one_ray.reflected(&mut sky, &floor::<S>(1.0), &Stream::new(seed, i, 0));
        let x = f64::from(x.r);
        both[0].add(x);
        both[1].add((x - 0.75).powi(2));
    }
    both
}
// ANCHOR_END: two_tone

/// Records what one sample's variance is: how much the cosine gains, how far all is from its truth,
/// and the variance of a cosine sample.
fn variances<S: Space>(desk: &mut Desk, name: &str, of_uniform: f64) -> (f64, Largest, f64) {
    let (rays, seed) = (desk.choose(1_000_000, 100_000), desk.options.seed);
    let mut compared = Largest::default();
    let mut variance = |desk: &mut Desk, way: &str, recipe, exact: f64| {
        let [mean, square] = two_tone::<S>(recipe, rays, seed);
        let says = format!("{name}: variance of one {way} sample");
        // Where all samples lie as far from the mean, the rest is rounding.
        let error = square.std_error();
        let number = Number::new(&says, square.mean()).exact(exact);
        let error = (error > ROUNDING * exact).then_some(error);
        desk.number(
            &format!("variance_{way}_{name}"),
            Number { error, ..number },
        );
        for (estimate, truth) in [(mean, 0.75), (square, exact)] {
            compared.add(z_test(&estimate, truth, FOUR).z);
        }
        square
    };
    let uniform = variance(desk, "uniform", Recipe::Uniform, of_uniform);
    let cosine = variance(desk, "cosine", Recipe::Cosine, 1.0 / 16.0);
    let gain = uniform.mean() / cosine.mean();
    let says = format!("{name}: uniform rays for one cosine ray");
    let number = Number::new(&says, gain).exact(16.0 * of_uniform);
    let error = Some(uniform.std_error() / cosine.mean());
    desk.number(&format!("gain_{name}"), Number { error, ..number });
    let even = furnace::open::<S>(Recipe::Cosine, 1.0, 1, rays, seed).variance();
    let says = format!("{name}: variance of a cosine sample under an even sky");
    desk.known(&format!("furnace_variance_{name}"), &says, even, 0.0);
    (gain, compared, cosine.mean())
}
