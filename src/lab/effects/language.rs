//! Light paths of a scene, of an integrator and of a class, as expressions.

use crate::integrators::{Entry, Found};
use crate::notation::{Expression, Language};
use crate::scene::{Effect, Effects, Inventory, Sky};

/// An expression that is known to be one.
pub(super) fn known(text: &str) -> Expression {
    match Expression::parse(text) {
        Ok(expression) => expression,
        Err(error) => unreachable!("{error}"),
    }
}

/// Classes of light paths; every path is in exactly one. A surface of kind `D` or `G` is rough.
///
/// Caustics and bleeding are defined here, and nowhere else: what [`Effect::Caustics`] and
/// [`Effect::Bleeding`] bring are the words of these classes.
///
/// Source: Heckbert, Adaptive Radiosity Textures for Bidirectional Ray Tracing (SIGGRAPH 1990), for
/// the notation, and for `LS+DE`, the caustic, and `LD+E`, the light between diffuse surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Class {
    /// A lamp or the sky, seen.
    Seen,
    /// The same by way of mirrors and glass.
    SeenSpecular,
    /// Light that a rough surface sends to the eye.
    Direct,
    /// The same by way of mirrors and glass.
    DirectSpecular,
    /// Light that its first rough surface receives from the light itself, and hands on to another one:
    /// colour that bleeds, `LDDE`, also by way of mirrors and glass, `LDSDE`.
    Bleeding,
    /// Light that mirrors or glass hand from the light to its first rough surface: there is nothing
    /// but `S`, at least once, between `L` and the first `D` or `G`. What becomes of it afterwards
    /// does not matter: `LSDE`, `LSDSE` and `LSDDE` are caustics, `LDSDE` is none.
    Caustic,
}

impl Class {
    /// All of them: what Whitted's ray tracing finds first.
    pub const ALL: [Class; 6] = [
        Class::Seen,
        Class::SeenSpecular,
        Class::Direct,
        Class::DirectSpecular,
        Class::Bleeding,
        Class::Caustic,
    ];

    /// Its words.
    pub fn text(self) -> &'static str {
        match self {
            Class::Seen => "LE",
            Class::SeenSpecular => "LS+E",
            Class::Direct => "L(D|G)E",
            Class::DirectSpecular => "L(D|G)S+E",
            Class::Bleeding => "L(D|G)S*(D|G)(D|S|G)*E",
            Class::Caustic => "LS+(D|G)(D|S|G)*E",
        }
    }

    /// What it is called.
    pub fn name(self) -> &'static str {
        match self {
            Class::Seen => "lamps and sky, seen",
            Class::SeenSpecular => "lamps and sky in mirrors and glass",
            Class::Direct => "direct light",
            Class::DirectSpecular => "direct light in mirrors and glass",
            Class::Bleeding => "light between rough surfaces",
            Class::Caustic => "caustics",
        }
    }

    /// The same as an expression.
    pub fn expression(self) -> Expression {
        known(self.text())
    }
}

/// The paths that count.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// Their words from the light to the eye.
    pub light_first: Language,
    /// The same from the eye to the light.
    pub eye_first: Language,
}

impl Wanted {
    /// Those that an expression matches.
    pub fn new(paths: &Expression) -> Self {
        Wanted {
            light_first: paths.light_first().clone(),
            eye_first: paths.eye_first().clone(),
        }
    }

    /// Those among them that another expression does not match.
    #[must_use]
    pub fn but(self, paths: &Expression) -> Self {
        Wanted {
            light_first: self.light_first.difference(paths.light_first()),
            eye_first: self.eye_first.difference(paths.eye_first()),
        }
    }
}

/// All paths from a light to the eye.
pub fn everything() -> Expression {
    known("L(D|S|G)*E")
}

/// The paths a scene can have, but for their length; `None` in the dark.
pub fn of_scene(inventory: &Inventory) -> Option<Expression> {
    let effects = inventory.effects();
    if effects == Effects::default() {
        return None;
    }
    let any = letters(effects, true);
    let rough = letters(effects, false);
    let many = |set: &str| match set {
        "" => String::new(),
        // What is alone and rough scatters light once.
        _ if inventory.is_alone() => format!("{set}?"),
        _ => format!("{set}*"),
    };
    Some(if inventory.light_can_be_met() {
        known(&format!("L{}E", many(&any)))
    } else if rough.is_empty() {
        // A point that shines is too small to be seen, in a mirror, too.
        return None;
    } else if inventory.is_alone() {
        known(&format!("L{rough}E"))
    } else {
        known(&format!("L{any}*{rough}{any}*E"))
    })
}

/// The paths of a scene's lights without extent that neither walks from the eye nor walks from the lights can
/// find: they reach their first rough surface by way of mirrors or glass, and the eye by such a way, too. `None`
/// where there are none.
pub fn out_of_reach(inventory: &Inventory) -> Option<Expression> {
    let effects = inventory.effects();
    let rough = letters(effects, false);
    let focused = effects.has(Effect::PointLights) && effects.has(Effect::Specular);
    (focused && !rough.is_empty()).then(|| {
        let any = letters(effects, true);
        known(&format!("LS+{rough}{any}*SE"))
    })
}

/// `(D|S|G)` with the letters there are, or of the rough ones alone.
fn letters(effects: Effects, with_specular: bool) -> String {
    let letter = |effect, letter| effects.has(effect).then_some(letter);
    let found = [
        letter(Effect::Diffuse, "D"),
        letter(Effect::Specular, "S").filter(|_| with_specular),
        letter(Effect::Gloss, "G"),
    ];
    let found: Vec<&str> = found.into_iter().flatten().collect();
    match found.as_slice() {
        [] => String::new(),
        [one] => (*one).to_owned(),
        many => format!("({})", many.join("|")),
    }
}

/// What an integrator finds of a class of light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Finds {
    /// The scene has no such light.
    Absent,
    /// None of it.
    Nothing,
    /// Some of its words, or those of some lights.
    Part,
    /// All of it.
    All,
}

/// The light of one kind of source in a scene, and what an integrator finds of it.
pub(super) struct OfSource {
    /// Whose light it is.
    pub name: &'static str,
    /// Its paths in the scene.
    pub there_are: Language,
    /// Those that the integrator finds; `None` for none.
    pub found: Option<Expression>,
    /// Why it finds no others.
    pub because: &'static str,
}

/// The light of a scene by its sources; none of an integrator that shows something else.
pub(super) fn by_source(integrator: &Entry, inventory: &Inventory) -> Vec<OfSource> {
    let (Some(scene), Some(finds)) = (of_scene(inventory), integrator.finds()) else {
        return Vec::new();
    };
    // A light without extent is seen only where a rough surface shows it.
    let of_points = known("L(D|S|G)*(D|G)(D|S|G)*E");
    let of_points = of_points.light_first().intersection(scene.light_first());
    let of_others = scene.light_first();
    let points = "point and directional lights";
    [
        (inventory.area_lights > 0, "lamps", of_others, finds.lamps),
        (
            inventory.sky == Sky::Image,
            "the sky",
            of_others,
            finds.image,
        ),
        (
            inventory.sky == Sky::Constant,
            "the sky",
            of_others,
            finds.sky,
        ),
        (inventory.point_lights > 0, points, &of_points, finds.points),
    ]
    .into_iter()
    .filter(|(present, ..)| *present)
    .map(|(_, name, there_are, found)| OfSource {
        name,
        there_are: there_are.clone(),
        found: paths(&found),
        because: found.because,
    })
    .collect()
}

/// The paths that an integrator finds, as an expression; `None` for none.
pub fn paths(found: &Found) -> Option<Expression> {
    found.paths.map(known)
}

/// The paths that an integrator finds of lamps with extent; `None` for none.
pub fn of_lamps(integrator: &Entry) -> Option<Expression> {
    integrator.finds().and_then(|finds| paths(&finds.lamps))
}

/// What an integrator finds of a class of light in a scene.
pub fn finds(integrator: &Entry, class: Class, inventory: &Inventory) -> Finds {
    let class = class.expression();
    let answers = by_source(integrator, inventory)
        .into_iter()
        .filter_map(|source| {
            let all = source.there_are.intersection(class.light_first());
            (!all.is_empty()).then(|| share(source.found.as_ref(), &all))
        });
    answers
        .reduce(|a, b| if a == b { a } else { Finds::Part })
        .unwrap_or(Finds::Absent)
}

fn share(found: Option<&Expression>, all: &Language) -> Finds {
    match found.map(Expression::light_first) {
        Some(found) if found.includes(all) => Finds::All,
        Some(found) if !found.intersection(all).is_empty() => Finds::Part,
        _ => Finds::Nothing,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrators::{Kajiya, LADDER, Path, Whitted};

    #[test]
    fn every_path_is_in_exactly_one_class() {
        let mut rest = everything().light_first().clone();
        for class in Class::ALL {
            let words = class.expression();
            assert!(rest.includes(words.light_first()), "{}", class.text());
            rest = rest.difference(words.light_first());
        }
        assert!(rest.is_empty(), "{:?}", rest.shortest(3));
    }

    #[test]
    fn a_scene_has_the_paths_of_its_surfaces_and_lights() {
        let text = |inventory: &Inventory| of_scene(inventory).map(|e| e.to_string());
        let dark = Inventory::default();
        assert_eq!(text(&dark), None);
        let lamp = Inventory {
            area_lights: 1,
            ..dark.clone()
        };
        assert_eq!(text(&lamp).as_deref(), Some("LE"));
        let floor = Inventory {
            diffuse: 1,
            scattering: 1,
            flat: 1,
            ..lamp.clone()
        };
        assert_eq!(text(&floor).as_deref(), Some("LD?E"));
        let room = Inventory {
            diffuse: 3,
            scattering: 3,
            ..lamp.clone()
        };
        assert_eq!(text(&room).as_deref(), Some("LD*E"));
        let glass = Inventory {
            specular: 1,
            scattering: 4,
            ..room.clone()
        };
        assert_eq!(text(&glass).as_deref(), Some("L(D|S)*E"));
        let point = Inventory {
            area_lights: 0,
            point_lights: 1,
            ..glass.clone()
        };
        assert_eq!(text(&point).as_deref(), Some("L(D|S)*D(D|S)*E"));
        let lost = out_of_reach(&point).map(|e| e.to_string());
        assert_eq!(lost.as_deref(), Some("LS+D(D|S)*SE"));
        assert_eq!(out_of_reach(&glass).map(|e| e.to_string()), None);
        let mirror = Inventory {
            specular: 1,
            scattering: 1,
            diffuse: 0,
            ..point
        };
        assert_eq!(text(&mirror), None, "a point is too small to be seen");
    }

    #[test]
    fn the_table_states_paths_there_are_and_why_others_are_missing() {
        for entry in LADDER {
            let finds = entry.finds().unwrap();
            for found in [finds.lamps, finds.image, finds.sky, finds.points] {
                let all = everything();
                let lacks = match paths(&found) {
                    Some(some) => {
                        assert!(all.light_first().includes(some.light_first()));
                        !some.light_first().includes(all.light_first())
                    }
                    None => true,
                };
                assert_eq!(lacks, !found.because.is_empty(), "{}", entry.name);
            }
        }
    }

    #[test]
    fn what_integrators_find() {
        let room = Inventory {
            area_lights: 1,
            diffuse: 5,
            specular: 1,
            scattering: 6,
            ..Inventory::default()
        };
        let whitted = Class::ALL.map(|class| finds(&Whitted::ENTRY, class, &room));
        use Finds::*;
        assert_eq!(whitted, [All, All, All, All, Nothing, Nothing]);
        let point = Inventory {
            area_lights: 0,
            point_lights: 1,
            ..room
        };
        let path = Class::ALL.map(|class| finds(&Path::ENTRY, class, &point));
        assert_eq!(path, [Absent, Absent, All, All, All, Part]);
        let kajiya = Class::ALL.map(|class| finds(&Kajiya::ENTRY, class, &point));
        assert_eq!(kajiya, [Absent, Absent, Nothing, Nothing, Nothing, Nothing]);
        let both = Inventory {
            area_lights: 1,
            ..point
        };
        assert_eq!(finds(&Path::ENTRY, Class::Caustic, &both), Part);
        assert_eq!(finds(&Path::ENTRY, Class::Bleeding, &both), All);
    }
}
