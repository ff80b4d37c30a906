//! What is simulated and what is not, with a reason for each, from the scene alone.

use super::language;
use crate::notation::{Expression, Language, Word};
use crate::numeric::count;
use crate::scene::{Effect, Inventory, Scene, Sky};
use serde::Serialize;
use std::fmt::{self, Display, Formatter};

/// What a scene calls for.
#[derive(Clone, Debug, Serialize)]
pub struct Plan {
    /// One line for each effect, in the order of [`Effect::ALL`].
    pub lines: Vec<Line>,
    /// The paths the scene can have, as an expression; `None` where no light reaches the eye.
    pub paths: Option<String>,
    /// Light that is there, and that neither walks from the eye nor walks from the lights find.
    pub out_of_reach: Option<OutOfReach>,
    /// What a reader of the scene file may want to know.
    pub notes: Vec<String>,
}

/// One effect.
#[derive(Clone, Debug, Serialize)]
pub struct Line {
    /// Which.
    pub effect: Effect,
    /// Whether it is simulated.
    pub simulated: bool,
    /// Why, or why not, in a sentence.
    pub reason: String,
}

/// Light that is there, and that neither walks from the eye nor walks from the lights find.
#[derive(Clone, Debug, Serialize)]
pub struct OutOfReach {
    /// Its paths.
    pub paths: String,
    /// Why, in a sentence.
    pub reason: String,
}

/// What a demand for certain paths leaves of a scene's.
#[derive(Clone, Debug, Serialize)]
pub struct Demand {
    /// True where every path of the scene is wanted.
    pub all: bool,
    /// The shortest words that are wanted and may occur.
    pub kept: Vec<String>,
    /// The shortest words that occur and are not wanted.
    pub left_out: Vec<String>,
}

/// Words shown of a language.
const SHOWN: usize = 5;

impl Display for Plan {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        for (simulated, title) in [(true, "simulated"), (false, "not simulated")] {
            let lines = || self.lines.iter().filter(|l| l.simulated == simulated);
            if lines().next().is_some() {
                writeln!(f, "\n{title}")?;
            }
            for line in lines() {
                writeln!(f, "  {:<13} {}", line.effect.name(), line.reason)?;
            }
        }
        let none = "none, so the picture is black";
        let paths = self.paths.as_deref().unwrap_or(none);
        writeln!(f, "\nlight paths: {paths}")?;
        if let Some(OutOfReach { paths, reason }) = &self.out_of_reach {
            writeln!(f, "out of reach: {paths}: {reason}")?;
        }
        self.notes
            .iter()
            .try_for_each(|note| writeln!(f, "note: {note}"))
    }
}

impl Display for Demand {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        if self.all {
            return writeln!(f, "the demand: every path of the scene");
        }
        writeln!(f, "the demand keeps {} …", self.kept.join(", "))?;
        writeln!(f, "        and leaves out {} …", self.left_out.join(", "))
    }
}

/// What a scene calls for.
pub fn plan(scene: &Scene) -> Plan {
    let inventory = &scene.inventory;
    let effects = inventory.effects();
    let line = |effect| Line {
        effect,
        simulated: effects.has(effect),
        reason: reason(effect, inventory),
    };
    let out_of_reach = language::out_of_reach(inventory).map(|paths| OutOfReach {
        paths: paths.to_string(),
        reason: "a light without extent, seen by way of what it is focused on: mirrors or glass bind a walk \
                 from the eye and one from the light to single directions, so that they meet with \
                 probability 0, and no straight line joins them: they read exactly 0. Only `photons` \
                 finds it, blurred, for it takes what lands nearby"
            .to_owned(),
    });
    Plan {
        lines: Effect::ALL.map(line).to_vec(),
        paths: language::of_scene(inventory).map(|paths| paths.to_string()),
        out_of_reach,
        notes: notes(scene),
    }
}

/// What a demand leaves of a scene's paths; `None` where nothing is left.
pub fn demand(inventory: &Inventory, wanted: &Language) -> Option<Demand> {
    let scene = language::of_scene(inventory)?;
    let all = scene.light_first();
    let kept = all.intersection(wanted);
    let words = |language: &Language| {
        let words = language.shortest(SHOWN);
        words.iter().map(Word::to_string).collect::<Vec<_>>()
    };
    let left_out = all.difference(wanted);
    (!kept.is_empty()).then(|| Demand {
        all: left_out.is_empty(),
        kept: words(&kept),
        left_out: words(&left_out),
    })
}

/// Why an expression can have no path of any scene, where it cannot.
pub fn never_a_path(wanted: &Expression) -> Option<&'static str> {
    let paths = language::everything();
    let any = wanted.light_first().intersection(paths.light_first());
    any.is_empty().then_some(
        "matches no light path: a path is L for the light, then any number of D, S and G, then E \
         for the eye",
    )
}

/// Why an effect is simulated, or why not, in a sentence.
pub fn reason(effect: Effect, has: &Inventory) -> String {
    let simulated = has.effects().has(effect);
    if has.is_dark() {
        return "nothing shines, so there is nothing to simulate".to_owned();
    }
    match (effect, simulated) {
        (Effect::PointLights, true) => {
            let (one, many) = ("light without extent", "lights without extent");
            let how = match has.is_rough() {
                true => ": found by shadow rays, for no path can meet them",
                false => ", but only rough surfaces show it, and there are none",
            };
            count(has.point_lights, one, many) + how
        }
        (Effect::PointLights, false) => "no light is a point or a direction".to_owned(),
        (Effect::AreaLights, true) => {
            let how = match has.is_rough() {
                true => "aimed at, met by chance, and weighted by how likely either was",
                false => "met by paths, for no surface is rough and could aim",
            };
            let lights = count(has.area_lights, "surface shines", "surfaces shine");
            format!("{lights}: {how}")
        }
        (Effect::AreaLights, false) => "no surface shines".to_owned(),
        (Effect::Sky, true) => match has.sky {
            Sky::Image if has.is_rough() => {
                "an image surrounds the scene: aimed at, and met by rays that leave"
            }
            Sky::Image => "an image surrounds the scene: met by rays that leave",
            _ => "the same light comes from everywhere beyond the scene: met by rays that leave",
        }
        .to_owned(),
        (Effect::Sky, false) => "no light comes from beyond the scene".to_owned(),
        (Effect::Diffuse, true) => format!(
            "{} light in all directions alike",
            count(has.diffuse, "object scatters", "objects scatter")
        ),
        (Effect::Diffuse, false) => "no object scatters light in all directions alike".to_owned(),
        (Effect::Specular, true) => format!(
            "{} light in single directions",
            count(
                has.specular,
                "object mirrors or refracts",
                "objects mirror or refract"
            )
        ),
        (Effect::Specular, false) => "nothing is a mirror or glass".to_owned(),
        (Effect::Gloss, true) => format!(
            "{} light around a direction",
            count(has.glossy, "object scatters", "objects scatter")
        ),
        (Effect::Gloss, false) => "nothing is a rough mirror or rough glass".to_owned(),
        (Effect::Bleeding, true) if has.diffuse + has.glossy == has.flat && has.flat == 1 => {
            "one flat surface is rough, and may light itself by way of mirrors or glass".to_owned()
        }
        (Effect::Bleeding, true) => "rough surfaces may light each other".to_owned(),
        (Effect::Bleeding, false) if !has.is_rough() => {
            "no surface is rough: light goes on in single directions".to_owned()
        }
        (Effect::Bleeding, false) => {
            "there is one flat surface, which cannot light itself".to_owned()
        }
        (Effect::Caustics, simulated) => caustics(simulated, has),
        (Effect::Lens, simulated) => match has.lens.filter(|_| simulated) {
            Some(lens) => format!(
                "the lens has a radius of {} and is focused at a distance of {}",
                lens.radius, lens.focus
            ),
            None => {
                "the camera is a pinhole: its lens has a radius of 0, or there is none".to_owned()
            }
        },
        (Effect::Motion, true) => format!(
            "{} while the shutter is open",
            count(has.moving, "object moves", "objects move")
        ),
        (Effect::Motion, false) if has.frozen > 0 => format!(
            "{} a motion, but the shutter is open for no time",
            count(has.frozen, "object has", "objects have")
        ),
        (Effect::Motion, false) => "nothing moves".to_owned(),
    }
}

fn caustics(simulated: bool, has: &Inventory) -> String {
    if simulated {
        let looked = match has.casters {
            0 => String::new(),
            n => format!(
                ", and by looking towards {}",
                count(n, "mirror or glass", "mirrors and glasses")
            ),
        };
        let met = has.light_can_be_met();
        return match has.caustics_start_at_lights() {
            true if met => format!(
                "mirrors or glass, rough surfaces, and light: traced from the lights; what is seen in mirrors \
                 or through glass is found by chance{looked}"
            ),
            true => {
                "mirrors or glass, rough surfaces, and light: traced from the lights".to_owned()
            }
            false => format!(
                "mirrors or glass, rough surfaces, and light that can be met: found by chance{looked}"
            ),
        };
    }
    if has.specular == 0 {
        "nothing is a mirror or glass, so nothing focuses light"
    } else {
        "no surface is rough, so none shows focused light"
    }
    .to_owned()
}

fn notes(scene: &Scene) -> Vec<String> {
    let mut notes = Vec::new();
    let unused = &scene.inventory.unused_materials;
    if !unused.is_empty() {
        let (are, it, counts) = match unused.as_slice() {
            [_] => ("is", "it", "it counts"),
            _ => ("are", "them", "they count"),
        };
        notes.push(format!(
            "{} {are} defined, but no object uses {it}: {counts} for nothing",
            unused.join(", ")
        ));
    }
    if !scene.is_dark() && !scene.inventory.is_alone() {
        notes.push(format!(
            "paths end at {} segments, which is {} between light and eye (`max_depth`)",
            scene.suggested.max_depth,
            count(
                scene.suggested.max_depth as usize - 1,
                "surface",
                "surfaces"
            )
        ));
    }
    notes
}
