//! Light of a scene that an integrator cannot find, however long it looks.

use super::language;
use crate::integrators::Named;
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

const SKY: &str = "the sky";
const POINTS: &str = "point and directional lights";

/// The light of a scene that an integrator leaves out, of the words that are `wanted` or else of all.
pub fn missed(named: Named, inventory: &Inventory, wanted: Option<&Language>) -> Vec<Missed> {
    let Some(scene) = language::of_scene(inventory) else {
        return Vec::new();
    };
    let extended = language::everything();
    // A light without extent is seen only where a rough surface shows it.
    let point = language::known("L(D|S|G)*(D|G)(D|S|G)*E");
    let (lamps, points) = (language::of_lamps(named), language::of_points(named));
    let kinds = [
        (inventory.area_lights > 0, "lamps", &extended, lamps.clone()),
        (inventory.sky == Sky::Image, SKY, &extended, lamps),
        (
            inventory.sky == Sky::Constant,
            SKY,
            &extended,
            language::of_sky(named),
        ),
        (inventory.point_lights > 0, POINTS, &point, points),
    ];
    let mut missed = Vec::new();
    for (present, light_of, possible, found) in kinds {
        let mut all = scene.light_first().intersection(possible.light_first());
        if let Some(wanted) = wanted {
            all = all.intersection(wanted);
        }
        let lost = match found.as_ref().map(Expression::light_first) {
            Some(found) => all.difference(found),
            None => all.clone(),
        };
        if present && !lost.is_empty() {
            missed.push(Missed {
                light_of,
                words: lost.shortest(SHOWN).iter().map(Word::to_string).collect(),
                all: lost.includes(&all),
                reason: reason(named, light_of),
            });
        }
    }
    missed
}

/// Lamps that an integrator finds by chance alone and has not met, so that their light is not in the scatter of
/// its samples either: how many of how many. `met` is what [`Tracer::lamps_met`] says.
pub fn unmet(named: Named, scene: &Scene, met: u64) -> [usize; 2] {
    if !matches!(named, Named::Kajiya | Named::Roulette) {
        return [0, 0];
    }
    let lamps = (0..scene.lights.len().min(<Tracer>::LAMPS_NOTED as usize))
        .filter(|&i| !scene.lights[i].is_delta() && scene.environment_light != Some(i));
    let unmet = lamps.clone().filter(|&i| met & 1 << i == 0);
    [unmet.count(), lamps.count()]
}

/// True where an integrator finds none of a scene's light, though there is some.
pub fn misses_everything(named: Named, inventory: &Inventory) -> bool {
    let kinds = [
        inventory.area_lights > 0,
        inventory.sky != Sky::Black,
        inventory.point_lights > 0,
    ];
    let missed = missed(named, inventory, None);
    let all = missed.iter().filter(|missed| missed.all).count();
    all > 0 && all == kinds.into_iter().filter(|&present| present).count()
}

fn reason(named: Named, light_of: &str) -> &'static str {
    match (named, light_of) {
        (Named::Whitted, SKY) => {
            "it aims at a sky from rough surfaces only where the sky is an image, and goes no further"
        }
        (Named::Whitted, POINTS) => {
            "it aims from the first rough surface of a path and goes no further, and no aim goes through \
             mirrors or glass"
        }
        (Named::Whitted, _) => "it aims from the first rough surface of a path and goes no further",
        (Named::Kajiya | Named::Roulette, _) => "a random walk never meets a point or a direction",
        (Named::WhichRay | Named::NextEvent | Named::Combine | Named::Path, _) => {
            "no walk from the eye meets a point or a direction, and no shadow ray goes through mirrors or \
             glass"
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn room() -> Inventory {
        Inventory {
            area_lights: 1,
            diffuse: 5,
            scattering: 5,
            ..Inventory::default()
        }
    }

    fn words(named: Named, inventory: &Inventory) -> Vec<(bool, String)> {
        let missed = missed(named, inventory, None);
        let one = |m: Missed| (m.all, m.words[..2].join(" "));
        missed.into_iter().map(one).collect()
    }

    #[test]
    fn each_integrator_says_the_words_it_lacks() {
        let room = room();
        assert_eq!(words(Named::Path, &room), []);
        assert_eq!(words(Named::Kajiya, &room), []);
        assert_eq!(words(Named::Whitted, &room), [(false, "LDDE LDDDE".into())]);
        let point = Inventory {
            area_lights: 0,
            point_lights: 1,
            ..room.clone()
        };
        for walk in [Named::Kajiya, Named::Roulette] {
            assert_eq!(words(walk, &point), [(true, "LDE LDDE".into())]);
            assert!(misses_everything(walk, &point));
        }
        assert_eq!(words(Named::Combine, &point), []);
        let glass = Inventory {
            specular: 1,
            scattering: 6,
            ..point
        };
        assert_eq!(words(Named::Path, &glass), [(false, "LSDE LSDDE".into())]);
        let both = Inventory {
            area_lights: 1,
            ..glass
        };
        let kajiya = words(Named::Kajiya, &both);
        assert_eq!(kajiya, [(true, "LDE LDDE".into())], "lamps are found");
        assert!(!misses_everything(Named::Kajiya, &both));
        assert!(!misses_everything(Named::Path, &both));
    }

    #[test]
    fn what_is_not_wanted_is_not_missed() {
        let direct = language::known("LDE");
        let wanted = Some(direct.light_first());
        assert_eq!(missed(Named::Whitted, &room(), wanted), []);
        assert_eq!(missed(Named::Whitted, &Inventory::default(), None), []);
    }
}
