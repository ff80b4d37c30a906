//! Chapter 14, exercises 2 and 3: a caustic that is seen in a mirror. What is its expression, and which
//! scene of the gallery has it? And the class of a word, by a loop.
//!
//! The light goes by way of mirrors or glass, `S+`, to one diffuse surface, `D`, and from there by
//! way of mirrors or glass again, `S+`, to the eye: `LS+DS+E`. Whether a scene can have such paths
//! is decided by its expression; how much light they bring is measured.

#![allow(clippy::print_stdout)]

use halfdisk::integrators::Path;
use halfdisk::lab::effects::language;
use halfdisk::lab::effects::words::words;
use halfdisk::notation::Expression;
use halfdisk::render::Options;
use halfdisk::scene::gallery::{self, GALLERY};
use std::error::Error;

const MIRRORED: &str = "LS+DS+E";

// ANCHOR: class
/// The number of a word's class, in the order of [`Class::ALL`](language::Class::ALL); `None` for what is no light path.
fn class(word: &str) -> Option<usize> {
    let letters = word.strip_prefix('L')?.strip_suffix('E')?;
    // The class of the word, if it ended here.
    letters
        .chars()
        .try_fold(0, |class, letter| match (class, letter) {
            (0 | 1, 'S') => Some(1),
            (2 | 3, 'S') => Some(3),
            (0, 'D' | 'G') => Some(2),
            (1, 'D' | 'G') => Some(5),
            (2 | 3, 'D' | 'G') => Some(4),
            (4 | 5, 'S' | 'D' | 'G') => Some(class),
            _ => None,
        })
}
// ANCHOR_END: class

/// The scenes whose paths can be such ones.
fn candidates(paths: &Expression) -> Result<Vec<&'static str>, Box<dyn Error>> {
    let mut found = Vec::new();
    for (name, _) in GALLERY {
        let scene = gallery::load(name)?;
        if let Some(all) = language::of_scene(&scene.inventory) {
            let here = all.light_first().intersection(paths.light_first());
            // Light that no walk from the eye finds is in no picture here.
            let lost = language::out_of_reach(&scene.inventory);
            let seen = scene.inventory.light_can_be_met() || lost.is_none();
            if seen && !here.is_empty() {
                found.push(*name);
            }
        }
    }
    Ok(found)
}

/// What these paths bring.
struct Share {
    /// Their share of the scene's light.
    light: f64,
    /// Its standard error.
    error: f64,
    /// How many brought some: each is a witness that there are such paths.
    paths: u64,
}

/// The share of these paths in a scene's light.
fn share(name: &str, paths: &Expression, side: u32) -> Result<Share, Box<dyn Error>> {
    let scene = gallery::load(name)?.sized([side; 2]);
    let options = Options {
        spp: 8,
        ..Options::default()
    };
    let path = Path::new(scene.suggested.max_depth);
    let words = words(&scene, &path, &options, 8);
    let own = words.shares.iter();
    let own = own.filter(|(word, _)| paths.light_first().accepts(&word.0));
    let (mut light, mut squared_error, mut found) = (0.0, 0.0, 0);
    for (_, share) in own {
        light += share.light.mean();
        squared_error += share.light.std_error().powi(2);
        found += share.paths;
    }
    let total = words.total.mean();
    Ok(Share {
        light: light / total,
        error: squared_error.sqrt() / total,
        paths: found,
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    let paths = MIRRORED.parse()?;
    println!("scenes that may have {MIRRORED}:");
    for name in candidates(&paths)? {
        let found = share(name, &paths, 64)?;
        let [light, error] = [found.light, found.error].map(|x| 100.0 * x);
        let paths = found.paths;
        println!("  {name:<9} {light:.3} ± {error:.3} % of the light, by {paths} paths");
    }
    for word in ["LSDSE", "LDSDE"] {
        let class = class(word).map_or("no light path", |i| language::Class::ALL[i].name());
        println!("{word}: {class}");
    }
    println!("to see one: halfdisk render spheres --paths '{MIRRORED}'");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use halfdisk::notation::Word;

    #[test]
    fn the_expression_says_what_it_should() {
        let paths: Expression = MIRRORED.parse().unwrap();
        for (word, inside) in [
            ("LSDSE", true),
            ("LSSDSSE", true),
            ("LSDE", false),
            ("LDSE", false),
            ("LSDDSE", false),
            ("LSSE", false),
        ] {
            let word = Word::read(word).unwrap();
            assert_eq!(paths.light_first().accepts(&word.0), inside, "{word}");
        }
    }

    #[test]
    fn the_loop_knows_the_class_of_every_word_of_up_to_six_letters() {
        let languages = language::Class::ALL.map(language::Class::expression);
        let mut in_a_class = 0;
        for length in 0..=6 {
            for number in 0..5_usize.pow(length) {
                let letters = (0..length).map(|i| b"LDSGE"[number / 5_usize.pow(i) % 5]);
                let text: String = letters.map(char::from).collect();
                let word = Word::read(&text).unwrap();
                let is_in = |e: &Expression| e.light_first().accepts(&word.0);
                assert_eq!(class(&text), languages.iter().position(is_in), "{text}");
                in_a_class += u32::from(class(&text).is_some());
            }
        }
        assert_eq!(
            in_a_class,
            1 + 3 + 9 + 27 + 81,
            "words of up to four surfaces"
        );
    }

    #[test]
    fn the_room_with_two_spheres_has_it_and_the_one_with_blocks_has_not() {
        let paths: Expression = MIRRORED.parse().unwrap();
        let found = candidates(&paths).unwrap();
        assert!(found.contains(&"spheres") && !found.contains(&"cornell"));
        let seen = share("mixture", &paths, 32).unwrap();
        assert!(seen.paths > 100 && seen.light > 4.4 * seen.error);
        let unseen = share("cornell", &paths, 16).unwrap();
        assert_eq!((unseen.paths, unseen.light), (0, 0.0));
    }
}
