//! Chapter 14, exercise 1: a caustic that is seen in a mirror. What is its expression, and which
//! scene of the gallery has it?
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
