//! Chapter 9, exercise 2: a lamp behind a baffle.
//!
//! A baffle that hides part of the lamp makes shadow rays fail, and chance fails with them: the
//! walk that would have met the hidden part meets the baffle, too. The second moment of both grows
//! by the same factor, so aiming keeps its advantage, whatever the baffle. Aiming loses where it
//! finds nothing at all: the shadow ray is then one more ray for the same zero.

#![allow(clippy::print_stdout)]

use glam::Vec2;
use halfdisk::flatland::gallery;
use halfdisk::integrators::{Kajiya, NextEvent};
use halfdisk::lab::estimators::walks::{self, Walks};
use halfdisk::scene::SceneError;
use halfdisk::scene::read::Source;
use halfdisk::space::{Flat, Ray};

/// Half the angle in which the lamp would be seen.
const HALF_ANGLE: f64 = 0.1;

/// What the floor below the lamp reflects, by chance and by aiming, where a baffle close below the
/// lamp leaves the share `open` of its angle to be seen.
fn measure(open: f64, count: u32) -> Result<(f64, [Walks; 2]), SceneError> {
    // Angles from the normal: the baffle hides what lies right of `edge`.
    let edge = HALF_ANGLE * (2.0 * open - 1.0);
    let half = libm::tan(HALF_ANGLE);
    let text = format!(
        "name = 'baffle'\n\
         [[objects]]\nalbedo = 1\nsegment = {{ from = [-9, 0], to = [9, 0] }}\n\
         [[objects]]\nalbedo = 0\nsegment = {{ from = [0.5, 0.9], to = [{:?}, 0.9] }}\n\
         [[objects]]\nemits = 1\nsegment = {{ from = [{half:?}, 1], to = [{:?}, 1] }}\n",
        0.9 * libm::tan(edge),
        -half
    );
    let world = gallery::from_text(Source {
        file: "baffle",
        text: &text,
    })?;
    let truth = 0.5 * (libm::sin(edge) + libm::sin(HALF_ANGLE));
    let ray = Ray::<Flat>::new(Vec2::new(-0.5, 0.25), Vec2::new(2.0, -1.0).normalize());
    let max_depth = 2;
    let chance = walks::flat(&world, truth, count, 1, |world, stream| {
        Kajiya { max_depth }.walk(world, &ray, stream)
    });
    let aim = walks::flat(&world, truth, count, 1, |world, stream| {
        NextEvent { max_depth }.walk(world, &ray, stream)
    });
    Ok((truth, [chance, aim]))
}

fn main() -> Result<(), SceneError> {
    for open in [1.0, 0.5, 0.1, 0.01, 0.0] {
        let (truth, [chance, aim]) = measure(open, 400_000)?;
        let second = |walks: &Walks| walks.squares.mean() + truth * truth;
        println!(
            "{open:4} of the lamp in sight: second moment {:.2e} by chance, {:.2e} by aiming, ratio \
             {:.2}; rays {:.2} and {:.2}",
            second(&chance),
            second(&aim),
            second(&chance) / second(&aim),
            chance.rays_each(),
            aim.rays_each()
        );
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_baffle_takes_from_both_alike() {
        for open in [1.0, 0.5, 0.1] {
            let (truth, both) = measure(open, 400_000).expect("a world");
            for walks in &both {
                assert!(walks.estimate.z(truth).abs() <= 4.0, "{open}: {walks:?}");
            }
            let [chance, aim] = both.map(|walks| walks.squares.mean() + truth * truth);
            // One over the lamp's angle, for one half times the cosine.
            let ratio = chance / aim * HALF_ANGLE;
            assert!((ratio - 1.0).abs() < 0.05, "{open}: {ratio}");
        }
    }

    #[test]
    fn behind_a_whole_baffle_aiming_is_a_ray_for_nothing() {
        let (_, [chance, aim]) = measure(0.0, 1000).expect("a world");
        assert_eq!(chance.estimate.mean(), 0.0);
        assert_eq!(aim.estimate.mean(), 0.0);
        assert!(aim.rays_each() > chance.rays_each());
    }
}
