//! Which light a user asks for: all of it, that of certain paths, or all but an effect.

use super::Stop;
use crate::lab::effects::language::{self, Wanted};
use crate::lab::effects::measure::{Setup, difference_watched};
use crate::lab::effects::plan::{demand, never_a_path, reason};
use crate::lab::effects::without::Without;
use crate::notation::Expression;
use crate::render::Progress;
use crate::scene::{Effect, Scene};
use crate::stats::Measurement;
use clap::Args;
use serde::Serialize;
use std::fmt::{self, Display, Formatter};

/// Where help lists these options: named by each, as a heading for what comes next would go on to the
/// options of the command.
const HEADING: &str = "Which light";

/// What is wanted of a scene's light.
#[derive(Clone, Debug, Args)]
pub(super) struct Demand {
    /// Only the light of these paths: an expression over L light, D diffuse, S mirror or glass,
    /// G gloss, E eye, such as 'LS+DE'; with groups, |, *, +, ?, {2,3} and [DS]
    #[arg(long, help_heading = HEADING, value_name = "EXPR", value_parser = Expression::parse)]
    pub paths: Option<Expression>,
    /// Leave an effect out on purpose; the picture is then wrong, and the report says by how much
    #[arg(long, help_heading = HEADING, value_name = "EFFECT", value_delimiter = ',', value_parser = effect)]
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

    /// What is left of a scene, and which of its paths count. A demand for light that is not there is a
    /// mistake, and not worth a black picture.
    pub(super) fn of(&self, scene: Scene) -> Result<Setup, Stop> {
        self.check_effects(&scene)?;
        let without: Without = self.without.iter().copied().collect();
        let setup = without.of(scene, self.paths.as_ref())?;
        if let Some(wanted) = &setup.wanted {
            self.check(&setup.scene, wanted)?;
        }
        Ok(setup)
    }

    /// What is not there cannot be left out.
    fn check_effects(&self, scene: &Scene) -> Result<(), Stop> {
        let effects = scene.inventory.effects();
        match self.without.iter().find(|effect| !effects.has(**effect)) {
            None => Ok(()),
            Some(effect) => Err(Stop::Input(format!(
                "--without {}: {} has no such effect to leave out: {}",
                effect.name(),
                scene.name,
                reason(*effect, &scene.inventory)
            ))),
        }
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

    /// What the names of results end with, so that those of less light do not replace those of all.
    pub(super) fn suffix(&self) -> String {
        let mut suffix = String::new();
        if let Some(paths) = &self.paths {
            suffix += &format!("-{}", in_a_file_name(&paths.to_string()));
        }
        if !self.without.is_empty() {
            suffix += "-without";
        }
        let names = self.without.iter().map(|effect| effect.name());
        suffix + &names.map(|name| format!("-{name}")).collect::<String>()
    }
}

/// By how much a picture of what is left differs from that of all light: measured in a small picture.
/// `None` where it was asked to stop.
pub(super) fn bias(whole: Scene, left: Setup, spp: u32, progress: &impl Progress) -> Option<Bias> {
    let size = measured_size(whole.size);
    let with = Setup {
        scene: whole.sized(size),
        wanted: None,
    };
    let without = Setup {
        scene: left.scene.sized(size),
        ..left
    };
    let found = difference_watched(&with, &without, spp.min(16), 4, progress)?;
    Some(Bias {
        missing: found.share,
        rel_mse: found.rel_mse,
    })
}

/// An expression in letters that every file system takes: what `*`, `?` and `|` stand for is written
/// out. A long one is cut.
fn in_a_file_name(expression: &str) -> String {
    let letter = |c: char| match c {
        '*' => "0+".to_owned(),
        '?' => "01".to_owned(),
        '|' => "or".to_owned(),
        c if c.is_alphanumeric() || "+-_()[]{},".contains(c) => c.to_string(),
        _ => String::new(),
    };
    expression.chars().take(80).map(letter).collect()
}

/// The size of a picture in which errors are measured: at most 128 x 128 pixels, of the same shape.
pub(super) fn measured_size([width, height]: [u32; 2]) -> [u32; 2] {
    let pixels = f64::from(width) * f64::from(height);
    let scale = (MEASURED_PIXELS / pixels).sqrt().min(1.0);
    [width, height].map(|n| ((f64::from(n) * scale) as u32).max(1))
}

/// By how much a picture is wrong on purpose.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Bias {
    /// The share of the light that it lacks.
    missing: Measurement,
    /// The mean squared relative error.
    rel_mse: Measurement,
}

impl Display for Bias {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let Measurement { value, error } = self.missing.percent();
        let change = if value < 0.0 {
            format!("has {:.2} ± {error:.2} % more light than it should", -value)
        } else {
            format!("lacks {value:.2} ± {error:.2} % of the light")
        };
        let Measurement { value, error } = self.rel_mse;
        write!(
            f,
            "left out on purpose, so the picture is biased: it {change}; relative squared error \
             {value:.1e} ± {error:.0e}"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_that_is_too_bright_misses_no_light() {
        let line = |share| {
            let bias = Bias {
                missing: (share, 0.0006).into(),
                rel_mse: (0.01, 0.001).into(),
            };
            bias.to_string()
        };
        let dark = line(0.0038);
        assert!(
            dark.contains("biased: it lacks 0.38 ± 0.06 % of the light;"),
            "{dark}"
        );
        let bright = line(-0.0038);
        assert!(
            bright.contains("biased: it has 0.38 ± 0.06 % more light than it should;"),
            "{bright}"
        );
    }
}
