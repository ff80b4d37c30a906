//! Chapter 7, exercise 2: how many paths for each ray from the eye?
//!
//! A sample of `s` paths has the variance `V1 + V2 / s`, where `V1` is what the ray from the eye
//! decides, and costs `c + s r`: `c` for that ray, `r` for the rays of each path. Variance times
//! cost is least for `s = √(c V2 / (r V1))`. Two measurements give `V1` and `V2`, a third one checks
//! them.

#![allow(clippy::print_stdout)]

#[path = "../../chapters/ch07_one_ray/split.rs"]
mod split;

use halfdisk::render::{Options, Rendered, render};
use halfdisk::scene::{Scene, SceneError, gallery};
use split::Split;

/// What a ray from the eye and what the rest of the path leaves to chance, and rays of a path.
struct Shares {
    eye: f64,
    rest: f64,
    rays: f64,
}

fn scene() -> Result<Scene, SceneError> {
    gallery::load("cornell").map(|scene| scene.sized([24; 2]))
}

fn paint(scene: &Scene, paths: u32, spp: u32) -> Rendered {
    let split = Split {
        paths,
        max_depth: 4,
    };
    let options = Options {
        spp,
        seed: u64::from(paths),
        ..Options::default()
    };
    render(scene, &split, &options, &())
}

/// Variance of a sample in the lower half of the box, where the lamp is not.
fn variance(found: &Rendered) -> f64 {
    let height = found.film.height();
    found.film.rows(height / 2..height).sample_variance()
}

fn measure(scene: &Scene, spp: u32) -> Shares {
    let (one, many) = (paint(scene, 1, spp), paint(scene, 16, spp));
    // V1 + V2 and V1 + V2 / 16.
    let rest = (variance(&one) - variance(&many)) * 16.0 / 15.0;
    Shares {
        eye: variance(&one) - rest,
        rest,
        rays: one.rays.total() as f64 / one.rays.camera as f64 - 1.0,
    }
}

impl Shares {
    fn variance(&self, paths: f64) -> f64 {
        self.eye + self.rest / paths
    }

    /// Variance times cost, where a ray from the eye costs as much as `cost` others.
    fn price(&self, paths: f64, cost: f64) -> f64 {
        self.variance(paths) * (cost + paths * self.rays)
    }

    fn best(&self, cost: f64) -> f64 {
        (cost * self.rest / (self.rays * self.eye)).sqrt()
    }
}

fn main() -> Result<(), SceneError> {
    let shares = measure(&scene()?, 256);
    println!(
        "the ray from the eye decides {:.2e}, the rest {:.2e} for {:.2} rays",
        shares.eye, shares.rest, shares.rays
    );
    for cost in [1.0, 10.0, 100.0] {
        let best = shares.best(cost);
        println!(
            "a ray from the eye costs {cost}: best are {best:.2} paths, {:.2} times as dear is one",
            shares.price(1.0, cost) / shares.price(best, cost)
        );
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_splits_foretell_a_third_and_the_best_is_the_best() {
        let scene = scene().expect("the box");
        let shares = measure(&scene, 192);
        let (told, found) = (shares.variance(4.0), variance(&paint(&scene, 4, 192)));
        assert!((told / found - 1.0).abs() < 0.08, "{told} and {found}");
        for cost in [1.0, 10.0, 100.0] {
            let best = shares.best(cost);
            for other in [0.5 * best, 2.0 * best] {
                assert!(shares.price(best, cost) < shares.price(other, cost));
            }
        }
        // Ten times the cost, √10 times the paths.
        let growth = shares.best(100.0) / shares.best(10.0);
        assert!((growth * growth - 10.0).abs() < 1e-9);
    }
}
