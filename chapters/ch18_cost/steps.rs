//! What samples buy: the same steps early and late, forty paths, two halves of a picture.

use crate::noise;
use halfdisk::integrators::Path;
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::experiment::named;
use halfdisk::render::{Options, Session, render};
use halfdisk::scene::gallery;
use halfdisk::stats::{Estimate, Measurement};

/// From 1000 samples to 2000, and from 20 000 to 21 000.
pub fn falls(desk: &mut Desk) -> Result<(), DeskError> {
    // ANCHOR: falls
    let lamp = named::find("half-disk-lamp").ok_or(DeskError::Missing("the lamp".to_owned()))?;
    let (runs, seed) = (desk.choose(12, 6), desk.options.seed);
    let found = noise::falls(runs, lamp.truth, |block| {
        (lamp.run)(1000, seed << 32 | u64::from(block))
    });
    // ANCHOR_END: falls
    let root = |a: f64, b: f64| 100.0 * (1.0 - (a / b).sqrt());
    let ratio = (1.0 - 0.5_f64.sqrt()) / (0.05_f64.sqrt() - (1.0 / 21.0_f64).sqrt());
    for (name, says, Measurement { value, error }, exact) in [
        (
            "early",
            "noise falls from 1000 to 2000 samples by, %",
            found.one_to_two.percent(),
            root(1.0, 2.0),
        ),
        (
            "late",
            "noise falls from 20 000 to 21 000 samples by, %",
            found.twenty_to_more.percent(),
            root(20.0, 21.0),
        ),
        (
            "ratio",
            "the first fall over the second",
            found.ratio,
            ratio,
        ),
    ] {
        let number = Number {
            error: Some(error),
            ..Number::new(says, value)
        };
        desk.number(name, number.exact(exact));
    }
    let runs = f64::from(runs) * 40.0;
    desk.value("runs", "runs of 21 000 samples", runs);
    Ok(())
}

/// The noise of forty paths over that of one, in pictures of the box; the rays.
pub fn forty(desk: &mut Desk) -> Result<u64, DeskError> {
    let scene = gallery::load("cornell")?.sized([32; 2]);
    let mut means = vec![Estimate::new(); 32 * 32];
    let mut singles = means.clone();
    let mut rays = 0;
    for number in 0..desk.choose(6, 3) {
        let options = Options {
            spp: 40,
            seed: desk.options.seed << 16 | number,
            ..Options::default()
        };
        let found = render(&scene, &Path::new(8), &options, &desk.bar("forty"));
        if found.interrupted {
            return Err(DeskError::Interrupted);
        }
        for ((mean, single), pixel) in means.iter_mut().zip(&mut singles).zip(found.film.pixels()) {
            mean.add(pixel.channels[1].mean());
            single.add(pixel.channels[1].variance());
        }
        rays += found.rays.total();
    }
    // Pixel by pixel, so that a few bright ones do not decide.
    let pairs = means
        .iter()
        .zip(&singles)
        .filter(|(_, one)| one.mean() > 0.0);
    let squares: Estimate = pairs.map(|(m, one)| m.variance() / one.mean()).collect();
    let ratio = squares.mean().sqrt();
    let number = Number {
        error: Some(0.5 * squares.std_error() / ratio),
        ..Number::new("noise of forty paths over noise of one", ratio)
    };
    desk.number("forty", number.exact(1.0 / libm::sqrt(40.0)));
    Ok(rays)
}

/// A picture that paused half-way, and two halves put together; the rays.
pub fn halves(desk: &mut Desk) -> Result<u64, DeskError> {
    let scene = gallery::load("cornell")?.sized([32; 2]);
    let path = Path::new(8);
    let seed = desk.options.seed;
    let options = |spp, number| Options {
        spp,
        seed: seed + number,
        ..Options::default()
    };
    // ANCHOR: halves
    let whole = render(&scene, &path, &options(32, 0), &());
    let mut paused = Session::new(&scene, &path, &options(32, 0));
    paused.advance(16, &());
    paused.advance(32, &());
    let paused = paused.rendered();
    // ANCHOR_END: halves
    let differ = |a: &f64, b: &f64| a.to_bits() != b.to_bits();
    let [one, other] = [&whole.film, &paused.film].map(|f| f.picture().values);
    let count = one
        .iter()
        .flatten()
        .zip(other.iter().flatten())
        .filter(|(a, b)| differ(a, b))
        .count();
    desk.known(
        "paused",
        "values that differ after a pause",
        count as f64,
        0.0,
    );
    // Two pictures of other seeds as one: the mean of their means, up to the last bit.
    let [a, b] = [1, 2].map(|number| render(&scene, &path, &options(16, number), &()));
    let mut worst = 0_u64;
    for (a, b) in a.film.pixels().iter().zip(b.film.pixels()) {
        for (a, b) in a.channels.iter().zip(&b.channels) {
            let (merged, mean) = (a.merge(b).mean(), 0.5 * (a.mean() + b.mean()));
            worst = worst.max(merged.to_bits().abs_diff(mean.to_bits()));
        }
    }
    desk.value(
        "merged",
        "two halves and their mean: units in the last place",
        worst as f64,
    );
    let rays = [&whole, &paused, &a, &b].map(|r| r.rays.total());
    Ok(rays.iter().sum())
}
