//! Light of a scene that an integrator cannot find, however long it looks.

use super::language;
use crate::integrators::Entry;
use crate::notation::{Expression, Language, Word};
use crate::scene::{Inventory, Scene, Sky, Tracer};
use serde::Serialize;

/// Light of one kind of source that an integrator leaves out.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Missed {
    /// Whose light it is.
    pub light_of: &'static str,
    /// Its shortest words.
    pub words: Vec<String>,
    /// True where it is all light of these sources.
    pub all: bool,
    /// Why it is left out.
    pub reason: &'static str,
}

/// Words shown of a language.
const SHOWN: usize = 3;

/// The light of a scene that an integrator leaves out, of the words that are `wanted` or else of all.
pub fn missed(entry: &Entry, inventory: &Inventory, wanted: Option<&Language>) -> Vec<Missed> {
    let mut missed = Vec::new();
    for source in language::by_source(entry, inventory) {
        let all = match wanted {
            Some(wanted) => source.there_are.intersection(wanted),
            None => source.there_are,
        };
        let lost = match source.found.as_ref().map(Expression::light_first) {
            Some(found) => all.difference(found),
            None => all.clone(),
        };
        if !lost.is_empty() {
            missed.push(Missed {
                light_of: source.name,
                words: lost.shortest(SHOWN).iter().map(Word::to_string).collect(),
                all: lost.includes(&all),
                reason: source.because,
            });
        }
    }
    missed
}

/// Lamps that an integrator finds by chance alone and has not met, so that their light is not in the scatter of
/// its samples either: how many of how many. `met` is what [`Tracer::lights_met`] says.
pub fn unmet(entry: &Entry, scene: &Scene, met: u64) -> [usize; 2] {
    if !entry.finds().is_some_and(|finds| finds.by_chance) {
        return [0, 0];
    }
    let lamps = (0..scene.lights.len().min(Tracer::LIGHTS_NOTED as usize))
        .filter(|&i| !scene.lights[i].is_delta() && scene.environment_light != Some(i));
    let unmet = lamps.clone().filter(|&i| met & 1 << i == 0);
    [unmet.count(), lamps.count()]
}

/// True where an integrator finds none of a scene's light, though there is some.
pub fn misses_everything(entry: &Entry, inventory: &Inventory) -> bool {
    let kinds = [
        inventory.area_lights > 0,
        inventory.sky != Sky::Black,
        inventory.point_lights > 0,
    ];
    let missed = missed(entry, inventory, None);
    let all = missed.iter().filter(|missed| missed.all).count();
    all > 0 && all == kinds.into_iter().filter(|&present| present).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrators::{Combine, Kajiya, Path, Roulette, Whitted};

    fn room() -> Inventory {
        Inventory {
            area_lights: 1,
            diffuse: 5,
            scattering: 5,
            ..Inventory::default()
        }
    }

    fn words(entry: Entry, inventory: &Inventory) -> Vec<(bool, String)> {
        let missed = missed(&entry, inventory, None);
        let one = |m: Missed| (m.all, m.words[..2].join(" "));
        missed.into_iter().map(one).collect()
    }

    #[test]
    fn each_integrator_says_the_words_it_lacks() {
        let room = room();
        assert_eq!(words(Path::ENTRY, &room), []);
        assert_eq!(words(Kajiya::ENTRY, &room), []);
        assert_eq!(words(Whitted::ENTRY, &room), [(false, "LDDE LDDDE".into())]);
        let point = Inventory {
            area_lights: 0,
            point_lights: 1,
            ..room.clone()
        };
        for walk in [Kajiya::ENTRY, Roulette::ENTRY] {
            assert_eq!(words(walk, &point), [(true, "LDE LDDE".into())]);
            assert!(misses_everything(&walk, &point));
        }
        assert_eq!(words(Combine::ENTRY, &point), []);
        let glass = Inventory {
            specular: 1,
            scattering: 6,
            ..point
        };
        assert_eq!(words(Path::ENTRY, &glass), [(false, "LSDSE LSDDSE".into())]);
        assert_eq!(
            words(Combine::ENTRY, &glass),
            [(false, "LSDE LSDDE".into())]
        );
        let both = Inventory {
            area_lights: 1,
            ..glass
        };
        let kajiya = words(Kajiya::ENTRY, &both);
        assert_eq!(kajiya, [(true, "LDE LDDE".into())], "lamps are found");
        assert!(!misses_everything(&Kajiya::ENTRY, &both));
        assert!(!misses_everything(&Path::ENTRY, &both));
    }

    #[test]
    fn what_is_not_wanted_is_not_missed() {
        let direct = language::known("LDE");
        let wanted = Some(direct.light_first());
        assert_eq!(missed(&Whitted::ENTRY, &room(), wanted), []);
        assert_eq!(missed(&Whitted::ENTRY, &Inventory::default(), None), []);
    }
}
