//! Lamps in closed form: many of them, one in a mirror, and one that counts twice.

use crate::figures::picture;
use crate::pick_one::PickOne;
use halfdisk::integrators::{Kajiya, NextEvent};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::estimators::walks::{self, Walks};
use halfdisk::lab::mistakes::count_twice::CountTwice;
use halfdisk::notation::{Expression, ExpressionError};
use halfdisk::sampling::discrete::Discrete;
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, SceneError, gallery};
use halfdisk::stats::z_test::{FOUR, Largest, z_test};
use std::f64::consts::PI;
use std::fmt::Write;

/// Radiances of eight lamps in a row.
const LAMPS: [f64; 8] = [1.0, 8.0, 2.0, 1.0, 4.0, 2.0, 1.0, 8.0];
const RADIUS: f64 = 0.1;

/// Where a lamp hangs above the floor, one beside the other.
fn place(lamp: usize) -> [f64; 2] {
    [0.6 * (lamp as f64 - 3.5), 1.5]
}

/// The radiance a floor of albedo one half reflects of a sphere of radiance `l`: of the irradiance
/// `π L (R/d)² cos θ`.
fn reflected(l: f64, radius: f64, [x, y]: [f64; 2]) -> f64 {
    let square = x * x + y * y;
    0.5 * l * radius * radius / square * (y / square.sqrt())
}

fn scene(text: &str) -> Result<Scene, SceneError> {
    let source = Source { file: "ch09", text };
    gallery::from_text(source, None, |_| {})
}

/// All lamps, or one of them: the largest |z| and the rays.
pub fn many(desk: &mut Desk, count: u32) -> Result<(Largest, u64), DeskError> {
    let mut text = "name = 'row'\ncamera = { from = [0, 0.3, -1], to = [0, 0, 0], fov = 40 }\n\
                    materials.grey.lambert.albedo = 0.5\n[[objects]]\nmaterial = 'grey'\n\
                    quad = { corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }\n"
        .to_owned();
    for (i, l) in LAMPS.iter().enumerate() {
        let [x, y] = place(i);
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "[[objects]]\nemits = {l:?}\n\
             sphere = {{ center = [{x:?}, {y:?}, 0], radius = {RADIUS:?} }}"
        );
    }
    let scene = scene(&text)?;
    let gives: Vec<f64> = (0..LAMPS.len())
        .map(|i| reflected(LAMPS[i], RADIUS, place(i)))
        .collect();
    let truth: f64 = gives.iter().sum();
    let ray = scene.camera.ray(0.5, 0.5);
    let seed = desk.options.seed;
    let mut seen = Seen::default();
    let all = NextEvent { max_depth: 2 };
    let found = walks::solid(&scene, &ray, &all, truth, count, seed);
    seen.record(desk, "all", "eight lamps, all of them", &found, truth);
    for (name, says, weights) in [
        ("uniform", "each alike", vec![1.0; LAMPS.len()]),
        ("power", "by power", LAMPS.to_vec()),
        ("given", "by what it gives here", gives),
    ] {
        let choice = Discrete::new(weights)
            .ok_or_else(|| DeskError::Missing("lamps that shine".to_owned()))?;
        let one = PickOne {
            max_depth: 2,
            choice,
        };
        let found = walks::solid(&scene, &ray, &one, truth, count, seed);
        let says = format!("eight lamps, one of them, {says}");
        seen.record(desk, name, &says, &found, truth);
    }
    Ok((seen.compared, seen.rays))
}

/// How far some estimates are from their truths, and the rays of all.
#[derive(Default)]
struct Seen {
    compared: Largest,
    rays: u64,
}

impl Seen {
    fn record(&mut self, desk: &mut Desk, name: &str, says: &str, found: &Walks, truth: f64) {
        desk.estimate(&format!("lamps_{name}"), says, &found.estimate, Some(truth));
        let (value, error) = found.relative_variance(truth);
        let number = Number::new("  its relative variance", value);
        let error = Some(error);
        desk.number(
            &format!("lamps_{name}_variance"),
            Number { error, ..number },
        );
        desk.value(
            &format!("lamps_{name}_rays"),
            "  its rays",
            found.rays_each(),
        );
        self.compared.add(z_test(&found.estimate, truth, FOUR).z);
        self.rays += found.rays;
    }
}

// ANCHOR: mirror
/// A lamp and its image in a mirror: what walks find of each, compared with the truth, and the rays.
pub fn mirror(desk: &mut Desk, count: u32) -> Result<(Largest, u64), DeskError> {
    // Seen from the floor, the lamp and its image, as if it were a second lamp.
    let (lamp, image) = ([0.0, 1.5], [2.0, 1.5]);
    let text = include_str!("mirror.toml");
    let point = "[[lights]]\npoint = { position = [0, 1.5, 0], intensity = 1 }\n";
    let scene_point = scene(&format!("{text}\n{point}"))?;
    // A sphere of the same power shows the point the disc of area π R² with radiance I / π R².
    let radius = 0.3;
    let radiance = 1.0 / (PI * radius * radius);
    let scene_sphere = scene(&format!(
        "{text}\n[[objects]]\nemits = {radiance:?}\n\
         sphere = {{ center = [0, 1.5, 0], radius = {radius:?} }}\n"
    ))?;
    // ANCHOR_END: mirror
    let [direct, mirrored] = [lamp, image].map(|at| reflected(radiance, radius, at));
    desk.value("mirror_direct", "from the lamp", direct);
    desk.value("mirror_image", "from its image", mirrored);
    let (seed, aim) = (desk.options.seed, NextEvent { max_depth: 3 });
    let chance = Kajiya { max_depth: 3 };
    let (mut compared, mut rays) = (Largest::default(), 0);
    let both = direct + mirrored;
    let ray = scene_point.camera.ray(0.5, 0.5);
    for (name, says, found, truth) in [
        (
            "point",
            "a point lamp by a mirror, by aiming",
            walks::solid(&scene_point, &ray, &aim, direct, count / 16, seed),
            direct,
        ),
        (
            "sphere",
            "a sphere by a mirror, by aiming",
            walks::solid(&scene_sphere, &ray, &aim, both, count, seed),
            both,
        ),
        (
            "chance",
            "a sphere by a mirror, by chance",
            walks::solid(&scene_sphere, &ray, &chance, both, count, seed),
            both,
        ),
    ] {
        desk.estimate(
            &format!("mirror_{name}"),
            says,
            &found.estimate,
            Some(truth),
        );
        compared.add(z_test(&found.estimate, truth, FOUR).z);
        rays += found.rays;
    }
    let missing = missing_words().map_err(|e| DeskError::Missing(e.to_string()))?;
    desk.say(&format!(
        "paths of a point lamp that no walk finds: {missing}"
    ));
    Ok((compared, rays))
}

/// What aiming at lamps without extent leaves out, the shortest words first.
fn missing_words() -> Result<String, ExpressionError> {
    let [all, found]: [Expression; 2] = ["L(S|D)*E".parse()?, "LD(S|D)*E".parse()?];
    let missing = all.light_first().difference(found.light_first());
    let words: Vec<String> = missing.shortest(5).iter().map(|w| w.to_string()).collect();
    Ok(words.join(", "))
}

/// The box with its lamp counted twice, beside the right one; the rays.
pub fn twice(desk: &mut Desk) -> Result<u64, DeskError> {
    let scene = gallery::load("cornell")?.sized([96; 2]);
    let depth = 2;
    let right = picture(desk, &scene, &NextEvent { max_depth: depth }, 128, 2)?;
    let wrong = picture(desk, &scene, &CountTwice { max_depth: depth }, 128, 2)?;
    desk.picture("once.png", "Direct light.", &right.film, &scene)?;
    let caption = "The lamp counts by shadow rays and where walks meet it: twice as bright.";
    desk.picture("twice.png", caption, &wrong.film, &scene)?;
    // A point of the floor, where nothing stands in the way.
    let ray = scene.camera.ray(0.35, 0.93);
    let (count, seed) = (30_000, desk.options.seed);
    let once = walks::solid(
        &scene,
        &ray,
        &NextEvent { max_depth: depth },
        0.0,
        count,
        seed,
    );
    let twice = walks::solid(
        &scene,
        &ray,
        &CountTwice { max_depth: depth },
        0.0,
        count,
        seed,
    );
    desk.estimate("floor_once", "a point of the floor", &once.estimate, None);
    let ratio = twice.estimate.mean() / once.estimate.mean();
    let error = twice
        .estimate
        .std_error()
        .hypot(2.0 * once.estimate.std_error())
        / once.estimate.mean();
    let number = Number::new("  counted twice, times as bright", ratio).exact(2.0);
    let error = Some(error);
    desk.number("floor_twice", Number { error, ..number });
    Ok(once.rays + twice.rays + right.rays.total() + wrong.rays.total())
}
