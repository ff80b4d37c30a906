//! Passes over tiles over threads.

use super::clock::Clock;
use super::progress::Progress;
use super::recorder::{Recorded, Recorder};
use super::shots::{OfPasses, Shots};
use super::tile::{Tile, tiles};
use super::watch::Watch;
use super::{Film, Options, Pixel, Rendered, State, rounding};
use crate::integrators::{Integrator, PathInLanes};
use crate::sampling::stream::{EVEN_SAMPLES, Sampler, even_run};
use crate::scene::{RayCounts, Scene};
use crate::time::Moment;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Duration;

/// Renders a scene on the threads of the current rayon pool.
pub fn render(
    scene: &Scene,
    integrator: &dyn Integrator,
    options: &Options,
    progress: &dyn Progress,
) -> Rendered {
    let mut session = Session::new(scene, integrator, options);
    session.advance(options.spp, progress);
    session.rendered()
}

/// Renders a scene with all that a recorder keeps of its samples, on the threads of the current rayon
/// pool.
pub fn record<R: Recorder>(
    scene: &Scene,
    recorder: &R,
    options: &Options,
    progress: &dyn Progress,
) -> Recorded<R::Notes> {
    let mut session = Session::new(scene, recorder, options);
    session.advance(options.spp, progress);
    Recorded {
        pictures: (0..recorder.pictures())
            .map(|i| session.further(i))
            .collect(),
        notes: session.tiles.iter().map(|t| t.notes.clone()).collect(),
        rendered: session.rendered(),
    }
}

/// A render that can be looked at and taken further: the film after `n` samples is that of a render
/// of `n` samples, bit for bit, wherever it paused before.
pub struct Session<'a, R: Recorder + ?Sized = dyn Integrator + 'a> {
    scene: &'a Scene,
    recorder: &'a R,
    options: Options,
    tiles: Vec<Tile<R::Notes>>,
    prepared: OfPasses,
    /// The recorder's samples many at a time, where it can take them so.
    lanes: Option<PathInLanes<'a>>,
    spp: u32,
    /// Those that it had already when it went on.
    spp_before: u32,
    /// The rays of these.
    rays_before: RayCounts,
    time: Duration,
    interrupted: bool,
}

impl<'a, R: Recorder + ?Sized> Session<'a, R> {
    /// A render without any sample yet; `options.spp` is how many it tells that there will be.
    pub fn new(scene: &'a Scene, recorder: &'a R, options: &Options) -> Self {
        Session {
            scene,
            recorder,
            options: *options,
            tiles: tiles(scene.size, options, recorder.pictures()),
            prepared: OfPasses::default(),
            lanes: options
                .fixed
                .is_empty()
                .then(|| recorder.in_lanes(scene))
                .flatten(),
            spp: 0,
            spp_before: 0,
            rays_before: RayCounts::default(),
            time: Duration::ZERO,
            interrupted: false,
        }
    }

    /// A render that goes on from a state: its picture will be that of one that never stopped, bit for bit, where
    /// scene, recorder, seed and sampler are the same.
    ///
    /// # Panics
    ///
    /// Where the state's picture is of another size, or the recorder has further pictures or notes, which a state
    /// does not hold.
    pub fn resume(scene: &'a Scene, recorder: &'a R, options: &Options, state: &State) -> Self {
        assert_eq!([state.film.width(), state.film.height()], scene.size);
        assert!(recorder.pictures() == 0 && size_of::<R::Notes>() == 0);
        let mut session = Session::new(scene, recorder, options);
        let tally = &state.tally;
        for tile in &mut session.tiles {
            let places = tile
                .y
                .clone()
                .flat_map(|y| tile.x.clone().map(move |x| [x, y]));
            let pixels = tile.pixels.iter_mut().zip(places);
            pixels.for_each(|(pixel, [x, y])| *pixel = *state.film.pixel(x, y));
        }
        // Sums over all tiles: one of them holds what came before.
        if let Some(first) = session.tiles.first_mut() {
            first.rays = tally.rays - tally.pass_rays;
            first.watch = Watch::from(*tally);
            first.lights_met = tally.lights_met;
        }
        session.prepared = OfPasses {
            rays: tally.pass_rays,
            means: tally.passes,
        };
        session.spp = state.spp(options.shard);
        session.spp_before = session.spp;
        session.rays_before = tally.rays;
        session
    }

    /// Goes on until each pixel has `spp` samples; does nothing where they have more, or where it was
    /// stopped.
    ///
    /// Samples are taken in passes of 1, 1, 2, 4 … 64, 64 … over the whole picture, so that an
    /// interrupted render is a picture everywhere.
    pub fn advance(&mut self, spp: u32, progress: &dyn Progress) {
        let start = Moment::now();
        let (scene, recorder, options) = (self.scene, self.recorder, &self.options);
        let pixels = self
            .tiles
            .iter()
            .map(|tile| tile.pixels.len() as u64)
            .sum::<u64>();
        let total = pixels * u64::from(spp.max(options.spp));
        let done = AtomicU64::new(pixels * u64::from(self.spp));
        let interrupted = AtomicBool::new(self.interrupted);
        let stop = || interrupted.load(Ordering::Relaxed) || progress.stop();

        for pass in passes(self.spp, spp) {
            let tell = |samples: u64| {
                let before = done.fetch_add(samples, Ordering::Relaxed);
                progress.tell(before + samples, total);
            };
            let shots = Shots {
                scene,
                recorder,
                options,
                lanes: self.lanes.as_ref(),
                stop: &stop,
                tell: &tell,
            };
            if !shots.take(pass, &mut self.tiles, &mut self.prepared) {
                interrupted.store(true, Ordering::Relaxed);
            }
        }
        self.spp = self.spp.max(spp);
        self.time += start.elapsed().unwrap_or_default();
        self.interrupted = interrupted.into_inner();
    }

    /// Goes on until each pixel has at least `spp` samples and at most `most`, it is stopped, or time is up;
    /// true in the last case.
    ///
    /// Samples are taken in passes over the picture, and the pass that the clock cuts off is dropped, whole;
    /// only where the clock waits for it is the first one finished. That keeps the picture unbiased,
    /// though bright paths may take longer than dark ones: that `n` passes were finished in time says the
    /// same of each of them, so their mean expects what the first of them does; and over all `n` that is
    /// the light, for the first is always kept. To keep the pass that is cut off, which is more likely a
    /// slow one, would be biased.
    ///
    /// Source: Glynn, Heidelberger, Bias Properties of Budget Constrained Simulations (Operations
    /// Research 38(5), 1990). It asks that samples can be exchanged. Independent ones can, so a pass has one
    /// for each pixel. Of those that lie evenly the first 1, 2, 4, 8 and 16 of a run can among themselves,
    /// and so can equal runs: passes are those of [`Session::advance`], the last of which are whole runs.
    pub(super) fn advance_within(
        &mut self,
        spp: u32,
        most: u32,
        clock: &Clock,
        progress: &dyn Progress,
    ) -> bool {
        if self.spp == 0 && spp > 0 && clock.waits {
            self.advance(1, progress);
            clock.tell();
        }
        let start = Moment::now();
        let (scene, recorder, options) = (self.scene, self.recorder, &self.options);
        let stop = || clock.late() || progress.stop();
        let mut late = false;
        while self.spp < spp && !self.interrupted && !late {
            let most = match options.sampler {
                Sampler::Independent => most.min(self.spp + 1),
                Sampler::Sobol => most,
            };
            let Some(pass) = passes(self.spp, most).next() else {
                break;
            };
            let (mut tiles, mut prepared) = (self.tiles.clone(), self.prepared);
            let shots = Shots {
                scene,
                recorder,
                options,
                lanes: self.lanes.as_ref(),
                stop: &stop,
                tell: &|_| (),
            };
            let whole = shots.take(pass.clone(), &mut tiles, &mut prepared);
            late = clock.late();
            if !late {
                // Who stops a render keeps what there is.
                self.interrupted = !whole;
                (self.tiles, self.prepared) = (tiles, prepared);
                self.spp = pass.end;
            }
            clock.tell();
        }
        self.time += start.elapsed().unwrap_or_default();
        late
    }

    /// The samples of each pixel so far, or, once interrupted, at most.
    pub fn spp(&self) -> u32 {
        self.spp
    }

    /// Samples of each pixel in a second; `None` before the first.
    pub(super) fn rate(&self) -> Option<f64> {
        let samples = self.spp - self.spp_before;
        (samples > 0).then(|| f64::from(samples) / self.time.as_secs_f64())
    }

    /// Time spent in the pixel loop so far; zero where there is no clock.
    pub fn time(&self) -> Duration {
        self.time
    }

    /// True once it was stopped.
    pub fn interrupted(&self) -> bool {
        self.interrupted
    }

    /// The least relative error that can be told of the picture: see [`rounding`].
    pub fn rounding(&self) -> f64 {
        rounding(&self.rays())
    }

    /// The rays of what passes prepared so far.
    pub(super) fn pass_rays(&self) -> RayCounts {
        self.prepared.rays
    }

    /// All rays so far.
    pub(super) fn rays(&self) -> RayCounts {
        let mut rays = self.prepared.rays;
        self.tiles.iter().for_each(|tile| rays += tile.rays);
        rays
    }

    /// The picture so far.
    pub fn film(&self) -> Film {
        self.picture(|tile| tile.pixels.iter())
    }

    /// Further picture `i` so far.
    pub(super) fn further(&self, i: usize) -> Film {
        let pictures = self.recorder.pictures();
        self.picture(|tile| tile.further.iter().skip(i).step_by(pictures))
    }

    /// The picture of some pixels of each tile, row by row.
    fn picture<'t, I: Iterator<Item = &'t Pixel>>(
        &'t self,
        of_tile: impl Fn(&'t Tile<R::Notes>) -> I,
    ) -> Film {
        let [width, height] = self.scene.size;
        let mut pixels = vec![Pixel::default(); width as usize * height as usize];
        for tile in &self.tiles {
            let places = tile.y.clone().flat_map(|y| {
                let row = y as usize * width as usize;
                tile.x.clone().map(move |x| row + x as usize)
            });
            places
                .zip(of_tile(tile))
                .for_each(|(at, pixel)| pixels[at] = *pixel);
        }
        Film::new(width, pixels)
    }

    /// What there is so far.
    pub fn rendered(&self) -> Rendered {
        let mut watch = Watch::default();
        self.tiles.iter().for_each(|tile| watch.join(tile.watch));
        Rendered {
            film: self.film(),
            rays: self.rays(),
            pass_rays: self.prepared.rays,
            rays_before: self.rays_before,
            lanes: self.lanes.as_ref().map(PathInLanes::level_name),
            time: self.time,
            non_finite: watch.faults.non_finite(),
            faults: watch.faults,
            first_bad: watch.first,
            largest: watch.largest,
            interrupted: self.interrupted,
            lights_met: self.tiles.iter().fold(0, |met, tile| met | tile.lights_met),
            passes: self.prepared.means,
        }
    }
}

/// The ranges of sample numbers of each pass from `start` to `end`: each as long as all before it, up
/// to 64, so that none reaches beyond an [`even_run`].
fn passes(mut start: u32, end: u32) -> impl Iterator<Item = Range<u32>> {
    std::iter::from_fn(move || {
        let boundary = match start {
            0..EVEN_SAMPLES => (start + 1).next_power_of_two(),
            _ => even_run(start).end,
        };
        let pass = start..boundary.min(end);
        start = pass.end;
        (!pass.is_empty()).then_some(pass)
    })
}
