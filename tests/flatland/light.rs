//! What light does in the flat world: plain estimates against closed forms.

use super::draw::Draw;
use crate::checks::accept;
use glam::{DVec2, Vec2};
use halfdisk::flatland::{FlatWorld, exact, gallery, load};
use halfdisk::scene::read::Source;
use halfdisk::stats::Estimate;
use std::f64::consts::PI;

/// Irradiance at the probe from what it sees, by directions uniform in angle: `π` times the mean of
/// `L cos θ`.
fn irradiance(world: &FlatWorld, seed: u64) -> Estimate {
    let p = world.probe.unwrap().surface;
    let sample = |i| {
        let wi = Draw::new(seed, i).uniform(p.n);
        let radiance = match world.first_hit(p.leave(wi), wi) {
            Some(hit) => hit.emitted(-wi),
            None => world.background,
        };
        PI * f64::from(radiance.g) * f64::from(wi.dot(p.n))
    };
    (0..1_000_000).map(sample).collect()
}

/// A floor with the probe at its middle, and something that shines.
fn world(lamp: &str) -> FlatWorld {
    let floor = "albedo = 0.5\nsegment = { from = [-5, 0], to = [5, 0] }";
    let probe = "name = \"test\"\nprobe = { at = [0, 0], normal = [0, 1] }";
    let text = format!("{probe}\n[[objects]]\n{floor}\n[[objects]]\nemits = 1\n{lamp}");
    let file = "test.toml";
    gallery::from_text(Source { file, text: &text }).unwrap()
}

#[test]
fn a_constant_sky() {
    let furnace = load("furnace").unwrap();
    let estimate = irradiance(&furnace, 60);
    accept("sky", &estimate, exact::sky(1.0), exact::sky(1.0));
    // π cos θ has the standard deviation √(π²/2 - 4).
    let sigma = estimate.variance().sqrt();
    assert!((sigma - 0.966_8).abs() < 0.004, "{sigma}");
}

#[test]
fn segments() {
    let lamp = load("lamp").unwrap();
    let above = [DVec2::new(0.5, 1.0), DVec2::new(-0.5, 1.0)];
    let truth = exact::segment(1.0, above);
    assert!((truth - 2.0 / 5_f64.sqrt()).abs() < 1e-12);
    accept("segment", &irradiance(&lamp, 61), truth, truth);
    // Its far end is below the horizon.
    let ends = [DVec2::new(2.0, -1.0), DVec2::new(0.4, 0.9)];
    let sunk = world("segment = { from = [2, -1], to = [0.4, 0.9] }");
    let estimate = irradiance(&sunk, 62);
    accept(
        "segment across the horizon",
        &estimate,
        exact::segment(1.0, ends),
        exact::segment(1.0, ends),
    );
    // The back of the same segment is dark.
    let turned = world("segment = { from = [0.4, 0.9], to = [2, -1] }");
    assert_eq!(irradiance(&turned, 63).mean(), 0.0);
}

#[test]
fn circles_high_and_sinking() {
    for (seed, angle) in [(64, 0.0), (65, 0.5), (66, -1.2), (67, 1.5)] {
        let (sin, cos) = libm::sincos(angle);
        let (x, y) = (2.0 * sin, 2.0 * cos);
        let lamp = world(&format!(
            "circle = {{ center = [{x:?}, {y:?}], radius = 0.5 }}"
        ));
        let truth = exact::circle(1.0, 0.5, 2.0, angle);
        let what = format!("circle at {angle}");
        let estimate = irradiance(&lamp, seed);
        let z = estimate.z(truth);
        println!(
            "{what}: {:.6}, exactly {truth:.6}, z = {z:.2}",
            estimate.mean()
        );
        assert!(z.abs() <= 4.0, "{what}: z = {z}");
    }
}

#[test]
fn a_point_lamp_is_a_formula() {
    let yard = load("yard").unwrap();
    let (lamp, p) = (yard.point_lights[0], yard.probe.unwrap().surface);
    let light = lamp.light_at(p.p).unwrap();
    let local = halfdisk::flatland::frame(p.n).transpose() * (lamp.position - p.p);
    let truth = exact::lamp(f64::from(lamp.power.r), local.as_dvec2());
    let ours = light.irradiance.r * light.wi.dot(p.n);
    assert!((f64::from(ours) / truth - 1.0).abs() < 1e-6);
    assert!(yard.sees_point(&p, lamp.position));
}

#[test]
fn strings_by_rays() {
    let plates = world("segment = { from = [1.2, 0.8], to = [-0.4, 1.3] }");
    let [a, b] = [[[-1.0, 0.0], [1.0, 0.0]], [[1.2, 0.8], [-0.4, 1.3]]];
    let sample = |i| {
        let mut draw = Draw::new(68, i);
        let p = Vec2::new(draw.between(-1.0, 1.0), 0.0);
        let met = plates.first_hit(p, draw.cosine(Vec2::Y)).is_some();
        f64::from(u8::from(met))
    };
    let estimate: Estimate = (0..1_000_000).map(sample).collect();
    let truth = exact::form_factor(a.map(DVec2::from), b.map(DVec2::from));
    accept("form factor", &estimate, truth, truth);
}

/// Reflected radiance at the probe by a random walk: at each wall the light is absorbed or goes
/// on, with the albedo for odds, proportionally to the cosine.
fn walk(world: &FlatWorld, seed: u64, walks: u32) -> Estimate {
    let probe = world.probe.unwrap();
    let one = |i| {
        let mut draw = Draw::new(seed, i);
        let mut hit = probe;
        let mut wo = probe.surface.n;
        let mut sum = 0.0;
        while draw.one() < hit.albedo.g {
            wo = -draw.cosine(hit.surface.normal_towards(wo));
            match world.first_hit(hit.surface.leave(-wo), -wo) {
                Some(next) => hit = next,
                None => return sum + f64::from(world.background.g),
            }
            sum += f64::from(hit.emitted(wo).g);
        }
        sum
    };
    (0..walks).map(one).collect()
}

#[test]
fn the_room_by_random_walks() {
    let room = load("room").unwrap();
    accept(
        "room",
        &walk(&room, 69, 4_000_000),
        exact::ROOM_FLOOR,
        exact::ROOM_FLOOR,
    );
}

#[test]
fn two_plates_by_random_walks() {
    let plates = load("plates").unwrap();
    let truth = exact::plates(1.0, f64::from(0.3_f32), 0.5);
    accept("plates", &walk(&plates, 70, 1_000_000), truth, truth);
}
