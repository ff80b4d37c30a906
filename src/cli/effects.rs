//! `halfdisk effects`.

use super::demand::{Demand, measured_size};
use super::{Stop, answer};
use crate::desk::{Bar, on_ctrl_c, tell, whole};
use crate::effects::measure::{Difference, Setup, difference_watched};
use crate::effects::plan::{self, Plan, demand};
use crate::effects::without::Without;
use crate::numeric::count;
use crate::scene::{Effect, Scene, gallery};
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;
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
      what each effect costs, and what would be wrong without it";

/// What leaving an effect out would save and lose.
struct Measured {
    effect: Effect,
    difference: Difference,
}

/// The measurements that were asked for, or those made before Ctrl-C.
struct Measurements {
    effects: Vec<Measured>,
    all_on: Option<Difference>,
    interrupted: bool,
    /// How many there should be.
    wanted: usize,
}

impl EffectsOf {
    pub(super) fn run(self) -> Result<(), Stop> {
        let scene = gallery::load(&self.scene)?;
        let setup = self.demand.of(scene.clone())?;
        let plan = plan::plan(&setup.scene);
        let left = setup
            .wanted
            .as_ref()
            .and_then(|wanted| demand(&setup.scene.inventory, &wanted.light_first));
        let measured = match self.measure {
            true => Some(self.measure(&scene)?),
            false => None,
        };
        let interrupted = measured.as_ref().filter(|m| m.interrupted);
        let interrupted = interrupted.map(|m| (m.effects.len(), m.wanted));
        if self.json {
            let object = json!({
                "scene": scene.name,
                "plan": plan,
                "demand": left,
                "measured": measured.as_ref().map(as_json),
            });
            answer(&(serde_json::to_string_pretty(&object)? + "\n"))?;
        } else {
            let mut text = describe(&setup.scene, &plan);
            if let Some(left) = left {
                text += &describe_demand(&left);
            }
            if let Some(measured) = measured {
                text += &describe_measurements(&measured, self.spp, self.rounds);
            }
            answer(&text)?;
        }
        if let Some((done, all)) = interrupted {
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

fn describe(scene: &Scene, plan: &Plan) -> String {
    let mut text = format!("{}: {}", scene.name, scene.about)
        .trim_end()
        .to_owned()
        + "\n";
    for (simulated, title) in [(true, "\nsimulated\n"), (false, "\nnot simulated\n")] {
        let lines: Vec<_> = plan
            .lines
            .iter()
            .filter(|l| l.simulated == simulated)
            .collect();
        if !lines.is_empty() {
            text += title;
        }
        for line in lines {
            text += &format!("  {:<13} {}\n", line.effect.name(), line.reason);
        }
    }
    text += &match &plan.paths {
        Some(paths) => format!("\nlight paths: {paths}\n"),
        None => "\nlight paths: none, so the picture is black\n".to_owned(),
    };
    if let Some(lost) = &plan.out_of_reach {
        text += &format!("out of reach: {}: {}\n", lost.paths, lost.reason);
    }
    for note in &plan.notes {
        text += &format!("note: {note}\n");
    }
    text
}

fn describe_demand(left: &plan::Demand) -> String {
    if left.all {
        return "the demand: every path of the scene\n".to_owned();
    }
    format!(
        "the demand keeps {} …\n        and leaves out {} …\n",
        left.kept.join(", "),
        left.left_out.join(", ")
    )
}

fn describe_measurements(measured: &Measurements, spp: u32, rounds: u32) -> String {
    let mut text = format!(
        "\nmeasured with {} per pixel, {rounds} times with and without in turn\n\
         {:<14} {:<26} {:<22} relative squared error without\n",
        count(spp as usize, "sample", "samples"),
        "effect",
        "time with / without",
        "share of the light"
    );
    for Measured { effect, difference } in &measured.effects {
        let share = format!(
            "{:.2} ± {:.2} %",
            100.0 * difference.share,
            100.0 * difference.share_error
        );
        text += &format!(
            "{:<14} {:<26} {share:<22} {:.1e} ± {:.0e}\n",
            effect.name(),
            times(difference),
            difference.rel_mse,
            difference.rel_mse_error
        );
    }
    if measured.effects.iter().any(|m| m.difference.share < 0.0) {
        text += "(below zero: the picture is brighter without)\n";
    }
    if let Some(all_on) = &measured.all_on {
        text += &format!(
            "every effect at work, those that are absent at no strength: {} of the time, the same \
             picture\n",
            times(all_on)
        );
    }
    text
}

fn times(difference: &Difference) -> String {
    let [ratio, low, high] = difference.time();
    format!("{ratio:.2} [{low:.2}, {high:.2}]")
}

fn as_json(measured: &Measurements) -> serde_json::Value {
    let one = |d: &Difference| {
        let [ratio, low, high] = d.time();
        json!({
            "time_ratio": { "value": ratio, "low": low, "high": high },
            "rays_ratio": d.rays,
            "share": { "value": d.share, "error": d.share_error },
            "rel_mse": { "value": d.rel_mse, "error": d.rel_mse_error },
        })
    };
    let effects: Vec<_> = measured
        .effects
        .iter()
        .map(|m| json!({ "effect": m.effect, "difference": one(&m.difference) }))
        .collect();
    json!({
        "effects": effects,
        "all_effects_on": measured.all_on.as_ref().map(one),
        "interrupted": measured.interrupted,
    })
}
