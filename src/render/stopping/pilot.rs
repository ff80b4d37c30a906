//! A short render with random numbers of its own that tells what a long one will take.

use super::MOST_SAMPLES;
use super::split::{InParts, Split};
use super::worth::Worth;
use super::{TIME_SHARE, own_error, whole};
use crate::integrators::Integrator;
use crate::render::accuracy::Accuracy;
use crate::render::clock::Clock;
use crate::render::goal::{Goal, Pilot, Prediction, StoppedBy};
use crate::render::{Options, Progress, Recorder, Rendered, Session};
use crate::sampling::stream::{EVEN_SAMPLES, Sampler};
use crate::scene::Scene;

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
/// One of so many samples may end at this share though its prediction is rough ...
const LONG: u32 = 1024;
const LONG_SHARE: f64 = 1.0 / 8.0;
/// ... and one of so many in any case: what it says is wanted before the render is half done.
const LONGEST: u32 = 4096;
/// Where light is traced from its sources, for mirrors or glass focus it, a pilot takes so many samples of the
/// whole picture at least: of what is focused and seen in a mirror or through glass, one path of ten thousands may find
/// all, and a pilot that met none of them would promise far too much.
const MANY: u32 = 1 << 19;

/// The seed of the pilot of a picture.
pub fn pilot_seed(seed: u64) -> u64 {
    !seed
}

/// Why a pilot says nothing.
#[derive(Debug, thiserror::Error)]
pub enum Unfinished {
    /// Time was up before it could tell its error.
    #[error("time was up before the pilot could tell its error")]
    Late,
    /// Somebody stopped it; its picture is kept.
    #[error("the pilot was stopped before it could tell its error")]
    Stopped(Box<Rendered>),
}

/// Runs a pilot until it can say what a render to the goal will take. Without a limit of time, the clock
/// has no say in the number of samples.
pub fn predict(
    scene: &Scene,
    integrator: &dyn Integrator,
    options: &Options,
    goal: &Goal,
    progress: &dyn Progress,
) -> Result<Prediction, Unfinished> {
    let clock = goal.time.map(|time| Clock::new(time, progress));
    pilot(scene, integrator, options, goal, clock.as_ref(), progress)
}

/// The same by a clock that is running already, of whose time the pilot may take a share.
pub(super) fn pilot(
    scene: &Scene,
    integrator: &dyn Integrator,
    options: &Options,
    goal: &Goal,
    clock: Option<&Clock>,
    progress: &dyn Progress,
) -> Result<Prediction, Unfinished> {
    let options = Options {
        seed: pilot_seed(options.seed),
        spp: LEAST,
        ..*options
    };
    let passes = integrator.passes(scene);
    let [width, height] = scene.size;
    let least = match passes {
        Some(_) => (MANY / width.saturating_mul(height)).clamp(FIRST, LONG),
        None => FIRST,
    };
    match passes.and_then(|passes| passes.light_paths(scene)) {
        None => {
            let session = Session::new(scene, integrator, &options);
            watch(session, |_| None, least, &options, goal, clock, progress)
        }
        Some(light_paths) => {
            let parts = InParts(integrator);
            let session = Session::new(scene, &parts, &options);
            let split = |session: &Session<_>| Split::better(session, light_paths);
            watch(session, split, least, &options, goal, clock, progress)
        }
    }
}

/// Takes a pilot's samples, and looks at it after 32, 64, 128 ... until it has seen enough.
///
/// * `split`: the better split of the work, where there is one, as far as the pilot can tell.
/// * `least`: samples that are too few to have seen enough if they are fewer.
fn watch<R: Recorder + ?Sized>(
    mut session: Session<R>,
    split: impl Fn(&Session<R>) -> Option<Split>,
    least: u32,
    options: &Options,
    goal: &Goal,
    clock: Option<&Clock>,
    progress: &dyn Progress,
) -> Result<Prediction, Unfinished> {
    let own_clock = clock.map(|clock| clock.share(TIME_SHARE));
    let mut looks: Vec<Pilot> = Vec::new();
    let mut better = None;
    let mut before = f64::INFINITY;
    let mut spp = FIRST;
    loop {
        let late = match &own_clock {
            Some(clock) => session.advance_within(spp, spp, clock, progress),
            None => {
                session.advance(spp, progress);
                false
            }
        };
        if session.interrupted() {
            return Err(Unfinished::Stopped(Box::new(session.rendered())));
        }
        let left = clock.map(|clock| clock.left().as_secs_f64());
        if late {
            let said =
                (!looks.is_empty()).then(|| predicted(&looks, better, options, goal, left, false));
            return said.ok_or(Unfinished::Late);
        }
        let film = session.film();
        let look = Pilot {
            spp,
            seconds: session.time().as_secs_f64(),
            error: own_error(&film, goal.measure, session.rounding()),
            uncertainty: known(Accuracy::of(&film).uncertainty()),
        };
        progress.piloted(&look);
        looks.push(look);
        let blind = look.error.is_infinite() || look.error <= session.rounding();
        better = split(&session);
        let prediction = predicted(&looks, better, options, goal, left, blind);
        let need = f64::from(prediction.spp);
        let share = f64::from(spp) / need;
        let steady = (need / before - 1.0).abs() < STEADY && look.uncertainty < SURE;
        let enough = share >= LARGE
            || spp >= LEAST && share >= LARGEST_SHARE && look.uncertainty < ROUGH
            || spp >= 2 * LEAST && share >= SMALLEST_SHARE && steady
            || spp >= LONG && share >= LONG_SHARE
            || spp >= LONGEST;
        // The next look would take as long as all before it.
        let late = own_clock
            .as_ref()
            .is_some_and(|clock| clock.left() < clock.elapsed());
        if enough && spp >= least || late || blind {
            return Ok(prediction);
        }
        before = need;
        spp *= 2;
    }
}

/// What no division by zero has spoilt, or infinity.
fn known(x: f64) -> f64 {
    if x.is_nan() { f64::INFINITY } else { x }
}

/// What follows from the looks so far, of which there is one at least; `left` are the seconds there are,
/// and `blind` where the last look saw no noise, or none that rounding does not make.
fn predicted(
    looks: &[Pilot],
    split: Option<Split>,
    options: &Options,
    goal: &Goal,
    left: Option<f64>,
    blind: bool,
) -> Prediction {
    let last = looks[looks.len() - 1];
    let (square, cost) = split.map_or((1.0, 1.0), |split| (split.square, split.rays));
    let per_sample = cost * last.seconds / f64::from(last.spp);
    let worth = square * Worth::new(looks, options.sampler);
    let most = f64::from(MOST_SAMPLES);
    let (for_error, for_what) = match goal.error {
        // More would not change it: as many as the pilot.
        Some(target) if blind && last.error > target => (f64::from(FIRST), StoppedBy::NoNoise),
        Some(target) => {
            let need = round_up(worth.samples(target * target), options.sampler);
            (f64::from(need), StoppedBy::Error)
        }
        None => (most, StoppedBy::Samples),
    };
    let in_time = |left: f64| whole((left / per_sample).clamp(1.0, most) as u32, options.sampler);
    let for_time = left.map_or(most, |left| in_time(left).into());
    let (spp, limited_by) = match for_error.min(for_time) {
        spp if spp < for_error => (spp, StoppedBy::Time),
        spp if spp < most => (spp, for_what),
        spp => (spp, StoppedBy::Samples),
    };
    Prediction {
        pilot: last,
        spp: spp as u32,
        seconds: spp * per_sample,
        error: if last.error.is_infinite() {
            f64::INFINITY
        } else {
            worth.square(spp).sqrt()
        },
        limited_by,
        separate: true,
        light_paths: split.map(|split| split.light_paths),
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
