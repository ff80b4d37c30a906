//! What a scene calls for, by reading it.

use crate::ROOM;
use glam::DVec2;
use halfdisk::integrators::{FilteredPath, Kajiya, Path};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{ChartError, StrokeKind};
use halfdisk::lab::effects::language::{Class, of_scene, out_of_reach};
use halfdisk::lab::effects::plan;
use halfdisk::lab::effects::words::words;
use halfdisk::lab::figures::sketch::Sketch;
use halfdisk::notation::Expression;
use halfdisk::render::{Options, render};
use halfdisk::scene::description::{Description, Light, Object, Shape};
use halfdisk::scene::read::Source;
use halfdisk::scene::value::{Emission, Positive};
use halfdisk::scene::{Scene, SceneError, gallery};
use halfdisk::stats::Estimate;
use std::f64::consts::PI;

/// One line for each effect.
pub fn of_room(desk: &mut Desk) -> Result<(), DeskError> {
    let scene = gallery::load(ROOM)?;
    let plan = plan::plan(&scene);
    for line in &plan.lines {
        let name = line.effect.name();
        let says = format!("{name}: {}", line.reason);
        let simulated = f64::from(u8::from(line.simulated));
        desk.value(
            &format!("asks_{}", name.replace('-', "_")),
            &says,
            simulated,
        );
    }
    let simulated = plan.lines.iter().filter(|line| line.simulated).count();
    desk.value("asks", "effects that are simulated", simulated as f64);
    desk.value("effects", "effects there are", plan.lines.len() as f64);
    let paths = plan.paths.unwrap_or_default();
    desk.say(&format!("light paths: {paths}"));
    let effects = format!("{simulated} of {} effects,", plan.lines.len());
    let caption = "From the scene file to the first ray. The file is counted once, ten questions are answered from the counts, \
                   and the walk is chosen that was compiled for the letters that are left.";
    desk.figure("plan.svg", caption, drawing([&effects, &paths])?)
}

/// From the scene file to the walk, in four boxes.
fn drawing([effects, paths]: [&str; 2]) -> Result<String, ChartError> {
    let mut sketch = Sketch::new("A plan", [-6.0, -0.9], [6.0, 0.9]);
    let boxes = [
        ["scene file", "objects, materials,", "lights, camera"],
        ["inventory", "counts what is used", "and does something"],
        ["plan", effects, paths],
        ["walk", "compiled for these", "letters alone"],
    ];
    let half = DVec2::new(1.25, 0.75);
    for (place, words) in boxes.into_iter().enumerate() {
        let middle = DVec2::new(3.1 * place as f64 - 4.65, 0.0);
        let corner = |x: f64, y: f64| middle + half * DVec2::new(x, y);
        let corners = [[-1., -1.], [1., -1.], [1., 1.], [-1., 1.], [-1., -1.]];
        let corners = corners.map(|[x, y]| corner(x, y));
        sketch.curve(StrokeKind::Outline, corners);
        for (line, word) in words.into_iter().enumerate() {
            sketch.word(middle + DVec2::new(0.0, 0.42 - 0.42 * line as f64), word);
        }
        if place + 1 < boxes.len() {
            let gap = DVec2::new(0.55, 0.0);
            sketch.arrow(StrokeKind::Camera, corner(1.0, 0.0), corner(1.0, 0.0) + gap);
        }
    }
    sketch.to_svg()
}

/// A point shines through glass: a caustic that `path` traces from the light, and its image in the glass, which it reads
/// as 0. The rays it took.
pub fn point_through_glass(desk: &mut Desk) -> Result<u64, DeskError> {
    let scene = load(|_| {})?;
    let lost = out_of_reach(&scene.inventory)
        .ok_or_else(|| DeskError::Missing("the point's light is within reach".to_owned()))?;
    let options = Options {
        spp: desk.choose(40, 16),
        seed: desk.options.seed,
        ..Options::default()
    };
    let path = Path::new(scene.suggested.max_depth);
    let paths = lost.eye_first();
    let read = render(&scene, &FilteredPath { path, paths }, &options, &());
    let mut rays = read.rays.total();
    let caustics = Class::Caustic.expression();
    let paths = caustics.eye_first();
    let traced = render(&scene, &FilteredPath { path, paths }, &options, &());
    rays += traced.rays.total();
    let whole = render(&scene, &path, &options, &());
    rays += whole.rays.total();
    let percent = |x: f64| 100.0 * x / whole.film.mean().0;
    let (light, error) = traced.film.mean();
    let number = Number {
        error: Some(percent(error)),
        ..Number::new(
            "point through glass: caustics, percent of the light",
            percent(light),
        )
    };
    desk.number("point_caustics", number);
    let says = format!("point through glass: the brightest pixel of {lost}");
    desk.known("point_lost", &says, read.film.max(), 0.0);
    let found = of_scene(&scene.inventory);
    let shares = found.is_some_and(|all| all.light_first().includes(lost.light_first()));
    desk.value(
        "point_has",
        "its paths are among the scene's",
        f64::from(u8::from(shares)),
    );
    // Walks that meet lamps by chance read 0 everywhere, and the others agree without it.
    let kajiya = render(&scene, &Kajiya { max_depth: 12 }, &options, &());
    rays += kajiya.rays.total();
    let says = "point through glass: the brightest pixel of kajiya";
    desk.known("point_kajiya", says, kajiya.film.max(), 0.0);

    // The same light from a small ball is found.
    let radius = 0.2;
    let scene = load(|said| ball(said, radius))?;
    let (mut share, mut unseen) = (Estimate::new(), Estimate::new());
    for seed in 0..8 {
        let options = Options { seed, ..options };
        let words = words(&scene, &path, &options, 1);
        rays += words.rays;
        let light = |paths: &Expression| {
            let own = words.shares.iter();
            let own = own.filter(|(word, _)| paths.light_first().accepts(&word.0));
            let light: f64 = own.map(|(_, share)| share.light.mean()).sum();
            100.0 * light / words.total.mean()
        };
        share.add(light(&caustics));
        unseen.add(light(&lost));
    }
    let says = format!("a ball in its place: {lost}, percent of the light");
    desk.estimate("ball_lost", &says, &unseen, None);
    let says = "a ball in its place: caustics, percent of the light";
    desk.estimate("ball_caustics", says, &share, None);
    Ok(rays)
}

/// The point over the ball, with something changed.
pub fn load(change: impl FnOnce(&mut Description)) -> Result<Scene, SceneError> {
    let source = Source {
        file: "point.toml",
        text: include_str!("point.toml"),
    };
    gallery::from_text(source, None, change)
}

/// A ball of the same power in the point's place.
fn ball(said: &mut Description, radius: f64) {
    let is_sphere = |o: &&Object| matches!(o.shape, Shape::Sphere { .. });
    let Some(model) = said.objects.iter().find(is_sphere).cloned() else {
        return;
    };
    for light in said.lights.drain(..) {
        let Light::Point {
            position,
            intensity,
        } = light
        else {
            continue;
        };
        said.objects.push(Object {
            material: None,
            emits: Some(Emission(intensity.0.map(|i| i / (PI * radius * radius))).into()),
            shape: Shape::Sphere {
                center: position,
                radius: Positive(radius),
                inward: false,
            },
            ..model.clone()
        });
    }
}
