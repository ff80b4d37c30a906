//! Light that a picture lacks: what its integrator cannot find, and what was left out on purpose.

use super::demand::Bias;
use crate::effects::black::why_black;
use crate::effects::language::Wanted;
use crate::effects::missed::{Missed, missed, unmet};
use crate::effects::plan::{Demand, demand, plan};
use crate::integrators::Entry;
use crate::render::Rendered;
use crate::scene::Scene;
use serde::Serialize;

/// What a picture of a scene by an integrator lacks.
#[derive(Debug)]
pub(super) struct LeftOut {
    integrator: Entry,
    missed: Vec<Missed>,
    on_purpose: Option<Demand>,
    /// Lamps that no sample has met, and all that might have been.
    unmet: [usize; 2],
}

impl LeftOut {
    pub fn new(scene: &Scene, integrator: Entry, wanted: Option<&Wanted>) -> Self {
        let language = wanted.map(|wanted| &wanted.light_first);
        LeftOut {
            integrator,
            missed: missed(&integrator, &scene.inventory, language),
            on_purpose: language
                .and_then(|language| demand(&scene.inventory, language))
                .filter(|demand| !demand.all),
            unmet: [0, 0],
        }
    }

    /// What to say before the work, for people.
    pub fn notes(&self, scene: &Scene) -> String {
        let mut text = String::new();
        let name = self.integrator.name;
        for Missed {
            light_of,
            words,
            all,
            reason,
        } in &self.missed
        {
            let (light, words) = (if *all { "all light" } else { "light" }, words.join(", "));
            text +=
                &format!("note: {name} leaves out {light} of {light_of} ({words} …): {reason}\n");
        }
        let found = self.missed.iter().all(|missed| !missed.all);
        if let Some(lost) = plan(scene).out_of_reach.filter(|_| found) {
            text += &format!("note: {} is out of reach: {}\n", lost.paths, lost.reason);
        }
        text
    }

    /// The integrator, where it cannot find all that is wanted.
    pub fn finder(&self) -> Option<&'static str> {
        (!self.missed.is_empty()).then_some(self.integrator.name)
    }

    /// What is not in the error of the picture, in words; `None` where everything is.
    pub fn unknown(&self) -> Option<String> {
        let name = self.integrator.name;
        let words = self.words();
        if !words.is_empty() {
            Some(format!("{name} leaves out {} …", words.join(", ")))
        } else if self.unmet[0] > 0 {
            Some(self.not_met())
        } else {
            None
        }
    }

    /// What is found out when the picture is finished: the lamps that a walk has met.
    pub fn see(&mut self, scene: &Scene, rendered: &Rendered) {
        self.unmet = unmet(&self.integrator, scene, rendered.lamps_met);
    }

    /// What to say of lamps that no sample has met; nothing where there are none.
    pub fn after(&self) -> String {
        match self.unmet[0] {
            0 => String::new(),
            _ => format!(
                "note: {}: what they send is neither in the picture nor in its error\n",
                self.not_met()
            ),
        }
    }

    fn not_met(&self) -> String {
        let ([unmet, all], name) = (self.unmet, self.integrator.name);
        format!("no sample of {name} has met {unmet} of {all} lamps")
    }

    /// How many lamps no sample has met, though chance alone finds them.
    pub fn unmet(&self) -> usize {
        self.unmet[0]
    }

    fn words(&self) -> Vec<&str> {
        let mut words = Vec::new();
        for word in self.missed.iter().flat_map(|missed| &missed.words) {
            if !words.contains(&word.as_str()) {
                words.push(word);
            }
        }
        words
    }

    /// Why a picture is black, for people.
    pub fn why_black(&self, scene: &Scene, max_depth: u32) -> String {
        let why = why_black(scene, &self.integrator, max_depth);
        match self.on_purpose {
            Some(_) if !scene.is_dark() => {
                format!("no light came by the paths that are asked for; {why}")
            }
            _ => why,
        }
    }

    /// What is left out; `None` where nothing is.
    pub fn lacks(&self, bias: Option<Bias>) -> Option<Lacks> {
        let nothing = self.missed.is_empty() && self.on_purpose.is_none() && bias.is_none();
        (!nothing).then(|| Lacks {
            integrator: self.integrator.name,
            words: self.words().into_iter().map(str::to_owned).collect(),
            lights: self.missed.clone(),
            on_purpose: self
                .on_purpose
                .as_ref()
                .map(|demand| demand.left_out.clone()),
            bias,
        })
    }
}

/// Light that a picture lacks, for programs.
#[derive(Debug, Serialize)]
pub(super) struct Lacks {
    integrator: &'static str,
    words: Vec<String>,
    lights: Vec<Missed>,
    on_purpose: Option<Vec<String>>,
    #[serde(flatten)]
    bias: Option<Bias>,
}
