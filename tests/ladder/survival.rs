//! Walks that end by chance, in furnaces of any albedo, and without the weight of survivors.

use super::radiance;
use crate::checks::{CRITICAL, accept};
use crate::of_chapters::survival::Game;
use halfdisk::color::Rgb;
use halfdisk::integrators::world::World;
use halfdisk::integrators::{Kajiya, Path, Roulette, Survival};
use halfdisk::lab::estimators::worlds::{Counted, Furnace};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::gallery;
use halfdisk::space::Flat;
use halfdisk::stats::Estimate;

fn furnace(albedo: f64) -> Counted<Furnace> {
    Counted::new(Furnace {
        albedo: albedo as f32,
    })
}

/// The value of one walk in a furnace without shapes, and its segments.
fn walk(albedo: f64, survival: Survival, stream: &Stream) -> (f64, u64) {
    let mut room = furnace(albedo);
    let li = Roulette { survival }.walk::<Flat>(&mut room, &Furnace::eye(), stream);
    (f64::from(li.r), room.rays)
}

/// Roulette whose survivors do not stand for those that ended.
fn unweighted(albedo: f64, q: f32, stream: &Stream) -> f64 {
    let mut room = furnace(albedo);
    let mut beta = Rgb::WHITE;
    let mut li = 0.0;
    for place in 1.. {
        World::<Flat>::intersect(&mut room, &Furnace::eye(), 1);
        li += f64::from(beta.r);
        beta = beta * room.world.albedo;
        if stream.at(place, Purpose::Survival).one() >= q {
            break;
        }
    }
    li
}

#[test]
fn s1_02_a_cut_loses_a_power_of_the_albedo_and_roulette_nothing() {
    // The table: the share of the light that is missing, in percent.
    for (albedo, bounces, known) in [(0.8_f64, 5, 26.2), (0.9, 8, 38.7), (0.5, 3, 6.25)] {
        let cut = Kajiya {
            max_depth: bounces + 1,
        };
        let mut room = furnace(albedo);
        let read = cut.walk::<Flat>(&mut room, &Furnace::eye(), &Stream::new(1, 0, 0));
        let lost = 1.0 - f64::from(read.r) * (1.0 - albedo);
        assert!(
            (lost - albedo.powi(bounces as i32 + 1)).abs() < 1e-6,
            "{lost}"
        );
        assert!((100.0 * lost - known).abs() < 0.05, "{lost}");

        let truth = 1.0 / (1.0 - albedo);
        for survival in [Survival::Constant(0.92), Survival::Throughput(0.05)] {
            let one = |i| walk(albedo, survival, &Stream::new(2, i, 0)).0;
            let read: Estimate = (0..200_000).map(one).collect();
            accept(
                &format!("{albedo}, {survival:?}"),
                &read,
                truth,
                3.0 * truth,
            );
            // And so much that the cut is far away.
            assert!(read.z(truth * (1.0 - lost)) > CRITICAL);
        }
        let one = |i| unweighted(albedo, 0.92, &Stream::new(2, i, 0));
        let read: Estimate = (0..200_000).map(one).collect();
        let (exact, z) = (1.0 / (1.0 - 0.92 * albedo), read.z(truth));
        println!(
            "{albedo} unweighted: {:.4}, exact {exact:.4}, z {z:.1}",
            read.mean()
        );
        assert!(read.z(exact).abs() <= CRITICAL && z < -CRITICAL);
    }
}

#[test]
fn s1_02_variances_of_roulette() {
    // Those of the table, within a tenth; a hundredth would do for these.
    for (albedo, survival, known) in [
        (0.8, 0.8, 20.0),
        (0.8, 0.9, 6.15),
        (0.8, 0.95, 2.58),
        (0.9, 0.95, 28.93),
        (0.9, 0.99, 4.5),
    ] {
        let game = Game { albedo, survival };
        let constant = Survival::Constant(survival as f32);
        let mut mean = Estimate::new();
        let mut segments = Estimate::new();
        for i in 0..1_000_000 {
            let (value, rays) = walk(albedo, constant, &Stream::new(3, i, 0));
            mean.add(value);
            segments.add(rays as f64);
        }
        let found = mean.variance();
        println!(
            "{game:?}: variance {found:.3}, exact {:.3}",
            game.variance()
        );
        assert!((found / known - 1.0).abs() < 0.1, "{game:?}: {found}");
        assert!(
            (found / game.variance() - 1.0).abs() < 0.04,
            "{game:?}: {found}"
        );
        assert!(mean.z(game.mean()).abs() <= CRITICAL, "{game:?}");
        assert!(segments.z(game.rays()).abs() <= CRITICAL, "{game:?}");
    }
}

#[test]
fn near_the_wall_the_common_walks_are_right_and_below_it_no_variance_settles() {
    // At 0.65 the fourth moment is infinite: a measured variance says nothing about 560. What the
    // walks of at most twelve segments add to the second moment can be measured; the rest of it, by
    // the closed form, is most of it.
    let game = Game {
        albedo: 0.8,
        survival: 0.65,
    };
    let constant = |q| Survival::Constant(q);
    let one = |i| {
        let (value, segments) = walk(0.8, constant(0.65), &Stream::new(4, i, 0));
        if segments <= 12 { value * value } else { 0.0 }
    };
    let common: Estimate = (0..1_000_000).map(one).collect();
    let exact = game.mean_of(12, |s| s * s);
    accept("common walks at 0.65", &common, exact, 5.0 * exact);
    let rest = game.variance() + game.mean() * game.mean() - exact;
    println!("of {:.1} they are {exact:.1}", exact + rest);
    assert!(rest > 4.0 * exact);
    // The variance of so many walks grows with their number where there is none.
    let variance = |q: f32, walks: u32| {
        let one = |i| walk(0.8, constant(q), &Stream::new(5, i, 0)).0;
        (0..walks).map(one).collect::<Estimate>().variance()
    };
    let growth = variance(0.5, 1 << 20) / variance(0.5, 1 << 10);
    let settled = variance(0.9, 1 << 20) / variance(0.9, 1 << 10);
    println!("from 1024 walks to a million: x {growth:.1} at 0.5, x {settled:.2} at 0.9");
    assert!(growth > 4.0 && (settled - 1.0).abs() < 0.5);
}

#[test]
fn s0_22_the_walks_for_an_error_are_the_variance_over_its_square() {
    // Found from one set of walks, tried on others.
    let game = Game {
        albedo: 0.8,
        survival: 0.9,
    };
    let constant = Survival::Constant(0.9);
    let pilot: Estimate = (0..400_000)
        .map(|i| walk(0.8, constant, &Stream::new(6, i, 0)).0)
        .collect();
    for error in [0.1, 0.03] {
        let needed = pilot.variance() / (error * pilot.mean()).powi(2);
        let squares: Estimate = (0..4_000)
            .map(|run| {
                let one = |i| walk(0.8, constant, &Stream::new(7, i, run)).0;
                let mean: Estimate = (0..needed.round() as u32).map(one).collect();
                (mean.mean() / game.mean() - 1.0).powi(2)
            })
            .collect();
        // Walks that would have been needed for what was reached, over those that were taken.
        let ratio = squares.mean() / (error * error);
        let own = squares.std_error() / (error * error);
        println!("{error}: {needed:.0} walks, ratio {ratio:.3} ± {own:.3}");
        // So many round to a whole number of walks.
        assert!((ratio - 1.0).abs() < 0.05 + 4.4 * own && own < 0.03);
        // Half as many do not do it.
        assert!((2.0 * ratio - 1.0).abs() > 4.4 * own);
    }
}

#[test]
fn between_white_walls_and_with_broken_throughputs_every_walk_ends() {
    let white = |i| {
        let survival = Survival::Throughput(0.05);
        walk(1.0, survival, &Stream::new(8, i, 0)).1 as f64
    };
    let segments: Estimate = (0..100_000).map(white).collect();
    assert!(segments.z(20.0).abs() <= CRITICAL, "{segments:?}");
    for broken in [f32::NAN, f32::INFINITY] {
        for i in 0..100 {
            let (_, segments) = walk(
                f64::from(broken),
                Survival::Throughput(0.05),
                &Stream::new(9, i, 0),
            );
            assert!(segments < 1000, "{broken}: {segments}");
        }
    }
}

#[test]
fn real_rooms_read_what_the_furnace_does() {
    let room = gallery::load("furnace").unwrap();
    let ray = room.camera.ray(0.7, 0.2);
    for survival in [Survival::Constant(0.8), Survival::Throughput(0.05)] {
        let roulette = Roulette { survival };
        let read = radiance(&roulette, &room, &ray, 50_000);
        accept(&format!("room, {survival:?}"), &read, 2.0, 3.0 * 2.0);
    }
    // The last rung of the ladder: roulette and a cut that is too deep to matter.
    let path = Path {
        roulette_from: 1,
        ..Path::new(64)
    };
    accept(
        "room, path",
        &radiance(&path, &room, &ray, 50_000),
        2.0,
        3.0 * 2.0,
    );
}
