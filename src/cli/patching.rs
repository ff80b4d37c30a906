//! How small the patches of `halfdisk render --integrator radiosity` are.

use super::Stop;
use crate::integrators::Entry;
use crate::lab::chapter::whole;
use crate::radiosity::{PatchSize, Report};
use crate::render::stopping::percent;
use clap::Args;
use serde::Serialize;
use std::fmt::{self, Display, Formatter};

/// What patches took, and how far their size puts a picture off.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Patched {
    #[serde(flatten)]
    pub report: Report,
    pub seconds: f64,
}

impl Display for Patched {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let Report {
            effort,
            hidden,
            mesh_error,
        } = self.report;
        let megabytes = effort.bytes as f64 / 1e6;
        write!(
            f,
            "patches: {}, {megabytes:.1} MB of form factors by {} shadow rays, solved in {} sweeps, {:.3} s",
            effort.patches, effort.rays, effort.sweeps, self.seconds
        )?;
        if hidden > 0 {
            write!(
                f,
                "\nnote: {hidden} patches lie in the very place of others, which rays meet first, and were left out"
            )?;
        }
        match mesh_error {
            Some(error) => write!(
                f,
                "\nerror of the patches: at most about {} of the indirect light, which no sample takes away (by a \
                 quarter of the patches)",
                percent(error)
            ),
            None => f.write_str(
                "\nerror of the patches: not known (there are too few to compare with fewer)",
            ),
        }
    }
}

/// How small patches are.
#[derive(Clone, Copy, Debug, Args)]
pub(super) struct Patching {
    /// Patches, at most: both sides of every surface count that can matter [default: 1000]
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = whole(1..=usize::MAX),
        conflicts_with = "patch_size", help_heading = HEADING)]
    pub patches: Option<usize>,
    /// The longest edge of a patch, in scene units
    #[arg(long, value_name = "LENGTH", allow_negative_numbers = true, value_parser = length,
        help_heading = HEADING)]
    pub patch_size: Option<f64>,
}

const HEADING: &str = "Patches";

fn length(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(length) if length > 0.0 && length.is_finite() => Ok(length),
        _ => Err("a length is a number above 0, in scene units".to_owned()),
    }
}

impl Patching {
    /// What was asked for, or else the usual.
    pub fn size(&self) -> PatchSize {
        match (self.patches, self.patch_size) {
            (_, Some(length)) => PatchSize::Length(length),
            (Some(number), None) => PatchSize::Number(number),
            (None, None) => PatchSize::default(),
        }
    }

    /// Refuses what makes no sense together.
    pub fn check(&self, integrator: Entry) -> Result<(), Stop> {
        let name = integrator.name;
        let said = match (self.patches, self.patch_size) {
            (Some(_), _) => Some("--patches"),
            (_, Some(_)) => Some("--patch-size"),
            _ => None,
        };
        match said {
            Some(said) if !integrator.is_prepared() => Err(Stop::Input(format!(
                "{said}: `{name}` has no patches, only `radiosity` has"
            ))),
            _ => Ok(()),
        }
    }
}
