//! A render that ends when the picture is good enough, or when time is up: how many samples that will
//! take is found out first, by a pilot.
//!
//! A rule that watches a render's own error and stops when it looks small stops at lucky moments: its
//! pictures are biased. Here the number of samples follows from a pilot with random numbers of its own,
//! so that the picture stays unbiased, after Stein, A Two-Sample Test for a Linear Hypothesis Whose
//! Power is Independent of the Variance (Annals of Mathematical Statistics 16(3), 1945).
//!
//! Only where the error turns out above its target by more than a twentieth is the render taken
//! further, by as many samples as that asks for. The unlucky pictures get more samples than the lucky
//! ones, which is a bias again. Both biases are of the order of the squared relative error of the whole
//! picture's mean: in `tests/target.rs`, of nine pixels at an error of 50 %, the mean is 3 % off by the
//! first rule, 2 % with such extensions, and not at all by the pilot alone; of ten thousand pixels at
//! 2 %, that would be less than a millionth.

use super::accuracy::Accuracy;
use super::{Options, Progress, Rendered, Session};
use crate::integrators::Integrator;
use crate::sampling::stream::Sampler;
use crate::scene::Scene;
use std::time::Instant;

mod pilot;
mod words;
mod worth;

pub use super::goal::{Goal, Pilot, Prediction, Reached, StoppedBy};
pub use pilot::{pilot_seed, predict};
pub use words::{percent, seconds};

/// The most samples a pixel may get.
pub const MOST_SAMPLES: u32 = 1 << 24;
/// A render goes on where its error is above the target by more than this factor.
const TOLERANCE: f64 = 1.05;
/// It never takes more than this times the samples that were predicted.
const LONGEST: u32 = 4;
/// Seconds between two looks at its error on the way ...
const LOOK: f64 = 0.5;
/// ... and samples before the first.
const FIRST_LOOK: u32 = 16;

/// A render that was given a goal.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The picture: that of a render with `spp` samples under `seed`, unless interrupted.
    pub rendered: Rendered,
    /// The seed of the picture: the one that was asked for, or, where even the pilot was interrupted,
    /// the pilot's.
    pub seed: u64,
    /// What the pilot said, where there was one and it was not interrupted.
    pub prediction: Option<Prediction>,
    /// Samples for each pixel in the end, or, of one that was interrupted, those it aimed at.
    pub spp: u32,
    /// How far it got.
    pub reached: Reached,
    /// Why it ended.
    pub stopped_by: StoppedBy,
    /// How often it went on because its error was above the target.
    pub extensions: u32,
}

/// Renders until the goal is met, with as many samples as a pilot says; without a goal, with
/// `options.spp` samples and no pilot.
pub fn render_to(
    scene: &Scene,
    integrator: &dyn Integrator,
    options: &Options,
    goal: &Goal,
    progress: &dyn Progress,
) -> Outcome {
    let start = Instant::now();
    let mut prediction = None;
    if goal.error.is_some() || goal.time.is_some() {
        match predict(scene, integrator, options, goal, progress) {
            Ok(said) => prediction = Some(said),
            Err(pilot) => return cut_short(*pilot, options, goal),
        }
    }
    prediction.iter().for_each(|said| progress.predicted(said));

    let mut aim = prediction.map_or(options.spp, |said| said.spp);
    let options = Options {
        spp: aim,
        ..*options
    };
    let most = aim.saturating_mul(LONGEST).min(MOST_SAMPLES);
    let mut session = Session::new(scene, integrator, &options);
    let mut extensions = 0;
    loop {
        session.advance(aim.min(next_look(&session)), progress);
        let reached = look(&session, &options, goal, prediction);
        progress.reached(&reached);
        let late = goal.time.is_some_and(|time| start.elapsed() >= time);
        let by_time = prediction.is_some_and(|said| said.limited_by == StoppedBy::Time);
        let stopped_by = match goal.error {
            _ if session.interrupted() => StoppedBy::Interrupt,
            _ if session.spp() < aim && !late => continue,
            Some(target) if reached.error <= TOLERANCE * target => StoppedBy::Error,
            _ if late || by_time => StoppedBy::Time,
            Some(target) if aim < most => {
                extensions += 1;
                let need = f64::from(aim) * (reached.error / target).powi(2);
                aim = pilot::round_up(need, options.sampler).min(most);
                continue;
            }
            _ => StoppedBy::Samples,
        };
        let interrupted = stopped_by == StoppedBy::Interrupt;
        return Outcome {
            rendered: session.finish(),
            seed: options.seed,
            prediction,
            spp: if interrupted { aim } else { reached.spp },
            reached,
            stopped_by,
            extensions,
        };
    }
}

/// How many samples a session should have before its error is looked at again.
fn next_look(session: &Session) -> u32 {
    let spp = session.spp();
    if spp == 0 {
        return FIRST_LOOK;
    }
    let rate = f64::from(spp) / session.time().as_secs_f64();
    let step = (LOOK * rate).min(f64::from(MOST_SAMPLES)) as u32;
    spp + step.max(spp)
}

/// How far a session got.
fn look(
    session: &Session,
    options: &Options,
    goal: &Goal,
    prediction: Option<Prediction>,
) -> Reached {
    let error = match prediction {
        Some(said) if session.spp() < fewest(options.sampler) => {
            said.error * (f64::from(said.spp) / f64::from(session.spp())).sqrt()
        }
        _ => Accuracy::of(&session.film()).error(goal.measure),
    };
    reached(session.spp(), session.time().as_secs_f64(), error, goal)
}

fn reached(spp: u32, seconds: f64, error: f64, goal: &Goal) -> Reached {
    let until = |target: f64| seconds * ((error / target).powi(2) - 1.0).max(0.0);
    Reached {
        spp,
        seconds,
        error,
        seconds_to_target: goal.error.map(until),
        seconds_to_half: 3.0 * seconds,
    }
}

/// The fewest samples of a pixel that tell their error; fewer even ones can only bound it.
pub fn fewest(sampler: Sampler) -> u32 {
    match sampler {
        Sampler::Independent => 2,
        Sampler::Sobol => 32,
    }
}

/// A pilot that was interrupted is a picture, too.
fn cut_short(rendered: Rendered, options: &Options, goal: &Goal) -> Outcome {
    let least = rendered.film.pixels().iter().map(|p| p.count()).min();
    let error = Accuracy::of(&rendered.film).error(goal.measure);
    let spp = least.unwrap_or(0) as u32;
    Outcome {
        seed: pilot_seed(options.seed),
        prediction: None,
        spp,
        reached: reached(spp, rendered.time.as_secs_f64(), error, goal),
        stopped_by: StoppedBy::Interrupt,
        extensions: 0,
        rendered,
    }
}
