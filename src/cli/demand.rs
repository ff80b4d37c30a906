//! Which light a user asks for: all of it, that of certain paths, or all but an effect.

use super::Stop;
use crate::effects::language::{self, Wanted};
use crate::effects::measure::{Difference, Setup, difference};
use crate::effects::plan::{demand, never_a_path};
use crate::effects::without::Without;
use crate::notation::Expression;
use crate::scene::description::Description;
use crate::scene::{Effect, Scene, gallery};
use clap::Args;
use serde_json::json;

/// What is wanted of a scene's light.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Which light")]
pub(super) struct Demand {
    /// Only the light of these paths: an expression over L light, D diffuse, S mirror or glass,
    /// G gloss, E eye, such as 'LS+DE'; with groups, |, *, +, ?, {2,3} and [DS]
    #[arg(long, value_name = "EXPR", value_parser = Expression::parse)]
    pub paths: Option<Expression>,
    /// Leave an effect out on purpose; the picture is then wrong, and the report says by how much
    #[arg(long, value_name = "EFFECT", value_delimiter = ',', value_parser = effect)]
    pub without: Vec<Effect>,
}

fn effect(name: &str) -> Result<Effect, String> {
    let found = Effect::ALL.into_iter().find(|e| e.name() == name);
    found.ok_or_else(|| {
        let names = Effect::ALL.map(Effect::name);
        format!("the effects are {}", names.join(", "))
    })
}

/// Pixels of the pictures in which the size of an error is measured.
const MEASURED_PIXELS: f64 = 16_384.0;

impl Demand {
    /// True where all light is wanted.
    pub(super) fn is_everything(&self) -> bool {
        self.paths.is_none() && self.without.is_empty()
    }

    fn leaves_out(&self) -> Without {
        self.without.iter().copied().collect()
    }

    /// The scene `name`, changed by the demand and by `change`, and which of its paths count. A
    /// demand for light that is not there is a mistake, and not worth a black picture.
    pub(super) fn load(
        &self,
        name: &str,
        change: impl FnOnce(&mut Description),
    ) -> Result<Setup, Stop> {
        let setup = self.load_anything(name, change)?;
        if let Some(wanted) = &setup.wanted {
            self.check(&setup.scene, wanted)?;
        }
        Ok(setup)
    }

    /// The same, though nothing may be left.
    pub(super) fn load_anything(
        &self,
        name: &str,
        change: impl FnOnce(&mut Description),
    ) -> Result<Setup, Stop> {
        let without = self.leaves_out();
        let scene = gallery::load_with(name, |said| {
            change(said);
            without.change(said);
        })?;
        let wanted = without.restrict(self.paths.as_ref());
        Ok(Setup { scene, wanted })
    }

    fn check(&self, scene: &Scene, wanted: &Wanted) -> Result<(), Stop> {
        if let Some(paths) = &self.paths
            && let Some(why) = never_a_path(paths)
        {
            return Err(Stop::Input(format!("--paths {paths}: {why}")));
        }
        let Some(there) = language::of_scene(&scene.inventory) else {
            return Ok(());
        };
        if demand(&scene.inventory, &wanted.light_first).is_none() {
            let said = match &self.paths {
                Some(paths) => format!("--paths {paths}"),
                None => "--without".to_owned(),
            };
            return Err(Stop::Input(format!(
                "{said}: no such light: the paths of {} are {there}",
                scene.name
            )));
        }
        Ok(())
    }

    /// By how much the picture differs from that of all light: measured in a small picture.
    pub(super) fn bias(&self, name: &str, size: [u32; 2], spp: u32) -> Result<Difference, Stop> {
        let small = |said: &mut Description| said.film.size = measured_size(size).map(i64::from);
        let with = Setup {
            scene: gallery::load_with(name, small)?,
            wanted: None,
        };
        let without = self.load(name, small)?;
        Ok(difference(&with, &without, spp.min(16), 4))
    }
}

/// The size of a picture in which errors are measured: at most 128 x 128 pixels, of the same shape.
pub(super) fn measured_size([width, height]: [u32; 2]) -> [u32; 2] {
    let pixels = f64::from(width) * f64::from(height);
    let scale = (MEASURED_PIXELS / pixels).sqrt().min(1.0);
    [width, height].map(|n| ((f64::from(n) * scale) as u32).max(1))
}

/// A bias for people.
pub(super) fn bias_line(difference: &Difference) -> String {
    let (share, error) = (100.0 * difference.share, 100.0 * difference.share_error);
    let change = if share < 0.0 {
        format!("has {:.2} ± {error:.2} % more light than it should", -share)
    } else {
        format!("lacks {share:.2} ± {error:.2} % of the light")
    };
    format!(
        "left out on purpose, so the picture is biased: it {change}; relative squared error {:.1e} ± \
         {:.0e}\n",
        difference.rel_mse, difference.rel_mse_error
    )
}

/// A bias for machines.
pub(super) fn bias_json(difference: &Difference) -> serde_json::Value {
    json!({
        "missing": { "value": difference.share, "error": difference.share_error },
        "rel_mse": { "value": difference.rel_mse, "error": difference.rel_mse_error },
    })
}
