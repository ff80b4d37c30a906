//! Chance against aim: variances in closed form, many lamps, and what counts twice; several paths
//! from one surface.

use crate::checks::{accept, alike, reject};
use crate::of_chapters::pick_one::PickOne;
use crate::of_chapters::shrinking_lamp::{self, Technique};
use crate::of_chapters::split::Split;
use glam::Vec2;
use halfdisk::color::Rgb;
use halfdisk::flatland::{self, FlatWorld, exact};
use halfdisk::integrators::world::FlatTracer;
use halfdisk::integrators::{Kajiya, NextEvent};
use halfdisk::lab::estimators::walks;
use halfdisk::lab::mistakes::count_twice::CountTwice;
use halfdisk::render::{Film, Options, render};
use halfdisk::sampling::discrete::Discrete;
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::gallery;
use halfdisk::scene::read::Source;
use halfdisk::space::{Flat, Ray};
use halfdisk::stats::slope::Line;

#[test]
fn s0_03_chance_costs_a_half_pi_over_the_half_angle_and_aim_next_to_nothing() {
    // Where 160 000 walks find the lamp, its variance is known to a quarter of a percent.
    for a in [0.3, 0.1, 0.03] {
        for technique in [Technique::Uniform, Technique::Cosine, Technique::Aim] {
            let count = (160_000.0 / technique.finds_flat(a)) as u32;
            let walks = shrinking_lamp::flat(technique, a, count, 5).unwrap();
            accept(
                &format!("{technique:?}, {a}"),
                &walks.estimate,
                libm::sin(a),
                2.0 * libm::sin(a),
            );
            let (truth, exact) = (libm::sin(a), technique.exact_flat(a));
            let name = format!("{technique:?}, {a}, variance");
            alike(&name, walks.relative_variance(truth), (exact, 0.0), 0.026);
        }
        // The laws are apart: neither would pass for the other.
        let [uniform, cosine] = [Technique::Uniform, Technique::Cosine].map(|t| t.exact_flat(a));
        assert!(uniform / cosine > 1.4);
    }
}

#[test]
fn the_variance_of_chance_falls_as_the_lamp_grows() {
    for technique in [Technique::Uniform, Technique::Cosine] {
        let points: Vec<(f64, f64)> = [0.03, 0.01, 0.003]
            .map(|a| {
                let count = (20_000.0 / technique.finds_flat(a)) as u32;
                let walks = shrinking_lamp::flat(technique, a, count, 6).unwrap();
                (a, walks.relative_variance(libm::sin(a)).0)
            })
            .to_vec();
        let slope = Line::through(&points).unwrap().slope;
        println!("{technique:?}: slope {slope:.4}");
        assert!((slope + 1.0).abs() <= 0.03, "{technique:?}: {slope}");
    }
}

#[test]
fn spheres_in_space_are_found_by_the_square() {
    for a in [0.6, 0.3, 0.1] {
        for technique in [Technique::Uniform, Technique::Cosine, Technique::Aim] {
            let count = match technique {
                Technique::Aim => 400_000,
                _ => (160_000.0 / (a * a)) as u32,
            };
            let walks = shrinking_lamp::solid(technique, a, count, 7).unwrap();
            let truth = libm::sin(a) * libm::sin(a);
            // π L (R / d)² of irradiance, of which a white floor reflects the share 1/π.
            accept(
                &format!("{technique:?}, {a}"),
                &walks.estimate,
                truth,
                2.0 * truth,
            );
            let name = format!("{technique:?}, {a}, variance");
            alike(
                &name,
                walks.relative_variance(truth),
                (technique.exact_solid(a), 0.0),
                0.040,
            );
        }
    }
}

fn world(text: &str) -> FlatWorld {
    flatland::gallery::from_text(Source { file: "test", text }).unwrap()
}

/// Onto the middle of a floor.
fn down() -> Ray<Flat> {
    Ray::new(Vec2::new(-0.5, 0.25), Vec2::new(2.0, -1.0).normalize())
}

#[test]
fn a_lamp_that_counts_twice_is_refused() {
    let lamp = flatland::load("lamp").unwrap();
    let truth = 0.4 * exact::segment(1.0, [[-0.5, 1.0], [0.5, 1.0]].map(Into::into));
    let read = |walk: &(dyn Fn(&mut FlatTracer, &Stream) -> Rgb + Sync)| {
        walks::flat(&lamp, truth, 200_000, 8, walk).estimate
    };
    let max_depth = 2;
    let right = read(&|world, stream| NextEvent { max_depth }.walk(world, &down(), stream));
    accept("asked", &right, truth, truth);
    let right = read(&|world, stream| Kajiya { max_depth }.walk(world, &down(), stream));
    accept("by chance", &right, truth, 2.0 * truth);
    let wrong = read(&|world, stream| CountTwice { max_depth }.walk(world, &down(), stream));
    reject("asked and by chance", &wrong, truth);
    accept("which is twice as much", &wrong, 2.0 * truth, 4.0 * truth);
}

#[test]
fn one_lamp_of_many_stands_for_all() {
    let text = "name = 'test'\n\
                [[objects]]\nalbedo = 0.5\nsegment = { from = [-9, 0], to = [9, 0] }\n\
                [[objects]]\nemits = 2\nsegment = { from = [-0.5, 1], to = [-1, 1] }\n\
                [[objects]]\nemits = 5\ncircle = { center = [1.5, 2], radius = 0.2 }\n\
                [[lamps]]\npoint = { position = [0, 1], power = 3 }";
    let lamps = world(text);
    let sum = exact::segment(2.0, [[-0.5, 1.0], [-1.0, 1.0]].map(Into::into))
        + exact::circle(5.0, 0.2, 2.5, libm::atan2(1.5, 2.0))
        + exact::lamp(3.0, [0.0, 1.0].into());
    // Albedo one half, and the Lambert constant of the flat world.
    let truth = 0.25 * sum;
    for weights in [[1.0, 1.0, 1.0], [3.0, 1.0, 2.0], [0.2, 4.0, 1.0]] {
        let choice = Discrete::new(weights).unwrap();
        let one = PickOne {
            max_depth: 2,
            choice,
        };
        let walks = walks::flat(&lamps, truth, 200_000, 9, |world, stream| {
            one.walk(world, &down(), stream)
        });
        accept(
            &format!("one by {weights:?}"),
            &walks.estimate,
            truth,
            3.0 * truth,
        );
        assert!(walks.rays_each() <= 3.0, "eye, lamp, walk: {walks:?}");
    }
    let forgetful = PickOne {
        max_depth: 2,
        choice: Discrete::new([1.0, 0.0, 1.0]).unwrap(),
    };
    let walks = walks::flat(&lamps, truth, 50_000, 9, |world, stream| {
        forgetful.walk(world, &down(), stream)
    });
    // The lamp that nobody asks is missing: where a walk meets it, it was taken for asked.
    reject("one lamp never asked", &walks.estimate, truth);
    let all = walks::flat(&lamps, truth, 50_000, 9, |world, stream| {
        NextEvent { max_depth: 2 }.walk(world, &down(), stream)
    });
    accept("all", &all.estimate, truth, truth);
    assert_eq!(all.rays_each(), 5.0);
}

#[test]
fn s0_16_a_path_has_one_ray_and_one_to_each_lamp_at_each_surface() {
    // From everywhere in a convex room both lamps are to be seen.
    let room = world(
        "name = 'test'\n\
         [[objects]]\nalbedo = 0.5\n\
         polyline = { points = [[0, 0], [1, 0], [1, 1], [0, 1]], closed = true }\n\
         [[lamps]]\npoint = { position = [0.4, 0.5], power = 1 }\n\
         [[lamps]]\npoint = { position = [0.6, 0.7], power = 1 }",
    );
    let eye = Ray::<Flat>::new(Vec2::new(0.3, 0.2), Vec2::new(0.8, -0.6));
    for depth in 1..=8_u32 {
        let rays = |walk: &dyn Fn(&mut FlatTracer)| {
            let mut world = FlatTracer::new(&room);
            walk(&mut world);
            world.rays
        };
        let stream = Stream::new(4, depth, 0);
        let max_depth = depth;
        let walk = rays(&|world| {
            Kajiya { max_depth }.walk(world, &eye, &stream);
        });
        let asking = rays(&|world| {
            NextEvent { max_depth }.walk(world, &eye, &stream);
        });
        let four = rays(&|world| {
            Split {
                paths: 4,
                max_depth,
            }
            .walk(world, &eye, &stream);
        });
        let bounces = u64::from(depth - 1);
        assert_eq!(walk, bounces + 1);
        assert_eq!(asking, 1 + 3 * bounces);
        assert_eq!(four, 1 + 4 * 3 * bounces);
    }
}

#[test]
fn paths_that_share_their_first_ray_paint_the_same_picture() {
    let scene = gallery::load("spheres").unwrap().sized([12, 12]);
    let paint = |integrator: &dyn Fn(&Options) -> Film, spp, seed| {
        integrator(&Options {
            spp,
            seed,
            ..Options::default()
        })
    };
    let max_depth = 6;
    let right = paint(
        &|o| render(&scene, &NextEvent { max_depth }, o, &()).film,
        4096,
        1,
    );
    // One path is the walk itself, number by number.
    let one = paint(
        &|o| {
            render(
                &scene,
                &Split {
                    paths: 1,
                    max_depth,
                },
                o,
                &(),
            )
            .film
        },
        64,
        3,
    );
    let walk = paint(
        &|o| render(&scene, &NextEvent { max_depth }, o, &()).film,
        64,
        3,
    );
    let ((a, _), (b, _)) = (one.mean(), walk.mean());
    assert!((a - b).abs() <= 1e-6 * b, "{a} and {b}");
    let split = Split {
        paths: 4,
        max_depth,
    };
    let four = paint(&|o| render(&scene, &split, o, &()).film, 1024, 2);
    let ((a, a_error), (b, b_error)) = (four.mean(), right.mean());
    let z = (a - b) / a_error.hypot(b_error);
    println!("four paths: {a:.5} and {b:.5}, z {z:.2}");
    assert!(z.abs() <= 4.4, "{z}");
    assert!(a_error.hypot(b_error) < 0.02 * b);
}

#[test]
fn the_golden_room_by_any_number_of_paths() {
    let room = flatland::load("room").unwrap();
    let (truth, max_depth) = (exact::ROOM_FLOOR, 20);
    let eye = Ray::<Flat>::new(Vec2::splat(0.5), Vec2::NEG_Y);
    let mut variances = Vec::new();
    for paths in [1, 2, 4, 16] {
        let split = Split { paths, max_depth };
        let found = walks::flat(&room, truth, 160_000 / paths, 10, |world, stream| {
            split.walk(world, &eye, stream)
        });
        accept(&format!("{paths} paths"), &found.estimate, truth, truth);
        variances.push(found.squares.mean() * f64::from(paths));
        let split = Split {
            paths,
            max_depth: 3,
        };
        let cut = walks::flat(&room, truth, 40_000, 10, |world, stream| {
            split.walk(world, &eye, stream)
        });
        reject("cut after two bounces", &cut.estimate, truth);
    }
    // The ray from the eye leaves nothing to chance here, so paths are as good as walks.
    for variance in &variances {
        assert!(
            (variance / variances[0] - 1.0).abs() < 0.05,
            "{variances:?}"
        );
    }
}
