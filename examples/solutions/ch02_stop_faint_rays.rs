//! Chapter 2, exercise 2: stop following rays of small weight; measure what it saves and costs.
//!
//! The integrator below is Whitted's with one more condition. It uses the library's scene,
//! materials and random numbers, so both pictures are of the same samples, and their difference is
//! the bias alone.

#![allow(clippy::print_stdout)]

use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Integrator, direct_light};
use halfdisk::render::{Film, Options, Rendered, compare, render};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::{Interaction, Scene, SceneError, Tracer, gallery};

/// Whitted's tree without its faint branches.
struct StopFaint {
    max_depth: u32,
    /// Rays that carry less than this share of a pixel's light are not followed.
    epsilon: f32,
}

impl Integrator for StopFaint {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let hit = tracer.camera_ray(ray);
        let root = Node {
            id: 1,
            depth: 1,
            weight: 1.0,
        };
        self.follow(tracer, ray, hit, root, stream)
    }
}

/// A place in the tree.
#[derive(Clone, Copy)]
struct Node {
    id: u64,
    depth: u32,
    weight: f32,
}

impl StopFaint {
    fn follow(
        &self,
        tracer: &mut Tracer,
        ray: &Ray,
        hit: Option<Interaction>,
        here: Node,
        stream: &Stream,
    ) -> Rgb {
        let Some(hit) = hit else {
            return tracer.scene().background(ray.direction);
        };
        let mut li = hit.emission;
        let (Some(bsdf), true) = (hit.bsdf, here.depth < self.max_depth) else {
            return li;
        };
        li += direct_light(tracer, &hit, here.id, stream);
        let specular = bsdf.specular(hit.wo);
        let branches = [
            (specular.reflected, 2 * here.id),
            (specular.transmitted, 2 * here.id + 1),
        ];
        for (branch, id) in branches {
            let Some(branch) = branch else { continue };
            let weight = here.weight * branch.weight.mean();
            // The new condition.
            if weight >= self.epsilon {
                let next_ray = hit.surface.spawn(hit.frame.to_world(branch.wi).normalize());
                let next_hit = tracer.secondary_ray(&next_ray);
                let next = Node {
                    id,
                    depth: here.depth + 1,
                    weight,
                };
                li += branch.weight * self.follow(tracer, &next_ray, next_hit, next, stream);
            }
        }
        li
    }
}

fn picture(scene: &Scene, epsilon: f32) -> Rendered {
    let options = Options {
        spp: 4,
        ..Options::default()
    };
    render(
        scene,
        &StopFaint {
            max_depth: 10,
            epsilon,
        },
        &options,
        &(),
    )
}

fn mean(film: &Film) -> f64 {
    film.mean().0
}

fn main() -> Result<(), SceneError> {
    let scene = gallery::load("whitted")?;
    let whole = picture(&scene, 0.0);
    println!(
        "whole tree: {} rays, mean {:.6}",
        whole.rays.total(),
        mean(&whole.film)
    );
    for epsilon in [0.0001, 0.001, 0.01, 0.1] {
        let cut = picture(&scene, epsilon);
        println!(
            "below {epsilon}: {:.1} % of the rays, bias of the mean {:+.6}, largest pixel error {:.2e} RMS",
            100.0 * cut.rays.total() as f64 / whole.rays.total() as f64,
            mean(&cut.film) - mean(&whole.film),
            compare::mse(&cut.film.picture(), &whole.film.picture()).sqrt(),
        );
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use halfdisk::integrators::Whitted;

    #[test]
    fn without_a_threshold_it_is_whitteds_tree_and_with_one_it_is_darker_and_cheaper() {
        let scene = gallery::load("whitted").unwrap();
        let options = Options {
            spp: 4,
            ..Options::default()
        };
        let whitted = render(&scene, &Whitted { max_depth: 10 }, &options, &());
        let whole = picture(&scene, 0.0);
        assert_eq!(whole.film, whitted.film, "the same bits");
        let cut = picture(&scene, 0.01);
        assert!(cut.rays.total() < whole.rays.total());
        assert!(mean(&cut.film) < mean(&whole.film));
    }
}
