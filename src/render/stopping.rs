//! A render that ends when the picture is good enough, or when time is up.
//!
//! A rule that watches a render's own error and stops when it looks small stops at lucky moments: its
//! pictures are biased. Here the number of samples for an error follows from a pilot with random numbers
//! of its own, so that the picture stays unbiased, after Stein, A Two-Sample Test for a Linear Hypothesis
//! Whose Power is Independent of the Variance (Annals of Mathematical Statistics 16(3), 1945).
//!
//! Only where the error turns out above its target by more than a twentieth is the render taken
//! further, by as many samples as that asks for. The unlucky pictures get more samples than the lucky
//! ones, which is a bias again. Both biases are of the order of the squared relative error of the whole
//! picture's mean: in `tests/target.rs`, of nine pixels at an error of 50 %, the mean is 3 % off by the
//! first rule, 2 % with such extensions, and not at all by the pilot alone; of ten thousand pixels at
//! 2 %, that would be less than a millionth.
//!
//! Where time is the limit no pilot is needed: passes over the picture end when time is up, and the one
//! that the clock cuts off is dropped, which is unbiased, too (see `Session::advance_within`).

use super::accuracy::{Accuracy, Measure};
use super::clock::Clock;
use super::{Film, Options, Progress, Rendered, Session, State, rounding};
use crate::integrators::Integrator;
use crate::sampling::stream::{EVEN_SAMPLES, Sampler};
use crate::scene::Scene;
use crate::time::Moment;
use std::time::Duration;

mod pilot;
mod split;
mod words;
mod worth;

pub use super::goal::{Goal, Pilot, Prediction, Reached, StoppedBy};
use pilot::pilot;
pub use pilot::{Unfinished, pilot_seed, predict};
pub use words::{percent, seconds};

/// The most samples a pixel may get.
pub const MOST_SAMPLES: u32 = 1 << 24;
/// A render goes on where its error is above the target by more than this share of it.
pub const TOLERANCE: f64 = 0.05;
/// It never takes more than this times the samples that were predicted.
const LONGEST: u32 = 4;
/// Seconds between two looks at its error on the way ...
const LOOK: f64 = 0.5;
/// ... and samples before the first.
const FIRST_LOOK: u32 = 16;
/// The share of the time there is that a pilot may take, or that passes before a prediction.
const TIME_SHARE: f64 = 0.1;

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
    /// True where it was interrupted so early that the picture is the pilot's.
    pub is_pilot: bool,
}

/// Renders until the goal is met: for an error, with as many samples as a pilot says; for a time, until
/// the clock says so; without a goal, with `options.spp` samples.
pub fn render_to(
    scene: &Scene,
    integrator: &dyn Integrator,
    options: &Options,
    goal: &Goal,
    progress: &dyn Progress,
) -> Outcome {
    render_from(None, scene, integrator, options, goal, progress)
}

/// The same from where another render ended, if any: see [`Session::resume`].
pub fn render_from(
    from: Option<&State>,
    scene: &Scene,
    integrator: &dyn Integrator,
    options: &Options,
    goal: &Goal,
    progress: &dyn Progress,
) -> Outcome {
    let clock = goal.time.map(|time| Clock::new(time, progress));
    let mut prediction = None;
    if goal.error.is_some() {
        match pilot(scene, integrator, options, goal, clock.as_ref(), progress) {
            Ok(said) => prediction = Some(said),
            Err(Unfinished::Late) => {}
            Err(Unfinished::Stopped(film)) => return cut_short(*film, options, goal),
        }
    }
    prediction.iter().for_each(|said| progress.predicted(said));
    let split = prediction.and_then(|said| said.light_paths);
    let split = split.and_then(|paths| integrator.passes(scene)?.with_light_paths(paths));
    let integrator = split.as_deref().unwrap_or(integrator);

    let mut aim = match prediction {
        // Then the clock counts the samples.
        Some(said) if said.limited_by == StoppedBy::Time => MOST_SAMPLES,
        Some(said) => said.spp,
        None if clock.is_some() => MOST_SAMPLES,
        None => options.spp,
    };
    let options = Options {
        spp: aim,
        ..*options
    };
    let most = aim.saturating_mul(LONGEST).min(MOST_SAMPLES);
    let mut session = match from {
        None => Session::new(scene, integrator, &options),
        Some(state) => Session::resume(scene, integrator, &options, state),
    };
    if let (Some(clock), None) = (&clock, prediction) {
        prediction = foresee(&mut session, clock, &options, goal.measure, progress);
    }
    let mut extensions = 0;
    let keeps_every = progress.keeps_every();
    let mut kept = Moment::now();
    loop {
        let next = next_look(&session).min(keeps_every.map_or(aim, |time| within(&session, time)));
        let next = aim.min(next);
        let late = match &clock {
            Some(clock) => session.advance_within(next, aim, clock, progress),
            None => {
                session.advance(next, progress);
                false
            }
        };
        let reached = look(&session, &options, goal, prediction);
        progress.reached(&reached);
        if keeps_every.is_some_and(|time| progress.elapsed(kept) >= time) {
            progress.keep(&session.rendered(), aim);
            kept = Moment::now();
        }
        let met = goal
            .error
            .is_some_and(|target| reached.error <= (1.0 + TOLERANCE) * target);
        let stopped_by = match goal.error {
            _ if session.interrupted() => StoppedBy::Interrupt,
            _ if late && met => StoppedBy::Error,
            _ if late => StoppedBy::Time,
            _ if session.spp() < aim => continue,
            Some(_) if met => StoppedBy::Error,
            Some(_) if blind(&reached, &session) => StoppedBy::NoNoise,
            Some(target) if aim < most => {
                extensions += 1;
                let need = f64::from(aim) * (reached.error / target).powi(2);
                aim = pilot::round_up(need, options.sampler).clamp(aim + 1, most);
                continue;
            }
            _ => StoppedBy::Samples,
        };
        let interrupted = stopped_by == StoppedBy::Interrupt;
        return Outcome {
            rendered: session.rendered(),
            seed: options.seed,
            prediction,
            spp: if interrupted { aim } else { reached.spp },
            reached,
            stopped_by,
            extensions,
            is_pilot: false,
        };
    }
}

/// Renders for a tenth of the time and says what the rest will bring, which changes nothing; `None` where
/// that time is too short to tell.
fn foresee(
    session: &mut Session,
    clock: &Clock,
    options: &Options,
    measure: Measure,
    progress: &dyn Progress,
) -> Option<Prediction> {
    let early = clock.share(TIME_SHARE);
    let before = session.spp();
    while !early.late() || session.spp() < 2 {
        let late = session.advance_within(session.spp() + 1, MOST_SAMPLES, clock, progress);
        if late || session.interrupted() || session.spp() == MOST_SAMPLES {
            return None;
        }
    }
    let (spp, seconds) = (session.spp(), clock.elapsed().as_secs_f64());
    let error = match spp < fewest(options.sampler) {
        true => f64::INFINITY,
        false => own_error(&session.film(), measure, session.rounding()),
    };
    let left = clock.left().as_secs_f64();
    let more = (left / seconds * f64::from(spp - before)).min(f64::from(MOST_SAMPLES - spp));
    let all = whole(spp + more as u32, options.sampler).max(spp);
    let said = Prediction {
        pilot: Pilot {
            spp,
            seconds,
            error,
            uncertainty: f64::INFINITY,
        },
        spp: all,
        seconds: seconds + left,
        error: error * (f64::from(spp) / f64::from(all)).sqrt(),
        limited_by: StoppedBy::Time,
        separate: false,
        light_paths: None,
    };
    progress.predicted(&said);
    Some(said)
}

/// The samples that the clock leaves of so many: of even ones it drops what is no whole pass.
fn whole(spp: u32, sampler: Sampler) -> u32 {
    match sampler {
        Sampler::Independent => spp,
        Sampler::Sobol if spp < EVEN_SAMPLES => 1 << spp.max(1).ilog2(),
        Sampler::Sobol => spp - spp % EVEN_SAMPLES,
    }
}

/// True where no noise was seen, or none that rounding does not make: more samples would not change it.
fn blind(reached: &Reached, session: &Session) -> bool {
    reached.error.is_infinite() || reached.error <= session.rounding()
}

/// How many samples a session should have before its error is looked at again.
fn next_look(session: &Session) -> u32 {
    match session.rate() {
        Some(rate) => {
            let step = (LOOK * rate).min(f64::from(MOST_SAMPLES)) as u32;
            session.spp() + step.max(session.spp())
        }
        None => session.spp() + FIRST_LOOK,
    }
}

/// How many samples a session has after this time, one more at least.
fn within(session: &Session, time: Duration) -> u32 {
    let rate = session.rate().unwrap_or(0.0);
    let more = (rate * time.as_secs_f64()).min(f64::from(MOST_SAMPLES)) as u32;
    session.spp() + more.max(1)
}

/// How far a session got.
fn look(
    session: &Session,
    options: &Options,
    goal: &Goal,
    prediction: Option<Prediction>,
) -> Reached {
    let error = match prediction {
        Some(said) if said.separate && (1..fewest(options.sampler)).contains(&session.spp()) => {
            said.error * (f64::from(said.spp) / f64::from(session.spp())).sqrt()
        }
        _ => own_error(&session.film(), goal.measure, session.rounding()),
    };
    reached(session.spp(), session.time().as_secs_f64(), error, goal)
}

/// The error of a picture by its own account, but no less than its samples are rounded by; infinite where
/// it is not known.
fn own_error(film: &Film, measure: Measure, rounding: f64) -> f64 {
    let accuracy = Accuracy::of(film);
    let noise = accuracy.error(Measure::RootMeanSquare);
    if noise > 0.0 {
        accuracy.error(measure).max(rounding)
    } else {
        f64::INFINITY
    }
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
    let error = own_error(&rendered.film, goal.measure, rounding(&rendered.rays));
    let spp = least.unwrap_or(0) as u32;
    Outcome {
        seed: pilot_seed(options.seed),
        prediction: None,
        spp,
        reached: reached(spp, rendered.time.as_secs_f64(), error, goal),
        stopped_by: StoppedBy::Interrupt,
        extensions: 0,
        is_pilot: true,
        rendered,
    }
}
