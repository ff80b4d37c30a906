//! Photons of the flat world, by the same code.

use crate::checks::{CRITICAL, alike};
use glam::{DVec2, Vec2};
use halfdisk::color::Rgb;
use halfdisk::flatland::{FlatWorld, exact, gallery};
use halfdisk::integrators::Photons;
use halfdisk::integrators::world::FlatTracer;
use halfdisk::photons::{Kernel, Photon, PhotonMap};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::read::Source;
use halfdisk::space::{Flat, Ray};
use halfdisk::stats::Estimate;

pub fn world(text: &str) -> FlatWorld {
    let text = format!("name = 'test'\n{text}");
    gallery::from_text(Source {
        file: "test.toml",
        text: &text,
    })
    .unwrap()
}

/// The photons of so many walks.
pub fn photons(world: &FlatWorld, by: &Photons, walks: u32, seed: u64) -> Vec<Photon<Flat>> {
    let mut found = Vec::new();
    let mut tracer = FlatTracer::new(world);
    for walk in 0..walks {
        let stream = Stream::new(seed, walk, 0);
        by.trace(&mut tracer, 0.0, &stream, &mut |photon| found.push(photon));
    }
    found
}

#[test]
fn a_closed_room_keeps_its_power() {
    // A ceiling of length 1 sends 2, and walls keep half of what they get.
    let room = gallery::load("room").unwrap();
    let walks = 100_000;
    let found = photons(&room, &Photons::in_space::<Flat>(7), walks, 1);
    for segments in 1..7 {
        let lands = || found.iter().filter(|photon| photon.segments == segments);
        let sum: f64 = lands().map(|photon| f64::from(photon.power.g)).sum();
        let expected = 2.0 * 0.5_f64.powi(segments as i32 - 1);
        let share = lands().count() as f64 / f64::from(walks);
        let error = expected * ((1.0 - share) / (share * f64::from(walks))).sqrt();
        let off = sum / f64::from(walks) - expected;
        println!(
            "{segments} segments: {:.5} for {expected}",
            sum / f64::from(walks)
        );
        assert!(off.abs() <= CRITICAL * error + 1e-4 * expected);
    }
}

#[test]
fn every_kind_of_light_lights_a_floor_as_it_should() {
    let floor = "[[objects]]\nalbedo = 0.5\nsegment = { from = [-4, 0], to = [4, 0] }\n";
    let at = |x, y| DVec2::new(x, y);
    for (what, light, truth) in [
        (
            "point",
            "[[lamps]]\npoint = { position = [0.3, 1], power = 2 }\n",
            exact::lamp(2.0, at(0.3, 1.0)),
        ),
        (
            "segment",
            "[[objects]]\nemits = 1.5\nsegment = { from = [0.5, 1], to = [-0.5, 1] }\n",
            exact::segment(1.5, [at(-0.5, 1.0), at(0.5, 1.0)]),
        ),
        (
            "circle",
            "[[objects]]\nemits = 3\ncircle = { center = [0, 1], radius = 0.25 }\n",
            exact::circle(3.0, 0.25, 1.0, 0.0),
        ),
        ("sky", "", exact::sky(0.7)),
    ] {
        let background = if light.is_empty() {
            "background = 0.7\n"
        } else {
            ""
        };
        let world = world(&format!("{background}{floor}{light}"));
        let (walks, radius) = (1 << 15, 0.1);
        let read = |seed| {
            let found = photons(&world, &Photons::in_space::<Flat>(2), walks, seed);
            let map = PhotonMap::new(found, walks, radius, Kernel::Constant);
            // A sky lights a floor from below as well.
            let above = |photon: &Photon<Flat>| match photon.wi.y > 0.0 {
                true => photon.power,
                false => Rgb::BLACK,
            };
            f64::from(map.estimate(Vec2::ZERO, Vec2::Y, radius, above).g)
        };
        let reads: Estimate = (0..32).map(read).collect();
        alike(what, (reads.mean(), reads.std_error()), (truth, 0.0), 0.07);
    }
}

#[test]
fn the_room_looked_at() {
    let room = gallery::load("room").unwrap();
    let by = Photons::in_space::<Flat>(24);
    let (walks, radius) = (4000, 0.03);
    let one = |seed| {
        let mut found = photons(&room, &by, walks, seed);
        found.retain(|photon| photon.segments > 1);
        let map = PhotonMap::new(found, walks, radius, Kernel::Epanechnikov);
        let mut tracer = FlatTracer::new(&room);
        let ray = Ray::<Flat>::new(Vec2::new(0.5, 0.6), Vec2::NEG_Y);
        let look = |i| {
            f64::from(
                by.look(&map, &mut tracer, &ray, &Stream::new(!seed, i, 0))
                    .g,
            )
        };
        (0..16).map(look).sum::<f64>() / 16.0
    };
    let reads: Estimate = (0..200).map(one).collect();
    let read = (reads.mean(), reads.std_error());
    alike("room", read, (exact::ROOM_FLOOR, 0.0), 0.03);
    // Light of two segments is not left out, nor counted twice.
    let only = |retain: fn(&Photon<Flat>) -> bool| {
        let found = photons(&room, &by, walks, 1);
        found.iter().filter(|photon| retain(photon)).count()
    };
    assert!(only(|photon| photon.segments == 1) == walks as usize);
}

#[test]
fn a_wall_shows_nothing_of_photons_on_its_other_side() {
    let below = world(
        "[[objects]]\nalbedo = 0.5\nsegment = { from = [-4, 0], to = [4, 0] }\n\
         [[lamps]]\npoint = { position = [0, -1], power = 2 }\n",
    );
    let (walks, radius) = (4000, 0.3);
    let found = photons(&below, &Photons::in_space::<Flat>(2), walks, 1);
    let map = PhotonMap::new(found, walks, radius, Kernel::Constant);
    let tracer = FlatTracer::new(&below);
    let seen = |from: f32| {
        let hit = below
            .first_hit(Vec2::new(0.0, from), Vec2::new(0.0, -from))
            .unwrap();
        let hit = hit.seen_from(Vec2::new(0.0, from));
        f64::from(Photons::radiance(&map, &tracer, &hit, radius, 9).g)
    };
    assert_eq!(seen(1.0), 0.0, "from above it is dark");
    // Half of the irradiance times the albedo.
    let truth = 0.25 * exact::lamp(2.0, DVec2::new(0.0, 1.0));
    assert!((seen(-1.0) / truth - 1.0).abs() < 0.2, "{}", seen(-1.0));
}
