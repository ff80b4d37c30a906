//! Light that a picture lacks: what its integrator cannot find, and what was left out on purpose.

use super::demand::Bias;
use crate::integrators::Entry;
use crate::lab::effects::black::why_black;
use crate::lab::effects::language::Wanted;
use crate::lab::effects::missed::{Missed, missed, unmet};
use crate::lab::effects::plan::{demand, plan};
use crate::render::Rendered;
use crate::scene::Scene;
use serde::Serialize;

/// What a picture of a scene by an integrator lacks.
#[derive(Debug, Serialize)]
pub(super) struct LeftOut {
    integrator: &'static str,
    #[serde(skip)]
    entry: Entry,
    /// Words of what is missed, each once.
    words: Vec<String>,
    #[serde(rename = "lights")]
    missed: Vec<Missed>,
    /// Words that are not wanted.
    on_purpose: Option<Vec<String>>,
    /// By how much the picture is wrong, where that was measured.
    #[serde(flatten)]
    pub bias: Option<Bias>,
    /// Lamps that no sample has met, and all that might have been.
    #[serde(skip)]
    unmet: [usize; 2],
}

impl LeftOut {
    pub fn new(scene: &Scene, entry: Entry, wanted: Option<&Wanted>) -> Self {
        let language = wanted.map(|wanted| &wanted.light_first);
        let missed = missed(&entry, &scene.inventory, language);
        let mut words: Vec<String> = Vec::new();
        for word in missed.iter().flat_map(|missed| &missed.words) {
            if !words.contains(word) {
                words.push(word.clone());
            }
        }
        let left = language.and_then(|language| demand(&scene.inventory, language));
        LeftOut {
            integrator: entry.name,
            entry,
            words,
            missed,
            on_purpose: left.filter(|left| !left.all).map(|left| left.left_out),
            bias: None,
            unmet: [0, 0],
        }
    }

    /// True where nothing is known to be missing.
    pub fn is_nothing(&self) -> bool {
        self.missed.is_empty() && self.on_purpose.is_none() && self.bias.is_none()
    }

    /// What to say before the work, for people.
    pub fn notes(&self, scene: &Scene) -> String {
        let mut text = String::new();
        let name = self.integrator;
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
        let part = |missed: &Missed| !missed.all;
        let in_part = !self.missed.is_empty() && self.missed.iter().all(part);
        if let Some(lost) = plan(scene).out_of_reach.filter(|_| in_part) {
            text += &format!("note: {} is out of reach: {}\n", lost.paths, lost.reason);
        }
        text
    }

    /// The integrator, where it cannot find all that is wanted.
    pub fn finder(&self) -> Option<&'static str> {
        (!self.missed.is_empty()).then_some(self.integrator)
    }

    /// What is not in the error of the picture, in words; `None` where everything is.
    pub fn unknown(&self) -> Option<String> {
        if !self.words.is_empty() {
            let words = self.words.join(", ");
            return Some(format!("{} leaves out {words} …", self.integrator));
        }
        (self.unmet[0] > 0).then(|| self.not_met())
    }

    /// What is found out when the picture is finished: the lamps that a walk has met.
    pub fn see(&mut self, scene: &Scene, rendered: &Rendered) {
        self.unmet = unmet(&self.entry, scene, rendered.lights_met);
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
        let ([unmet, all], name) = (self.unmet, self.integrator);
        format!("no sample of {name} has met {unmet} of {all} lamps")
    }

    /// How many lamps no sample has met, though chance alone finds them.
    pub fn unmet(&self) -> usize {
        self.unmet[0]
    }

    /// Why a picture is black, for people.
    pub fn why_black(&self, scene: &Scene, max_depth: u32) -> String {
        let why = why_black(scene, &self.entry, max_depth);
        match self.on_purpose {
            Some(_) if !scene.is_dark() => {
                format!("no light came by the paths that are asked for; {why}")
            }
            _ => why,
        }
    }
}
