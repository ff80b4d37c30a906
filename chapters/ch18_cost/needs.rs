//! How many samples an error needs: predicted from four pictures, found in others.

use crate::prices::{Prices, digits};
use halfdisk::integrators::Path;
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::render::accuracy::{Measure, true_error};
use halfdisk::render::stopping::{Goal, render_to};
use halfdisk::render::{Options, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::stats::Estimate;

/// The error that is wanted.
const ERROR: f64 = 0.05;

/// The samples that a pilot predicts, against those that other pictures turn out to need; the rays.
pub fn held_out(desk: &mut Desk, prices: &Prices) -> Result<u64, DeskError> {
    let scene = &prices.scene;
    let path = Path::new(scene.suggested.max_depth);
    let options = |spp, number: u64| Options {
        spp,
        seed: desk.options.seed << 20 | number,
        ..Options::default()
    };
    let truth = &prices.measured.reference;
    let (mut required, mut rays, mut interrupted) = (Estimate::new(), 0, false);
    // ANCHOR: needed
    for number in 0..4 {
        let options = options(desk.choose(32, 24), number);
        let pilot = render(scene, &path, &options, &desk.bar("pilot"));
        // The variance of a sample over the squared error that is wanted, mean over all pixels.
        let pixels: Estimate = truth.required(&pilot.film, ERROR).into_iter().collect();
        required.add(pixels.mean());
        rays += pilot.rays.total();
        interrupted |= pilot.interrupted;
    }
    // ANCHOR_END: needed
    let needed = required.mean().ceil() as u32;
    let mut squares = Estimate::new();
    for number in 0..4 {
        let found = render(
            scene,
            &path,
            &options(needed, 4 + number),
            &desk.bar("held out"),
        );
        rays += found.rays.total();
        interrupted |= found.interrupted;
        let square: Estimate = truth.squares(&found.film).into_iter().collect();
        squares.add(square.mean());
    }
    if interrupted {
        return Err(DeskError::Interrupted);
    }
    desk.value(
        "needed",
        "paths for an error of 5 % in the box, from four pictures",
        needed.into(),
    );
    let error = squares.mean().sqrt();
    let reached = Number {
        error: Some(100.0 * squares.std_error() / (2.0 * error)),
        ..Number::new("error of other pictures with so many, %", 100.0 * error)
    };
    desk.number("reached", reached.exact(100.0 * ERROR));
    // Who is off by a share of the error is off by twice the share of the samples.
    let (ratio, own) = (
        squares.mean() / ERROR.powi(2),
        squares.std_error() / ERROR.powi(2),
    );
    let both = own.hypot(required.std_error() / required.mean());
    let held = Number {
        error: Some(both),
        ..Number::new("paths that others need over paths predicted", ratio)
    };
    desk.number("held_out", held.exact(1.0));
    Ok(rays)
}

/// A render to an error: what it says before, and what it took; the rays.
pub fn target(desk: &mut Desk, prices: &Prices) -> Result<u64, DeskError> {
    let scene = &prices.scene;
    let options = Options {
        seed: desk.options.seed,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    let goal = Goal {
        error: Some(ERROR),
        measure: Measure::default(),
        time: None,
    };
    let path = Path::new(scene.suggested.max_depth);
    let outcome = render_to(scene, &path, &options, &goal, &desk.bar("target"));
    if outcome.rendered.interrupted {
        return Err(DeskError::Interrupted);
    }
    let truth = &prices.measured.reference.picture;
    let found = true_error(&outcome.rendered.film.picture(), truth, goal.measure);
    let said = outcome
        .prediction
        .ok_or(DeskError::Missing("a prediction".to_owned()))?;
    for (name, says, value) in [
        ("predicted", "samples, predicted", f64::from(said.spp)),
        ("taken", "samples, taken", f64::from(outcome.spp)),
        (
            "seconds_predicted",
            "seconds, predicted",
            digits(said.seconds),
        ),
        (
            "seconds_taken",
            "seconds, taken",
            digits(outcome.reached.seconds),
        ),
        (
            "account",
            "error by its own account, %",
            digits(100.0 * outcome.reached.error),
        ),
        (
            "found",
            "error against the reference, %",
            digits(100.0 * found),
        ),
    ] {
        desk.value(
            &format!("time_target_{name}"),
            &format!("--target-error 5%: {says}"),
            value,
        );
    }
    Ok(outcome.rendered.rays.total())
}
