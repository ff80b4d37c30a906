//! A short render with random numbers of its own that tells what a long one will take.

use super::MOST_SAMPLES;
use super::worth::Worth;
use crate::integrators::Integrator;
use crate::render::accuracy::Accuracy;
use crate::render::goal::{Goal, Pilot, Prediction, StoppedBy};
use crate::render::{Options, Progress, Rendered, Session};
use crate::sampling::stream::{EVEN_SAMPLES, Sampler};
use crate::scene::Scene;
use std::time::Instant;

/// A pilot's first look; it doubles from there.
const FIRST: u32 = 32;
/// A pilot that takes this share of the render's samples has seen enough ...
const LARGE: f64 = 0.5;
/// ... and one of this many samples where it takes this share, and knows its own error so well, relatively.
const LEAST: u32 = EVEN_SAMPLES;
const LARGEST_SHARE: f64 = 0.25;
const ROUGH: f64 = 0.03;
/// One of twice as many, which has seen two runs of full length, may end at this share where its
/// prediction is steady.
const SMALLEST_SHARE: f64 = 1.0 / 16.0;
/// Steady is a prediction that the last doubling changed by less, relatively ...
const STEADY: f64 = 0.1;
/// ... of an error whose own relative error is less.
const SURE: f64 = 0.02;
/// The share of the time there is that a pilot may take.
const TIME_SHARE: f64 = 0.1;

/// The seed of the pilot of a picture.
pub fn pilot_seed(seed: u64) -> u64 {
    !seed
}

/// Runs a pilot until it can say what a render to the goal will take; the pilot's picture where it is
/// interrupted. Without a limit of time, the clock has no say in the number of samples.
pub fn predict(
    scene: &Scene,
    integrator: &dyn Integrator,
    options: &Options,
    goal: &Goal,
    progress: &dyn Progress,
) -> Result<Prediction, Box<Rendered>> {
    let start = Instant::now();
    let options = Options {
        seed: pilot_seed(options.seed),
        spp: LEAST,
        ..*options
    };
    let mut session = Session::new(scene, integrator, &options);
    let mut looks: Vec<Pilot> = Vec::new();
    let mut before = f64::INFINITY;
    let mut spp = FIRST;
    loop {
        session.advance(spp, progress);
        if session.interrupted() {
            return Err(Box::new(session.finish()));
        }
        let accuracy = Accuracy::of(&session.film());
        let look = Pilot {
            spp,
            seconds: session.time().as_secs_f64(),
            error: accuracy.error(goal.measure),
            uncertainty: accuracy.uncertainty(),
        };
        looks.push(look);
        let prediction = predicted(&looks, &options, goal, start.elapsed().as_secs_f64());
        let need = f64::from(prediction.spp);
        let share = f64::from(spp) / need;
        let steady = (need / before - 1.0).abs() < STEADY && look.uncertainty < SURE;
        let late = goal.time.is_some_and(|time| {
            2.0 * start.elapsed().as_secs_f64() > TIME_SHARE * time.as_secs_f64()
        });
        let long = spp >= LEAST && share >= LARGEST_SHARE && look.uncertainty < ROUGH;
        let sure = steady && spp >= 2 * LEAST;
        if share >= LARGE || long || sure && share >= SMALLEST_SHARE || late {
            return Ok(prediction);
        }
        before = need;
        spp *= 2;
    }
}

/// What follows from the looks so far, `elapsed` seconds after the start.
fn predicted(looks: &[Pilot], options: &Options, goal: &Goal, elapsed: f64) -> Prediction {
    let last = looks[looks.len() - 1];
    let per_sample = last.seconds / f64::from(last.spp);
    let worth = Worth::new(looks, options.sampler);
    let most = f64::from(MOST_SAMPLES);
    let for_error = goal.error.map_or(most, |target| {
        round_up(worth.samples(target * target), options.sampler).into()
    });
    let for_time = goal.time.map_or(most, |time| {
        ((time.as_secs_f64() - elapsed) / per_sample)
            .floor()
            .max(1.0)
    });
    let (spp, limited_by) = match for_error.min(for_time).min(most) {
        spp if spp < most && spp == for_error => (spp, StoppedBy::Error),
        spp if spp < most => (spp, StoppedBy::Time),
        spp => (spp, StoppedBy::Samples),
    };
    Prediction {
        pilot: last,
        spp: spp as u32,
        seconds: spp * per_sample,
        error: worth.square(spp).sqrt(),
        limited_by,
    }
}

/// A whole number of samples that is not smaller; of even ones one that few leave a run early.
pub(super) fn round_up(need: f64, sampler: Sampler) -> u32 {
    let need = need.clamp(1.0, f64::from(MOST_SAMPLES)).ceil() as u32;
    let step = match sampler {
        Sampler::Independent => 1,
        Sampler::Sobol => (need / 16).next_power_of_two().min(16),
    };
    need.next_multiple_of(step)
}
