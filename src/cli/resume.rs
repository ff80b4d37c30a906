//! `halfdisk render --resume`: goes on where a render ended.

use super::long::Long;
use super::render::Render;
use super::{Action, Command, Stop};
use crate::output::{self, Provenance};
use crate::render::State;
use crate::scene::Scene;
use clap::Parser;
use std::path::Path;

/// Where a render ended.
pub(super) struct Resumed {
    /// Its file.
    file: String,
    facts: Provenance,
    pub state: State,
}

impl Render {
    /// The render that a file holds, with the end that is asked for now, and where it was.
    pub(super) fn resumed(self, file: &Path) -> Result<(Render, Resumed), Stop> {
        let name = file.display().to_string();
        let refuse = |what: String| Stop::Input(format!("--resume {name}: {what}"));
        let (facts, state) = output::made(file)?;
        if !facts.seeds.is_empty() {
            let what = "is an average of several seeds, and no single render goes on from it: render more seeds, and merge all";
            return Err(refuse(what.to_owned()));
        }
        let Some(state) = state.filter(|_| !facts.command.is_empty()) else {
            let what = "says no more than the picture: only .exr files of `halfdisk render` can be gone on with";
            return Err(refuse(what.to_owned()));
        };
        let arguments = std::iter::once("halfdisk".to_owned()).chain(facts.command.iter().cloned());
        let Ok(Command {
            action: Action::Render(made),
        }) = Command::try_parse_from(arguments)
        else {
            return Err(refuse(
                "was made by a command that this version does not know".to_owned(),
            ));
        };
        let ending = self.ending.or(made.ending);
        let asked = ending.spp(0);
        let has = u64::from(state.spp(facts.shard)).min(facts.spp);
        if asked > 0 && u64::from(asked) <= has {
            return Err(refuse(format!(
                "has {has} samples per pixel already; --spp, --target-error or --time say how far to go"
            )));
        }
        let render = Render {
            scene: self.scene.or(made.scene),
            ending,
            threads: self.threads,
            out: self.out.or_else(|| Some(file.to_owned())),
            maps: self.maps,
            json: self.json,
            quiet: self.quiet,
            long: Long {
                shard: made.long.shard,
                ..self.long
            },
            ..*made
        };
        Ok((
            render,
            Resumed {
                file: name,
                facts,
                state,
            },
        ))
    }
}

impl Resumed {
    /// Refuses a scene that is not the one of the file, and a file of another version.
    pub(super) fn check(&self, scene: &Scene, fingerprint: Option<&str>) -> Result<(), Stop> {
        let Resumed { file, facts, state } = self;
        let now = Provenance::new(scene, "", 0, 0, 0);
        let what = if facts.software != now.software {
            format!(
                "was made by {}, and its samples may be others than those of {}",
                facts.software, now.software
            )
        } else if fingerprint != facts.fingerprint.as_deref() {
            format!(
                "was made of another scene: {} or a file that it names has changed",
                scene.name
            )
        } else if [state.film.width(), state.film.height()] != scene.size {
            "is of another size".to_owned()
        } else {
            return Ok(());
        };
        Err(Stop::Input(format!("--resume {file}: {what}")))
    }
}
