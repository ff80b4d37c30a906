//! Two techniques with weights, against quadratures, in furnaces, and misled.

use super::radiance;
use crate::checks::{CRITICAL, accept};
use glam::Vec2;
use halfdisk::flatland;
use halfdisk::geometry::Ray;
use halfdisk::integrators::world::{FlatTracer, World};
use halfdisk::integrators::{Combine, Kajiya, NextEvent, Path, Roulette, Survival};
use halfdisk::lab::estimators::overhead::{Aim, Overhead, Technique};
use halfdisk::lab::mistakes::misled::{Misled, Slip};
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::description::Material;
use halfdisk::scene::value::Albedo;
use halfdisk::scene::{gallery, read::Source};
use halfdisk::space::{self, Flat};
use halfdisk::stats::Estimate;

const BALANCE: Technique = Technique::Both(Heuristic::Balance);
const POWER: Technique = Technique::Both(Heuristic::Power);
const ALL: [Technique; 4] = [Technique::Chance, Technique::Aiming, BALANCE, POWER];

/// Walks under a lamp: their mean, and their squared distance from a truth.
fn walks(
    world: &mut impl World<Flat>,
    technique: Technique,
    truth: f64,
    count: u32,
) -> [Estimate; 2] {
    let mut both = [Estimate::new(); 2];
    for i in 0..count {
        let found = technique.walk(world, &Stream::new(13, i, 0));
        both[0].add(found);
        both[1].add((found - truth).powi(2));
    }
    both
}

#[test]
fn s0_23_all_ways_agree_and_their_variances_keep_the_bound() {
    for a in [0.01, 0.03, 0.1, 0.3, 0.5, 0.8, 1.0, 1.2, 1.5] {
        let lamp = Overhead::new(a);
        let world = lamp.world(1).unwrap();
        let measured = ALL.map(|technique| {
            let mut walk = FlatTracer::new(&world);
            let [mean, square] = walks(&mut walk, technique, lamp.mean(), 100_000);
            let exact = lamp.variance(technique);
            println!(
                "{a} {technique:?}: z {:.2}; variance {:.4e} ± {:.1e}, {exact:.4e}",
                mean.z(lamp.mean()),
                square.mean(),
                square.std_error()
            );
            assert!(mean.z(lamp.mean()).abs() <= CRITICAL, "{a} {technique:?}");
            assert!(square.z(exact).abs() <= CRITICAL, "{a} {technique:?}");
            square.mean()
        });
        for all in [measured, ALL.map(|technique| lamp.variance(technique))] {
            let [chance, aiming, balance, power] = all;
            assert!(balance <= lamp.bound(), "{a}: {balance} {}", lamp.bound());
            assert!(power <= lamp.bound(), "{a}: {power}");
            assert!(balance.max(power) <= chance.max(aiming), "{a}: {all:?}");
        }
    }
}

#[test]
fn s0_23_points_drawn_by_length() {
    // The variances of the table: by chance, by a point of the lamp's length, both.
    for (a, known, within) in [
        (1.5, [0.0025, 7.31, 0.118], 0.01),
        (1.0, [0.134, 0.193, 0.062], 0.01),
        (0.03, [0.0291, 1.46e-10, 2.5e-5], 0.02),
    ] {
        let lamp = Overhead {
            half_angle: a,
            aim: Aim::Length,
        };
        for (technique, known) in ALL.into_iter().zip(known) {
            let exact = lamp.variance(technique);
            assert!(
                (exact / known - 1.0).abs() < within,
                "{a} {technique:?}: {exact}"
            );
        }
    }
}

#[test]
fn the_weights_of_a_direction_add_up_to_one() {
    let mut worst = 0.0_f64;
    for a in [0.01, 0.1, 0.5, 1.0, 1.5] {
        for aim in [Aim::Angle, Aim::Length] {
            let lamp = Overhead { half_angle: a, aim };
            for k in 0..=10_000 {
                let theta = a * (2.0 * f64::from(k) / 10_000.0 - 1.0);
                for technique in [BALANCE, POWER] {
                    let [chance, aiming] = lamp.weights(technique, theta);
                    worst = worst.max((chance + aiming - 1.0).abs());
                }
            }
        }
    }
    println!("largest distance from one: {worst:e}");
    assert!(worst <= 1e-12);
}

#[test]
fn misled_walks_read_what_they_should_and_are_rejected() {
    let lamp = Overhead::new(1.0);
    let world = lamp.world(2).unwrap();
    for heuristic in [Heuristic::Balance, Heuristic::Power] {
        let both = Technique::Both(heuristic);
        let [right, _] = walks(&mut FlatTracer::new(&world), both, 0.0, 400_000);
        assert!(right.z(lamp.mean()).abs() <= CRITICAL);
        for (slip, rejected) in [
            (Slip::CountedTwice, true),
            (Slip::Density(0.93), true),
            (Slip::Density(1.07), true),
            (Slip::OneWeight(0.93), true),
            (Slip::Selection, true),
            (Slip::BothWeights(0.93), false),
        ] {
            let mut misled = Misled {
                world: FlatTracer::new(&world),
                slip,
            };
            let [read, _] = walks(&mut misled, both, 0.0, 400_000);
            let exact = slip.reading(&lamp, 2, heuristic);
            let (z, own) = (read.z(lamp.mean()), read.z(exact));
            println!(
                "{heuristic:?} {slip:?}: {:.5}, exact {exact:.5} ({own:.2}), z {z:.1}",
                read.mean()
            );
            assert!(own.abs() <= CRITICAL, "{slip:?}");
            assert_eq!(z.abs() > CRITICAL, rejected, "{slip:?}");
        }
    }
}

#[test]
fn inside_a_glowing_room_every_walk_reads_the_closed_form() {
    for (albedo, max_depth) in [(0.5, 30), (0.75, 60)] {
        let truth = 1.0 / (1.0 - albedo);
        let room = gallery::load_with("furnace", |said| {
            for material in said.materials.values_mut() {
                *material = Material::Lambert {
                    albedo: Albedo([albedo; 3]).into(),
                };
            }
        })
        .unwrap();
        let ray = room.camera.ray(0.3, 0.6);
        let ray = Ray::new(ray.origin, ray.direction);
        let read = |name: &str, estimate: Estimate, percent| {
            accept(
                &format!("room of {albedo}, {name}"),
                &estimate,
                truth,
                percent * truth,
            );
        };
        let walk = Kajiya { max_depth };
        read("chance", radiance(&walk, &room, &ray, 100), 1e-3);
        let asking = NextEvent { max_depth };
        read("aiming", radiance(&asking, &room, &ray, 20_000), 6.0);
        for heuristic in [Heuristic::Balance, Heuristic::Power] {
            let both = Combine {
                max_depth,
                heuristic,
            };
            read("both", radiance(&both, &room, &ray, 20_000), 1.0);
        }
        let path = Path::new(max_depth);
        read("path", radiance(&path, &room, &ray, 20_000), 4.0);
        let roulette = Roulette {
            survival: Survival::Constant(0.9),
        };
        read("roulette", radiance(&roulette, &room, &ray, 20_000), 4.0);
    }
}

#[test]
fn inside_a_glowing_polygon_too() {
    // Twenty-four walls: nearly a circle that shines inwards.
    let corner = |k: u32| {
        let (sin, cos) = libm::sincos(f64::from(k) * std::f64::consts::TAU / 24.0);
        format!("[{cos:.6}, {sin:.6}]")
    };
    let corners: Vec<String> = (0..24).map(corner).collect();
    let text = format!(
        "name = 'round'\n[[objects]]\nalbedo = 0.5\nemits = 1\n\
         polyline = {{ closed = true, points = [{}] }}\n",
        corners.join(", ")
    );
    let source = Source {
        file: "round.toml",
        text: &text,
    };
    let world = flatland::gallery::from_text(source).unwrap();
    let mut walk = FlatTracer::new(&world);
    let eye = space::Ray::<Flat>::new(Vec2::new(0.3, 0.1), Vec2::new(0.6, 0.8));
    let max_depth = 24;
    for heuristic in [Heuristic::Balance, Heuristic::Power] {
        let both = Combine {
            max_depth,
            heuristic,
        };
        let one = |i| {
            let shares = both.walk(&mut walk, &eye, &Stream::new(1, i, 0));
            f64::from((shares.by_chance + shares.by_aiming).r)
        };
        let read: Estimate = (0..10_000).map(one).collect();
        accept("round room", &read, 2.0, 2.0 * 2.0);
    }
}
