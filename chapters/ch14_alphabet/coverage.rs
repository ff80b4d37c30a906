//! What each integrator finds: said by expressions, and measured.

use crate::figures::short;
use crate::share_of;
use halfdisk::integrators::{Entry, Path, Settings, WALKS};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::effects::language::{Class, Finds, finds, paths};
use halfdisk::lab::effects::words::{Words, words};
use halfdisk::notation::Expression;
use halfdisk::render::{Options, render};
use halfdisk::scene::description::{Description, Light, Object, Shape};
use halfdisk::scene::value::{Emission, Positive, Triple};
use halfdisk::scene::{Scene, gallery};
use halfdisk::stats::Estimate;
use halfdisk::stats::z_test::Largest;
use std::f64::consts::PI;

/// Where the lamp is that takes the place of the room's own.
const PLACE: [f64; 3] = [278.0, 480.0, 279.5];
/// What it sends out, in W/sr: about as much as the room's own.
const INTENSITY: f64 = 200_000.0;

/// The light of a point that walks from the eye find.
const BY_POINT: [Class; 3] = [Class::Direct, Class::DirectSpecular, Class::Bleeding];

/// The rays, and how far the pictures are from what the expressions say.
pub fn work(desk: &mut Desk) -> Result<(u64, Largest), DeskError> {
    let (by_lamp, compared) = room(desk, "lamp", |_| {})?;
    let (by_point, of_point) = room(desk, "point", point)?;
    // What the point's light would be if it were a small ball: then paths find all of it.
    let scene = load(desk, |said| ball(said, 20.0))?;
    let found = paths_in(Path::ENTRY, "point");
    let (mut caustics, mut lost) = (Estimate::new(), Estimate::new());
    let mut rays = by_lamp + by_point;
    for seed in 0..8 {
        let words = spell(desk, &scene, seed);
        rays += words.rays;
        let light = |class: &Class| share_of(*class, &words)[0];
        let by_eye: f64 = BY_POINT.iter().map(light).sum();
        let all = by_eye + light(&Class::Caustic);
        caustics.add(100.0 * light(&Class::Caustic) / by_eye);
        let has = light_in(&words, found.as_ref()) / words.total.mean();
        lost.add(100.0 * (all - has) / all);
    }
    let says = "caustics of a small ball, percent of what walks from the eye find of a point";
    desk.estimate("ball_caustic", says, &caustics, None);
    let says = "of a small ball's light that a point has, too, percent that path would not find of a point";
    desk.estimate("ball_lost", says, &lost, None);
    Ok((rays, compared.with(of_point)))
}

fn load(desk: &Desk, change: impl FnOnce(&mut Description)) -> Result<Scene, DeskError> {
    let side = desk.choose(24, 16);
    Ok(gallery::load_with("spheres", change)?.sized([side; 2]))
}

fn point(said: &mut Description) {
    said.objects.retain(|object| object.emits.is_none());
    said.lights.push(Light::Point {
        position: Triple(PLACE),
        intensity: Emission([INTENSITY; 3]),
    });
}

fn ball(said: &mut Description, radius: f64) {
    for object in said.objects.iter_mut().filter(|o| o.emits.is_some()) {
        *object = Object {
            emits: Some(Emission([INTENSITY / (PI * radius * radius); 3]).into()),
            shape: Shape::Sphere {
                center: Triple(PLACE),
                radius: Positive(radius),
                inward: false,
            },
            ..object.clone()
        };
    }
}

/// All integrators in one room: the rays, and the largest distance in standard errors.
fn room(
    desk: &mut Desk,
    lamp: &str,
    change: impl FnOnce(&mut Description),
) -> Result<(u64, Largest), DeskError> {
    let scene = load(desk, change)?;
    desk.say(&format!("\nthe room with a {lamp}"));
    let spelt: Vec<Words> = (0..8).map(|seed| spell(desk, &scene, seed)).collect();
    let all: Estimate = spelt.iter().map(|words| words.total.mean()).collect();
    let mut rays: u64 = spelt.iter().map(|words| words.rays).sum();
    let mut compared = Largest::default();
    for integrator in WALKS {
        let found = |class: &Class| finds(&integrator, *class, &scene.inventory);
        for class in Class::ALL {
            answer(desk, lamp, integrator, class, found(&class));
        }
        let paths = paths_in(integrator, lamp);
        let (mut said, mut read, mut apart) = (Estimate::new(), Estimate::new(), Estimate::new());
        for (seed, words) in (0..).zip(&spelt) {
            let light = light_in(words, paths.as_ref());
            let (mean, traced) = picture(desk, &scene, integrator, seed)?;
            said.add(light);
            read.add(mean);
            // Both saw the lamp through the same points of the pixels: no noise of their difference.
            apart.add(mean - light);
            rays += traced;
        }
        let says = format!("{}: percent of the light", integrator.name);
        let percent = |light: f64| 100.0 * light / all.mean();
        let number = Number {
            error: Some(percent(apart.std_error())),
            ..Number::new(&says, percent(read.mean())).exact(percent(said.mean()))
        };
        desk.number(&format!("{lamp}_{}", key(integrator)), number);
        // `path` is compared with itself, and differs by rounding alone.
        if apart.std_error() > 1e-6 * all.mean() {
            compared.add(apart.z(0.0));
        }
    }
    Ok((rays, compared))
}

/// The paths that an integrator finds in the room with a lamp, or with a point in its place; `None` for none.
fn paths_in(integrator: Entry, lamp: &str) -> Option<Expression> {
    let finds = integrator.finds()?;
    match lamp {
        "point" => paths(&finds.points),
        _ => paths(&finds.lamps),
    }
}

/// The light of a picture that comes by some paths.
fn light_in(words: &Words, paths: Option<&Expression>) -> f64 {
    let Some(paths) = paths else { return 0.0 };
    let own = words.shares.iter();
    let own = own.filter(|(word, _)| paths.light_first().accepts(&word.0));
    own.map(|(_, share)| share.light.mean()).sum()
}

/// 1 where the integrator finds the class, one half where it finds some of its words, 0 where it does not, nothing where there is no such light.
fn answer(desk: &mut Desk, lamp: &str, integrator: Entry, class: Class, found: Finds) {
    let value = match found {
        Finds::All => 1.0,
        Finds::Part => 0.5,
        Finds::Nothing => 0.0,
        Finds::Absent => return,
    };
    let says = format!("{} finds {}", integrator.name, class.text());
    let name = format!("{lamp}_{}_{}", key(integrator), short(class));
    desk.value(&name, &says, value);
}

fn options(desk: &Desk, seed: u64) -> Options {
    Options {
        spp: 4,
        seed: desk.options.seed + seed,
        ..Options::default()
    }
}

fn spell(desk: &Desk, scene: &Scene, seed: u64) -> Words {
    let path = Path::new(scene.suggested.max_depth);
    words(scene, &path, &options(desk, seed), 1)
}

/// The mean of a picture, and its rays.
fn picture(
    desk: &Desk,
    scene: &Scene,
    integrator: Entry,
    seed: u64,
) -> Result<(f64, u64), DeskError> {
    let by = integrator.prepare(scene, &Settings::new(scene.suggested.max_depth))?;
    let options = options(desk, seed);
    let rendered = render(scene, &by, &options, &desk.bar(integrator.name));
    if rendered.interrupted {
        return Err(DeskError::Interrupted);
    }
    Ok((rendered.film.mean().0, rendered.rays.total()))
}

fn key(integrator: Entry) -> String {
    integrator.name.replace('-', "_")
}
