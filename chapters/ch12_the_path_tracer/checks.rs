//! The path tracer where its answer is known.

use glam::Vec2;
use halfdisk::color::Rgb;
use halfdisk::flatland::{self, exact};
use halfdisk::integrators::world::World;
use halfdisk::integrators::{AllLight, Path};
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::estimators::walks::{self, Walks};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, SceneError, gallery};
use halfdisk::space::{Flat, Ray};
use halfdisk::stats::z_test::{FOUR, Largest, z_test};
use std::f64::consts::PI;
use std::fmt::Write;

/// Lamps in a row of the square over the floor.
const ROW: usize = 8;
const RADIUS: f64 = 0.1;
const HEIGHT: f64 = 1.5;

/// A floor of albedo one half, seen at the origin.
fn floor(lamps: &str) -> Result<Scene, SceneError> {
    let text = format!(
        "name = 'floor'\ncamera = {{ from = [0, 0.3, -1], to = [0, 0, 0], fov = 40 }}\n\
         materials.grey.lambert.albedo = 0.5\n[[objects]]\nmaterial = 'grey'\n\
         quad = {{ corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }}\n{lamps}"
    );
    let (file, text) = ("ch12", text.as_str());
    gallery::from_text(Source { file, text }, None, |_| {})
}

/// Radiance that this floor reflects of an irradiance.
fn reflected(irradiance: f64) -> f64 {
    0.5 / PI * irradiance
}

/// A square lamp of side and radiance 1, one metre above the floor.
fn square() -> (&'static str, f64) {
    let lamp = "[[objects]]\nemits = 1\n\
                quad = { corner = [-0.5, 1, -0.5], u = [1, 0, 0], v = [0, 0, 1] }\n";
    // Four corners, each of them with sides of half a metre.
    let (x, s) = (0.5, 1.25_f64.sqrt());
    (lamp, reflected(4.0 * x / s * libm::atan(x / s)))
}

/// A ball of radiance 1 two metres away, seen at the angle 0.4 to each side. Its centre stands 1.6 from the normal, below
/// the horizon: the floor cuts it.
fn sunk() -> (String, f64) {
    let (s, d, b) = (0.4, 2.0, 1.6);
    let lamp = format!(
        "[[objects]]\nemits = 1\nsphere = {{ center = [{}, {}, 0], radius = {} }}\n",
        d * libm::sin(b),
        d * libm::cos(b),
        d * libm::sin(s)
    );
    (lamp, reflected(0.034_672_2))
}

/// Many balls in a square, of radiances 1 to 8: a ball at the distance `d` gives `π L (R/d)² cos θ`.
fn many() -> (String, f64) {
    let (mut text, mut irradiance) = (String::new(), 0.0);
    for k in 0..ROW * ROW {
        let [x, z] = [k % ROW, k / ROW].map(|i| 0.6 * (i as f64 - 0.5 * (ROW as f64 - 1.0)));
        let radiance = 1.0 + (k % 8) as f64;
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "[[objects]]\nemits = {radiance:?}\n\
             sphere = {{ center = [{x:?}, {HEIGHT:?}, {z:?}], radius = {RADIUS:?} }}"
        );
        let square = x * x + z * z + HEIGHT * HEIGHT;
        irradiance += PI * radiance * RADIUS * RADIUS / square * HEIGHT / square.sqrt();
    }
    (text, reflected(irradiance))
}

/// One estimate by the path tracer in a flat world.
fn flat_path(
    max_depth: u32,
    world: &mut impl World<Flat>,
    eye: &Ray<Flat>,
    stream: &Stream,
) -> Rgb {
    let mut all = AllLight::default();
    Path::new(max_depth).walk(world, eye, stream, &mut all);
    all.li
}

/// How far the path tracer is from closed forms, and its rays.
pub fn work(desk: &mut Desk) -> Result<(Largest, u64), DeskError> {
    let (mut compared, mut rays) = (Largest::default(), 0);
    let (count, seed) = (desk.choose(80_000, 50_000), desk.options.seed);
    let mut record = |desk: &mut Desk, name: &str, says: &str, found: &Walks, truth: f64| {
        desk.estimate(name, says, &found.estimate, Some(truth));
        desk.value(&format!("{name}_rays"), "  rays", found.rays_each());
        compared.add(z_test(&found.estimate, truth, FOUR).z);
        rays += found.rays;
    };

    // Two worlds without a third dimension, and light that bounces without end.
    let down = |from: f32| Ray::<Flat>::new(Vec2::new(from, 0.5), Vec2::NEG_Y);
    let plates = flatland::load("plates")?;
    let truth = exact::plates(1.0, f64::from(0.9_f32), 0.5);
    let found = walks::flat(&plates, truth, count, seed, |world, stream| {
        flat_path(512, world, &down(0.0), stream)
    });
    record(desk, "plates", "the dark one of two plates", &found, truth);
    let room = flatland::load("room")?;
    let truth = exact::ROOM_FLOOR;
    let found = walks::flat(&room, truth, count, seed, |world, stream| {
        flat_path(512, world, &down(0.5), stream)
    });
    record(desk, "room", "the floor of the flat room", &found, truth);

    // Direct light in space.
    let (lamp, truth) = square();
    let (sunk, sunk_truth) = sunk();
    let (many, many_truth) = many();
    for (name, says, lamps, truth) in [
        ("square", "a square lamp above the floor", lamp, truth),
        ("sunk", "a ball, half below the horizon", &sunk, sunk_truth),
        ("many", "sixty-four balls", &many, many_truth),
    ] {
        let scene = floor(lamps)?;
        let ray = scene.camera.ray(0.5, 0.5);
        let found = walks::solid(&scene, &ray, &Path::new(2), truth, count, seed);
        record(desk, name, says, &found, truth);
    }
    Ok((compared, rays))
}
