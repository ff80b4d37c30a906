//! `halfdisk effects`.

use super::answer::answer;
use super::demand::{Demand, measured_size};
use super::{Stop, check_folder, drawn, save};
use crate::lab::chapter::{Bar, on_ctrl_c, tell, whole};
use crate::lab::drawing::{self, BarChart, BarGroup};
use crate::lab::effects::measure::{Difference, Setup, difference_watched};
use crate::lab::effects::plan::{self, Plan, demand, plan};
use crate::lab::effects::without::Without;
use crate::numeric::count;
use crate::scene::{Effect, Scene, gallery};
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use std::fmt::{self, Display, Formatter};
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

/// What a scene calls for and why, what is left out and why.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub struct EffectsOf {
    /// A scene of the gallery (see `halfdisk scenes`), or a path to a .toml file
    scene: String,
    /// Measure what each effect costs in time and changes in the picture: renders the scene with and
    /// without it, in turn; Ctrl-C keeps the effects that are finished
    #[arg(long)]
    measure: bool,
    /// Samples per pixel of each of these renders
    #[arg(long, requires = "measure", default_value_t = 16, allow_negative_numbers = true, value_parser = whole(1_u32..=65_536))]
    spp: u32,
    /// How often each is rendered
    #[arg(long, requires = "measure", default_value_t = 6, allow_negative_numbers = true, value_parser = whole(3_u32..=1000))]
    rounds: u32,
    /// Folder for a chart of the measured light: effects.svg and effects.png
    #[arg(long, requires = "measure", value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print all of it as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    demand: Demand,
}

const AFTER_HELP: &str = "\
Examples:
  halfdisk effects caustic
      what is simulated, what is not, and the light paths that follow
  halfdisk effects caustic --paths 'LS+DE'
      what a demand for these paths leaves
  halfdisk effects lens --measure
      what each effect costs, and what would be wrong without it
  halfdisk effects room --measure --out out/effects
      the same, and a chart of it for a lecture";

/// What a scene calls for.
#[derive(Serialize)]
struct CalledFor {
    scene: String,
    #[serde(skip)]
    about: String,
    plan: Plan,
    demand: Option<plan::Demand>,
    measured: Option<Measurements>,
}

/// What leaving an effect out would save and lose.
#[derive(Serialize)]
struct Measured {
    effect: Effect,
    difference: Difference,
}

/// The measurements that were asked for, or those made before Ctrl-C.
#[derive(Serialize)]
struct Measurements {
    effects: Vec<Measured>,
    #[serde(rename = "all_effects_on")]
    all_on: Option<Difference>,
    interrupted: bool,
    /// How many there should be.
    #[serde(skip)]
    wanted: usize,
    #[serde(skip)]
    spp: u32,
    #[serde(skip)]
    rounds: u32,
}

impl EffectsOf {
    pub(super) fn run(self) -> Result<(), Stop> {
        let scene = gallery::load(&self.scene)?;
        self.out.as_deref().map(check_folder).transpose()?;
        let setup = self.demand.of(scene.clone())?;
        let wanted = setup.wanted.as_ref();
        let result = CalledFor {
            plan: plan(&setup.scene),
            demand: wanted.and_then(|w| demand(&setup.scene.inventory, &w.light_first)),
            measured: self.measure.then(|| self.measure(&scene)).transpose()?,
            scene: scene.name,
            about: scene.about,
        };
        answer(&result, self.json)?;
        if let (Some(folder), Some(measured)) = (&self.out, &result.measured) {
            measured.draw(&result.scene, folder)?;
        }
        if let Some(m) = result.measured.filter(|m| m.interrupted) {
            let (done, all) = (m.effects.len(), m.wanted);
            tell(format_args!("interrupted: kept {done} of {all} effects"));
            return Err(Stop::Interrupted);
        }
        Ok(())
    }

    /// Each effect that is simulated, with and without.
    fn measure(&self, scene: &Scene) -> Result<Measurements, Stop> {
        let full = Setup {
            scene: scene.clone().sized(measured_size(scene.size)),
            wanted: None,
        };
        let stop = on_ctrl_c();
        let effects: Vec<Effect> = scene.inventory.effects().iter().collect();
        let bar = ProgressBar::new(effects.len() as u64 + 1);
        let template = "{msg}  [{bar:32}] {pos} of {len}  {elapsed} gone, {eta} left";
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style.progress_chars("=> "));
        }
        let mut measured = Measurements {
            wanted: effects.len(),
            effects: Vec::new(),
            all_on: None,
            interrupted: false,
            spp: self.spp,
            rounds: self.rounds,
        };
        // The pictures tell nothing of themselves, but ask whether to stop.
        let quiet = Bar::hidden(stop);
        let compare =
            |a: &Setup, b: &Setup| difference_watched(a, b, self.spp, self.rounds, &quiet);
        for effect in effects {
            bar.set_message(effect.name());
            let without = Without::from_iter([effect]).of(full.scene.clone(), None)?;
            let Some(difference) = compare(&full, &without) else {
                break;
            };
            measured.effects.push(Measured { effect, difference });
            bar.inc(1);
        }
        measured.interrupted = stop.load(Ordering::Relaxed);
        if !measured.interrupted {
            bar.set_message("all on");
            let all_on = Setup {
                scene: full.scene.clone().with_all_effects(),
                wanted: None,
            };
            measured.all_on = compare(&all_on, &full);
            measured.interrupted = measured.all_on.is_none();
        }
        bar.finish_and_clear();
        Ok(measured)
    }
}

impl Measurements {
    /// A bar for each effect: the light that a picture lacks without it.
    fn chart(&self, scene: &str) -> BarChart {
        let group = |Measured { effect, difference }: &Measured| {
            let share = difference.share.percent();
            BarGroup {
                name: effect.name().to_owned(),
                bars: vec![drawing::Bar {
                    error: Some(share.error),
                    ..drawing::Bar::new("", share.value)
                }],
            }
        };
        BarChart {
            title: format!("What each effect brings: {scene}"),
            x_label: "effect; bars: one standard error".to_owned(),
            y_label: "light that is missing without it, percent".to_owned(),
            groups: self.effects.iter().map(group).collect(),
            ..BarChart::default()
        }
    }

    fn draw(&self, scene: &str, folder: &Path) -> Result<(), Stop> {
        let chart = self.chart(scene);
        let files = drawn(&folder.join("effects"), chart.to_svg(), chart.to_png())?;
        for (file, bytes) in files.into_iter().flatten() {
            save(&file, bytes)?;
            tell(format_args!("wrote {}", file.display()));
        }
        Ok(())
    }
}

impl Display for CalledFor {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        writeln!(
            f,
            "{}",
            format!("{}: {}", self.scene, self.about).trim_end()
        )?;
        self.plan.fmt(f)?;
        self.demand.iter().try_for_each(|demand| demand.fmt(f))?;
        self.measured
            .iter()
            .try_for_each(|measured| measured.fmt(f))
    }
}

impl Display for Measurements {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let spp = count(self.spp as usize, "sample", "samples");
        let rounds = self.rounds;
        writeln!(
            f,
            "\nmeasured with {spp} per pixel, {rounds} times with and without in turn\n\
             {:<14} {:<26} {:<22} relative squared error without",
            "effect", "time with / without", "share of the light"
        )?;
        for Measured { effect, difference } in &self.effects {
            let Difference { time, rel_mse, .. } = difference;
            let share = difference.share.percent();
            writeln!(
                f,
                "{:<14} {:<26} {:<22} {:.1e} ± {:.0e}",
                effect.name(),
                time.to_string(),
                format!("{:.2} ± {:.2} %", share.value, share.error),
                rel_mse.value,
                rel_mse.error
            )?;
        }
        if self.effects.iter().any(|m| m.difference.share.value < 0.0) {
            writeln!(f, "(below zero: the picture is brighter without)")?;
        }
        self.all_on.iter().try_for_each(|all_on| {
            writeln!(
                f,
                "every effect at work, those that are absent at no strength: {} of the time, the same \
                 picture",
                all_on.time
            )
        })
    }
}
