//! How many paths `halfdisk render --integrator path` traces from the lights.

use super::Stop;
use crate::integrators::{Entry, Path};
use crate::lab::chapter::whole;
use crate::scene::Scene;
use clap::Args;

/// How many paths start at the lights.
#[derive(Clone, Copy, Debug, Args)]
pub(super) struct LightPaths {
    /// Paths from the lights in each sample of all pixels, where a scene's mirrors or glass focus light onto
    /// what the eye sees; with 0 all light is looked for from the eye [default: one for every eight pixels; with
    /// --target-error as many as the pilot finds worth their rays]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole(0..=Path::MOST_LIGHT_PATHS))]
    light_paths: Option<u32>,
}

impl LightPaths {
    /// The number that was asked for.
    pub fn asked(&self) -> Option<u32> {
        self.light_paths
    }

    /// How many there are in a picture; `None` where none start at the lights.
    pub fn used(&self, integrator: Entry, scene: &Scene, max_depth: u32) -> Option<u32> {
        let path = Path {
            light_paths: self.light_paths,
            ..Path::new(max_depth)
        };
        let used = path.light_paths_of(scene);
        (integrator == Path::ENTRY && used > 0).then_some(used)
    }

    /// Refuses what makes no sense together.
    pub fn check(&self, integrator: Entry) -> Result<(), Stop> {
        match self.light_paths {
            Some(_) if integrator != Path::ENTRY => Err(Stop::Input(format!(
                "--light-paths: only `path` traces some of its light from the lights, not `{}`",
                integrator.name
            ))),
            _ => Ok(()),
        }
    }
}
