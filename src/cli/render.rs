//! `halfdisk render`.

use super::answer::{print, to_json};
use super::checkpoint::Keeper;
use super::choices::{Points, by_name, size};
use super::demand::{Demand, bias};
use super::exposure::Exposure;
use super::left_out::LeftOut;
use super::light_paths::LightPaths;
use super::long::Long;
use super::maps::Maps;
use super::patching::{Patched, Patching};
use super::photons::{Landed, PhotonArgs};
use super::report::Report;
use super::resume::Resumed;
use super::stop::{Ended, Ending};
use super::views::Views;
use super::{Stop, note_slow_build, use_threads};
use crate::integrators::{Entry, FilteredPath, Integrator, Path as PathTracer, Settings};
use crate::lab::chapter::{Bar, on_ctrl_c, tell, whole};
use crate::lab::effects::measure::Setup;
use crate::output::{self, Provenance};
use crate::render::stopping::{Outcome, render_from};
use crate::render::{Blur, Options, Progress, State, Tally};
use crate::scene::{Scene, gallery};
use crate::time::Moment;
use clap::Args;
use std::path::PathBuf;
use std::sync::OnceLock;

/// Render a scene.
///
/// The picture is a pure function of scene, integrator, seed and samples per pixel. Ctrl-C keeps what
/// is there; a second one ends at once.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub struct Render {
    /// A scene of the gallery (see `halfdisk scenes`), or a path to a .toml file
    #[arg(required_unless_present = "resume")]
    pub(super) scene: Option<String>,
    /// How light is computed
    #[arg(long, value_name = "NAME", default_value = PathTracer::ENTRY.name, value_parser = by_name())]
    pub(super) integrator: Entry,
    #[command(flatten)]
    pub(super) ending: Ending,
    /// Longest path in segments: the camera ray is the first, the one to the light the last
    /// [default: the scene's suggestion]
    #[arg(long, allow_negative_numbers = true, value_parser = whole(1_u32..=100_000))]
    pub(super) max_depth: Option<u32>,
    /// How the samples of a pixel lie to each other [default: sobol for path, else independent]
    #[arg(long, value_enum)]
    pub(super) sampler: Option<Points>,
    /// Image size in pixels, such as 640x480 [default: the scene's]
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub(super) size: Option<[u32; 2]>,
    /// Seed of all random numbers: the same seed gives the same bytes
    #[arg(long, default_value_t = 0, allow_negative_numbers = true, value_parser = whole(0..=u64::MAX))]
    pub(super) seed: u64,
    /// Threads to render on; changes no bit of the picture [default: one for each core]
    #[arg(long, allow_negative_numbers = true, value_parser = whole(1_u16..=1024))]
    pub(super) threads: Option<u16>,
    /// The picture: .png for screens, .exr with errors and sample counts, .hdr
    /// [default: out/FILE.png after the scene's file; by another integrator than path out/FILE-NAME.png]
    #[arg(long, value_name = "FILE")]
    pub(super) out: Option<PathBuf>,
    #[command(flatten)]
    pub(super) exposure: Exposure,
    #[command(flatten)]
    pub(super) light_paths: LightPaths,
    #[command(flatten)]
    pub(super) patching: Patching,
    #[command(flatten)]
    pub(super) photons: PhotonArgs,
    #[command(flatten)]
    pub(super) views: Views,
    #[command(flatten)]
    pub(super) maps: Maps,
    /// Print what was rendered as JSON, to stdout
    #[arg(long)]
    pub(super) json: bool,
    /// Keep every effect at work, those that the scene lacks at no strength: the same picture,
    /// later. For comparisons
    #[arg(long)]
    pub(super) all_effects: bool,
    /// No progress bar and no report
    #[arg(long, short)]
    pub(super) quiet: bool,
    #[command(flatten)]
    pub(super) long: Long,
    #[command(flatten)]
    pub(super) demand: Demand,
}

const AFTER_HELP: &str = "\
Examples:
  halfdisk render cornell
      a scene of the gallery, as its file suggests, in out/cornell.png
  halfdisk render cornell --integrator normals
      is the geometry right? colours are directions
  halfdisk render mine.toml --size 640x480 --spp 256 --out mine.exr
      a scene of your own, with the error of each pixel beside its value
  halfdisk render gloss --target-error 2% --maps
      as many samples as it takes; and where they are needed
  halfdisk render caustic --integrator photons --photons 200000 --radius 0.05
      light that comes through glass, looked at where it lands; and how much that blurs
  halfdisk render caustic --time 30s
      the best picture of half a minute, and how good it is
  halfdisk render mine.toml --spp 4 --json --quiet
      a first look, and the facts for a program";

impl Render {
    pub(super) fn run(self) -> Result<(), Stop> {
        if !self.quiet {
            note_slow_build();
        }
        match self.long.resume.clone() {
            None => self.go_on(None),
            Some(file) => self
                .resumed(&file)
                .and_then(|(render, from)| render.go_on(Some(&from))),
        }
    }

    /// Renders, from the beginning or from where another render ended.
    fn go_on(self, from: Option<&Resumed>) -> Result<(), Stop> {
        // Before anything asks for threads: large meshes are put into their tree by all of them.
        use_threads(self.threads)?;
        let mut whole = gallery::load(self.scene())?;
        if let Some(size) = self.size {
            whole = whole.sized(size);
        }
        // Kept to be compared with what is left of it.
        let compared = (!self.demand.is_everything()).then(|| whole.clone());
        let Setup { mut scene, wanted } = self.demand.of(whole)?;
        if wanted.is_some() && self.integrator != PathTracer::ENTRY {
            return Err(Stop::Input(format!(
                "--integrator {}: only `path` knows which paths it follows, and can leave some out",
                self.integrator.name
            )));
        }
        let aims = self.ending.goal().error.is_some();
        if let Some(bias) = self.integrator.biased.filter(|_| aims) {
            return Err(Stop::Input(format!(
                "--target-error: the scatter of its samples is not all of the error of `{}`: {bias}; \
                 --spp or --time ends it, and says how much that is",
                self.integrator.name
            )));
        }
        let fingerprint = scene.fingerprint().ok();
        from.map_or(Ok(()), |from| from.check(&scene, fingerprint.as_deref()))?;
        if self.all_effects {
            scene = scene.with_all_effects();
        }
        if self.all_effects && self.integrator != PathTracer::ENTRY {
            return Err(Stop::Input(format!(
                "--all-effects: only `path` leaves out what a scene lacks, not `{}`",
                self.integrator.name
            )));
        }
        let max_depth = self.max_depth(&scene)?;
        self.light_paths.check(self.integrator)?;
        self.patching.check(self.integrator)?;
        self.photons.check(self.integrator)?;
        // Checked before any work, so that none is lost to a misspelt name or a closed folder.
        let path = self.path();
        output::prepare(&path, &scene)?;
        self.exposure.check(&path, self.integrator)?;
        self.long.check(&path)?;
        self.long.sweep(&path);
        let views = self.views.of(&scene, &path)?;
        for map in self.maps.pictures(&path) {
            output::prepare(&map, &scene)?;
        }

        // What refuses the scene says so before anything else is said.
        let start = Moment::now();
        let made: Box<dyn Integrator + '_> = match &wanted {
            None => self.prepare(&scene, max_depth)?,
            Some(wanted) => Box::new(FilteredPath {
                path: PathTracer {
                    light_paths: self.light_paths.asked(),
                    ..PathTracer::new(max_depth)
                },
                paths: &wanted.eye_first,
            }),
        };
        let seconds = start.elapsed().unwrap_or_default().as_secs_f64();
        let solved = made.solved().map(|&report| Patched { report, seconds });
        let mut left_out = self
            .integrator
            .finds()
            .map(|_| LeftOut::new(&scene, self.integrator, wanted.as_ref()));
        if !self.quiet
            && let Some(left_out) = &left_out
        {
            let notes = left_out.notes(&scene);
            if !notes.is_empty() {
                tell(notes.trim_end());
            }
        }
        let facts_of = |scene: &Scene, spp: u32, seed: u64, split: Option<u32>| Provenance {
            sampler: self.sampler(),
            light_paths: split.or_else(|| self.light_paths.used(self.integrator, scene, max_depth)),
            photons: made
                .photons()
                .map(|photons| Landed::new(photons, scene, spp).facts),
            shard: self.long.shard,
            ..Provenance::new(scene, self.integrator.name, max_depth, spp.into(), seed)
        };
        let whole_facts = |spp, seed, split| {
            let facts = facts_of(&scene, spp, seed, split);
            let command = self.again(&scene, &facts);
            let fingerprint = fingerprint.clone();
            Provenance {
                command,
                fingerprint,
                ..facts
            }
        };
        let keeper = Keeper {
            bar: self.bar(&scene.name),
            every: self.long.checkpoint,
            path: &path,
            facts: &|spp, split| whole_facts(spp, self.seed, split),
            light_paths: OnceLock::new(),
        };
        let outcome = self.with(&scene, &made, from.map(|from| &from.state), &keeper);
        let split = outcome.prediction.and_then(|said| said.light_paths);
        let rendered = &outcome.rendered;
        if rendered.interrupted && rendered.film.pixels().iter().all(|p| p.count() == 0) {
            tell("interrupted before the first sample: nothing is written");
            return Err(Stop::Interrupted);
        }
        left_out.iter_mut().for_each(|l| l.see(&scene, rendered));
        let display = self.exposure.display(self.integrator, &rendered.film);
        let photons = made.photons();
        let mut landed = photons.map(|photons| Landed::new(photons, &scene, outcome.spp));
        let facts = Provenance {
            tally: Some(Tally::from(rendered)),
            ..whole_facts(outcome.spp, outcome.seed, split)
        };
        // All files first: what follows is for people, or may fail.
        let kept = output::write_somewhere(&path, &rendered.film, display, &facts)?;
        let path = &kept.path;
        let mut seen = Vec::new();
        for view in views.iter().filter(|_| !rendered.interrupted) {
            let moved = view.integrator(&scene, &made);
            let bar = self.bar(&view.scene.name);
            let drawn = self.with(&view.scene, moved.as_ref().unwrap_or(&made), None, &bar);
            let split = drawn.prediction.and_then(|said| said.light_paths);
            let its = facts_of(&view.scene, drawn.spp, drawn.seed, split);
            let drawn = drawn.rendered;
            output::write(&view.path, &drawn.film, display, &its)?;
            seen.push(view.path.display().to_string());
            let black = left_out
                .as_ref()
                .filter(|_| drawn.is_black() && !self.quiet);
            if let Some(left_out) = black {
                let why = left_out.why_black(&view.scene, max_depth);
                tell(format!("note: {} is black: {why}", view.path.display()));
            }
            if drawn.interrupted {
                break;
            }
        }
        let goal = self.ending.goal();
        let ((maps, no_maps), maps_failed) = match self.maps.write(path, &rendered.film, &goal) {
            Ok(maps) => (maps, None),
            Err(error) => (Default::default(), Some(error)),
        };
        let compared = compared.filter(|_| !rendered.interrupted);
        let biased = compared.is_some();
        let bias = compared.and_then(|whole| {
            let left = Setup {
                scene: scene.clone(),
                wanted: wanted.clone(),
            };
            bias(whole, left, outcome.spp, &Bar::hidden(on_ctrl_c()))
        });
        let unmeasured = biased && bias.is_none();
        let nobody_asks = self.quiet && !self.json;
        if let (Some(photons), Some(landed), false) =
            (photons, &mut landed, rendered.interrupted || nobody_asks)
        {
            let options = self.options(outcome.spp);
            let bar = self.bar("blur");
            landed.blur = Blur::measure(&scene, photons, &rendered.film, &options, &bar);
        }
        left_out.iter_mut().for_each(|l| l.bias = bias);
        let left_out = left_out.as_ref();
        let report = Report {
            facts: &facts,
            size: scene.size,
            built: &scene.report,
            made: rendered,
            out: path.display().to_string(),
            accuracy: Ended::new(&outcome, &goal, facts.sampler, left_out),
            too_bright_pixels: self.too_bright(&scene, rendered, max_depth),
            clipped_pixels: output::clipped(&rendered.film, display, path),
            maps,
            views: seen,
            no_maps,
            black: left_out
                .filter(|_| rendered.is_black())
                .map(|left_out| left_out.why_black(&scene, max_depth)),
            patches: solved,
            photons: landed,
            biased: self.integrator.biased,
            rarely_asked: self.rarely_asked(&scene, rendered, max_depth),
            lamps_unmet: left_out.map_or(0, LeftOut::unmet),
            unmet: left_out.map_or_else(String::new, LeftOut::after),
            left_out: left_out.filter(|left_out| !left_out.is_nothing()),
            unmeasured,
        };
        if !self.quiet {
            tell(&report);
        }
        let printed = match self.json {
            true => to_json(&report).and_then(|json| print(&json)),
            false => Ok(()),
        };
        if let Some(what) = kept.complaint() {
            return Err(Stop::Failure(what));
        }
        maps_failed.map_or(Ok(()), Err)?;
        printed?;
        if rendered.interrupted || unmeasured {
            return Err(Stop::Interrupted);
        }
        Ok(())
    }

    /// The integrator for a scene, with a bar of its own where that takes a while.
    fn prepare(&self, scene: &Scene, max_depth: u32) -> Result<Box<dyn Integrator>, Stop> {
        let stop = on_ctrl_c();
        let bar = match self.quiet || !self.integrator.is_prepared() {
            true => Bar::hidden(stop),
            false => Bar::new("patches", stop),
        };
        let settings = Settings {
            max_depth,
            patches: self.patching.size(),
            light_paths: self.light_paths.asked(),
            walks: self.photons.walks(),
            radius: self.photons.radius(),
            watch: &bar,
        };
        let made = self.integrator.prepare(scene, &settings);
        made.map_err(|refused| match refused.is_stop() {
            true => {
                tell("interrupted before the first sample: nothing is written");
                Stop::Interrupted
            }
            false => Stop::Input(format!("--integrator {}: {refused}", self.integrator.name)),
        })
    }

    fn with(
        &self,
        scene: &Scene,
        integrator: &impl Integrator,
        from: Option<&State>,
        progress: &dyn Progress,
    ) -> Outcome {
        let options = self.options(self.ending.spp(scene.suggested.spp));
        render_from(
            from,
            scene,
            integrator,
            &options,
            &self.ending.goal(),
            progress,
        )
    }

    fn options(&self, spp: u32) -> Options {
        Options {
            spp,
            seed: self.seed,
            sampler: self.sampler(),
            shard: self.long.shard,
            ..Options::default()
        }
    }

    fn bar(&self, what: &str) -> Bar {
        match self.quiet {
            true => Bar::hidden(on_ctrl_c()),
            false => Bar::new(what, on_ctrl_c()),
        }
    }
}
